// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/winding_number.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/boundary_loops.h"
#include "geometry/bvh.h"
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
    std::vector<std::array<Vec3, 3>> triangles;  // closed: the surface and the fans, those turned round
    std::vector<std::array<Vec3, 3>> fans;       // with the boundary of the surface
    Bvh tree;                                    // over triangles
    Box box;

    std::vector<Triangle> number_by_place(std::span<const Vec3> positions, std::span<const Triangle> faces);
    void close(std::span<const Triangle> faces);
    [[nodiscard]] double count_along_ray(Vec3 p) const;
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
    for (const std::vector<Index>& loop : boundary_loops(faces)) {
        for (std::size_t i = 2; i < loop.size(); ++i) {
            const Vec3 apex = vertices[loop[0]];
            fans.push_back({apex, vertices[loop[i - 1]], vertices[loop[i]]});
            triangles.push_back({apex, vertices[loop[i]], vertices[loop[i - 1]]});
        }
    }
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

double WindingNumber::at(Vec3 p) const {
    const Box& box = surface_->box;
    const bool is_within = p.x >= box.low.x && p.y >= box.low.y && p.z >= box.low.z && p.x <= box.high.x &&
                           p.y <= box.high.y && p.z <= box.high.z;
    const double whole = is_within ? surface_->count_along_ray(p) : 0;
    if (surface_->fans.empty()) return whole;
    AngleSum sum;
    for (const auto& [a, b, c] : surface_->fans) add_triangle(sum, a, b, c, p);
    return whole + sum.fraction();
}

}
