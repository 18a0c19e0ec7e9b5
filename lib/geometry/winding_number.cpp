// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/winding_number.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "geometry/measures.h"

namespace crumple {

namespace {

// Leaves this small are summed triangle by triangle.
constexpr Index leaf_size = 8;

// A boundary edge of a set of triangles: how often it runs from low to high minus how often it runs back.
struct ChainEdge {
    Index low = 0;
    Index high = 0;
    int times = 0;
};

bool chain_less(const ChainEdge& a, const ChainEdge& b) { return a.low != b.low ? a.low < b.low : a.high < b.high; }

void drop_cancelled(std::vector<ChainEdge>& chain) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < chain.size();) {
        ChainEdge edge = chain[i];
        for (++i; i < chain.size() && !chain_less(edge, chain[i]); ++i) edge.times += chain[i].times;
        if (edge.times != 0) chain[kept++] = edge;
    }
    chain.resize(kept);
}

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

// A vertex seen from the query point.
struct Ray {
    Ray(Vec3 vertex, Vec3 from) : to(vertex - from), distance(length(to)) {}
    Vec3 to;
    double distance;
};

// tan(angle / 2) of a triangle seen from the origin [Van Oosterom and Strackee 1983].
void add_triangle(AngleSum& sum, const Ray& a, const Ray& b, const Ray& c) {
    const double real = a.distance * b.distance * c.distance + dot(a.to, b.to) * c.distance +
                        dot(b.to, c.to) * a.distance + dot(c.to, a.to) * b.distance;
    sum.add(real, dot(a.to, cross(b.to, c.to)));
}

}

// Triangles halved along the longest axis again and again. From outside a node's box its triangles look like any other
// surface with the same boundary [Jacobson et al. 2013, section 4.2]: a fan over each boundary loop, exact and much
// smaller.
struct WindingNumber::Tree {
    struct Node {
        Box box;
        Index first = 0;  // of triangles
        Index count = 0;
        Index right = none;     // the left child is the next node; none at a leaf
        Index loops_first = 0;  // of loops
        Index loops_count = 0;  // entries of loops
    };

    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
    std::vector<Index> loops;  // vertices of one closed loop after the other, each loop followed by none
    std::vector<Node> nodes;
    std::vector<Vec3> centres;  // of triangles, while building

    void number_by_place(std::span<const Vec3> positions, std::span<const Triangle> faces);
    std::vector<ChainEdge> build(std::vector<Index>& order, Index first, Index count);
    std::vector<ChainEdge> build_leaf(std::vector<Index>& order, Index first, Index count) const;
    void split(std::vector<Index>& order, const Node& node, Index half) const;
    void add_loops(Node& node, const std::vector<ChainEdge>& chain);
    void sum_node(AngleSum& sum, Index index, Vec3 p) const;
    void sum_loops(AngleSum& sum, const Node& node, Vec3 p) const;
};

// Numbers vertices by place and sorts the triangles, so that neither the input's order nor its welding shows.
void WindingNumber::Tree::number_by_place(std::span<const Vec3> positions, std::span<const Triangle> faces) {
    std::vector<Vec3> used;
    used.reserve(faces.size() * 3);
    for (const Triangle& face : faces) {
        for (const Index v : face) used.push_back(positions[v]);
    }
    vertices = used;
    std::sort(vertices.begin(), vertices.end(), lexicographic_less<double>);
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    const auto number = [&](Vec3 p) {
        const auto found = std::lower_bound(vertices.begin(), vertices.end(), p, lexicographic_less<double>);
        return static_cast<Index>(found - vertices.begin());
    };
    for (std::size_t f = 0; f < faces.size(); ++f) {
        Triangle face{number(used[3 * f]), number(used[3 * f + 1]), number(used[3 * f + 2])};
        if (face[0] == face[1] || face[1] == face[2] || face[2] == face[0]) continue;
        std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
        triangles.push_back(face);
    }
    std::sort(triangles.begin(), triangles.end());
    for (const Triangle& t : triangles) centres.push_back(vertices[t[0]] + vertices[t[1]] + vertices[t[2]]);
}

std::vector<ChainEdge> WindingNumber::Tree::build_leaf(std::vector<Index>& order, Index first, Index count) const {
    std::sort(order.begin() + first, order.begin() + first + count);
    std::vector<ChainEdge> chain;
    for (Index i = first; i < first + count; ++i) {
        const Triangle& t = triangles[order[i]];
        for (int corner = 0; corner < 3; ++corner) {
            const Index from = t[corner];
            const Index to = t[(corner + 1) % 3];
            chain.push_back({std::min(from, to), std::max(from, to), from < to ? 1 : -1});
        }
    }
    std::sort(chain.begin(), chain.end(), chain_less);
    drop_cancelled(chain);
    return chain;
}

void WindingNumber::Tree::split(std::vector<Index>& order, const Node& node, Index half) const {
    const Vec3 size = node.box.high - node.box.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const auto begin = order.begin() + node.first;
    std::nth_element(begin, begin + half, begin + node.count, [&](Index a, Index b) {
        return centres[a][axis] != centres[b][axis] ? centres[a][axis] < centres[b][axis] : a < b;
    });
}

// Returns the boundary of the node's triangles.
std::vector<ChainEdge> WindingNumber::Tree::build(std::vector<Index>& order, Index first, Index count) {
    const auto index = static_cast<Index>(nodes.size());
    Node node;
    node.first = first;
    node.count = count;
    for (Index i = first; i < first + count; ++i) {
        for (const Index v : triangles[order[i]]) node.box.add(vertices[v]);
    }
    nodes.push_back(node);
    std::vector<ChainEdge> chain;
    if (count <= leaf_size) {
        chain = build_leaf(order, first, count);
    } else {
        const Index half = count / 2;
        split(order, node, half);
        const std::vector<ChainEdge> left = build(order, first, half);
        node.right = static_cast<Index>(nodes.size());
        const std::vector<ChainEdge> right = build(order, first + half, count - half);
        chain.resize(left.size() + right.size());
        std::merge(left.begin(), left.end(), right.begin(), right.end(), chain.begin(), chain_less);
        drop_cancelled(chain);
    }
    add_loops(node, chain);
    nodes[index] = node;
    return chain;
}

// A boundary enters every vertex as often as it leaves it, so walking along unused edges always comes back to the
// start.
void WindingNumber::Tree::add_loops(Node& node, const std::vector<ChainEdge>& chain) {
    std::vector<Edge> steps;
    for (const ChainEdge& edge : chain) {
        const Edge step = edge.times > 0 ? Edge{edge.low, edge.high} : Edge{edge.high, edge.low};
        steps.insert(steps.end(), static_cast<std::size_t>(std::abs(edge.times)), step);
    }
    std::sort(steps.begin(), steps.end());
    std::vector<std::uint8_t> is_used(steps.size(), 0);
    node.loops_first = static_cast<Index>(loops.size());
    for (std::size_t start = 0; start < steps.size(); ++start) {
        if (is_used[start]) continue;
        for (std::size_t at = start; at < steps.size();) {
            is_used[at] = 1;
            loops.push_back(steps[at][0]);
            const Index next = steps[at][1];
            at = static_cast<std::size_t>(std::lower_bound(steps.begin(), steps.end(), Edge{next, 0}) - steps.begin());
            while (at < steps.size() && steps[at][0] == next && is_used[at]) ++at;
            if (at < steps.size() && steps[at][0] != next) break;
        }
        loops.push_back(none);
    }
    node.loops_count = static_cast<Index>(loops.size()) - node.loops_first;
}

void WindingNumber::Tree::sum_loops(AngleSum& sum, const Node& node, Vec3 p) const {
    const Index end = node.loops_first + node.loops_count;
    for (Index i = node.loops_first; i < end; ++i) {
        const Ray apex(vertices[loops[i]], p);
        Ray last(vertices[loops[++i]], p);
        double last_on_apex = dot(apex.to, last.to);
        for (++i; loops[i] != none; ++i) {
            const Ray next(vertices[loops[i]], p);
            const double next_on_apex = dot(apex.to, next.to);
            const double real = apex.distance * (last.distance * next.distance + dot(last.to, next.to)) +
                                last_on_apex * next.distance + next_on_apex * last.distance;
            sum.add(real, dot(apex.to, cross(last.to, next.to)));
            last = next;
            last_on_apex = next_on_apex;
        }
    }
}

void WindingNumber::Tree::sum_node(AngleSum& sum, Index index, Vec3 p) const {
    const Node& node = nodes[index];
    const bool outside = p.x < node.box.low.x || p.y < node.box.low.y || p.z < node.box.low.z ||
                         p.x > node.box.high.x || p.y > node.box.high.y || p.z > node.box.high.z;
    if (outside && node.loops_count <= 2 * node.count) return sum_loops(sum, node, p);
    if (node.right != none) {
        sum_node(sum, index + 1, p);
        sum_node(sum, node.right, p);
        return;
    }
    for (Index i = node.first; i < node.first + node.count; ++i) {
        const Triangle& t = triangles[i];
        add_triangle(sum, Ray(vertices[t[0]], p), Ray(vertices[t[1]], p), Ray(vertices[t[2]], p));
    }
}

WindingNumber::WindingNumber(std::span<const Vec3> positions, std::span<const Triangle> triangles)
    : tree_(std::make_unique<Tree>()) {
    tree_->number_by_place(positions, triangles);
    std::vector<Index> order(tree_->triangles.size());
    std::iota(order.begin(), order.end(), Index{0});
    if (order.empty()) return;
    tree_->build(order, 0, static_cast<Index>(order.size()));
    std::vector<Triangle> sorted;
    sorted.reserve(order.size());
    for (const Index t : order) sorted.push_back(tree_->triangles[t]);
    tree_->triangles = std::move(sorted);
    tree_->centres = {};
}

WindingNumber::~WindingNumber() = default;
WindingNumber::WindingNumber(WindingNumber&&) noexcept = default;
WindingNumber& WindingNumber::operator=(WindingNumber&&) noexcept = default;

double WindingNumber::at(Vec3 p) const {
    AngleSum sum;
    if (!tree_->nodes.empty()) tree_->sum_node(sum, 0, p);
    return sum.fraction();
}

}
