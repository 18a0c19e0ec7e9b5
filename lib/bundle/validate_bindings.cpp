// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "bundle/exact_volume.h"
#include "bundle/validate_parts.h"

namespace crumple {
namespace {

constexpr double weight_sum_tolerance = 1e-5;  // of the sum of the weights' sizes: float rounding of four numbers
constexpr double frame_tolerance = 1e-5;       // of a rotation matrix, and of the size of a sensor's cluster

template <class Named>
void check_names(const std::vector<Named>& items, Complaints& complaints) {
    std::vector<std::string_view> names;
    for (const Named& item : items) names.push_back(item.name);
    std::sort(names.begin(), names.end());
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (names[i].empty() || (i > 0 && names[i] == names[i - 1])) {
            complaints.add("BUNDLE_NAME", "a name is empty or used twice", none, no_place, names[i]);
        }
    }
}

// Weights are quotients of volumes computed in double: rounding is a few 1e-16 of the cube of the tet's size. Then they
// are rounded to float.
double inside_tolerance(const Bundle& b, const Tet& tet) {
    const Vec3f origin = b.rest_positions[tet[0]];
    double size = 0;
    for (std::size_t corner = 1; corner < 4; ++corner) {
        size = std::max(size, static_cast<double>(length(b.rest_positions[tet[corner]] - origin)));
    }
    const double volume =
        six_volumes(origin, b.rest_positions[tet[1]], b.rest_positions[tet[2]], b.rest_positions[tet[3]]);
    return 1e-6 + 1e-14 * size * size * size / volume;
}

// The flag says what the weights say, but for rounding.
bool is_flag_true(const Bundle& b, const BundleVisual& visual, std::size_t v, float least) {
    const bool seems_inside = least >= 0;
    if (seems_inside == (visual.inside[v] != 0)) return true;
    return std::fabs(least) <= inside_tolerance(b, b.tets[visual.tet[v]]);
}

void check_vertex(const Bundle& b, const BundleVisual& visual, std::size_t v, Complaints& complaints) {
    const std::array<float, 4>& weights = visual.barycentric[v];
    double sum = 0;
    double size = 0;
    for (const float w : weights) {
        sum += w;
        size += std::fabs(w);
    }
    const auto complain = [&](const char* message) {
        complaints.add("BUNDLE_BINDING", message, static_cast<Index>(v), no_place, visual.name);
    };
    if (!(std::fabs(sum - 1) <= weight_sum_tolerance * size))
        complain("the weights of a visual vertex do not sum to 1");
    if (visual.distance[v] < 0 || (visual.inside[v] && visual.distance[v] != 0))
        complain("a visual vertex is inside at a distance, or at a negative one");
    if (!is_flag_true(b, visual, v, *std::min_element(weights.begin(), weights.end()))) {
        complain(visual.inside[v] ? "a visual vertex is called inside but has a negative weight"
                                  : "a visual vertex is called outside but has no negative weight");
    }
}

// Every vertex once, under its own tet, ascending.
void check_inverse_table(const Bundle& b, const BundleVisual& visual, Complaints& complaints) {
    for (std::size_t t = 0; t < b.tets.size(); ++t) {
        for (Index k = visual.tet_start[t]; k < visual.tet_start[t + 1]; ++k) {
            const Index vertex = visual.vertices_by_tet[k];
            const bool ascends = k == visual.tet_start[t] || visual.vertices_by_tet[k - 1] < vertex;
            if (visual.tet[vertex] != t || !ascends) {
                complaints.add("BUNDLE_BINDING", "vertices_by_tet and tet disagree", vertex, no_place, visual.name);
            }
        }
    }
}

bool is_rotation(const std::array<float, 9>& m) {
    const auto row = [&](std::size_t i) { return Vec3{m[3 * i], m[3 * i + 1], m[3 * i + 2]}; };
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            if (!(std::fabs(dot(row(i), row(j)) - (i == j ? 1 : 0)) <= frame_tolerance)) return false;
        }
    }
    return dot(row(0), cross(row(1), row(2))) > 0;
}

void check_weights(const BundleSensor& sensor, Complaints& complaints) {
    double sum = 0;
    for (std::size_t k = 0; k < sensor.node.size(); ++k) {
        sum += sensor.weight[k];
        if (!(sensor.weight[k] > 0) || (k > 0 && sensor.node[k - 1] >= sensor.node[k])) {
            complaints.add("BUNDLE_SENSOR", "a sensor's nodes do not ascend or a weight is not positive",
                           sensor.node[k], no_place, sensor.name);
        }
    }
    if (!(std::fabs(sum - 1) <= weight_sum_tolerance)) {
        complaints.add("BUNDLE_SENSOR", "a sensor's weights do not sum to 1", none, no_place, sensor.name);
    }
}

void check_frame(const Bundle& b, const BundleSensor& sensor, Complaints& complaints) {
    Vec3 centre;
    double reach = 0;
    for (std::size_t k = 0; k < sensor.node.size(); ++k) {
        const Vec3f p = b.rest_positions[sensor.node[k]];
        centre += Vec3{p.x, p.y, p.z} * static_cast<double>(sensor.weight[k]);
        reach = std::max({reach, std::fabs(double{p.x}), std::fabs(double{p.y}), std::fabs(double{p.z})});
    }
    const Vec3f origin = sensor.rest_origin;
    if (!(length(centre - Vec3{origin.x, origin.y, origin.z}) <= frame_tolerance * reach) ||
        !is_rotation(sensor.rest_axes)) {
        complaints.add("BUNDLE_SENSOR", "a sensor's rest frame is not a rotation at the centre of its nodes", none,
                       origin, sensor.name);
    }
}

}

void check_visuals(const Bundle& b, Complaints& complaints) {
    check_names(b.visuals, complaints);
    for (const BundleVisual& visual : b.visuals) {
        for (std::size_t v = 0; v < visual.tet.size(); ++v) check_vertex(b, visual, v, complaints);
        check_inverse_table(b, visual, complaints);
    }
}

void check_sensors(const Bundle& b, Complaints& complaints) {
    check_names(b.sensors, complaints);
    for (const BundleSensor& sensor : b.sensors) {
        check_weights(sensor, complaints);
        check_frame(b, sensor, complaints);
    }
}

}
