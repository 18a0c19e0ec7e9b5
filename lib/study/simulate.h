// SPDX-License-Identifier: GPL-3.0-or-later
// A scene played with a bundle, and what came of it.
#pragma once
#include "bundle/bundle.h"
#include "core/context.h"
#include "study/run.h"
#include "study/scene.h"

namespace crumple::study {

// Every number of the run is finite. Throws Error(bad_input) for a bundle that cannot be stepped and for a run that
// leaves what floats can hold, Error(usage) for a handle without nodes.
[[nodiscard]] Run simulate(const Bundle& bundle, const Scene& scene, const Context& context = {});

}
