// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/bvh.h"

#include <numeric>

namespace crumple {

namespace {

constexpr Index leaf_size = 4;

constexpr float infinity = std::numeric_limits<float>::infinity();

float rounded_down(double x) {
    const auto f = static_cast<float>(x);
    return f > x ? std::nextafterf(f, -infinity) : f;
}

float rounded_up(double x) {
    const auto f = static_cast<float>(x);
    return f < x ? std::nextafterf(f, infinity) : f;
}

}

Bvh::Bvh(std::span<const Box> boxes) : elements_(boxes.size()) {
    std::iota(elements_.begin(), elements_.end(), Index{0});
    if (boxes.empty()) return;
    std::vector<Vec3> centres;
    centres.reserve(boxes.size());
    for (const Box& box : boxes) {
        centres.push_back(box.low * 0.5 + box.high * 0.5);
        for (int axis = 0; axis < 3; ++axis) {
            slack_ = std::max({slack_, std::fabs(box.low[axis]) * 1e-14, std::fabs(box.high[axis]) * 1e-14});
        }
    }
    nodes_.reserve(boxes.size());
    build(centres, boxes, 0, static_cast<Index>(boxes.size()));
}

void Bvh::build(std::vector<Vec3>& centres, std::span<const Box> boxes, Index first, Index count) {
    Box whole;
    Box middles;
    for (Index i = first; i < first + count; ++i) {
        whole.add(boxes[elements_[i]].low);
        whole.add(boxes[elements_[i]].high);
        middles.add(centres[elements_[i]]);
    }
    const auto index = nodes_.size();
    nodes_.push_back({});
    for (int axis = 0; axis < 3; ++axis) {
        nodes_[index].low[axis] = rounded_down(whole.low[axis]);
        nodes_[index].high[axis] = rounded_up(whole.high[axis]);
    }
    if (count <= leaf_size) {
        nodes_[index].first = first;
        nodes_[index].count = count;
        return;
    }
    const Vec3 size = middles.high - middles.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const auto begin = elements_.begin() + first;
    const Index half = count / 2;
    std::nth_element(begin, begin + half, begin + count, [&](Index a, Index b) {
        return centres[a][axis] != centres[b][axis] ? centres[a][axis] < centres[b][axis] : a < b;
    });
    build(centres, boxes, first, half);
    nodes_[index].first = static_cast<Index>(nodes_.size());
    nodes_[index].count = 0;
    build(centres, boxes, first + half, count - half);
}

Bvh tree_of(std::span<const Vec3> positions, std::span<const Triangle> triangles) {
    std::vector<Box> boxes(triangles.size());
    for (std::size_t t = 0; t < boxes.size(); ++t) {
        for (const Index v : triangles[t]) boxes[t].add(positions[v]);
    }
    return Bvh(boxes);
}

}
