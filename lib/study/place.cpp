// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/place.h"

#include <algorithm>

namespace crumple::study {
namespace {

double distance_to(const solver::Obstacle& obstacle, const Bundle& bundle) {
    double least = 1e300;
    for (const Vec3f p : bundle.rest_positions) least = std::min(least, nearest_surface(obstacle, widen(p)).distance);
    return least;
}

// Backwards along the way it comes until it is `gap` off. Distances change at most as fast as places, so far away a
// step of what is missing never goes too far; the body's box bounds where to begin.
void stand_back(solver::Obstacle& obstacle, const Bundle& bundle, Vec3 way, double gap) {
    const Box box = box_of(bundle);
    const double size = length(box.high - box.low) + gap + obstacle.radius + length(obstacle.axis);
    const Vec3 begin = obstacle.position - way * (2 * size);
    double along = 0;
    for (int i = 0; i < 200 && along < 4 * size; ++i) {
        obstacle.position = begin + way * along;
        const double missing = distance_to(obstacle, bundle) - gap;
        if (missing < 1e-6 * size) return;
        along += missing;
    }
}

std::vector<Vec3f> values_of(const std::vector<Vec3>& values, double scale) {
    std::vector<Vec3f> result;
    for (const Vec3 v : values) result.push_back(narrow(v * scale));
    return result;
}

solver::Spline spline_of(solver::SplineKind kind, const std::vector<float>& times, const std::vector<Vec3f>& values,
                         std::vector<Vec3f>& slopes) {
    if (values.empty()) return {};
    slopes.resize(values.size());
    std::vector<float> scratch(values.size());
    find_slopes(kind, times, values, slopes, scratch);
    return {times, values, slopes};
}

}

Box box_of(const Bundle& bundle) {
    Box box{widen(bundle.rest_positions.front()), widen(bundle.rest_positions.front())};
    for (const Vec3f p : bundle.rest_positions) {
        for (int i = 0; i < 3; ++i) {
            box.low[i] = std::min(box.low[i], static_cast<double>(p[i]));
            box.high[i] = std::max(box.high[i], static_cast<double>(p[i]));
        }
    }
    return box;
}

solver::Obstacle place_obstacle(const SceneObstacle& o, const Bundle& bundle, Vec3 velocity) {
    solver::Obstacle placed;
    placed.shape = o.shape;
    placed.position = box_of(bundle).middle() + o.position;
    placed.axis = o.axis;
    // A plane's axis may have any length, which is no size of it.
    if (o.shape == solver::ObstacleShape::plane) placed.axis = nearest_surface(placed, placed.position).normal;
    placed.radius = o.radius_m;
    placed.velocity = o.velocity;
    placed.restitution = static_cast<float>(o.restitution);
    const Vec3 way = o.velocity - velocity;
    if (o.gap_m >= 0 && length(way) > 0) stand_back(placed, bundle, way / length(way), o.gap_m);
    return placed;
}

PlacedHandle::PlacedHandle(const SceneHandle& scene, const Bundle& bundle)
    : shift(values_of(scene.shift_m, 1)), turn(values_of(scene.turn_deg, 3.14159265358979 / 180)) {
    const Box box = box_of(bundle);
    Vec3 sum;
    for (Index n = 0; n < bundle.rest_positions.size(); ++n) {
        const Vec3 p = widen(bundle.rest_positions[n]);
        bool is_in = true;
        for (int i = 0; i < 3; ++i) {
            const double half = std::max(0.5 * (box.high[i] - box.low[i]), 1e-30);
            const double at = (p[i] - box.middle()[i]) / half;
            is_in = is_in && at >= scene.box_low[i] - 1e-6 && at <= scene.box_high[i] + 1e-6;
        }
        if (!is_in) continue;
        nodes.push_back(n);
        sum += p;
    }
    for (const double t : scene.times_s) times.push_back(static_cast<float>(t));
    if (!nodes.empty()) handle.pivot = narrow(sum / static_cast<double>(nodes.size()));
    handle.nodes = nodes;
    handle.shift = spline_of(scene.spline, times, shift, shift_slopes);
    handle.turn = spline_of(scene.spline, times, turn, turn_slopes);
}

}
