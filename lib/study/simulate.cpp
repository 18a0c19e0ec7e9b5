// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/simulate.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <new>

#include "core/parallel_for.h"
#include "report/number_text.h"
#include "solver/check_input.h"
#include "solver/instance.h"
#include "solver/measure.h"
#include "solver/sensor.h"
#include "solver/skin.h"
#include "study/place.h"
#include "study/rigid_body.h"

namespace crumple::study {
namespace {

using solver::Mat3d;
using solver::narrow;
using solver::widen;

// Memory on the boundary the solver wants.
class Block {
public:
    explicit Block(std::size_t size)
        : memory_(static_cast<std::byte*>(::operator new[](size, std::align_val_t{64}))), size_(size) {}
    [[nodiscard]] std::span<std::byte> get() const { return {memory_.get(), size_}; }

private:
    struct Free {
        void operator()(std::byte* p) const { ::operator delete[](p, std::align_val_t{64}); }
    };
    std::unique_ptr<std::byte[], Free> memory_;
    std::size_t size_;
};

solver::Settings settings_of(const Scene& scene) {
    solver::Settings settings;
    settings.max_iterations = scene.iterations;
    settings.plasticity = scene.plasticity;
    settings.treatment = scene.treatment;
    return settings;
}

solver::BundleView checked_view(const Bundle& bundle) {
    const solver::BundleView view = solver::view_of(bundle);
    if (const char* problem = first_problem(view)) {
        throw Error(ErrorKind::bad_input, std::string("the bundle cannot be stepped: ") + problem);
    }
    return view;
}

// The library's threads as the solver wants them.
struct Workers {
    const Context& context;
    [[nodiscard]] solver::Jobs jobs() const {
        if (context.jobs < 2) return {};
        return {[](void* user, std::size_t count, solver::Jobs::Task task, void* of_task) {
                    parallel_for(*static_cast<const Context*>(user), count, 1, [&](std::size_t begin, std::size_t end) {
                        for (std::size_t i = begin; i < end; ++i) task(of_task, i);
                    });
                },
                const_cast<Context*>(&context)};
    }
};

class Player {
public:
    Player(const Bundle& bundle, const Scene& scene, const Context& context)
        : bundle_(bundle),
          scene_(scene),
          settings_(settings_of(scene)),
          jobs_(Workers{context}.jobs()),
          view_(checked_view(bundle)),
          model_memory_(solver::model_bytes(view_)),
          model_(solver::build_model(view_, model_memory_.get())),
          state_memory_(solver::state_bytes(model_, scene.plasticity)),
          workspace_memory_(solver::workspace_bytes(model_)),
          state_(solver::make_state(model_, scene.plasticity, state_memory_.get())),
          workspace_(solver::make_workspace(model_, workspace_memory_.get())),
          carrier_(bundle, scene.velocity, scene.angular_velocity_deg * (3.14159265358979 / 180)),
          room_(2 * model_.node_count),
          sensor_memories_(bundle.sensors.size()) {
        has_locks_ = std::any_of(bundle.locked.begin(), bundle.locked.end(), [](auto locked) { return locked != 0; });
        rides_ = has_locks_ && scene.carrier == Carrier::dynamic;
        if (!rides_) start_moving();
        for (const SceneObstacle& o : scene.obstacles) {
            obstacles_.push_back(place_obstacle(o, bundle, scene.velocity));
        }
        for (const SceneHandle& h : scene.handles) {
            handles_.push_back(std::make_unique<PlacedHandle>(h, bundle));
            if (handles_.back()->nodes.empty()) {
                throw Error(ErrorKind::usage,
                            "handles[" + std::to_string(handles_.size() - 1) +
                                "]: no node lies in its box; it is in parts of the body's box, -1 to 1");
            }
        }
    }

    void step(double time_s, float dt) {
        solver::InstanceInput input;
        input.dt = dt;
        if (rides_) input.carrier = carrier_.motion();
        input.is_carrier_free = rides_;
        input.gravity = scene_.gravity;
        input.obstacles = obstacles_;
        const std::span<solver::Constraint> room = room_;
        std::size_t driven = 0;
        for (const auto& handle : handles_) {
            driven += drive(model_, state_, handle->handle, static_cast<float>(time_s), dt,
                            room.first(model_.node_count).subspan(driven));
        }
        given_.assign(room.begin(), room.begin() + static_cast<std::ptrdiff_t>(driven));
        input.constraints = given_;
        input.room = room;
        input.may_sleep = handles_.empty();
        report_ = step_instance(model_, state_, workspace_, input, settings_, jobs_);
        if (rides_) carrier_.step(report_.load, scene_.gravity, dt);
        for (solver::Obstacle& o : obstacles_) o.position += o.velocity * static_cast<double>(dt);
    }

    [[nodiscard]] Frame frame(double time_s, double since_s) {
        Frame f;
        f.time_s = time_s;
        const solver::CarrierMotion motion = rides_ ? carrier_.motion() : solver::CarrierMotion{};
        const solver::Frame world(motion);
        for (std::size_t n = 0; n < model_.node_count; ++n) {
            f.nodes.push_back(narrow(world.point_to_world(position(state_, n))));
        }
        for (const BundleVisual& visual : bundle_.visuals) f.vertices.push_back(drawn(visual, world));
        read_tets(f);
        for (std::size_t i = 0; i < bundle_.sensors.size(); ++i) {
            f.sensors.push_back(sensed(i, motion, world, static_cast<float>(since_s)));
        }
        f.kinetic_j = kinetic_energy(model_, state_);
        f.elastic_j = elastic_energy(model_, state_, solver::EnergyRotation::of_state);
        f.iterations = report_.step.iterations;
        f.contacts = static_cast<std::uint32_t>(report_.contacts);
        f.is_asleep = report_.is_asleep;
        return f;
    }

    void measure(Run& run) const {
        run.driven_inside_out = count_driven_inside_out();
        const Box box = box_of(bundle_);
        const Resting resting = rides_ ? Resting{} : find_resting();
        for (std::size_t n = 0; n < model_.node_count; ++n) {
            const Vec3 rest = widen(bundle_.rest_positions[n]);
            const double way = length(widen(position(state_, n)) - resting.place(rest));
            if (bundle_.locked[n] && handles_.empty()) {
                run.locked_drift = std::max(run.locked_drift, way / length(box.high - box.low));
            }
            run.deepest_dent_m = std::max(run.deepest_dent_m, way);
        }
    }

    [[nodiscard]] const solver::InstanceReport& report() const { return report_; }

private:
    // Where the body would be if it had only moved as a whole.
    struct Resting {
        Mat3d turn = Mat3d::identity();
        Vec3 from, to;
        [[nodiscard]] Vec3 place(Vec3 rest) const { return to + turn * (rest - from); }
    };
    // The rigid motion that fits the nodes best, by their masses.
    [[nodiscard]] Resting find_resting() const {
        Resting r;
        if (!handles_.empty() || has_locks_) return r;
        double mass = 0;
        for (std::size_t n = 0; n < model_.node_count; ++n) {
            const double m = bundle_.mass[n];
            r.from += widen(bundle_.rest_positions[n]) * m;
            r.to += widen(position(state_, n)) * m;
            mass += m;
        }
        r.from = r.from / mass;
        r.to = r.to / mass;
        Mat3d moved;
        for (std::size_t n = 0; n < model_.node_count; ++n) {
            const double m = bundle_.mass[n] / mass;
            moved = moved +
                    solver::outer(widen(position(state_, n)) - r.to, (widen(bundle_.rest_positions[n]) - r.from) * m);
        }
        solver::Mat3 narrow;
        for (std::size_t i = 0; i < 9; ++i) narrow.m[i] = static_cast<float>(moved.m[i]);
        const solver::Mat3 turn = rotation_svd_smallest(narrow, solver::Mat3::identity());
        for (std::size_t i = 0; i < 9; ++i) r.turn.m[i] = static_cast<double>(turn.m[i]);
        return r;
    }
    // Tets that handles turn inside out against each other or against locked nodes.
    [[nodiscard]] std::uint32_t count_driven_inside_out() const {
        if (handles_.empty()) return 0;
        std::vector<std::uint8_t> is_driven = bundle_.locked;
        for (const auto& handle : handles_) {
            for (const Index n : handle->nodes) is_driven[n] = 1;
        }
        std::uint32_t count = 0;
        for (std::size_t t = 0; t < model_.tet_count; ++t) {
            const Tet& tet = bundle_.tets[t];
            const bool is_all_driven = std::all_of(tet.begin(), tet.end(), [&](Index n) { return is_driven[n] != 0; });
            count += is_all_driven && determinant(deformation_gradient(model_, state_, t)) <= 0;
        }
        return count;
    }
    // Without a rigid body to ride on the nodes themselves move.
    void start_moving() {
        const Vec3 middle = box_of(bundle_).middle();
        const Vec3 turn = scene_.angular_velocity_deg * (3.14159265358979 / 180);
        for (std::size_t n = 0; n < model_.node_count; ++n) {
            const Vec3f p = bundle_.rest_positions[n];
            const Vec3 v = scene_.velocity + cross(turn, Vec3{p.x, p.y, p.z} - middle);
            if (!bundle_.locked[n]) set_velocity(state_, n, narrow(v));
        }
    }

    std::vector<Vec3f> drawn(const BundleVisual& visual, const solver::Frame& world) {
        std::vector<Vec3f> vertices(visual.tet.size());
        skin(model_, state_, solver::view_of(bundle_, visual), {}, {vertices, {}, {}}, {0, vertices.size()}, settings_,
             jobs_);
        for (Vec3f& p : vertices) p = narrow(world.point_to_world(p));
        return vertices;
    }

    void read_tets(Frame& f) const {
        f.plastic_strain.assign(bundle_.tets.size(), 0);
        for (std::size_t t = 0; t < model_.tet_count; ++t) {
            f.inverted += determinant(deformation_gradient(model_, state_, t)) <= 0;
            f.plastic_strain[t] = plastic_strain(model_, state_, t);
        }
    }

    SensorFrame sensed(std::size_t i, const solver::CarrierMotion& motion, const solver::Frame& world, float since_s) {
        const solver::SensorReading reading =
            read_sensor(model_, state_, solver::view_of(bundle_.sensors[i]), sensor_memories_[i], since_s);
        SensorFrame s;
        s.orientation = solver::to_quaternion(to_matrix(motion.orientation) * to_matrix(reading.orientation));
        s.origin = world.point_to_world(reading.origin);
        s.deformation = reading.deformation;
        s.plastic_strain = reading.plastic_strain;
        s.acceleration = length(reading.acceleration);
        return s;
    }

    const Bundle& bundle_;
    const Scene& scene_;
    solver::Settings settings_;
    solver::Jobs jobs_;
    solver::BundleView view_;
    Block model_memory_;
    solver::Model model_;
    Block state_memory_;
    Block workspace_memory_;
    solver::State state_;
    solver::Workspace workspace_;
    RigidBody carrier_;
    std::vector<solver::Constraint> room_, given_;
    std::vector<solver::SensorMemory> sensor_memories_;
    std::vector<solver::Obstacle> obstacles_;
    std::vector<std::unique_ptr<PlacedHandle>> handles_;
    solver::InstanceReport report_;
    bool has_locks_ = false;
    bool rides_ = false;
};

Bundle with_scaled_materials(Bundle bundle, const Scene& scene) {
    for (Material& m : bundle.materials) {
        m.young_pa *= scene.young_scale;
        m.yield_pa *= scene.yield_scale;
        m.creep_per_s *= scene.creep_scale;
        m.beta_s *= scene.damping_scale;
    }
    return bundle;
}

bool is_finite(const SensorFrame& s) {
    const solver::Quaternion q = s.orientation;
    const double sum = static_cast<double>(q.x + q.y + q.z + q.w) + static_cast<double>(s.deformation) +
                       static_cast<double>(s.plastic_strain) + static_cast<double>(s.acceleration);
    return std::isfinite(sum) && solver::is_usable(narrow(s.origin));
}

bool is_finite(const Frame& f) {
    const auto are_places = [](const std::vector<Vec3f>& places) {
        return std::all_of(places.begin(), places.end(), [](Vec3f p) { return solver::is_usable(p); });
    };
    return are_places(f.nodes) && std::all_of(f.vertices.begin(), f.vertices.end(), are_places) &&
           std::all_of(f.plastic_strain.begin(), f.plastic_strain.end(), [](float x) { return std::isfinite(x); }) &&
           std::all_of(f.sensors.begin(), f.sensors.end(), [](const SensorFrame& s) { return is_finite(s); }) &&
           std::isfinite(f.kinetic_j) && std::isfinite(f.elastic_j);
}

[[noreturn]] void leave_the_finite(double time_s) {
    throw Error(ErrorKind::bad_input, "at " + report::number_text(time_s, 3) +
                                          " s the run is beyond what floats can hold; it takes less speed and turning, "
                                          "more steps_per_s or a smaller young_scale");
}

StepTimes times_of(std::vector<double> ms) {
    if (ms.empty()) return {};
    std::sort(ms.begin(), ms.end());
    const auto at = [&](double part) {
        return ms[static_cast<std::size_t>(part * static_cast<double>(ms.size() - 1))];
    };
    return {at(0.5), at(0.99), ms.back()};
}

void add_findings(Run& run) {
    if (run.warned_steps > 0) {
        run.findings.push_back(
            {"RUN_WARNED",
             Severity::warning,
             "steps were too stiff for float, not finite or cut short: smaller steps or a softer material",
             run.warned_steps,
             {}});
    }
    if (run.inverted_at_end > 0) {
        run.findings.push_back(
            {"RUN_INVERTED", Severity::warning, "tets are inside out at the end", run.inverted_at_end, {}});
    }
    if (run.driven_inside_out > 0) {
        run.findings.push_back({"RUN_HANDLES_CROSS",
                                Severity::warning,
                                "of these tets have no free node: handles move them through each other or through "
                                "locked nodes; move the handles less or give them smaller boxes",
                                run.driven_inside_out,
                                {}});
    }
}

}

Run simulate(const Bundle& cooked, const Scene& scene, const Context& context) {
    check_params(scene);
    const Bundle bundle = with_scaled_materials(cooked, scene);
    Player player(bundle, scene, context);
    Run run;
    const double dt = 1 / scene.steps_per_s;
    run.steps = static_cast<std::uint32_t>(std::lround(scene.seconds * scene.steps_per_s));
    const double frame_count = scene.seconds * scene.frames_per_s;
    run.frames.push_back(player.frame(0, 0));
    std::vector<double> ms;
    for (std::uint32_t i = 0; i < run.steps; ++i) {
        context.stop_if_cancelled();
        const auto begin = std::chrono::steady_clock::now();
        player.step(i * dt, static_cast<float>(dt));
        ms.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
        const std::uint32_t warnings = player.report().step.warnings;
        if ((warnings & solver::step_bad_input) != 0) leave_the_finite(i * dt);
        run.warned_steps += warnings != 0;
        // Frame k is the first step at or behind its time.
        const double done = (i + 1.0) / run.steps;
        const auto due = static_cast<std::size_t>(std::floor(done * frame_count + 1e-9));
        if (due >= run.frames.size() || i + 1 == run.steps) {
            const double time_s = (i + 1) * dt;
            run.frames.push_back(player.frame(time_s, time_s - run.frames.back().time_s));
            if (!is_finite(run.frames.back())) leave_the_finite(time_s);
        }
        context.tell_progress("simulate", done);
    }
    player.measure(run);
    run.inverted_at_end = run.frames.back().inverted;
    run.times = times_of(std::move(ms));
    add_findings(run);
    return run;
}

}
