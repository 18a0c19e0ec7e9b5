// SPDX-License-Identifier: MIT
#include "solver/crash_run.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "solver/outside.h"

namespace crumple::solver::test {
namespace {

double between(Rng& rng, double low, double high) { return low * std::pow(high / low, rng.next_unit()); }

bool coin(Rng& rng) { return rng.next_below(2) == 0; }

Vec3 random_direction(Rng& rng) {
    const Vec3 v = widen(random_vector(rng));
    return v / length(v);
}

Quaternion random_turn(Rng& rng) { return to_quaternion(random_rotation(rng)); }

Material wild_material(Rng& rng) {
    Material m = elastic_material(between(rng, 1e3, 1e9), 0.499 * rng.next_unit());
    m.density_kg_m3 = between(rng, 50, 5000);
    m.yield_pa = between(rng, 1e2, 1e9);
    m.creep_per_s = between(rng, 1e-2, 1e4);
    m.hardening_pa = coin(rng) ? 0 : between(rng, 1e3, 1e8);
    m.alpha_per_s = coin(rng) ? 0 : between(rng, 1e-2, 10);
    m.beta_s = coin(rng) ? 0 : between(rng, 1e-5, 1e-2);
    return m;
}

Settings wild_settings(Rng& rng) {
    Settings settings;
    settings.rotation = static_cast<RotationMethod>(rng.next_below(5));
    settings.treatment = static_cast<Treatment>(rng.next_below(4));
    settings.plasticity = static_cast<Plasticity>(rng.next_below(3));
    settings.max_iterations = 1 + rng.next_below(40);
    const Isa widths[] = {Isa::automatic, Isa::scalar, Isa::avx2, Isa::avx512};
    settings.isa = widths[rng.next_below(4)];
    return settings;
}

// Of a push on a node: what makes the node faster works on the mean of its velocities, the rest, which goes on to its
// neighbours, on the way that it goes.
double work_of(Vec3 push, Vec3 before, Vec3 after, double mass) {
    const double size = length(push);
    if (!(size > 0)) return 0;
    const double gained = dot(after - before, push) / size;
    return dot(push, after) - 0.5 * mass * gained * gained;
}

// Boxes of up to 36 tets around the origin, free, held at one end or at one node.
Bundle small_body(Rng& rng) {
    const int n = 1 + static_cast<int>(rng.next_below(2));
    const Cells cells{n + 1, n, n};
    const Material material = wild_material(rng);
    Bundle grid = grid_body(cells, {0.3f, 0.3f, 0.3f}, material);
    const Vec3f middle = Vec3f{static_cast<float>(cells.x), static_cast<float>(n), static_cast<float>(n)} * 0.15f;
    for (Vec3f& p : grid.rest_positions) p -= middle;
    const float end = -middle.x;
    const std::uint32_t locks = rng.next_below(3);
    return bundle_of(grid.rest_positions, grid.tets, material, [&](Vec3f p) {
        return locks == 1 ? p.x == end : locks == 2 && p.x == end && p.y == -middle.y && p.z == -middle.z;
    });
}

}

Mat3d RigidBody::world_inertia() const {
    Mat3d turn;
    const Frame frame(motion);
    for (int c = 0; c < 3; ++c) {
        Vec3 axis;
        axis[c] = 1;
        const Vec3 column = frame.to_world(axis);
        for (int r = 0; r < 3; ++r) turn(r, c) = column[r];
    }
    return turn * inertia * transpose(turn);
}

Vec3 RigidBody::turning(Vec3 angular_momentum) const {
    const Mat3d now = world_inertia();
    return transpose(cofactor(now)) * angular_momentum / determinant(now);
}

void RigidBody::push(Vec3 force, Vec3 torque, double dt) {
    motion.velocity += force * (dt / mass);
    angular_momentum_ = world_inertia() * motion.angular_velocity + torque * dt;
    motion.angular_velocity = turning(angular_momentum_);
}

void RigidBody::move(double dt) {
    motion.position += motion.velocity * dt;
    const double angle = length(motion.angular_velocity) * dt;
    if (!(angle > 0)) return;
    const Vec3 n = motion.angular_velocity * (std::sin(angle / 2) / (angle / dt));
    const Quaternion by{static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z),
                        static_cast<float>(std::cos(angle / 2))};
    motion.orientation = to_quaternion(to_matrix(by) * to_matrix(motion.orientation));
    motion.angular_velocity = turning(angular_momentum_);
}

CrashRun::CrashRun(std::uint64_t seed) : CrashRun(seed, Rng(seed, 10)) {}

CrashRun::CrashRun(std::uint64_t seed, Rng rng) : body(small_body(rng), wild_settings(rng)), rng_(rng), seed_(seed) {
    rng_ = Rng(seed, 11);
    is_free = coin(rng_);
    extra_ = is_free ? between(rng_, 1, 10) : 0;
    for (std::size_t i = 0; i < body.node_count(); ++i) {
        const double m = body.bundle.mass[i];
        const Vec3 r = widen(body.rest(i));
        carrier_.mass += m * (1 + extra_);
        carrier_.inertia = carrier_.inertia + (Mat3d::identity() * dot(r, r) - outer(r, r)) * (m * (1 + extra_));
    }
    const Material& m = body.bundle.materials[0];
    const double pressure_modulus = m.young_pa * (1 - m.poisson) / ((1 + m.poisson) * (1 - 2 * m.poisson));
    for (const float volume : body.bundle.volume) noise_ += 2e-12 * pressure_modulus * static_cast<double>(volume);
    set_going();
    put_obstacles();
    take_hold();
    reactions_.resize(body.node_count());
    room_.resize(rng_.next_below(8) == 0 ? rng_.next_below(4) : 2 * body.node_count());
}

void CrashRun::set_going() {
    if (coin(rng_)) {
        const double share = rng_.next_unit();
        body.set_positions([&](Vec3f p) {
            if (rng_.next_unit() >= share) return p;
            return is_free ? p + random_vector(rng_) * 0.1f : random_vector(rng_) * 3.0f;
        });
        // Locked nodes stay where the carrier has them.
        for (std::size_t i = 0; i < body.node_count(); ++i) {
            for (int k = 0; k < 3 && body.bundle.locked[i]; ++k) {
                body.state.positions[4 * i + static_cast<std::size_t>(k)] = body.rest(i)[k];
            }
        }
    }
    const double speed = coin(rng_) ? 0 : between(rng_, 1, is_free ? 10 : 100);
    for (std::size_t i = 0; i < body.node_count() && speed > 0; ++i) {
        if (!body.bundle.locked[i]) set_velocity(body.state, i, random_vector(rng_) * static_cast<float>(speed));
    }
    CarrierMotion& motion = carrier_.motion;
    motion.position = random_direction(rng_) * between(rng_, 1, 1e4);
    motion.orientation = random_turn(rng_);
    if (coin(rng_)) motion.velocity = random_direction(rng_) * between(rng_, 1, 100);
    if (coin(rng_)) motion.angular_velocity = random_direction(rng_) * between(rng_, 0.1, 10);
    input_.has_inertia = coin(rng_);
    if (!is_free && coin(rng_)) {
        motion.acceleration = random_direction(rng_) * between(rng_, 1, 100);
        motion.angular_acceleration = random_direction(rng_) * between(rng_, 0.1, 10);
    }
    input_.gravity = coin(rng_) ? Vec3{} : random_direction(rng_) * between(rng_, 1, 30);
    has_weight_ = is_free && coin(rng_);
    if (has_weight_) motion.acceleration = input_.gravity;
    input_.dt = static_cast<float>(between(rng_, 1.0 / 500, 1.0 / 20));
    input_.may_sleep = coin(rng_);
    input_.is_carrier_free = is_free;
    input_.carrier_mass = extra_ > 0 ? carrier_.mass : 0;
}

// Where the body is going, and some that come at it.
void CrashRun::put_obstacles() {
    const CarrierMotion& motion = carrier_.motion;
    const Frame frame(motion);
    for (std::uint32_t i = rng_.next_below(4); i > 0; --i) {
        Obstacle o;
        o.shape = static_cast<ObstacleShape>(rng_.next_below(3));
        o.radius = o.shape == ObstacleShape::capsule ? between(rng_, 0.02, 0.5) : 0.1 * rng_.next_below(2);
        o.restitution = coin(rng_) ? 0 : static_cast<float>(rng_.next_unit());
        const double speed = length(motion.velocity);
        const Vec3 ahead = speed > 0 && coin(rng_) ? motion.velocity / speed : random_direction(rng_);
        o.axis = o.shape == ObstacleShape::plane ? -ahead : random_direction(rng_) * between(rng_, 0.1, 2);
        if (o.shape == ObstacleShape::box) o.axis = {std::abs(o.axis.x), std::abs(o.axis.y), std::abs(o.axis.z)};
        o.orientation = random_turn(rng_);
        o.position = motion.position + ahead * between(rng_, 0.3, 3);
        if (coin(rng_)) o.velocity = -ahead * between(rng_, 0.1, 30);
        if (coin(rng_)) o.angular_velocity = random_direction(rng_) * between(rng_, 0.1, 5);
        obstacles_.push_back(o);
    }
    if (coin(rng_)) {
        wind_.velocity = random_vector(rng_) * static_cast<float>(between(rng_, 1, 100));
        wind_.density_kg_m3 = static_cast<float>(between(rng_, 0.1, 10));
        input_.wind = &wind_;
    }
}

void CrashRun::take_hold() {
    for (std::uint32_t i = is_free ? 0 : rng_.next_below(3); i > 0; --i) {
        Handles h;
        const double share = 0.3 * rng_.next_unit();
        for (Index n = 0; n < body.node_count(); ++n) {
            if (rng_.next_unit() < share) h.nodes.push_back(n);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            h.times[k] = 0.1f * static_cast<float>(k);
            h.shifts[k] = random_vector(rng_) * 0.5f;
            h.turns[k] = random_vector(rng_) * 2.0f;
        }
        const auto kind = coin(rng_) ? SplineKind::catmull_rom : SplineKind::natural_cubic;
        find_slopes(kind, h.times, h.shifts, h.shift_slopes, h.scratch);
        find_slopes(kind, h.times, h.turns, h.turn_slopes, h.scratch);
        handles_.push_back(std::move(h));
    }
    if (coin(rng_)) {
        const double weight = carrier_.mass / static_cast<double>(body.node_count());
        const auto push = static_cast<float>(is_free ? weight * between(rng_, 1, 100) : between(rng_, 1, 1e4));
        for (std::size_t i = 0; i < body.node_count(); ++i) forces_.push_back(random_vector(rng_) * push);
    }
}

void CrashRun::add_handles(std::vector<Constraint>& constraints) const {
    for (const Handles& h : handles_) {
        std::vector<Constraint> some(h.nodes.size());
        const Handle handle{h.nodes, {}, {h.times, h.shifts, h.shift_slopes}, {h.times, h.turns, h.turn_slopes}};
        drive(body.model, body.state, handle, time_, input_.dt, some);
        constraints.insert(constraints.end(), some.begin(), some.end());
    }
}

InstanceInput CrashRun::next_input() {
    InstanceInput input = input_;
    input.carrier = carrier_.motion;
    input.obstacles = obstacles_;
    hits_.clear();
    if (steps_ > 0 && rng_.next_below(8) == 0) {
        const Vec3 momentum = random_direction(rng_) * (carrier_.mass * between(rng_, 0.1, is_free ? 2 : 20));
        hits_.push_back({carrier_.motion.position + widen(random_vector(rng_)), momentum});
    }
    input.hits = hits_;
    constraints_.clear();
    add_handles(constraints_);
    if (seed_ % 5 == 0) {
        const auto node = static_cast<Index>(seed_ % body.node_count());
        const auto kind = seed_ % 2 == 0 ? ConstraintKind::plane : ConstraintKind::rail;
        constraints_.push_back({node, kind, {}, {1, 0.5f, 0}, {0, 0.2f, 1}});
    }
    input.constraints = constraints_;
    input.room = room_;
    input.reactions = reactions_;
    if (rng_.next_below(3) > 0) input.forces = forces_;
    return input;
}

std::vector<Vec3> CrashRun::node_velocities() const {
    std::vector<Vec3> all;
    const CarrierMotion& motion = carrier_.motion;
    const Frame frame(motion);
    for (std::size_t i = 0; i < body.node_count(); ++i) {
        const Vec3 own = widen(velocity(body.state, i));
        const Vec3 arm = frame.to_world(widen(body.x(i)));
        all.push_back(is_free ? motion.velocity + cross(motion.angular_velocity, arm) + frame.to_world(own) : own);
    }
    return all;
}

double CrashRun::kinetic() const {
    double sum = 0;
    const std::vector<Vec3> v = node_velocities();
    for (std::size_t i = 0; i < v.size(); ++i) sum += 0.5 * static_cast<double>(body.bundle.mass[i]) * dot(v[i], v[i]);
    if (!is_free) return sum;
    const CarrierMotion& motion = carrier_.motion;
    const Vec3 turn = Frame(motion).from_world(motion.angular_velocity);
    const double whole = carrier_.mass * dot(motion.velocity, motion.velocity) + dot(turn, carrier_.inertia * turn);
    return sum + 0.5 * whole * extra_ / (1 + extra_);
}

// What falls on locked nodes, in the frame: the nodes' share is in the state then, which is put back.
Six CrashRun::given_by_hits(const InstanceInput& input) {
    Six to_carrier{};
    const Frame frame(input.carrier);
    for (const Hit& hit : input.hits) {
        const Vec3f point = frame.point(hit.position);
        const Vec3f momentum = frame.vector(hit.momentum);
        const Six before = momentum_of(body.model, body.state);
        strike(body.model, body.state, point, momentum);
        add_to(to_carrier, 1, push_at(widen(point), widen(momentum)));
        add_to(to_carrier, -1, momentum_of(body.model, body.state));
        add_to(to_carrier, 1, before);
    }
    return to_carrier;
}

// N s on each node, in the frame, but what constraints give, and hits. The state is that after the hits.
std::vector<Vec3> CrashRun::known_impulses(const InstanceInput& input) {
    const Frame frame(input.carrier);
    StepInput step;
    step.forces = input.forces;
    if (!is_free) {
        step.gravity = frame.vector(input.gravity - (input.has_inertia ? input.carrier.acceleration : Vec3{}));
        if (input.has_inertia) {
            step.frame_turn = frame.vector(input.carrier.angular_velocity);
            step.frame_turn_rate = frame.vector(input.carrier.angular_acceleration);
        }
    }
    std::fill(body.workspace.outside.begin(), body.workspace.outside.end(), 0.0f);
    if (input.wind != nullptr) {
        Wind wind = *input.wind;
        wind.velocity = frame.velocity(input.carrier.position, widen(wind.velocity));
        add_wind(body.model, body.state, body.workspace, wind, input.dt);
    }
    std::vector<Vec3> all;
    for (std::size_t i = 0; i < body.node_count(); ++i) {
        const float* of_wind = &body.workspace.outside[4 * i];
        all.push_back(widen(outside_force(body.model, body.state, step, i)) * static_cast<double>(input.dt) +
                      Vec3{of_wind[0], of_wind[1], of_wind[2]});
    }
    return all;
}

// What is pulled or pushed within nodes and carrier: gravity pulls the nodes in the frame, and its counterpart the
// carrier; without inertia something holds the nodes against the turning of the frame.
double CrashRun::work_within(const InstanceInput& input, std::size_t node, Vec3 place, Vec3 own_before) const {
    const Frame frame(input.carrier);
    const Vec3 turning = (input.carrier.angular_velocity + carrier_.motion.angular_velocity) * 0.5;
    const Vec3 w = frame.from_world(turning);
    Vec3 pull = frame.from_world(input.gravity - (input.has_inertia ? input.carrier.acceleration : Vec3{}));
    if (!input.has_inertia) pull += cross(w, cross(w, place));
    const Vec3 u = (own_before + widen(velocity(body.state, node))) * 0.5;
    return static_cast<double>(body.bundle.mass[node]) * static_cast<double>(input.dt) * dot(pull, u);
}

void CrashRun::give(double work) { work_ += std::max(0.0, work); }

// The load, and what the game does beside it.
void CrashRun::move_free_carrier(const InstanceInput& input, const Six& hits) {
    const double dt = static_cast<double>(input.dt);
    const Frame frame(input.carrier);
    const CarrierMotion& now = carrier_.motion;
    give(0.5 * dot(frame.to_world(linear_part(hits)), input.carrier.velocity + now.velocity) +
         0.5 * dot(frame.to_world(angular_part(hits)), input.carrier.angular_velocity + now.angular_velocity));
    if (has_weight_) {
        const double before = kinetic();
        carrier_.motion.velocity += input.gravity * dt;
        give(kinetic() - before);
    }
    carrier_.move(dt);
}

void CrashRun::move_driven_carrier(double dt) {
    CarrierMotion& motion = carrier_.motion;
    motion.velocity += motion.acceleration * dt;
    const Vec3 turning = motion.angular_velocity + motion.angular_acceleration * dt;
    carrier_.move(dt);
    motion.angular_velocity = turning;
}

// What a step is given, and how the nodes stand when it begins.
struct CrashRun::Begin {
    double kinetic = 0;             // with the blows
    double own_kinetic = 0;         // of the nodes in the frame, with the blows
    double blows = 0;               // J
    Six to_carrier{};               // of the blows, N s and N m s
    std::vector<Vec3> impulses;     // N s in the frame
    std::vector<Vec3> velocities;   // see node_velocities()
    std::vector<Vec3> own, places;  // in the frame
};

// Tries the blows and puts the state back.
CrashRun::Begin CrashRun::look_ahead(const InstanceInput& input) {
    Begin begin;
    const double before = kinetic();
    const std::vector<std::byte> saved(body.bytes().begin(), body.bytes().end());
    begin.to_carrier = given_by_hits(input);
    begin.kinetic = kinetic();
    begin.own_kinetic = kinetic_energy(body.model, body.state);
    begin.blows = begin.kinetic - before;
    begin.impulses = known_impulses(input);
    begin.velocities = node_velocities();
    for (std::size_t i = 0; i < body.node_count(); ++i) {
        begin.own.push_back(widen(velocity(body.state, i)));
        begin.places.push_back(widen(body.x(i)));
    }
    std::memcpy(body.bytes().data(), saved.data(), saved.size());
    return begin;
}

void CrashRun::add_work(const InstanceInput& input, const Begin& begin) {
    const Frame frame(input.carrier);
    const std::vector<Vec3> after = node_velocities();
    for (std::size_t i = 0; i < body.node_count(); ++i) {
        const Vec3 given = begin.impulses[i] + widen(reactions_[i]) * static_cast<double>(input.dt);
        const Vec3 push = is_free ? frame.to_world(given) : given;
        give(work_of(push, begin.velocities[i], after[i], static_cast<double>(body.bundle.mass[i])));
        if (is_free) give(work_within(input, i, begin.places[i], begin.own[i]));
    }
}

void CrashRun::step() {
    const InstanceInput input = next_input();
    const double dt = static_cast<double>(input.dt);
    const Begin begin = look_ahead(input);
    report = step_instance(body.model, body.state, body.workspace, input, body.settings);
    time_ += input.dt;
    if (!report.is_asleep) {
        give(begin.blows);
        energy_at_begin_ = begin.kinetic + report.step.start_energy - begin.own_kinetic;
        if (steps_ == 0) start_ = energy_at_begin_;
        allowed_at_begin_ = start_ + work_;
    }
    ++steps_;
    if (is_free) carrier_.push(report.load.force, report.load.torque, dt);
    if (!report.is_asleep) add_work(input, begin);
    if (is_free) {
        move_free_carrier(input, begin.to_carrier);
    } else {
        move_driven_carrier(dt);
    }
    turned_ = std::max(turned_, length(carrier_.motion.angular_velocity) * dt);
    for (Obstacle& o : obstacles_) o.position += o.velocity * dt;
    energy_ = kinetic() + body.state.header->energy - kinetic_energy(body.model, body.state);
}

bool CrashRun::is_finite() const {
    return body.is_finite() && std::isfinite(length(report.load.force)) && std::isfinite(length(report.load.torque)) &&
           std::isfinite(report.step.energy);
}

bool CrashRun::is_bounded() const {
    return energy_ <= 2 * allowed() + noise_ && energy_at_begin_ <= 2 * allowed_at_begin_ + noise_;
}

}
