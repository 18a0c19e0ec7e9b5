// SPDX-License-Identifier: MIT
// A rounded animal-like blob: smooth, closed, genus 0, the friendliest input there is.
#pragma once
#include "samples/model.h"

namespace crumple::samples {

[[nodiscard]] Model blob_shell();   // one part, 642 vertices, the four feet locked
[[nodiscard]] Model blob_visual();  // one part, 10242 vertices, inside the shell

}
