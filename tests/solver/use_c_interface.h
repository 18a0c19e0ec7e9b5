/* SPDX-License-Identifier: MIT */
/* What use_c_interface.c does through crumple.h alone, as a program in C would. */
#ifndef CRUMPLE_TESTS_USE_C_INTERFACE_H
#define CRUMPLE_TESTS_USE_C_INTERFACE_H

#include "solver/crumple.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { USED_STEPS = 40 };

typedef struct used_c_interface {
    const char* failure; /* null when all went as it should */
    crumple_report last;
    size_t contacts; /* of all steps */
    int was_triggered;
    float* positions; /* four floats a node of the caller's, filled at the end */
} used_c_interface;

/* Drops a body on a floor, saves, goes on, restores, goes on again, skins, reads a sensor and lifts a node by a curve.
 */
void use_c_interface(const void* blob, size_t size, const crumple_allocator* allocator, const crumple_jobs* jobs,
                     used_c_interface* used);

#ifdef __cplusplus
}
#endif

#endif
