// SPDX-License-Identifier: GPL-3.0-or-later
// What a run has done to a body: its dents, and what went wrong on the way.
#pragma once
#include "study/player.h"
#include "study/run.h"

namespace crumple::study {

// Fills locked_drift, deepest_dent_m, inverted_at_end, driven_inside_out and findings. REQUIRES: the run has frames,
// and its steps are counted.
void judge_outcome(const Player& player, Run& run);

}
