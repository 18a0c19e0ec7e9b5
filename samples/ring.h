// SPDX-License-Identifier: MIT
// A swimming ring: genus 1, so the middle must stay empty.
#pragma once
#include "samples/model.h"

namespace crumple::samples {

[[nodiscard]] Model ring_shell();   // one part, one side of it locked
[[nodiscard]] Model ring_visual();  // one part, inside the shell

}
