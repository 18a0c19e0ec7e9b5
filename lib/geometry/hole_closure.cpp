// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/hole_closure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/measures.h"
#include "geometry/predicates.h"

namespace crumple {

namespace {

// A sum of solid angles kept as a product of unit-sized complex numbers (argument = half the angle) and the number of
// full turns. One arctangent at the end instead of one a triangle, only +, *, / and sqrt on the way: fast, accurate to
// a few ulp and the same on every machine.
class AngleSum {
public:
    void add(double real, double imaginary) {
        // In the plane of the triangle the principal value is no angle at all.
        if (imaginary == 0 || !std::isfinite(imaginary)) return;
        const double scale = 1 / (std::fabs(real) + std::fabs(imaginary));
        real *= scale;
        imaginary *= scale;
        const double next_real = real_ * real - imaginary_ * imaginary;
        const double next_imaginary = real_ * imaginary + imaginary_ * real;
        // Two angles of one sign may sum to more than half a turn. Counted without branches: signs are random.
        turns_ += int{imaginary_ >= 0} & int{imaginary > 0} & int{next_imaginary < 0};
        turns_ -= int{imaginary_ < 0} & int{imaginary < 0} & int{next_imaginary >= 0};
        real_ = next_real;
        imaginary_ = next_imaginary;
        if (std::fabs(real_) + std::fabs(imaginary_) < 0x1p-100) {
            real_ *= 0x1p100;
            imaginary_ *= 0x1p100;
        }
    }

    // Of the whole sphere. Adding 0 turns -0 into 0, so that the half turn has one sign.
    [[nodiscard]] double fraction() const {
        return turns_ + std::atan2(imaginary_ + 0.0, real_) / (2 * std::numbers::pi);
    }

private:
    double real_ = 1;
    double imaginary_ = 0;
    int turns_ = 0;
};

// tan(angle / 2) of a triangle seen from p [Van Oosterom and Strackee 1983]. Near the triangle's plane the exact sign
// decides on which side p is, as it does for the ray: the two must agree, or a whole turn goes astray.
void add_triangle(AngleSum& sum, Vec3 a, Vec3 b, Vec3 c, Vec3 p) {
    const Vec3 to_a = a - p;
    const Vec3 to_b = b - p;
    const Vec3 to_c = c - p;
    const double far_a = length(to_a);
    const double far_b = length(to_b);
    const double far_c = length(to_c);
    const double size = far_a * far_b * far_c;
    double volume = dot(to_a, cross(to_b, to_c));
    if (!(std::fabs(volume) > 1e-12 * size)) {
        const int side = -orient3d(a, b, c, p);
        volume = side * std::max(std::fabs(volume), std::numeric_limits<double>::min());
    }
    sum.add(size + dot(to_a, to_b) * far_c + dot(to_b, to_c) * far_a + dot(to_c, to_a) * far_b, volume);
}

}

struct HoleClosure::Hole {
    const std::vector<Vec3>* rim;
    Vec3 centre;
};

Index HoleClosure::open_node(double weight) {
    nodes_.push_back({});
    nodes_.back().weight = weight;
    return static_cast<Index>(nodes_.size() - 1);
}

// Sums up what was added since the node was opened.
void HoleClosure::close_node(Index node, const std::vector<Vec3>& held) {
    Node& closed = nodes_[node];
    const Box box = bounding_box(held);
    closed.centre = (box.low + box.high) * 0.5;
    for (const Vec3& place : held) closed.radius = std::max(closed.radius, length(place - closed.centre));
    closed.next = static_cast<Index>(nodes_.size());
    if (closed.triangle != none) {
        const auto& [a, b, c] = triangles_[closed.triangle];
        closed.area = length(area_vector(a, b, c)) / 2;
    }
    for (Index child = node + 1; child < closed.next; child = nodes_[child].next) closed.area += nodes_[child].area;
}

void HoleClosure::add_section(std::span<const Vec3> rim) {
    if (rim.size() < 3) return;
    const Index node = open_node(static_cast<double>(rim.size()) / edge_count_);
    const std::size_t middle = rim.size() / 2;
    // A straight piece of rim gives triangles that nobody can see.
    if (!are_collinear(rim.front(), rim[middle], rim.back())) {
        nodes_[node].triangle = static_cast<Index>(triangles_.size());
        triangles_.push_back({rim.front(), rim[middle], rim.back()});
    }
    add_section(rim.first(middle + 1));
    add_section(rim.subspan(middle));
    close_node(node, {rim.begin(), rim.end()});
}

void HoleClosure::add_holes(std::span<Hole> holes) {
    if (holes.empty()) return;
    if (holes.size() == 1) {
        add_section(*holes.front().rim);
        return;
    }
    std::vector<Vec3> held;
    for (const Hole& hole : holes) held.insert(held.end(), hole.rim->begin(), hole.rim->end());
    const Index node = open_node(static_cast<double>(held.size()) / edge_count_);
    Box middles;
    for (const Hole& hole : holes) middles.add(hole.centre);
    const Vec3 size = middles.high - middles.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    std::stable_sort(holes.begin(), holes.end(),
                     [&](const Hole& a, const Hole& b) { return a.centre[axis] < b.centre[axis]; });
    add_holes(holes.first(holes.size() / 2));
    add_holes(holes.subspan(holes.size() / 2));
    close_node(node, held);
}

HoleClosure::HoleClosure(const std::vector<std::vector<Vec3>>& rims) {
    std::vector<Hole> holes;
    for (const std::vector<Vec3>& rim : rims) {
        if (rim.size() < 3) continue;
        edge_count_ += static_cast<double>(rim.size());
        const Box box = bounding_box(rim);
        holes.push_back({&rim, (box.low + box.high) * 0.5});
    }
    add_holes(holes);
}

// A triangle of area A at least d away covers no more than A / (4 pi d^2) of the sphere.
double HoleClosure::share(Vec3 p, double tolerance) const {
    AngleSum sum;
    for (Index i = 0; i < nodes_.size();) {
        const Node& node = nodes_[i];
        const double gap = length(p - node.centre) - node.radius;
        const bool is_negligible = gap > 0 && node.area < 4 * std::numbers::pi * gap * gap * node.weight * tolerance;
        if (is_negligible) {
            i = node.next;
            continue;
        }
        if (node.triangle != none) {
            const auto& [a, b, c] = triangles_[node.triangle];
            add_triangle(sum, a, b, c, p);
        }
        ++i;
    }
    return sum.fraction();
}

}
