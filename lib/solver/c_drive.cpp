// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "solver/c_handles.h"
#include "solver/crumple.h"
#include "solver/spline.h"

namespace crumple::solver {
namespace {

constexpr bool are_same(int in_c, SplineKind kind) { return in_c == static_cast<int>(kind); }
static_assert(are_same(CRUMPLE_CATMULL_ROM, SplineKind::catmull_rom) &&
              are_same(CRUMPLE_NATURAL_CUBIC, SplineKind::natural_cubic));

// False where one is no number, too.
bool do_ascend(std::span<const float> times) {
    if (!times.empty() && std::isnan(times[0])) return false;
    for (std::size_t i = 1; i < times.size(); ++i) {
        if (!(times[i - 1] < times[i])) return false;
    }
    return true;
}

bool is_spline(const crumple_spline& s) {
    return s.key_count == 0 || (s.times && s.values && s.slopes && do_ascend({s.times, s.key_count}));
}

Spline in(const crumple_spline& s) {
    return {{s.times, s.key_count},
            {reinterpret_cast<const Vec3f*>(s.values), s.key_count},
            {reinterpret_cast<const Vec3f*>(s.slopes), s.key_count}};
}

}

// Functions of C linkage are the same in every namespace.
extern "C" {

crumple_status crumple_find_slopes(uint32_t kind, const float* times, const crumple_vec3f* values, size_t key_count,
                                   crumple_vec3f* slopes, float* scratch) {
    if (kind > CRUMPLE_NATURAL_CUBIC) return CRUMPLE_BAD_ARGUMENT;
    if (key_count == 0) return CRUMPLE_OK;
    if (!times || !values || !slopes || !scratch || !do_ascend({times, key_count})) return CRUMPLE_BAD_ARGUMENT;
    find_slopes(static_cast<SplineKind>(kind), {times, key_count}, {reinterpret_cast<const Vec3f*>(values), key_count},
                {reinterpret_cast<Vec3f*>(slopes), key_count}, {scratch, key_count});
    return CRUMPLE_OK;
}

crumple_status crumple_drive(const crumple_instance* instance, const crumple_handle* handle, float time, float dt,
                             crumple_constraint* constraints, size_t room) {
    if (instance == nullptr || handle == nullptr || !(dt > 0) || !is_spline(handle->shift) ||
        !is_spline(handle->turn) || handle->node_count > room) {
        return CRUMPLE_BAD_ARGUMENT;
    }
    if (handle->node_count == 0) return CRUMPLE_OK;
    if (handle->nodes == nullptr || constraints == nullptr) return CRUMPLE_BAD_ARGUMENT;
    const std::span<const Index> nodes(handle->nodes, handle->node_count);
    const Model& model = instance->model->model;
    if (std::any_of(nodes.begin(), nodes.end(), [&](Index n) { return n >= model.node_count; })) {
        return CRUMPLE_BAD_ARGUMENT;
    }
    const crumple_vec3f p = handle->pivot;
    drive(model, instance->state, {nodes, {p.x, p.y, p.z}, in(handle->shift), in(handle->turn)}, time, dt,
          {reinterpret_cast<Constraint*>(constraints), nodes.size()});
    return CRUMPLE_OK;
}
}

}
