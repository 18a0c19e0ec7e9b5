// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "bundle/small_bundle.h"
#include "store/boundary.h"
#include "store/export_msh.h"
#include "store/export_obj.h"
#include "store/export_vtu.h"

using namespace crumple;
using namespace crumple::store;

namespace {

// The lines between $name and $Endname.
std::istringstream section(const std::string& text, const std::string& name) {
    const std::size_t begin = text.find("$" + name + "\n") + name.size() + 2;
    return std::istringstream(text.substr(begin, text.find("$End" + name) - begin));
}

}

TEST(Boundary, EveryEdgeIsCrossedOnceEachWay) {
    const Bundle b = test::small_bundle(3);
    const std::vector<Triangle> faces = boundary_faces(b);
    EXPECT_EQ(faces.size(), 2u * (2 + 4 * 3));
    std::set<Edge> edges;
    for (const auto& [i, j, k] : faces) {
        for (const Edge edge : {Edge{i, j}, Edge{j, k}, Edge{k, i}}) EXPECT_TRUE(edges.insert(edge).second);
    }
    for (const auto& [i, j] : edges) EXPECT_TRUE(edges.contains({j, i}));
}

TEST(ExportMsh, ReadsBackExactly) {
    Bundle b = test::small_bundle(3);
    b.rest_positions[15] = {0.1f, 3.3333333f, 1e-7f};
    const std::string text = export_msh(b);
    std::istringstream nodes = section(text, "Nodes");
    std::size_t count = 0;
    nodes >> count;
    ASSERT_EQ(count, b.rest_positions.size());
    for (std::size_t node = 0; node < count; ++node) {
        std::size_t number = 0;
        Vec3f p;
        nodes >> number >> p.x >> p.y >> p.z;
        EXPECT_EQ(number, node + 1);
        EXPECT_EQ(p, b.rest_positions[node]);
    }
    std::istringstream elements = section(text, "Elements");
    elements >> count;
    EXPECT_EQ(count, 8 + b.tets.size());
    std::vector<Tet> tets;
    std::size_t locked = 0;
    for (std::size_t number = 0, type = 0, tags = 0, physical = 0, elementary = 0;
         elements >> number >> type >> tags >> physical >> elementary;) {
        ASSERT_EQ(tags, 2u);
        Tet tet{};
        for (std::size_t k = 0; k < (type == 4 ? 4u : 1u); ++k) elements >> tet[k];
        if (type == 15) locked += b.locked[tet[0] - 1];
        if (type == 4) tets.push_back({tet[0] - 1, tet[1] - 1, tet[2] - 1, tet[3] - 1});
    }
    EXPECT_EQ(locked, 8u);
    EXPECT_EQ(tets, b.tets);
}

TEST(ExportObj, LocksTheSamePositionsByRed) {
    const Bundle b = test::small_bundle(3);
    std::istringstream lines(export_obj(b));
    std::vector<Vec3f> locked;
    std::size_t faces = 0;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string kind;
        Vec3f p;
        Vec3f color;
        words >> kind >> p.x >> p.y >> p.z >> color.x >> color.y >> color.z;
        if (kind == "v" && color.x == 0) locked.push_back(p);
        if (kind == "f") ++faces;
    }
    std::sort(locked.begin(), locked.end(), lexicographic_less<float>);
    EXPECT_EQ(locked, b.locked_positions);
    EXPECT_EQ(faces, boundary_faces(b).size());
}

TEST(ExportObj, KeepsLockedNodesThatAreNotOnTheBoundary) {
    Bundle b = test::small_bundle();
    b.rest_positions.push_back({9, 9, 9});
    b.locked.push_back(1);
    EXPECT_NE(export_obj(b).find("v 9 9 9 0 0 1\n"), std::string::npos);
    EXPECT_NE(export_obj(b).find("p 13\n"), std::string::npos);
}

TEST(ExportVtu, SaysHowMuchThereIs) {
    const std::string text = export_vtu(test::small_bundle(3));
    EXPECT_NE(text.find("NumberOfPoints=\"16\" NumberOfCells=\"15\""), std::string::npos);
}
