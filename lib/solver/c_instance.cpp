// SPDX-License-Identifier: MIT
#include <algorithm>

#include "solver/blob_view.h"
#include "solver/c_handles.h"
#include "solver/check_input.h"

namespace crumple::solver {
namespace {

// Arrays of these cross the border as they are.
static_assert(sizeof(crumple_vec3f) == sizeof(Vec3f) && sizeof(crumple_vec3) == sizeof(Vec3));
static_assert(sizeof(crumple_constraint) == sizeof(Constraint) &&
              offsetof(crumple_constraint, kind) == offsetof(Constraint, kind) &&
              offsetof(crumple_constraint, velocity) == offsetof(Constraint, velocity) &&
              offsetof(crumple_constraint, normal) == offsetof(Constraint, normal) &&
              offsetof(crumple_constraint, second) == offsetof(Constraint, second));
static_assert(sizeof(crumple_obstacle) == sizeof(Obstacle) &&
              offsetof(crumple_obstacle, position) == offsetof(Obstacle, position) &&
              offsetof(crumple_obstacle, axis) == offsetof(Obstacle, axis) &&
              offsetof(crumple_obstacle, radius) == offsetof(Obstacle, radius) &&
              offsetof(crumple_obstacle, orientation) == offsetof(Obstacle, orientation) &&
              offsetof(crumple_obstacle, velocity) == offsetof(Obstacle, velocity) &&
              offsetof(crumple_obstacle, angular_velocity) == offsetof(Obstacle, angular_velocity) &&
              offsetof(crumple_obstacle, restitution) == offsetof(Obstacle, restitution));
static_assert(sizeof(crumple_hit) == sizeof(Hit) && offsetof(crumple_hit, momentum) == offsetof(Hit, momentum));
constexpr bool are_same(int in_c, int in_cpp) { return in_c == in_cpp; }
static_assert(are_same(CRUMPLE_TOO_STIFF, step_too_stiff) && are_same(CRUMPLE_NOT_FINITE, step_not_finite) &&
              are_same(CRUMPLE_BAD_CONSTRAINT, step_bad_constraint) && are_same(CRUMPLE_BAD_INPUT, step_bad_input) &&
              are_same(CRUMPLE_RESTRAINED, step_restrained));
static_assert(are_same(CRUMPLE_ROTATION_SVD_LAST, static_cast<int>(RotationMethod::svd_last)) &&
              are_same(CRUMPLE_TREATMENT_OFF, static_cast<int>(Treatment::off)) &&
              are_same(CRUMPLE_PLASTICITY_OFF, static_cast<int>(Plasticity::off)) &&
              are_same(CRUMPLE_ISA_AVX512, static_cast<int>(Isa::avx512)) &&
              are_same(CRUMPLE_ON_RAIL, static_cast<int>(ConstraintKind::rail)) &&
              are_same(CRUMPLE_IN_CONTACT, static_cast<int>(ConstraintKind::contact)) &&
              are_same(CRUMPLE_BOX, static_cast<int>(ObstacleShape::box)));

template <class To, class From>
std::span<const To> span_of(const From* data, std::size_t count) {
    return {reinterpret_cast<const To*>(data), data ? count : 0};
}

template <class To, class From>
std::span<To> room_of(From* data, std::size_t count) {
    return {reinterpret_cast<To*>(data), data ? count : 0};
}

Vec3 in(crumple_vec3 v) { return {v.x, v.y, v.z}; }
Vec3f in(crumple_vec3f v) { return {v.x, v.y, v.z}; }
crumple_vec3 out(Vec3 v) { return {v.x, v.y, v.z}; }
crumple_vec3f out(Vec3f v) { return {v.x, v.y, v.z}; }
Jobs in(const crumple_jobs* jobs) { return jobs ? Jobs{jobs->run, jobs->user} : Jobs{}; }

bool is_one_of(uint32_t value, int last) { return value <= static_cast<uint32_t>(last); }

// Numbers out of range are taken as the nearest in range, so that no setting can make a step loop or divide by zero.
struct ClampToRange {
    template <class T>
    void field(std::string_view, T&, std::string_view) {}
    template <class T>
    void field(std::string_view, T& number, Range range, std::string_view) {
        const double value = static_cast<double>(number);
        number = static_cast<T>(value > range.min ? std::min(value, range.max) : range.min);
    }
};

bool read_settings(const crumple_settings& from, Settings& settings) {
    if (!is_one_of(from.rotation, CRUMPLE_ROTATION_SVD_LAST) || !is_one_of(from.treatment, CRUMPLE_TREATMENT_OFF) ||
        !is_one_of(from.plasticity, CRUMPLE_PLASTICITY_OFF) || !is_one_of(from.isa, CRUMPLE_ISA_AVX512)) {
        return false;
    }
    settings.rotation = static_cast<RotationMethod>(from.rotation);
    settings.treatment = static_cast<Treatment>(from.treatment);
    settings.plasticity = static_cast<Plasticity>(from.plasticity);
    settings.isa = static_cast<Isa>(from.isa);
    settings.degenerate_threshold = from.degenerate_threshold;
    settings.min_plastic_stretch = from.min_plastic_stretch;
    settings.max_plastic_stretch = from.max_plastic_stretch;
    settings.max_iterations = from.max_iterations;
    settings.tolerance = from.tolerance;
    ClampToRange clamp;
    describe(clamp, settings);
    return true;
}

CarrierMotion in(const crumple_carrier& c) {
    const crumple_quaternion q = c.orientation;
    return {in(c.position),         {q.x, q.y, q.z, q.w}, in(c.velocity),
            in(c.angular_velocity), in(c.acceleration),   in(c.angular_acceleration)};
}

InstanceInput in(const crumple_input& from, const crumple_instance& instance, std::span<Constraint> room) {
    InstanceInput input;
    input.dt = from.dt;
    input.carrier = in(from.carrier);
    input.is_carrier_free = from.is_carrier_free != 0;
    input.carrier_mass = from.carrier_mass;
    input.has_inertia = from.has_inertia != 0;
    input.gravity = in(from.gravity);
    input.obstacles = span_of<Obstacle>(from.obstacles, from.obstacle_count);
    input.hits = span_of<Hit>(from.hits, from.hit_count);
    input.forces = span_of<Vec3f>(from.forces, instance.model->model.node_count);
    input.constraints = span_of<Constraint>(from.constraints, from.constraint_count);
    input.reactions = room_of<Vec3f>(from.reactions, instance.model->model.node_count);
    input.room = room;
    input.sleep = {from.sleep_speed, from.sleep_after_s, from.wake_speed, from.wake_pull};
    input.may_sleep = from.may_sleep != 0;
    return input;
}

crumple_report out(const InstanceReport& r) {
    return {r.step.iterations,  r.step.residual,   r.step.degenerate,  r.step.yielding, r.step.warnings,
            r.step.energy,      out(r.load.force), out(r.load.torque), r.contacts,      r.is_room_too_small ? 1 : 0,
            r.is_asleep ? 1 : 0};
}

template <class T>
bool is_array(const T* data, std::size_t count) {
    return data != nullptr || count == 0;
}

// Whether there are arrays where counts say so, and the kinds in them are some at all: a byte may hold any number.
bool are_arrays_fine(const crumple_input& input) {
    if (!is_array(input.obstacles, input.obstacle_count) || !is_array(input.hits, input.hit_count) ||
        !is_array(input.constraints, input.constraint_count)) {
        return false;
    }
    const auto obstacles = std::span(input.obstacles, input.obstacle_count);
    const auto constraints = std::span(input.constraints, input.constraint_count);
    return std::all_of(obstacles.begin(), obstacles.end(), [](const auto& o) { return o.shape <= CRUMPLE_BOX; }) &&
           std::all_of(constraints.begin(), constraints.end(),
                       [](const auto& c) { return c.kind <= CRUMPLE_IN_CONTACT; });
}

VisualView visual_at(const crumple_instance& instance, uint32_t visual) {
    return view_of(instance.model->blob, visual_of(instance.model->blob, visual));
}

bool has_visual(const crumple_instance* instance, uint32_t visual) {
    return instance && visual < instance->model->blob.counts.visuals;
}

bool has_sensor(const crumple_instance* instance, uint32_t sensor) {
    return instance && sensor < instance->model->blob.counts.sensors;
}

}

// Functions of C linkage are the same in every namespace.
extern "C" {

crumple_status crumple_workspace_create(const crumple_model* model, const crumple_allocator* allocator,
                                        crumple_workspace** workspace) {
    if (workspace == nullptr) return CRUMPLE_BAD_ARGUMENT;
    *workspace = nullptr;
    if (model == nullptr) return CRUMPLE_BAD_ARGUMENT;
    auto* made = make_handle<crumple_workspace>(allocator_or_heap(allocator));
    if (made == nullptr) return CRUMPLE_NO_MEMORY;
    made->model = model;
    if (!made->memory.allocate(made->allocator, workspace_bytes(model->model)) ||
        !made->room.allocate(made->allocator, 2 * model->model.node_count)) {
        destroy_handle(made);
        return CRUMPLE_NO_MEMORY;
    }
    made->workspace = make_workspace(model->model, made->memory.get());
    *workspace = made;
    return CRUMPLE_OK;
}

void crumple_workspace_destroy(crumple_workspace* workspace) { destroy_handle(workspace); }

crumple_settings crumple_default_settings(void) {
    const Settings s;
    return {static_cast<uint32_t>(s.rotation),
            static_cast<uint32_t>(s.treatment),
            static_cast<uint32_t>(s.plasticity),
            static_cast<uint32_t>(s.isa),
            s.degenerate_threshold,
            s.min_plastic_stretch,
            s.max_plastic_stretch,
            s.max_iterations,
            s.tolerance};
}

crumple_status crumple_instance_create(const crumple_model* model, const crumple_settings* settings,
                                       const crumple_allocator* allocator, crumple_instance** instance) {
    if (instance == nullptr) return CRUMPLE_BAD_ARGUMENT;
    *instance = nullptr;
    Settings read;
    if (model == nullptr || (settings && !read_settings(*settings, read))) return CRUMPLE_BAD_ARGUMENT;
    auto* made = make_handle<crumple_instance>(allocator_or_heap(allocator));
    if (made == nullptr) return CRUMPLE_NO_MEMORY;
    made->model = model;
    made->settings = read;
    if (!made->memory.allocate(made->allocator, state_bytes(model->model, read.plasticity)) ||
        !made->sensors.allocate(made->allocator, model->blob.counts.sensors)) {
        destroy_handle(made);
        return CRUMPLE_NO_MEMORY;
    }
    made->state = make_state(model->model, read.plasticity, made->memory.get());
    *instance = made;
    return CRUMPLE_OK;
}

void crumple_instance_destroy(crumple_instance* instance) { destroy_handle(instance); }

const float* crumple_positions(const crumple_instance* instance) {
    return instance ? instance->state.positions.data() : nullptr;
}

const float* crumple_velocities(const crumple_instance* instance) {
    return instance ? instance->state.velocities.data() : nullptr;
}

crumple_status crumple_set_velocity(crumple_instance* instance, uint32_t node, crumple_vec3f velocity) {
    if (instance == nullptr || node >= instance->model->model.node_count || !is_usable(in(velocity))) {
        return CRUMPLE_BAD_ARGUMENT;
    }
    set_velocity(instance->state, node, in(velocity));
    return CRUMPLE_OK;
}

void crumple_wake(crumple_instance* instance) {
    if (instance) wake(instance->state);
}

int crumple_is_asleep(const crumple_instance* instance) { return instance && is_asleep(instance->state) ? 1 : 0; }

crumple_input crumple_default_input(void) {
    const InstanceInput d;
    crumple_input input{};
    input.dt = d.dt;
    input.carrier.orientation = {0, 0, 0, 1};
    input.is_carrier_free = d.is_carrier_free ? 1 : 0;
    input.carrier_mass = d.carrier_mass;
    input.has_inertia = d.has_inertia ? 1 : 0;
    input.gravity = out(d.gravity);
    input.sleep_speed = d.sleep.speed;
    input.sleep_after_s = d.sleep.after_s;
    input.wake_speed = d.sleep.wake_speed;
    input.wake_pull = d.sleep.wake_pull;
    input.may_sleep = d.may_sleep ? 1 : 0;
    return input;
}

crumple_status crumple_step(crumple_instance* instance, crumple_workspace* workspace, const crumple_input* input,
                            const crumple_jobs* jobs, crumple_report* report) {
    if (report) *report = {};
    if (instance == nullptr || workspace == nullptr || input == nullptr || workspace->model != instance->model ||
        !are_arrays_fine(*input)) {
        return CRUMPLE_BAD_ARGUMENT;
    }
    InstanceInput step_input = in(*input, *instance, workspace->room.get());
    Wind wind;
    if (input->wind) {
        wind = {in(input->wind->velocity), input->wind->density_kg_m3, input->wind->drag};
        step_input.wind = &wind;
    }
    const InstanceReport done = step_instance(instance->model->model, instance->state, workspace->workspace, step_input,
                                              instance->settings, in(jobs));
    if (report) *report = out(done);
    return CRUMPLE_OK;
}

crumple_status crumple_moved_vertices(const crumple_instance* instance, uint32_t visual, float tolerance,
                                      uint32_t* first, uint32_t* last) {
    if (!has_visual(instance, visual) || first == nullptr || last == nullptr) return CRUMPLE_BAD_ARGUMENT;
    const VertexRange range =
        moved_vertices(instance->model->model, instance->state, visual_at(*instance, visual), tolerance);
    *first = static_cast<uint32_t>(range.first);
    *last = static_cast<uint32_t>(range.last);
    return CRUMPLE_OK;
}

void crumple_forget_moves(crumple_instance* instance) {
    if (instance) forget_moves(instance->state);
}

crumple_status crumple_skin(const crumple_instance* instance, uint32_t visual, const crumple_vertices* v,
                            uint32_t first, uint32_t last, const crumple_jobs* jobs) {
    if (!has_visual(instance, visual) || v == nullptr || v->positions == nullptr || !v->rest_normals != !v->normals ||
        !v->rest_tangents != !v->tangents) {
        return CRUMPLE_BAD_ARGUMENT;
    }
    const VisualView view = visual_at(*instance, visual);
    const std::size_t count = view.tet.size();
    if (first > last || last > count) return CRUMPLE_BAD_ARGUMENT;
    using Tangent = std::array<float, 4>;
    const RestVertices rest{span_of<Vec3f>(v->rest_normals, count), span_of<Tangent>(v->rest_tangents, count)};
    const DrawnVertices drawn{{reinterpret_cast<Vec3f*>(v->positions), count},
                              {reinterpret_cast<Vec3f*>(v->normals), v->normals ? count : 0},
                              {reinterpret_cast<Tangent*>(v->tangents), v->tangents ? count : 0}};
    skin(instance->model->model, instance->state, view, rest, drawn, {first, last}, instance->settings, in(jobs));
    return CRUMPLE_OK;
}

crumple_status crumple_read_sensor(crumple_instance* instance, uint32_t sensor, const crumple_carrier* carrier,
                                   float dt, crumple_reading* reading) {
    if (!has_sensor(instance, sensor) || reading == nullptr) return CRUMPLE_BAD_ARGUMENT;
    const CarrierMotion motion = carrier ? in(*carrier) : CarrierMotion{};
    if (!is_usable(motion)) return CRUMPLE_BAD_ARGUMENT;
    const SensorReading r =
        read_sensor(instance->model->model, instance->state, view_of(sensor_of(instance->model->blob, sensor)),
                    instance->sensors.get()[sensor], dt, motion);
    const Quaternion q = r.orientation;
    *reading = {{q.x, q.y, q.z, q.w}, out(r.origin), out(r.velocity),
                out(r.acceleration),  r.deformation, r.plastic_strain};
    return CRUMPLE_OK;
}

int crumple_trigger(crumple_instance* instance, uint32_t sensor, float value, float on, float off) {
    return has_sensor(instance, sensor) && trigger(instance->sensors.get()[sensor], value, on, off) ? 1 : 0;
}
}

}
