// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/shell_limits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/parallel_for.h"
#include "geometry/bvh.h"
#include "geometry/measures.h"
#include "geometry/surface_distance.h"
#include "quality/tet_measures.h"

namespace crumple::quality {

namespace {

constexpr double reached = 0.9;         // of what thinness allows
constexpr double needle_reached = 0.5;  // of the needle's corner: a tet's angle over it is often half of it

// Of an edge: no mesh is good between surfaces this near, whatever else is wrong with it.
constexpr double hardly_apart = 1e-3;

double degrees(double radians) { return radians * (180 / std::numbers::pi); }

// Of an acute angle; the same bound as everybody's where it is 10 degrees.
AngleKey key_of(double degrees) {
    if (degrees == bad_angle_deg) return key_of_10_deg;
    const double sine = std::sin(degrees * (std::numbers::pi / 180));
    return sine * sine;
}

// Which triangles use a node, as one list and where each node's part starts.
struct Fans {
    std::vector<Index> start;
    std::vector<Index> triangle;

    Fans(std::size_t node_count, std::span<const Triangle> triangles) : start(node_count + 1, 0) {
        for (const Triangle& corners : triangles) {
            for (const Index v : corners) ++start[v + 1];
        }
        for (std::size_t v = 0; v < node_count; ++v) start[v + 1] += start[v];
        triangle.resize(start.back());
        std::vector<Index> end(start.begin(), start.end() - 1);
        for (Index f = 0; f < triangles.size(); ++f) {
            for (const Index v : triangles[f]) triangle[end[v]++] = f;
        }
    }

    [[nodiscard]] std::span<const Index> around(Index v) const {
        if (v + 1 >= start.size()) return {};
        return {triangle.data() + start[v], triangle.data() + start[v + 1]};
    }
};

class Places {
public:
    explicit Places(const Surface& surface)
        : surface_(surface),
          distance_(surface.positions, surface.triangles),
          tree_(tree_of(surface.positions, surface.triangles)),
          fans_(surface.positions.size(), surface.triangles),
          diagonal_(bounding_box(surface.positions).diagonal()),
          thickness_(surface.triangles.size(), 0),
          clearance_(surface.triangles.size(), 0) {}

    // To be called with the tets that will be asked for: what is thick there is measured once a triangle.
    void prepare(std::span<const Tet> tets, std::span<const Index> asked, const Context& context) {
        std::vector<Index> near;
        for (const Index t : asked) {
            for (const Index v : tets[t]) {
                const std::span<const Index> fan = fans_.around(v);
                near.insert(near.end(), fan.begin(), fan.end());
            }
        }
        std::sort(near.begin(), near.end());
        near.erase(std::unique(near.begin(), near.end()), near.end());
        parallel_for(context, near.size(), 64, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                thickness_[near[i]] = measure_thickness(near[i]);
                clearance_[near[i]] = measure_clearance(near[i]);
            }
        });
    }

    // atan(t / e) around the corners of a tet, degrees; a right angle where there is no surface.
    [[nodiscard]] double thin_limit_deg(const Tet& tet) const {
        return degrees(std::atan(share_of_edge(tet, thickness_)));
    }

    // How near the surface comes to itself around the corners of a tet, in edges: on the whole, and at its nearest.
    [[nodiscard]] double gap(const Tet& tet) const { return share_of_edge(tet, clearance_); }
    [[nodiscard]] double narrowest_gap(const Tet& tet) const {
        double least = std::numeric_limits<double>::infinity();
        for (const Index v : tet) {
            for (const Index f : fans_.around(v)) least = std::min(least, clearance_[f] / longest_edge(f));
        }
        return least;
    }

    // The least corner of the surface triangles among a tet's faces, degrees; 90 when there is none.
    [[nodiscard]] double needle_deg(const Tet& tet) const {
        double least = 90;
        for (const auto& face : tet_face_corners) {
            const Index v = tet[face[0]];
            for (const Index f : fans_.around(v)) {
                if (is_same(surface_.triangles[f], {v, tet[face[1]], tet[face[2]]})) {
                    least = std::min(least, least_corner_deg(corners(f)));
                }
            }
        }
        return least;
    }

private:
    // Of lengths measured on triangles: their mean over the mean edge, infinite where there is no surface.
    [[nodiscard]] double share_of_edge(const Tet& tet, const std::vector<double>& lengths) const {
        double measured = 0;
        double edge = 0;
        for (const Index v : tet) {
            for (const Index f : fans_.around(v)) {
                const std::array<Vec3, 3> at = corners(f);
                const double weight = length(area_vector(at[0], at[1], at[2]));
                measured += weight * lengths[f];
                edge += weight * (length(at[1] - at[0]) + length(at[2] - at[1]) + length(at[0] - at[2])) / 3;
            }
        }
        return edge > 0 ? measured / edge : std::numeric_limits<double>::infinity();
    }

    [[nodiscard]] std::array<Vec3, 3> corners(Index f) const {
        const auto& [a, b, c] = surface_.triangles[f];
        return {surface_.positions[a], surface_.positions[b], surface_.positions[c]};
    }

    static bool is_same(Triangle a, Triangle b) {
        std::sort(a.begin(), a.end());
        std::sort(b.begin(), b.end());
        return a == b;
    }

    static double least_corner_deg(const std::array<Vec3, 3>& at) {
        double least = 90;
        for (int i = 0; i < 3; ++i) {
            const Vec3 u = at[(i + 1) % 3] - at[i];
            const Vec3 v = at[(i + 2) % 3] - at[i];
            least = std::min(least, degrees(std::atan2(length(cross(u, v)), dot(u, v))));
        }
        return least;
    }

    // The shrinking ball [Ma, Bae, Choi 2012, "3D medial axis point approximation using nearest neighbors and the
    // normal field"]: one that touches p from inside is made smaller until nothing of the surface lies within.
    [[nodiscard]] double measure_thickness(Index f) const {
        const std::array<Vec3, 3> at = corners(f);
        const Vec3 normal = area_vector(at[0], at[1], at[2]);
        const double size = length(normal);
        if (!(size > 0)) return 0;
        const Vec3 p = middle_of(f);
        const Vec3 inwards = normal * (-1 / size);
        double radius = diagonal_;
        for (int round = 0; round < 30; ++round) {
            const Vec3 centre = p + inwards * radius;
            const auto closest = distance_.closest(centre, f);
            const Vec3 away = closest.point - p;
            const double along = dot(away, inwards);
            // A surface of its own just behind p is within by little where the ball is large.
            const double touching =
                share_a_corner(surface_.triangles[f], surface_.triangles[closest.triangle]) ? 1e-3 : 1e-9;
            if (!(closest.distance < radius * (1 - touching)) || !(along > 0)) break;
            radius = dot(away, away) / (2 * along);
        }
        return 2 * radius;
    }

    // From the middle of a triangle to the nearest other one that lies before or behind it rather than beside it, its
    // longest edge at most: farther away it forces nothing. Two that face each other have nothing between them.
    [[nodiscard]] double measure_clearance(Index f) const {
        const std::array<Vec3, 3> at = corners(f);
        const Vec3 normal = area_vector(at[0], at[1], at[2]);
        const Vec3 p = middle_of(f);
        const auto distance_2 = [&](Index other) {
            if (share_a_corner(surface_.triangles[f], surface_.triangles[other]))
                return std::numeric_limits<double>::infinity();
            const std::array<Vec3, 3> of = corners(other);
            const Vec3 off = closest_point_on_triangle(of[0], of[1], of[2], p) - p;
            const double square = dot(off, off);
            const double along = dot(off, normal);
            const bool is_beside = along * along < 0.25 * square * dot(normal, normal);
            const bool is_facing = along >= 0 && dot(area_vector(of[0], of[1], of[2]), normal) < 0;
            return is_beside || is_facing ? std::numeric_limits<double>::infinity() : square;
        };
        const double edge = longest_edge(f);
        return std::sqrt(tree_.nearest(p, distance_2, {none, edge * edge}).distance_2);
    }

    [[nodiscard]] double longest_edge(Index f) const {
        const std::array<Vec3, 3> at = corners(f);
        return std::max({length(at[1] - at[0]), length(at[2] - at[1]), length(at[0] - at[2])});
    }

    [[nodiscard]] Vec3 middle_of(Index f) const {
        const std::array<Vec3, 3> at = corners(f);
        return (at[0] + at[1] + at[2]) / 3;
    }

    Surface surface_;
    SurfaceDistance distance_;
    Bvh tree_;
    Fans fans_;
    double diagonal_;
    std::vector<double> thickness_;  // F: the ball's diameter, where measured
    std::vector<double> clearance_;  // F: how near the surface comes to itself, likewise
};

ShellLimit judge(const Places& places, const Tet& tet, double angle_deg, double below_deg) {
    const double thin = places.thin_limit_deg(tet);
    if (reached * thin < below_deg && angle_deg >= reached * thin) return ShellLimit::thin;
    const double needle = places.needle_deg(tet);
    if (needle < below_deg && angle_deg >= needle_reached * needle) return ShellLimit::needle;
    if (places.narrowest_gap(tet) < hardly_apart) return ShellLimit::gap;
    const double gap = degrees(std::atan(places.gap(tet)));
    return reached * gap < below_deg && angle_deg >= reached * gap ? ShellLimit::gap : ShellLimit::none;
}

}

std::vector<ShellLimit> find_limits(const Surface& surface, std::span<const Vec3> positions, std::span<const Tet> tets,
                                    const Context& context, double below_deg) {
    std::vector<ShellLimit> limits(tets.size(), ShellLimit::none);
    const AngleKey below = key_of(below_deg);
    std::vector<Index> bad;
    std::vector<AngleKey> angle;
    for (Index t = 0; t < tets.size(); ++t) {
        const auto& [a, b, c, d] = tets[t];
        const AngleKey key = min_dihedral_key(positions[a], positions[b], positions[c], positions[d]);
        if (!(key > key_of_0_deg) || !(key < below)) continue;
        bad.push_back(t);
        angle.push_back(key);
    }
    if (bad.empty() || surface.triangles.empty()) return limits;
    Places places(surface);
    places.prepare(tets, bad, context);
    for (std::size_t i = 0; i < bad.size(); ++i)
        limits[bad[i]] = judge(places, tets[bad[i]], degrees_of(angle[i]), below_deg);
    return limits;
}

}
