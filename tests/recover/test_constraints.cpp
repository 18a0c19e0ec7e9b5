// SPDX-License-Identifier: GPL-3.0-or-later
#include "recover/constraints.h"

#include <gtest/gtest.h>

#include "recover/splits.h"

using namespace crumple;
using namespace crumple::recover;

namespace {

TEST(Constraints, CopiesAreOneFacetAndEdgesWithoutLengthNone) {
    Constraints constraints;
    constraints.add_facet({2, 0, 1}, 7);
    constraints.add_facet({0, 1, 2}, 8);
    constraints.add_facet({3, 3, 4}, 9);
    EXPECT_EQ(constraints.facets(), (std::vector<Triangle>{{0, 1, 2}}));
    EXPECT_EQ(constraints.segments(), (std::vector<Edge>{{0, 1}, {0, 2}, {1, 2}}));
    EXPECT_EQ(constraints.origin({0, 1, 2}), 7u);
    EXPECT_TRUE(constraints.has_segment(2, 1));
    EXPECT_FALSE(constraints.has_segment(3, 4));
}

TEST(Constraints, ASegmentGoesWithItsLastFacet) {
    Constraints constraints;
    constraints.add_facet({0, 1, 2}, 0);
    constraints.add_facet({1, 0, 3}, 1);
    EXPECT_EQ(constraints.apexes({0, 1}), (std::vector<Index>{2, 3}));
    constraints.remove_facet({2, 1, 0});
    EXPECT_EQ(constraints.apexes({0, 1}), (std::vector<Index>{3}));
    EXPECT_FALSE(constraints.has_segment(0, 2));
    constraints.remove_facet({0, 1, 3});
    EXPECT_TRUE(constraints.segments().empty());
}

TEST(Constraints, SplittingASegmentSplitsAllFacetsAtIt) {
    Constraints constraints;
    for (Index apex = 2; apex < 5; ++apex) constraints.add_facet({0, 1, apex}, apex);
    const Split split = split_segment(constraints, 0, 1, 9);
    EXPECT_EQ(split.apexes, (std::vector<Index>{2, 3, 4}));
    EXPECT_EQ(split.origins, (std::vector<Index>{2, 3, 4}));
    EXPECT_FALSE(constraints.has_segment(0, 1));
    EXPECT_EQ(constraints.facets().size(), 6u);
    EXPECT_EQ(constraints.origin({1, 3, 9}), 3u);
    EXPECT_TRUE(constraints.has_segment(9, 4));
}

TEST(Constraints, SplittingAFacetKeepsItsEdges) {
    Constraints constraints;
    constraints.add_facet({0, 1, 2}, 5);
    split_facet(constraints, {0, 1, 2}, 3);
    EXPECT_EQ(constraints.facets(), (std::vector<Triangle>{{0, 1, 3}, {0, 2, 3}, {1, 2, 3}}));
    EXPECT_TRUE(constraints.has_segment(0, 1));
    EXPECT_EQ(constraints.origin({0, 2, 3}), 5u);
}

}
