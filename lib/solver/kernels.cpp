// SPDX-License-Identifier: MIT
#include "solver/kernels.h"

namespace crumple::solver {
namespace {

bool can_run([[maybe_unused]] Isa isa) {
    if (isa == Isa::scalar) return true;
#ifdef CRUMPLE_X86
    const bool has_avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    if (isa == Isa::avx2) return has_avx2;
    if (isa == Isa::avx512) {
        return has_avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
               __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw");
    }
#endif
    return false;
}

}

Isa best_isa(Isa wanted) {
    for (const Isa isa : {Isa::avx512, Isa::avx2}) {
        if ((wanted == Isa::automatic || wanted == isa) && can_run(isa)) return isa;
        if (wanted == Isa::avx512 && isa == Isa::avx2 && can_run(isa)) return isa;
    }
    return Isa::scalar;
}

const Kernels& kernels([[maybe_unused]] Isa isa) {
#ifdef CRUMPLE_X86
    if (isa == Isa::avx512) return avx512_kernels;
    if (isa == Isa::avx2) return avx2_kernels;
#endif
    return scalar_kernels;
}

}
