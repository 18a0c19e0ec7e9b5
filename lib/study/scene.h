// SPDX-License-Identifier: GPL-3.0-or-later
// What happens to a bundle: what it runs into, how fast, who pulls at it. Fits any bundle: places of the body are given
// in its box, -1 to 1 from side to side, and obstacles find their distance by themselves.
#pragma once
#include <string>
#include <vector>

#include "core/fields.h"
#include "core/vec3.h"
#include "solver/contact.h"
#include "solver/spline.h"
#include "solver/step.h"

namespace crumple::solver {

inline constexpr EnumName<ObstacleShape> obstacle_shape_names[] = {
    {ObstacleShape::plane, "plane"}, {ObstacleShape::capsule, "capsule"}, {ObstacleShape::box, "box"}};
constexpr std::span<const EnumName<ObstacleShape>> enum_names(ObstacleShape) { return obstacle_shape_names; }

}

namespace crumple::study {

// What a scene may ask for, on each axis. Far beyond any crash, and what comes of it is still well inside a float.
inline constexpr Range any_place{-1e5, 1e5};    // m; m/s^2
inline constexpr Range any_speed{-1e4, 1e4};    // m/s
inline constexpr Range any_turning{-1e6, 1e6};  // degrees, degrees a second
inline constexpr Range any_axis{-1e6, 1e6};

struct SceneObstacle {
    solver::ObstacleShape shape = solver::ObstacleShape::plane;
    Vec3 position;       // metres from the middle of the body's box
    Vec3 axis{0, 1, 0};  // plane: normal out of the solid; capsule: half its length; box: half its edges
    double radius_m = 0;
    Vec3 velocity;
    double restitution = 0;
    double gap_m = -1;  // from 0: it is pushed back along the way it will come until it is this far off
};

template <class Visitor, FieldsOf<SceneObstacle> O>
void describe(Visitor& visit, O& o) {
    visit.field("shape", o.shape, "what it is");
    visit.field("position", o.position, any_place, "metres from the middle of the body's box");
    visit.field("axis", o.axis, any_axis,
                "plane: normal out of the solid, of any length; capsule: half its length; box: half its edges");
    visit.field("radius_m", o.radius_m, Range{0, 1e4}, "of a capsule, a rounding of the others");
    visit.field("velocity", o.velocity, any_speed, "m/s");
    visit.field("restitution", o.restitution, Range{0, 1}, "part of the speed a node rebounds with");
    visit.field("gap_m", o.gap_m, Range{-1, 1e4}, "from 0: it is put this far from the body, on the way it will come");
}

struct SceneHandle {
    Vec3 box_low{-1, -1, -1};  // of the body's box: the nodes inside
    Vec3 box_high{1, 1, 1};
    solver::SplineKind spline = solver::SplineKind::catmull_rom;
    std::vector<double> times_s;
    std::vector<Vec3> shift_m;   // a key each, or none
    std::vector<Vec3> turn_deg;  // a rotation vector a key, or none; about the middle of the handle's nodes
};

template <class Visitor, FieldsOf<SceneHandle> H>
void describe(Visitor& visit, H& h) {
    visit.field("box_low", h.box_low, any_place, "corner of the box of its nodes, -1 to 1 over the body's box");
    visit.field("box_high", h.box_high, any_place, "the other corner");
    visit.field("spline", h.spline, "the curve through the keys");
    visit.field("times_s", h.times_s, Range{0, 1e4}, "of the keys, ascending");
    visit.field("shift_m", h.shift_m, any_place, "where the nodes are at each key; empty: they stay");
    visit.field("turn_deg", h.turn_deg, any_turning, "how they are turned about their middle at each key; empty: not");
}

enum class Carrier { dynamic, fixed };
inline constexpr EnumName<Carrier> carrier_names[] = {{Carrier::dynamic, "dynamic"}, {Carrier::fixed, "fixed"}};
constexpr std::span<const EnumName<Carrier>> enum_names(Carrier) { return carrier_names; }

struct Scene {
    std::string description;
    double seconds = 1;
    double steps_per_s = 120;
    double frames_per_s = 30;
    std::uint32_t iterations = 20;
    solver::Plasticity plasticity = solver::Plasticity::additive;
    solver::Treatment treatment = solver::Treatment::reflect;
    double young_scale = 1;  // of all materials
    double yield_scale = 1;
    double creep_scale = 1;
    double damping_scale = 1;  // of beta
    Vec3 gravity{0, -9.81, 0};
    Carrier carrier = Carrier::dynamic;  // what the locked nodes hang on; a body without any flies by itself
    Vec3 velocity;
    Vec3 angular_velocity_deg;
    std::vector<SceneObstacle> obstacles;
    std::vector<SceneHandle> handles;
};

template <class Visitor, FieldsOf<Scene> S>
void describe(Visitor& visit, S& s) {
    visit.field("description", s.description, "for people");
    visit.field("seconds", s.seconds, Range{1e-3, 3600}, "how long");
    visit.field("steps_per_s", s.steps_per_s, Range{10, 1e5}, "steps of the solver");
    visit.field("frames_per_s", s.frames_per_s, Range{0.1, 1e5}, "frames kept");
    visit.field("iterations", s.iterations, Range{1, 1e5}, "of conjugate gradients a step");
    visit.field("plasticity", s.plasticity, "how plastic strain is kept");
    visit.field("treatment", s.treatment, "of inverted tets");
    visit.field("young_scale", s.young_scale, Range{1e-6, 1e6}, "on Young's modulus of all materials");
    visit.field("yield_scale", s.yield_scale, Range{1e-6, 1e6}, "on the yield stress of all materials");
    visit.field("creep_scale", s.creep_scale, Range{0, 1e6}, "on the rate of plastic flow");
    visit.field("damping_scale", s.damping_scale, Range{0, 1e6},
                "on the stiffness damping beta, whose stress can be far above yield in a crash");
    visit.field("gravity", s.gravity, any_place, "m/s^2");
    visit.field("carrier", s.carrier, "the rigid body that locked nodes hang on: moved by what happens, or held");
    visit.field("velocity", s.velocity, any_speed, "m/s at the start");
    visit.field("angular_velocity_deg", s.angular_velocity_deg, any_turning, "degrees a second at the start");
    visit.field("obstacles", s.obstacles, "what is in the way");
    visit.field("handles", s.handles, "nodes moved by keyframes");
}

// What no field's range says: keys that ascend, as many values as keys, a frame no shorter than a step. Throws
// Error(usage) that begins with the path of the field.
void check_params(const Scene& scene);

}
