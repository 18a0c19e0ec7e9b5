// SPDX-License-Identifier: GPL-3.0-or-later
// Says which bad tets are left and why: those that the shell forces, which only its artist can mend, and those that
// finish failed at.
#pragma once
#include <vector>

#include "core/context.h"
#include "finish/finish.h"

namespace crumple::finish {

// Fills report.forced_thin, forced_needle, failed and the findings. REQUIRES: the other figures of the report.
void judge_result(const Shell& shell, const TetMesh& mesh, Report& report, const Context& context);

}
