// SPDX-License-Identifier: GPL-3.0-or-later
// A body as it is at one moment, in the world.
#pragma once
#include "study/player.h"
#include "study/run.h"

namespace crumple::study {

// `since_s` after the frame before.
[[nodiscard]] Frame take_frame(Player& player, double time_s, double since_s);

// Every number of it is one that a file can hold.
[[nodiscard]] bool is_finite(const Frame& frame);

}
