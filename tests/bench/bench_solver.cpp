// SPDX-License-Identifier: GPL-3.0-or-later
// The runtime solver: beside two other ways to make the same steps of the same bar from the same states, kernel by
// kernel, and as a game has it. ratio = theirs / ours for step_*, rotation_* and two_threads_*, ours / theirs for
// half_inverted and scramble.
#include "bench/bench_solver_rows.h"

namespace crumple::bench {
namespace {

void add(const std::string& name, const std::function<void(Rows&)>& add_rows) {
    add_once("solver/" + name, [add_rows] {
        Rows rows;
        add_rows(rows);
        return rows;
    });
}

void add_all(bool quick) {
    using solver::Isa;
    add("step_5k", [quick](Rows& rows) { add_steps(rows, make_bar(BarSize::small), 22, quick); });
    add("kernels_5k", [](Rows& rows) { add_kernels(rows, make_bar(BarSize::small), "_5k"); });
    if (!quick) {
        add("step_50k", [](Rows& rows) { add_steps(rows, make_bar(BarSize::large), 48, false); });
        add("kernels_50k", [](Rows& rows) { add_kernels(rows, make_bar(BarSize::large), "_50k"); });
    }
    add("memory_bytes_per_tet", [](Rows& rows) { add_memory(rows, make_bar(BarSize::large)); });
    add("rotation_8", [](Rows& rows) { add_rotations(rows, "rotation_8", Isa::avx2); });
    add("rotation_16", [](Rows& rows) { add_rotations(rows, "rotation_16", Isa::avx512); });
    add("half_inverted", add_half_inverted);
    add("asleep_us", add_asleep);
    add("skin_100k", add_skin);
    add("cars", [quick](Rows& rows) { add_cars(rows, quick); });
    for (const std::string mode : {"none", "full"}) {
        add("crash_" + mode, [mode](Rows& rows) { add_crash(rows, mode); });
    }
    if (!quick) {
        add("load_50k", [](Rows& rows) { add_load(rows, make_bar(BarSize::large)); });
        add("two_threads_50k", [](Rows& rows) { add_two_threads(rows, make_bar(BarSize::large), 48); });
    }
    add("tip_error", [](Rows& rows) { add_tip_error(rows, make_bar(BarSize::small)); });
    add("table1", [quick](Rows& rows) { add_recovery_table(rows, quick ? 11 : 100); });
    add("table3", add_rotation_table);
    add("scramble", [quick](Rows& rows) { add_scramble(rows, quick ? 31 : 100); });
}

}
}

int main(int argc, char** argv) { return crumple::bench::run(argc, argv, crumple::bench::add_all); }
