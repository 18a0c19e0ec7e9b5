// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind/owners.h"

#include <algorithm>

namespace crumple::bind {

Owners::Owners(const Shell& shell, const TetMesh& mesh, const Params& params)
    : shell_(shell),
      mesh_(mesh),
      interior_(shell),
      rank_(shell.components.size()),
      tet_count_(shell.components.size(), 0),
      box_(shell.components.size()) {
    const auto by_volume = interior_.by_volume();
    for (Index i = 0; i < by_volume.size(); ++i) rank_[by_volume[i]] = i;
    for (const Index region : mesh.region) ++tet_count_[region];
    for (std::size_t f = 0; f < shell.triangles.size(); ++f) {
        for (const Index v : shell.triangles[f]) box_[shell.component[f]].add(shell.positions[v]);
    }
    preferences_ = {rank_, [this](Vec3 p) { return owner_at(p); }, params.max_weight,
                    params.nearest_slack * bounding_box(mesh.positions).diagonal()};
}

Index Owners::component(const std::string& name) const {
    if (name.empty()) return none;
    const auto found = std::find_if(shell_.components.begin(), shell_.components.end(),
                                    [&](const Component& c) { return c.name == name; });
    return found == shell_.components.end() ? none : static_cast<Index>(found - shell_.components.begin());
}

void Owners::build(Index component) {
    auto& locator = locators_[component];
    if (!locator) locator = std::make_unique<TetLocator>(mesh_, component, preferences_);
}

void Owners::prepare(Index component) {
    build(component);
    const auto regions = std::count_if(tet_count_.begin(), tet_count_.end(), [](Index count) { return count > 0; });
    if (component != none || regions < 2) return;
    // A vertex in no tet may still lie within a shell: its own tets are then asked as well.
    for (Index c = 0; c < tet_count_.size(); ++c) {
        if (has_tets(c)) build(c);
    }
}

Index Owners::owner_at(Vec3 p) const {
    const Index owner = interior_.material_at(p);
    return owner != none && has_tets(owner) ? owner : none;
}

// Boxes answer for most vertices and spare them the winding numbers.
bool Owners::may_belong_elsewhere(Vec3 p, Index region) const {
    for (Index c = 0; c < box_.size(); ++c) {
        const Box& box = box_[c];
        if (c != region && has_tets(c) && p.x >= box.low.x && p.y >= box.low.y && p.z >= box.low.z &&
            p.x <= box.high.x && p.y <= box.high.y && p.z <= box.high.z) {
            return true;
        }
    }
    return false;
}

Location Owners::locate(Vec3 p, Index component, Guess& guess) const {
    const Location location = locators_.at(component)->locate(p, guess);
    if (component != none || location.inside) return location;
    const Index region = mesh_.region[location.tet];
    if (!may_belong_elsewhere(p, region)) return location;
    const Index owner = owner_at(p);
    if (owner == none || owner == region) return location;
    Guess no_guess;
    const Location own = locators_.at(owner)->locate(p, no_guess);
    return own.distance <= location.distance ? own : location;
}

}
