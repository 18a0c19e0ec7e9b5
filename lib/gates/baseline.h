// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh held against what its asset was at before.
#pragma once
#include <cstdint>
#include <vector>

#include "core/fields.h"
#include "core/finding.h"
#include "gates/limits.h"
#include "quality/figures.h"

namespace crumple::gates {

// What an asset was at when it was last found good.
struct Baseline {
    std::uint64_t tets = 0;
    double volume = 0;
    std::uint32_t pcg_soft = 0;
    std::uint32_t pcg_stiff = 0;
};

template <class Visitor, FieldsOf<Baseline> B>
void describe(Visitor& visit, B& b) {
    visit.field("tets", b.tets, "tets");
    visit.field("volume", b.volume, "of the tets, cubic metres");
    visit.field("pcg_soft", b.pcg_soft, "iterations of the soft standard step");
    visit.field("pcg_stiff", b.pcg_stiff, "iterations of the stiff standard step");
}

[[nodiscard]] Baseline baseline_of(const quality::Figures& figures);

// GATE_PCG_SOFT, GATE_PCG_STIFF, GATE_TETS, GATE_VOLUME_CHANGED: of the whole mesh, so without places. An
// empty baseline compares nothing.
[[nodiscard]] std::vector<Finding> judge_against(const Baseline& baseline, const quality::Figures& figures,
                                                 const Limits& limits = {});

}
