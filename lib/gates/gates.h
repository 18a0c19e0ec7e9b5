// SPDX-License-Identifier: GPL-3.0-or-later
// The last stage: measures a bundle as a game will load it, beside the shell it was made from, and holds every figure
// against its gate. It changes nothing; whoever asked decides what becomes of a bundle that fails.
#pragma once
#include <cstdint>
#include <vector>

#include "bundle/bundle.h"
#include "core/context.h"
#include "core/fields.h"
#include "core/finding.h"
#include "gates/limits.h"
#include "mesh/asset.h"
#include "quality/figures.h"

namespace crumple::gates {

inline constexpr int version = 1;

struct Params {
    bool enforce = true;
    std::uint32_t hausdorff_samples = 4000;
    Limits limits;
};

struct Report {
    quality::Figures figures;
    std::vector<Finding> findings;  // GATE_*: Severity::error where a gate fails
};

template <class Visitor, FieldsOf<Params> P>
void describe(Visitor& visit, P& p) {
    visit.field("enforce", p.enforce, "false: a gate that fails is warned of, and the bundle is taken all the same");
    visit.field("hausdorff_samples", p.hausdorff_samples, Range{0, 10000000},
                "points spread over a surface to measure its distance from the other one, besides its vertices");
    describe(visit, p.limits);
}

template <class Visitor, FieldsOf<Report> R>
void describe(Visitor& visit, R& r) {
    visit.field("figures", r.figures, "of the bundle, as it will be loaded");
    visit.field("findings", r.findings, "gates that are not met");
}

// What cull found out about the shell's solid. Only an open or crossing shell needs it: it cannot be measured again
// without the tets outside.
struct Solid {
    double volume = 0;  // cubic metres, 0: not known
    double leak_share = 0;
    std::uint64_t pieces = 0;
};

// The same figures for the same bundle and asset. REQUIRES: the bundle is valid and was baked from this asset.
[[nodiscard]] Report judge_bundle(const Bundle& bundle, const Asset& asset, const Solid& solid,
                                  const Params& params = {}, const Context& context = {});

// For a file that does not hold the asset any more: what needs it is taken as it was told then. A bundle that passed
// passes again. REQUIRES: the bundle is valid.
[[nodiscard]] Report judge_again(const Bundle& bundle, const Report& told, const Params& params = {},
                                 const Context& context = {});

}
