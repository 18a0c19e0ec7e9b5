// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/winding_number.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/boundary_loops.h"
#include "geometry/bvh.h"
#include "geometry/hole_closure.h"
#include "geometry/predicates.h"
#include "geometry/triangle_contact.h"

namespace crumple {

namespace {

// On a surface the winding number is one half to rounding: without a margin noise would decide there.
constexpr double enclosing = 0.5 + 1e-9;

// A ray along one axis, seen along it: u and v are the other two, so that u, v, axis is a right-handed turn.
struct Ray {
    Vec3 from;
    int axis = 0;
    bool is_forward = true;
    int u = 1;
    int v = 2;
};

// The nearest way out of the box has the fewest triangles in it.
Ray shortest_ray(const Box& box, Vec3 p) {
    Ray ray{p};
    double shortest = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const double size = box.high[axis] - box.low[axis];
        for (const bool is_forward : {true, false}) {
            const double way = (is_forward ? box.high[axis] - p[axis] : p[axis] - box.low[axis]) / size;
            if (!(way < shortest)) continue;
            shortest = way;
            ray = {p, axis, is_forward, (axis + 1) % 3, (axis + 2) % 3};
        }
    }
    return ray;
}

// Sign of the turn from a over b to the ray, exact.
int turn(const Ray& ray, Vec3 a, Vec3 b) {
    const auto [u, v] = std::pair(ray.u, ray.v);
    const double left = (a[u] - ray.from[u]) * (b[v] - ray.from[v]);
    const double right = (a[v] - ray.from[v]) * (b[u] - ray.from[u]);
    const double turn = left - right;
    // Differences, products and one subtraction, each rounded: 4 * 2^-53 of the magnitudes [Shewchuk 1997,
    // ccwerrboundA].
    const double bound = 4.5e-16 * (std::fabs(left) + std::fabs(right)) + 1e-300;
    if (turn > bound) return 1;
    if (turn < -bound) return -1;
    const Vec3 p{ray.from[u], ray.from[v], 0};
    return orient3d({a[u], a[v], 0}, {b[u], b[v], 0}, p, p + Vec3{0, 0, 1});
}

// +1 where the ray passes through the triangle from its back, -1 from its front, 0 where it misses. An edge is passed
// where low end <= ray < high end and the ray lies to its left: the two triangles of an edge always agree, so a ray
// through an edge or a corner counts as if it were moved aside a little.
int passage(const Ray& ray, const Vec3* corners) {
    int turns = 0;
    const double height = ray.from[ray.v];
    for (int i = 0; i < 3; ++i) {
        const Vec3& a = corners[i];
        const Vec3& b = corners[(i + 1) % 3];
        if (a[ray.v] <= height) {
            if (b[ray.v] > height && turn(ray, a, b) > 0) ++turns;
        } else if (b[ray.v] <= height && turn(ray, a, b) < 0) {
            --turns;
        }
    }
    return turns;
}

}

struct WindingNumber::Surface {
    std::vector<Vec3> vertices;                  // in lexicographic order, each place once
    std::vector<std::array<Vec3, 3>> triangles;  // closed: the surface and then what closes it, turned round
    Index own_count = 0;                         // of the surface itself
    HoleClosure closure;
    Bvh tree;  // over triangles
    Box box;

    std::vector<Triangle> number_by_place(std::span<const Vec3> positions, std::span<const Triangle> faces);
    void close(std::span<const Triangle> faces);
    [[nodiscard]] double count_along_ray(Vec3 p) const;
    [[nodiscard]] double whole_at(Vec3 p) const { return box.holds(p) ? count_along_ray(p) : 0; }
};

// Numbers vertices by place and sorts the triangles, so that neither the input's order nor its welding shows.
std::vector<Triangle> WindingNumber::Surface::number_by_place(std::span<const Vec3> positions,
                                                              std::span<const Triangle> faces) {
    for (const Triangle& face : faces) {
        for (const Index v : face) vertices.push_back(positions[v]);
    }
    const std::vector<Vec3> used = vertices;
    std::sort(vertices.begin(), vertices.end(), lexicographic_less<double>);
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    const auto number = [&](Vec3 p) {
        const auto found = std::lower_bound(vertices.begin(), vertices.end(), p, lexicographic_less<double>);
        return static_cast<Index>(found - vertices.begin());
    };
    std::vector<Triangle> numbered;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        Triangle face{number(used[3 * f]), number(used[3 * f + 1]), number(used[3 * f + 2])};
        if (face[0] == face[1] || face[1] == face[2] || face[2] == face[0]) continue;
        std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
        numbered.push_back(face);
    }
    std::sort(numbered.begin(), numbered.end());
    return numbered;
}

void WindingNumber::Surface::close(std::span<const Triangle> faces) {
    for (const auto& [a, b, c] : faces) triangles.push_back({vertices[a], vertices[b], vertices[c]});
    own_count = static_cast<Index>(triangles.size());
    std::vector<std::vector<Vec3>> rims;
    for (const std::vector<Index>& loop : boundary_loops(faces)) {
        rims.emplace_back();
        for (const Index v : loop) rims.back().push_back(vertices[v]);
    }
    closure = HoleClosure(rims);
    for (const auto& [a, b, c] : closure.triangles()) triangles.push_back({a, c, b});
    std::vector<Box> boxes;
    boxes.reserve(triangles.size());
    for (const auto& corners : triangles) boxes.push_back(bounding_box(corners));
    tree = Bvh(boxes);
    box = bounding_box(vertices);
}

// Passages ahead of p; backwards, where as many lie behind as ahead, those behind with the other sign. A triangle that
// holds p counts half.
double WindingNumber::Surface::count_along_ray(Vec3 p) const {
    const Ray ray = shortest_ray(box, p);
    int halves = 0;
    tree.on_ray(p, ray.axis, ray.is_forward, [&](Index t) {
        const int passes = passage(ray, triangles[t].data());
        if (passes == 0) return false;
        const int side = passes * orient3d(triangles[t][0], triangles[t][1], triangles[t][2], p);
        if (side == 0) halves += ray.is_forward ? passes : -passes;
        if (side < 0 && ray.is_forward) halves += 2 * passes;
        if (side > 0 && !ray.is_forward) halves -= 2 * passes;
        return false;
    });
    return halves * 0.5;
}

WindingNumber::WindingNumber(std::span<const Vec3> positions, std::span<const Triangle> triangles)
    : surface_(std::make_unique<Surface>()) {
    surface_->close(surface_->number_by_place(positions, triangles));
}

WindingNumber::~WindingNumber() = default;
WindingNumber::WindingNumber(WindingNumber&&) noexcept = default;
WindingNumber& WindingNumber::operator=(WindingNumber&&) noexcept = default;

double WindingNumber::at(Vec3 p, double tolerance) const {
    const double whole = surface_->whole_at(p);
    return surface_->closure.empty() ? whole : whole + surface_->closure.share(p, tolerance);
}

bool WindingNumber::encloses(Vec3 p) const {
    const double whole = surface_->whole_at(p);
    if (surface_->closure.empty()) return std::fabs(whole) > enclosing;
    for (const double tolerance : {0.2, 0.02, 0.002}) {
        const double roughly = std::fabs(whole + surface_->closure.share(p, tolerance));
        if (std::fabs(roughly - enclosing) > tolerance + 1e-9) return roughly > enclosing;
    }
    return std::fabs(whole + surface_->closure.share(p)) > enclosing;
}

bool WindingNumber::is_on_surface(Vec3 p) const {
    bool is_on = false;
    surface_->tree.containing(p, [&](Index t) {
        is_on = t < surface_->own_count && is_on_triangle(surface_->triangles[t], p);
        return is_on;
    });
    return is_on;
}

}
