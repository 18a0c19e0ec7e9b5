// SPDX-License-Identifier: GPL-3.0-or-later
// A tree of boxes over numbered elements: which boxes hold a point or meet a box, and which element is nearest. Answers
// never depend on how the tree was walked: where two elements are equally near, the smaller number wins, so number
// elements by place where the order of the input must not show.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "core/index.h"
#include "geometry/measures.h"

namespace crumple {

class Bvh {
public:
    struct Nearest {
        Index element = none;
        double distance_2 = std::numeric_limits<double>::infinity();  // squared
    };

    Bvh() = default;
    explicit Bvh(std::span<const Box> boxes);

    [[nodiscard]] bool empty() const { return elements_.empty(); }

    // visit(element) for every element whose box holds p, and a few others, until it returns true.
    template <class Visit>
    void containing(Vec3 p, Visit&& visit) const {
        walk([&](const Node& node) { return node.holds(p); }, visit);
    }

    // visit(element) for every element whose box touches `box`, and a few others, until it returns true.
    template <class Visit>
    void touching(const Box& box, Visit&& visit) const {
        walk([&](const Node& node) { return node.touches(box); }, visit);
    }

    // visit(element) for every element whose box meets the ray from p along +axis or -axis, and a few others.
    template <class Visit>
    void on_ray(Vec3 p, int axis, bool is_forward, Visit&& visit) const {
        const int u = (axis + 1) % 3;
        const int v = (axis + 2) % 3;
        walk(
            [&](const Node& node) {
                return p[u] >= node.low[u] && p[u] <= node.high[u] && p[v] >= node.low[v] && p[v] <= node.high[v] &&
                       (is_forward ? p[axis] <= node.high[axis] : p[axis] >= node.low[axis]);
            },
            visit);
    }

    // visit(element) for every element whose box comes as near to p as `distance`, and a few others, until it returns
    // true.
    template <class Visit>
    void within(Vec3 p, double distance, Visit&& visit) const {
        const double reach = reach_2(distance * distance);
        walk([&](const Node& node) { return node.distance_2(p) <= reach; }, visit);
    }

    // The element of least distance_2(element), which must be its squared distance from p to a few ulp. Elements not
    // nearer than `known` are not reported instead of it; a good guess there saves most of the work.
    template <class Distance2>
    [[nodiscard]] Nearest nearest(Vec3 p, Distance2&& distance_2, Nearest known) const;

    template <class Distance2>
    [[nodiscard]] Nearest nearest(Vec3 p, Distance2&& distance_2) const {
        return nearest(p, distance_2, Nearest{});
    }

private:
    // 32 bytes, two a cache line. Bounds are floats rounded outwards: exact for float-representable positions.
    struct Node {
        std::array<float, 3> low;
        Index first;  // leaf: first of elements_; otherwise the right child, the left one being the next node
        std::array<float, 3> high;
        Index count;  // of elements at a leaf, else 0

        [[nodiscard]] bool holds(Vec3 p) const {
            return p.x >= low[0] && p.x <= high[0] && p.y >= low[1] && p.y <= high[1] && p.z >= low[2] &&
                   p.z <= high[2];
        }
        [[nodiscard]] bool touches(const Box& box) const {
            return box.high.x >= low[0] && box.low.x <= high[0] && box.high.y >= low[1] && box.low.y <= high[1] &&
                   box.high.z >= low[2] && box.low.z <= high[2];
        }
        [[nodiscard]] double distance_2(Vec3 p) const {
            double sum = 0;
            for (int axis = 0; axis < 3; ++axis) {
                const double outside = std::max({low[axis] - p[axis], p[axis] - high[axis], 0.0});
                sum += outside * outside;
            }
            return sum;
        }
    };

    // Halving by number keeps the tree this shallow for any 32-bit count.
    static constexpr int max_depth = 40;

    void build(std::vector<Vec3>& centres, std::span<const Box> boxes, Index first, Index count);

    template <class Enters, class Visit>
    void walk(Enters&& enters, Visit&& visit) const;

    // Squared distance beyond which a box cannot hold anything as near as `distance_2`, rounding errors included.
    [[nodiscard]] double reach_2(double distance_2) const {
        const double reach = std::sqrt(distance_2) * (1 + 1e-12) + slack_;
        return reach * reach;
    }

    std::vector<Node> nodes_;
    std::vector<Index> elements_;
    double slack_ = 0;  // metres of rounding error a distance may have at these coordinates
};

template <class Enters, class Visit>
void Bvh::walk(Enters&& enters, Visit&& visit) const {
    if (nodes_.empty()) return;
    std::array<Index, max_depth> stack;
    int waiting = 0;
    for (Index index = 0;;) {
        const Node& node = nodes_[index];
        if (enters(node)) {
            if (node.count == 0) {
                stack[waiting++] = node.first;
                ++index;
                continue;
            }
            for (Index i = node.first; i < node.first + node.count; ++i) {
                if (visit(elements_[i])) return;
            }
        }
        if (waiting == 0) return;
        index = stack[--waiting];
    }
}

template <class Distance2>
Bvh::Nearest Bvh::nearest(Vec3 p, Distance2&& distance_2, Nearest known) const {
    if (nodes_.empty()) return known;
    struct Waiting {
        Index node;
        double distance_2;
    };
    std::array<Waiting, max_depth> stack;
    int waiting = 0;
    stack[waiting++] = {0, nodes_[0].distance_2(p)};
    double reach = reach_2(known.distance_2);
    while (waiting > 0) {
        const Waiting next = stack[--waiting];
        if (next.distance_2 > reach) continue;
        const Node& node = nodes_[next.node];
        if (node.count == 0) {
            Waiting near{next.node + 1, nodes_[next.node + 1].distance_2(p)};
            Waiting far{node.first, nodes_[node.first].distance_2(p)};
            if (far.distance_2 < near.distance_2) std::swap(near, far);
            if (far.distance_2 <= reach) stack[waiting++] = far;
            if (near.distance_2 <= reach) stack[waiting++] = near;
            continue;
        }
        for (Index i = node.first; i < node.first + node.count; ++i) {
            const Index element = elements_[i];
            const double d = distance_2(element);
            if (d < known.distance_2) reach = reach_2(d);
            if (d < known.distance_2 || (d == known.distance_2 && element < known.element)) known = {element, d};
        }
    }
    return known;
}

// Over the boxes of triangles.
[[nodiscard]] Bvh tree_of(std::span<const Vec3> positions, std::span<const Triangle> triangles);

}
