// SPDX-License-Identifier: GPL-3.0-or-later
#include "gates/baseline.h"

#include <cmath>

#include "gates/judgement.h"

namespace crumple::gates {

Baseline baseline_of(const quality::Figures& figures) {
    return {figures.shape.tets, figures.shape.volume, figures.cost.pcg_soft, figures.cost.pcg_stiff};
}

std::vector<Finding> judge_against(const Baseline& baseline, const quality::Figures& figures, const Limits& limits) {
    Judgement judgement;
    const auto growth = [&](const char* code, const char* what, double now, double before, const Gate& gate) {
        if (!(before > 0)) return;
        judgement.ask(code, format("%s, now %.4g, over the baseline's %.4g,", what, now, before), now / before, gate,
                      Wanted::low, []() -> Judgement::Told {
                          return {"if that is wanted, run crumple check --update-baseline", {}};
                      });
    };
    growth("GATE_PCG_SOFT", "iterations of the soft standard step", figures.cost.pcg_soft, baseline.pcg_soft,
           limits.pcg_growth);
    growth("GATE_PCG_STIFF", "iterations of the stiff standard step", figures.cost.pcg_stiff, baseline.pcg_stiff,
           limits.pcg_growth);
    growth("GATE_TETS", "tets", figures.shape.tets, static_cast<double>(baseline.tets), limits.tets_growth);
    if (!(baseline.volume > 0)) return std::move(judgement.findings);
    const double change = std::fabs(figures.shape.volume - baseline.volume) / baseline.volume;
    judgement.ask("GATE_VOLUME_CHANGED", "the change of the volume since the baseline", change, limits.volume_change,
                  Wanted::low, []() -> Judgement::Told {
                      return {"if that is wanted, run crumple check --update-baseline", {}};
                  });
    return std::move(judgement.findings);
}

}
