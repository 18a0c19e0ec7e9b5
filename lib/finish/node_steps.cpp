// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/node_steps.h"

#include <algorithm>
#include <cmath>

#include "geometry/measures.h"

namespace crumple::finish {

double NodeSteps::step_of(const Load& load) {
    return load.volume > 0 && load.stiffness > 0 ? std::sqrt(load.volume / load.stiffness) : 0;
}

void NodeSteps::add(const Vec3 (&at)[4], int corner, double sign, Load& load) {
    const auto& face = tet_face_corners[corner];
    const Vec3 area = area_vector(at[face[0]], at[face[1]], at[face[2]]);
    const double volume = signed_volume(at[0], at[1], at[2], at[3]);
    load.volume += sign * volume;
    load.stiffness += sign * dot(area, area) / volume;
}

NodeSteps::NodeSteps(const WorkMesh& mesh) : loads_(mesh.complex.positions().size()) {
    for (Index t = 0; t < mesh.complex.slot_count(); ++t) {
        if (!mesh.complex.is_tet(t)) continue;
        const auto& [a, b, c, d] = mesh.complex.corners(t);
        const Vec3 at[4] = {mesh.at(a), mesh.at(b), mesh.at(c), mesh.at(d)};
        for (int corner = 0; corner < 4; ++corner) add(at, corner, 1, loads_[mesh.complex.corners(t)[corner]]);
    }
}

NodeSteps::Load& NodeSteps::local_load(Index node) {
    if (node == none) return local_.back();
    return local_[static_cast<std::size_t>(std::lower_bound(nodes_.begin(), nodes_.end(), node) - nodes_.begin())];
}

NodeSteps::Least NodeSteps::weigh(const WorkMesh& mesh, const Change& change) {
    nodes_.clear();
    for (const Index t : change.exchange.old) {
        const Tet& corners = mesh.complex.corners(t);
        nodes_.insert(nodes_.end(), corners.begin(), corners.end());
    }
    std::sort(nodes_.begin(), nodes_.end());
    nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
    Least least{1e300, 1e300};
    local_.clear();
    for (const Index v : nodes_) {
        local_.push_back(loads_[v]);
        least.before = std::min(least.before, step(v));
    }
    if (change.adds_node()) local_.emplace_back();
    for (const Index t : change.exchange.old) {
        const Tet& corners = mesh.complex.corners(t);
        const Vec3 at[4] = {mesh.at(corners[0]), mesh.at(corners[1]), mesh.at(corners[2]), mesh.at(corners[3])};
        for (int corner = 0; corner < 4; ++corner) add(at, corner, -1, local_load(corners[corner]));
    }
    for (const Tet& t : change.exchange.fresh) {
        const Vec3 at[4] = {change.at(mesh, t[0]), change.at(mesh, t[1]), change.at(mesh, t[2]), change.at(mesh, t[3])};
        for (int corner = 0; corner < 4; ++corner) add(at, corner, 1, local_load(t[corner]));
    }
    for (const Load& load : local_) least.after = std::min(least.after, step_of(load));
    return least;
}

void NodeSteps::carry_out(const WorkMesh& mesh, const Change& change, Index added) {
    (void)weigh(mesh, change);
    for (std::size_t i = 0; i < nodes_.size(); ++i) loads_[nodes_[i]] = local_[i];
    if (!change.adds_node()) return;
    loads_.resize(std::max<std::size_t>(loads_.size(), added + 1));
    loads_[added] = local_.back();
}

}
