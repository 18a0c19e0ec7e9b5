// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/place_search.h"

#include <gtest/gtest.h>

namespace crumple::finish {
namespace {

TEST(PlaceSearch, StaysWhereNothingIsBetter) {
    const Vec3 start{0.1, 0.2, 0.3};  // no floats
    const auto same = [](Vec3, double) { return 1.0; };
    EXPECT_EQ(search_place(start, 1, 1, same), start);
    const auto worse = [&](Vec3 place, double) { return 1 + length(place - start); };
    EXPECT_EQ(search_place(start, 1, 1, worse), start);
    EXPECT_EQ(search_place(start, 0, 2, worse), round_to_float(start)) << "a step of no length rounds";
}

TEST(PlaceSearch, ComesNearTheBestPlaceWithinReach) {
    const Vec3 goal{0.3, -0.2, 0.25};
    const auto lack = [&](Vec3 place, double) { return length(place - goal); };
    const Vec3 found = search_place({}, 1, length(goal), lack);
    EXPECT_LT(length(found - goal), 0.25 * length(goal));
    EXPECT_EQ(found, round_to_float(found));
}

TEST(PlaceSearch, TellsWhatAPlaceMustBeat) {
    double last = 1;
    const auto lack = [&](Vec3 place, double limit) {
        EXPECT_LE(limit, last);
        last = limit;
        return length(place - Vec3{1, 0, 0});
    };
    (void)search_place({}, 1, 1, lack);
    EXPECT_LT(last, 1);
}

}
}
