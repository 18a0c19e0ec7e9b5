// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/bvh.h"

#include <gtest/gtest.h>

#include <set>

#include "core/random.h"

namespace crumple {
namespace {

Vec3 random_point(Rng& rng) {
    const double x = rng.next_unit();
    const double y = rng.next_unit();
    return {x, y, rng.next_unit()};
}

std::vector<Box> random_boxes(std::uint64_t seed, int count) {
    Rng rng(seed);
    std::vector<Box> boxes(count);
    for (Box& box : boxes) {
        const Vec3 middle = random_point(rng);
        box.add(middle);
        box.add(middle + random_point(rng) * 0.1);
    }
    return boxes;
}

double distance_2(const Box& box, Vec3 p) {
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double d = std::max({box.low[axis] - p[axis], p[axis] - box.high[axis], 0.0});
        sum += d * d;
    }
    return sum;
}

std::set<Index> held(const Bvh& tree, Vec3 p) {
    std::set<Index> found;
    tree.containing(p, [&](Index element) { return !found.insert(element).second; });
    return found;
}

TEST(Bvh, AnEmptyTreeFindsNothing) {
    const Bvh tree;
    EXPECT_TRUE(tree.empty());
    EXPECT_TRUE(held(tree, {0, 0, 0}).empty());
    EXPECT_EQ(tree.nearest({0, 0, 0}, [](Index) { return 0.0; }).element, none);
    EXPECT_TRUE(Bvh(std::span<const Box>{}).empty());
}

TEST(Bvh, FindsEveryBoxThatHoldsAPoint) {
    const auto boxes = random_boxes(1, 700);
    const Bvh tree(boxes);
    Rng rng(2);
    for (int i = 0; i < 300; ++i) {
        const Vec3 p = i < 100 ? boxes[i].high : random_point(rng);
        const std::set<Index> found = held(tree, p);
        for (Index e = 0; e < boxes.size(); ++e) {
            if (distance_2(boxes[e], p) == 0) {
                EXPECT_TRUE(found.count(e)) << i;
            }
        }
        EXPECT_LT(found.size(), 60u);
    }
}

TEST(Bvh, FindsEveryBoxThatTouchesABox) {
    const auto boxes = random_boxes(3, 400);
    const Bvh tree(boxes);
    for (const Box& query : random_boxes(4, 50)) {
        std::set<Index> found;
        tree.touching(query, [&](Index element) { return !found.insert(element).second; });
        for (Index e = 0; e < boxes.size(); ++e) {
            bool touches = true;
            for (int axis = 0; axis < 3; ++axis) {
                touches = touches && boxes[e].low[axis] <= query.high[axis] && boxes[e].high[axis] >= query.low[axis];
            }
            if (touches) {
                EXPECT_TRUE(found.count(e));
            }
        }
        EXPECT_LT(found.size(), 100u);
    }
}

TEST(Bvh, FindsEveryBoxWithinADistance) {
    const auto boxes = random_boxes(9, 400);
    const Bvh tree(boxes);
    Rng rng(10);
    for (int i = 0; i < 100; ++i) {
        const Vec3 p = random_point(rng) * 2 - Vec3{0.5, 0.5, 0.5};
        const double distance = 0.2 * rng.next_unit();
        std::set<Index> found;
        tree.within(p, distance, [&](Index element) { return !found.insert(element).second; });
        for (Index e = 0; e < boxes.size(); ++e) {
            if (distance_2(boxes[e], p) <= distance * distance) {
                EXPECT_TRUE(found.count(e));
            }
        }
    }
}

TEST(Bvh, NearestAgreesWithTryingEveryElementWhateverTheGuess) {
    const auto boxes = random_boxes(5, 500);
    const Bvh tree(boxes);
    Rng rng(6);
    for (int i = 0; i < 200; ++i) {
        const Vec3 p = random_point(rng) * 3 - Vec3{1, 1, 1};
        const auto to = [&](Index e) { return distance_2(boxes[e], p); };
        Bvh::Nearest slow;
        for (Index e = 0; e < boxes.size(); ++e) {
            if (to(e) < slow.distance_2) slow = {e, to(e)};
        }
        const Bvh::Nearest fast = tree.nearest(p, to);
        EXPECT_EQ(fast.element, slow.element);
        EXPECT_EQ(fast.distance_2, slow.distance_2);
        const Index guess = rng.next_below(500);
        EXPECT_EQ(tree.nearest(p, to, {guess, to(guess)}).element, slow.element);
    }
}

TEST(Bvh, ManyEqualBoxesStayShallow) {
    const std::vector<Box> boxes(5000, random_boxes(7, 1)[0]);
    const Bvh tree(boxes);
    EXPECT_EQ(held(tree, boxes[0].low).size(), 5000u);
    EXPECT_EQ(tree.nearest({9, 9, 9}, [](Index) { return 1.0; }).element, 0u);
}

TEST(Bvh, TheVisitorCanStopTheWalk) {
    const std::vector<Box> boxes(100, random_boxes(8, 1)[0]);
    int visits = 0;
    Bvh(boxes).containing(boxes[0].low, [&](Index) { return ++visits == 3; });
    EXPECT_EQ(visits, 3);
}

}
}
