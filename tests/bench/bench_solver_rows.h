// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of bench_solver that stand in a file of their own.
#pragma once
#include <vector>

#include "bench/bench.h"
#include "bundle/bundle.h"

namespace crumple::bench {

void add_asleep(std::vector<Row>& rows);
void add_skin(std::vector<Row>& rows);
void add_two_threads(std::vector<Row>& rows, const Bundle& bundle, std::uint32_t iterations);

}
