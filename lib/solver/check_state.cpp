// SPDX-License-Identifier: MIT
#include "solver/check_state.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "solver/degenerate.h"

namespace crumple::solver {
namespace {

bool are_finite(std::span<const float> values) {
    return std::all_of(values.begin(), values.end(), [](float x) { return std::isfinite(x); });
}

bool is_header_fine(const StateHeader& h) {
    const float floats[] = {h.last_dt,      h.quiet_s,      h.sleep_centre.x, h.sleep_centre.y, h.sleep_centre.z,
                            h.sleep_radius, h.sleep_pull.x, h.sleep_pull.y,   h.sleep_pull.z};
    return are_finite(floats) && std::isfinite(h.energy) && std::isfinite(h.budget) && h.last_dt >= 0;
}

bool is_packet_fine(const TetState& packet) {
    const bool are_collapses = std::all_of(std::begin(packet.collapse), std::end(packet.collapse),
                                           [](std::uint8_t c) { return c < collapse_count; });
    return are_collapses && are_finite({packet.rotation[0], 4 * packet_size}) &&
           are_finite({packet.plastic[0], 6 * packet_size}) && are_finite(packet.hardening);
}

}

const char* first_problem(const Model& model, const State& state) noexcept {
    if (!is_header_fine(*state.header)) return "the state's header is not one";
    const std::size_t count = 4 * model.node_count;
    if (!are_finite(state.positions.first(count)) || !are_finite(state.velocities.first(count)) ||
        !are_finite(state.moved)) {
        return "the state has a node that is nowhere";
    }
    if (!std::all_of(state.tets.begin(), state.tets.end(), is_packet_fine)) return "the state has a tet that is none";
    for (const TetShape& shape : state.shapes) {
        if (!are_finite({shape.gradient[0], 9 * packet_size})) return "the state has a tet that is none";
    }
    return nullptr;
}

}
