// SPDX-License-Identifier: MIT
#include "solver/contact.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace crumple::solver {
namespace {

// Of any length: squares of what lies near the ends of the range of double are 0 or infinite.
Vec3 direction_of(Vec3 axis) {
    const double largest = std::max({std::abs(axis.x), std::abs(axis.y), std::abs(axis.z)});
    if (!(largest > 0)) return {0, 1, 0};
    if (largest < 1e-150 || largest > 1e150) axis = axis / largest;
    return axis / length(axis);
}

SurfacePoint from_centre(Vec3 away, double radius, Vec3 fallback) {
    const double size = length(away);
    return size > 0 ? SurfacePoint{size - radius, away / size} : SurfacePoint{-radius, fallback};
}

SurfacePoint capsule_surface(const Obstacle& o, Vec3 point) {
    const Vec3 from = point - o.position;
    const double squared = dot(o.axis, o.axis);
    const double along = squared > 0 ? std::clamp(dot(from, o.axis) / squared, -1.0, 1.0) : 0;
    const Vec3 aside = std::abs(o.axis.x) < std::abs(o.axis.y) ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    return from_centre(from - o.axis * along, o.radius, aside);
}

SurfacePoint box_surface(const Obstacle& o, const Frame& frame, Vec3 point) {
    const Vec3 p = widen(frame.point(point));
    Vec3 clamped;
    double depth = 1e300;
    int nearest = 0;
    for (int i = 0; i < 3; ++i) {
        clamped[i] = std::clamp(p[i], -o.axis[i], o.axis[i]);
        const double to_side = o.axis[i] - std::abs(p[i]);
        if (to_side < depth) {
            depth = to_side;
            nearest = i;
        }
    }
    Vec3 side;
    side[nearest] = p[nearest] < 0 ? -1 : 1;
    const SurfacePoint inside{-depth - o.radius, side};
    const SurfacePoint local = depth > 0 ? inside : from_centre(p - clamped, o.radius, side);
    return {local.distance, frame.to_world(local.normal)};
}

// An obstacle, with what is the same for all points worked out.
class Surface {
public:
    explicit Surface(const Obstacle& o) : obstacle_(o) {
        if (o.shape == ObstacleShape::plane) normal_ = direction_of(o.axis);
        if (o.shape != ObstacleShape::box) return;
        pose_.position = o.position;
        pose_.orientation = o.orientation;
        frame_.emplace(pose_);
    }
    Surface(const Surface&) = delete;
    Surface& operator=(const Surface&) = delete;

    [[nodiscard]] SurfacePoint nearest(Vec3 point) const {
        if (obstacle_.shape == ObstacleShape::capsule) return capsule_surface(obstacle_, point);
        if (frame_) return box_surface(obstacle_, *frame_, point);
        return {dot(point - obstacle_.position, normal_) - obstacle_.radius, normal_};
    }

private:
    const Obstacle& obstacle_;
    CarrierMotion pose_;
    std::optional<Frame> frame_;  // of a box, at pose_
    Vec3 normal_;                 // of a plane
};

// The velocity along the normal that the node leaves with, relative to the surface; false when it does not touch.
// `gains` is what the approach will gain in this step.
bool leaving_speed(double distance, float approach, float gains, float restitution, float dt, float& leaves) {
    const auto gap = static_cast<float>(distance);
    const float allowed = gap >= 0 ? -gap / dt : std::min(-gap * push_out_part / dt, push_out_speed);
    // What is inside stays watched on its way out: let go, it may spring back within the step.
    if (gap > 0 && approach + gains >= allowed) return false;
    const bool rebounds = -approach > rebound_from && restitution > 0;
    leaves = rebounds ? std::max(-restitution * approach, allowed) : allowed;
    return true;
}

// Weights of a point over the corners of a tet, moved inside.
std::array<float, 4> weights_in(const Model& model, const State& state, std::size_t tet, Vec3f point) {
    const Tet& t = model.bundle.tets[tet];
    const Vec3f x0 = position(state, t[0]);
    const Mat3 edges =
        Mat3::from_columns(position(state, t[1]) - x0, position(state, t[2]) - x0, position(state, t[3]) - x0);
    const float det = determinant(edges);
    std::array<float, 4> weights{0.25f, 0.25f, 0.25f, 0.25f};
    if (!(det > 0)) return weights;
    const Vec3f w = (transpose(cofactor(edges)) * (point - x0)) / det;
    weights = {1 - w.x - w.y - w.z, w.x, w.y, w.z};
    float sum = 0;
    for (float& weight : weights) {
        weight = std::max(weight, 0.0f);
        sum += weight;
    }
    for (float& weight : weights) weight /= sum;
    return weights;
}

Index nearest_node(const Model& model, const State& state, Vec3f point) {
    Index nearest = 0;
    float least = 3e38f;
    for (Index node = 0; node < model.node_count; ++node) {
        const Vec3f d = position(state, node) - point;
        if (dot(d, d) < least && model.node_start[node] < model.node_start[node + 1]) {
            least = dot(d, d);
            nearest = node;
        }
    }
    return nearest;
}

// Finds contacts and writes them down.
struct Contacts {
    const Model& model;
    const Frame& frame;
    std::span<const Obstacle> obstacles;
    float dt;
    std::span<std::uint8_t> is_taken;
    std::span<float> clearance;
    std::span<Constraint> room;
    ContactCounts counts;

    // The contact of a point of the body with the obstacle it is deepest in.
    bool touches(Vec3f x, Vec3f velocity, Vec3f falls, Constraint& contact, bool has_to_be_inside = false) const {
        const Vec3 place = frame.point_to_world(x);
        double deepest = 1e300;
        for (const Obstacle& o : obstacles) {
            const SurfacePoint surface = nearest_surface(o, place);
            if (surface.distance >= deepest || (has_to_be_inside && surface.distance >= 0)) continue;
            const Vec3f normal = frame.vector(surface.normal);
            const Vec3f v = frame.velocity(place, o.velocity + cross(o.angular_velocity, place - o.position));
            float leaves = 0;
            const float approach = dot(velocity - v, normal);
            const float gains = std::min(0.0f, dot(falls, normal));
            if (!leaving_speed(surface.distance, approach, gains, o.restitution, dt, leaves)) continue;
            deepest = surface.distance;
            contact = {none, ConstraintKind::contact, v + normal * leaves, normal, {}};
        }
        return deepest < 1e300;
    }
    // How far each node may be wrong about where it is and still touch nothing in this step.
    void find_clearances(const State& state) const {
        std::fill(clearance.begin(), clearance.end(), 3e38f);
        for (const Obstacle& o : obstacles) {
            const Surface surface(o);
            for (std::size_t node = 0; node < clearance.size(); ++node) {
                const Vec3 place = frame.point_to_world(position(state, node));
                const Vec3 of_surface = o.velocity + cross(o.angular_velocity, place - o.position);
                const float way = length(velocity(state, node) - frame.velocity(place, of_surface)) * dt;
                const float distance = static_cast<float>(surface.nearest(place).distance);
                clearance[node] = std::min(clearance[node], distance - way);
            }
        }
    }
    void hold(Index node, Constraint contact) {
        contact.node = node;
        is_taken[node] = 1;
        if (counts.found < room.size()) room[counts.written++] = contact;
        ++counts.found;
    }
};

// Places of a face between its nodes, as weights of its corners.
constexpr float between_nodes[4][3] = {
    {1.0f / 3, 1.0f / 3, 1.0f / 3}, {0.5f, 0.5f, 0}, {0, 0.5f, 0.5f}, {0.5f, 0, 0.5f}};

void hold_face(Contacts& contacts, const State& state, const Tet& tet, std::size_t opposite) {
    Index nodes[3];
    Vec3f places[3], velocities[3];
    float clearance = 3e38f;
    for (std::size_t i = 0; i < 3; ++i) {
        nodes[i] = tet[(opposite + 1 + i) % 4];
        places[i] = position(state, nodes[i]);
        velocities[i] = velocity(state, nodes[i]);
        clearance = std::min(clearance, contacts.clearance[nodes[i]]);
    }
    // Distances change by no more than the way, and of velocities that are affine the fastest is at a corner.
    const Vec3f edges[3] = {places[1] - places[0], places[2] - places[1], places[0] - places[2]};
    const float size_squared = std::max({dot(edges[0], edges[0]), dot(edges[1], edges[1]), dot(edges[2], edges[2])});
    if (clearance > 0 && clearance * clearance > 1.01f * size_squared) return;
    // Beside a node that touches, a face is only on its way there.
    const bool is_on_its_way = std::any_of(nodes, nodes + 3, [&](Index node) { return contacts.is_taken[node]; });
    const auto may_hold = [&](Index node) { return !contacts.model.bundle.locked[node] && !contacts.is_taken[node]; };
    for (const auto& weights : between_nodes) {
        Vec3f x, v;
        for (std::size_t i = 0; i < 3; ++i) {
            x += places[i] * weights[i];
            v += velocities[i] * weights[i];
        }
        Constraint contact;
        if (!contacts.touches(x, v, {}, contact, is_on_its_way)) continue;
        for (std::size_t i = 0; i < 3; ++i) {
            if (weights[i] > 0 && may_hold(nodes[i])) contacts.hold(nodes[i], contact);
        }
    }
}

}

SurfacePoint nearest_surface(const Obstacle& o, Vec3 point) { return Surface(o).nearest(point); }

ContactCounts find_contacts(const Model& model, const State& state, const Frame& frame,
                            std::span<const Obstacle> obstacles, Vec3f pull, float dt, std::span<std::uint8_t> is_taken,
                            std::span<float> clearance, std::span<Constraint> room) {
    Contacts contacts{model, frame, obstacles, dt, is_taken, clearance, room, {}};
    if (obstacles.empty()) return contacts.counts;
    contacts.find_clearances(state);
    const float falls = 1.01f * length(pull) * dt * dt;
    for (Index node = 0; node < model.node_count; ++node) {
        if (clearance[node] > falls || model.bundle.locked[node] || is_taken[node]) continue;
        Constraint contact;
        if (contacts.touches(position(state, node), velocity(state, node), pull * dt, contact))
            contacts.hold(node, contact);
    }
    for (std::size_t tet = 0; tet < model.tet_count; ++tet) {
        const unsigned boundary = model.packets[tet / packet_size].boundary[tet % packet_size];
        for (std::size_t corner = 0; boundary >> corner != 0; ++corner) {
            if (boundary >> corner & 1u) hold_face(contacts, state, model.bundle.tets[tet], corner);
        }
    }
    return contacts.counts;
}

void strike(const Model& model, State& state, Vec3f point, Vec3f momentum) {
    const Index node = nearest_node(model, state, point);
    std::array<float, 4> best{};
    std::size_t best_tet = model.tet_count;
    float least = 3e38f;
    for (Index k = model.node_start[node]; k < model.node_start[node + 1]; ++k) {
        const std::size_t tet = model.node_corner[k] / 4;
        const auto weights = weights_in(model, state, tet, point);
        Vec3f place;
        for (std::size_t i = 0; i < 4; ++i) place += position(state, model.bundle.tets[tet][i]) * weights[i];
        if (length(place - point) < least) {
            least = length(place - point);
            best = weights;
            best_tet = tet;
        }
    }
    if (best_tet == model.tet_count) return;
    for (std::size_t i = 0; i < 4; ++i) {
        const Index corner = model.bundle.tets[best_tet][i];
        if (model.bundle.locked[corner]) continue;
        set_velocity(state, corner, velocity(state, corner) + momentum * (best[i] / model.bundle.mass[corner]));
    }
}

}
