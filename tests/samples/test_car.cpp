// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "geometry/self_intersection.h"
#include "geometry/winding_number.h"
#include "samples/blob.h"
#include "samples/car.h"
#include "samples/ring.h"

namespace crumple::samples {
namespace {

double signed_volume(const Part& part) {
    double six = 0;
    for (const auto& [a, b, c] : part.triangles)
        six += dot(part.positions[a], cross(part.positions[b], part.positions[c]));
    return six / 6;
}

// Closed, 2-manifold edges and consistently wound: every directed edge once, and its reverse once.
bool is_closed(const Part& part) {
    std::map<Edge, int> directed;
    for (const auto& t : part.triangles) {
        for (std::size_t i = 0; i < 3; ++i) ++directed[{t[i], t[(i + 1) % 3]}];
    }
    return std::all_of(directed.begin(), directed.end(), [&](const auto& entry) {
        const auto reverse = directed.find({entry.first[1], entry.first[0]});
        return entry.second == 1 && reverse != directed.end() && reverse->second == 1;
    });
}

const Part& named(const Model& model, std::string_view name) {
    const auto part = std::find_if(model.begin(), model.end(), [&](const Part& p) { return p.name == name; });
    if (part == model.end()) throw std::runtime_error("no part " + std::string(name));
    return *part;
}

// One soup of all parts.
Part merged(const Model& model) {
    Part all{"all", {}, {}, {}};
    for (const auto& part : model) {
        const auto first = static_cast<Index>(all.positions.size());
        all.positions.insert(all.positions.end(), part.positions.begin(), part.positions.end());
        for (const auto& [a, b, c] : part.triangles) all.triangles.push_back({first + a, first + b, first + c});
    }
    return all;
}

std::size_t count_outside(const Part& points, const Part& shell) {
    const WindingNumber winding(shell.positions, shell.triangles);
    return static_cast<std::size_t>(
        std::count_if(points.positions.begin(), points.positions.end(), [&](Vec3 p) { return winding.at(p) < 0.5; }));
}

TEST(CarShell, IsSevenClosedSurfacesWoundOutwards) {
    const Model shell = car_shell();
    ASSERT_EQ(shell.size(), 7u);
    for (const auto& part : shell) {
        EXPECT_TRUE(is_closed(part)) << part.name;
        EXPECT_GT(signed_volume(part), 0) << part.name;
    }
}

TEST(CarShell, NowhereMeetsItself) {
    const Part all = merged(car_shell());
    EXPECT_TRUE(self_intersections(all.positions, all.triangles).empty());
}

TEST(CarShell, CarriesEverythingInsideTheBody) {
    const Model shell = car_shell();
    for (std::size_t i = 1; i < shell.size(); ++i) EXPECT_EQ(count_outside(shell[i], shell[0]), 0u) << shell[i].name;
}

TEST(CarShell, LocksEngineAndWheelHousesWhollyAndTheCageAtItsFeet) {
    const Model shell = car_shell();
    EXPECT_EQ(locked_count({named(shell, "body")}), 0u);
    EXPECT_EQ(locked_count({named(shell, "engine_block")}), named(shell, "engine_block").positions.size());
    EXPECT_EQ(locked_count({named(shell, "wheel_house_rear_left")}),
              named(shell, "wheel_house_rear_left").positions.size());
    EXPECT_EQ(locked_count({named(shell, "roll_cage")}), 6u * 8u);  // six feet of eight corners
}

TEST(CarShell, IsTheSizeOfAHandMadeControlShell) {
    const auto count = vertex_count(car_shell());
    EXPECT_GE(count, 600u);
    EXPECT_LE(count, 1500u);
}

TEST(CarVisual, HasFiftyThousandVerticesAndMoreAllInsideTheBody) {
    const Model visual = car_visual();
    EXPECT_GE(vertex_count(visual), 50000u);
    const Part body = car_shell().front();
    for (const auto& part : visual) EXPECT_EQ(count_outside(part, body), 0u) << part.name;
}

TEST(CarVisual, WheelsEngineAndCageLieInTheShellsThatCarryThem) {
    const Model visual = car_visual();
    const Model shell = car_shell();
    for (const auto& [inner, outer] : {std::pair{"wheel_front_left", "wheel_house_front_left"},
                                       {"wheel_front_right", "wheel_house_front_right"},
                                       {"wheel_rear_left", "wheel_house_rear_left"},
                                       {"wheel_rear_right", "wheel_house_rear_right"},
                                       {"engine", "engine_block"},
                                       {"cage", "roll_cage"}}) {
        EXPECT_EQ(count_outside(named(visual, inner), named(shell, outer)), 0u) << inner;
    }
}

TEST(CarVisual, HasNoTriangleWithoutArea) {
    for (const auto& part : car_visual()) {
        for (const auto& [a, b, c] : part.triangles) {
            const Vec3 normal = cross(part.positions[b] - part.positions[a], part.positions[c] - part.positions[a]);
            ASSERT_GT(dot(normal, normal), 0) << part.name << " triangle of " << a << ' ' << b << ' ' << c;
        }
    }
}

TEST(BlobAndRing, AreClosedAndEncloseTheirVisualMesh) {
    for (const auto& [shell, visual] : {std::pair{blob_shell(), blob_visual()}, {ring_shell(), ring_visual()}}) {
        const Part& surface = shell.front();
        EXPECT_TRUE(is_closed(surface)) << surface.name;
        EXPECT_GT(signed_volume(surface), 0) << surface.name;
        EXPECT_TRUE(self_intersections(surface.positions, surface.triangles).empty()) << surface.name;
        EXPECT_EQ(count_outside(visual.front(), surface), 0u) << surface.name;
    }
}

}
}
