// SPDX-License-Identifier: MIT
#include "store/check_view.h"

#include <gtest/gtest.h>

#include <functional>

#include "bundle/small_bundle.h"
#include "core/error.h"
#include "store/bundle_file.h"

using namespace crumple;
using namespace crumple::store;

namespace {

// A view as an attacker would write it, all digests and the seal right: no links, everything can lie.
struct View {
    std::vector<std::int64_t> version{1, 0};
    std::string type = "UnstructuredGrid";
    std::int64_t points_count = 0;
    std::int64_t cells = 0;
    std::int64_t ids = 0;
    std::vector<Vec3f> points;
    std::vector<std::int64_t> connectivity;
    std::vector<std::int64_t> offsets{0};
    std::vector<std::uint8_t> types;
    std::vector<float> mass;
    std::vector<float> volume;
    std::vector<float> added;
};

View true_view(const Bundle& bundle) {
    View view;
    view.points = bundle.rest_positions;
    for (const Tet& tet : bundle.tets) {
        view.connectivity.insert(view.connectivity.end(), tet.begin(), tet.end());
        view.offsets.push_back(static_cast<std::int64_t>(view.connectivity.size()));
    }
    view.points_count = static_cast<std::int64_t>(view.points.size());
    view.cells = static_cast<std::int64_t>(bundle.tets.size());
    view.ids = static_cast<std::int64_t>(view.connectivity.size());
    view.types.assign(bundle.tets.size(), 10);
    view.mass = bundle.mass;
    view.volume = bundle.volume;
    view.added.assign(bundle.tets.size(), 1);
    return view;
}

FileReader file_of(const Bundle& bundle, const View& view) {
    FileWriter file;
    file.write("/bundle/mass", bundle.mass);
    file.write("/bundle/volume", bundle.volume);
    file.set_attribute("/VTKHDF", "Version", view.version);
    file.set_attribute("/VTKHDF", "Type", view.type);
    file.write_value("/VTKHDF/NumberOfPoints", view.points_count);
    file.write_value("/VTKHDF/NumberOfCells", view.cells);
    file.write_value("/VTKHDF/NumberOfConnectivityIds", view.ids);
    file.write("/VTKHDF/Points", view.points);
    file.write("/VTKHDF/Connectivity", view.connectivity);
    file.write("/VTKHDF/Offsets", view.offsets);
    file.write("/VTKHDF/Types", view.types);
    file.write("/VTKHDF/PointData/mass", view.mass);
    file.write("/VTKHDF/CellData/volume", view.volume);
    file.write("/VTKHDF/CellData/min_dihedral", view.added);
    return FileReader(file.finish(), "view");
}

using Paths = std::vector<std::string>;

Paths differences(const std::function<void(View&)>& change) {
    const Bundle bundle = test::small_bundle();
    View view = true_view(bundle);
    change(view);
    return find_view_differences(file_of(bundle, view), bundle);
}

}

TEST(CheckView, AFileWithoutAViewShowsNothingWrong) {
    FileWriter file;
    file.write_value("/bundle/x", 1.0);
    EXPECT_TRUE(find_view_differences(FileReader(file.finish(), "none"), test::small_bundle()).empty());
}

TEST(CheckView, WhatWeWriteAgrees) {
    const Bundle bundle = test::small_bundle();
    EXPECT_TRUE(find_view_differences(FileReader(to_image(bundle), "good"), bundle).empty());
    EXPECT_TRUE(differences([](View&) {}).empty());
}

TEST(CheckView, EveryArrayThatLiesIsNamed) {
    EXPECT_EQ(differences([](View& v) { v.version = {2, 0}; }), Paths{"/VTKHDF@Version"});
    EXPECT_EQ(differences([](View& v) { v.type = "ImageData"; }), Paths{"/VTKHDF@Type"});
    EXPECT_EQ(differences([](View& v) { ++v.points_count; }), Paths{"/VTKHDF/NumberOfPoints"});
    EXPECT_EQ(differences([](View& v) { --v.cells; }), Paths{"/VTKHDF/NumberOfCells"});
    EXPECT_EQ(differences([](View& v) { v.ids += 4; }), Paths{"/VTKHDF/NumberOfConnectivityIds"});
    EXPECT_EQ(differences([](View& v) { v.points[0].x += 1; }), Paths{"/VTKHDF/Points"});
    EXPECT_EQ(differences([](View& v) { std::swap(v.connectivity[0], v.connectivity[1]); }),
              Paths{"/VTKHDF/Connectivity"});
    EXPECT_EQ(differences([](View& v) { v.offsets[1] = 3; }), Paths{"/VTKHDF/Offsets"});
    EXPECT_EQ(differences([](View& v) { v.types[0] = 12; }), Paths{"/VTKHDF/Types"});
    EXPECT_EQ(differences([](View& v) { v.mass[0] *= 2; }), Paths{"/VTKHDF/PointData/mass"});
    EXPECT_EQ(differences([](View& v) { v.volume.pop_back(); }), Paths{"/VTKHDF/CellData/volume"});
}

TEST(CheckView, AnAddedFieldHasARowACell) {
    EXPECT_EQ(differences([](View& v) { v.added.pop_back(); }), Paths{"/VTKHDF/CellData/min_dihedral"});
}

TEST(CheckView, AMissingArrayIsRefused) {
    FileWriter file;
    file.set_attribute("/VTKHDF", "Version", std::vector<std::int64_t>{1, 0});
    file.set_attribute("/VTKHDF", "Type", "UnstructuredGrid");
    const FileReader reader(file.finish(), "short");
    EXPECT_THROW((void)find_view_differences(reader, test::small_bundle()), Error);
}
