// SPDX-License-Identifier: GPL-3.0-or-later
// Which tets a visual mesh may hang on: those of the shell component it names, else all, the innermost shell deciding.
#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "bind/bind.h"
#include "bind/tet_locator.h"
#include "geometry/measures.h"
#include "mesh/shell_interior.h"

namespace crumple::bind {

class Owners {
public:
    Owners(const Shell& shell, const TetMesh& mesh, const Params& params);

    // The component of that name; none when there is no such component or no name is given.
    [[nodiscard]] Index component(const std::string& name) const;
    [[nodiscard]] bool has_tets(Index component) const { return tet_count_[component] > 0; }

    // Where p hangs when only `component` may have it, or, for none, any.
    [[nodiscard]] Location locate(Vec3 p, Index component, Guess& guess) const;

    // Builds what locate needs for that component, which must have tets, or for none.
    void prepare(Index component);

private:
    [[nodiscard]] Index owner_at(Vec3 p) const;
    [[nodiscard]] bool may_belong_elsewhere(Vec3 p, Index region) const;
    void build(Index component);

    const Shell& shell_;
    const TetMesh& mesh_;
    ShellInterior interior_;
    std::vector<Index> rank_;       // C: innermost first
    std::vector<Index> tet_count_;  // C
    std::vector<Box> box_;          // C
    Preferences preferences_;
    std::map<Index, std::unique_ptr<TetLocator>> locators_;  // by component, none for all
};

}
