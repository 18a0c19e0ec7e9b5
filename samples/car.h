// SPDX-License-Identifier: MIT
// The sample car: what an artist would hand to the cooker. X is left, Y up, Z forward, metres, ground at y = 0.
#pragma once
#include "samples/model.h"

namespace crumple::samples {

// The control shell: seven closed surfaces. The body carries everything; inside it lie the engine block (all locked),
// the roll cage (a frame of square tubes, its feet locked) and four wheel houses (all locked).
[[nodiscard]] Model car_shell();

// What is drawn: more than 50 000 vertices of panels, glass, lamps, wheels, engine, cage and seats, all inside the
// shell.
[[nodiscard]] Model car_visual();

}
