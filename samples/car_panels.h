// SPDX-License-Identifier: MIT
// The sample car's skin: panels cut out of one fine grid over the body, with shut lines, glass, lamps and wheel arches.
#pragma once
#include "samples/model.h"

namespace crumple::samples::car {

[[nodiscard]] Model panels();

}
