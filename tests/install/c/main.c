/* SPDX-License-Identifier: MIT */
/* A game in C: consumer BLOB drops the body on the floor. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "solver/crumple.h"

/* The file on a 64-byte boundary within *memory, which the caller frees when it steps no more. */
static void* read_file(const char* path, void** memory, size_t* size) {
    FILE* file = fopen(path, "rb");
    char* bytes = NULL;
    long length;
    if (file == NULL) return NULL;
    fseek(file, 0, SEEK_END);
    length = ftell(file);
    rewind(file);
    *memory = malloc((size_t)length + 64);
    bytes = *memory;
    if (bytes != NULL) {
        bytes += 64 - (size_t)bytes % 64;
        *size = fread(bytes, 1, (size_t)length, file);
    }
    fclose(file);
    return bytes;
}

int main(int argc, char** argv) {
    size_t size = 0;
    void* memory = NULL;
    void* blob = argc == 2 ? read_file(argv[1], &memory, &size) : NULL;
    const char* problem = "cannot be read";
    crumple_model* car = NULL;
    crumple_workspace* work = NULL;
    crumple_instance* body = NULL;
    crumple_obstacle floor_plane;
    crumple_input input = crumple_default_input();
    crumple_report report;
    int i;
    if (blob == NULL || crumple_model_create(blob, size, NULL, &car, &problem) != CRUMPLE_OK ||
        crumple_workspace_create(car, NULL, &work) != CRUMPLE_OK ||
        crumple_instance_create(car, NULL, NULL, &body) != CRUMPLE_OK) {
        fprintf(stderr, "%s: %s\n", argv[argc - 1], problem ? problem : "no memory");
        return 1;
    }
    memset(&floor_plane, 0, sizeof floor_plane);
    floor_plane.shape = CRUMPLE_PLANE;
    floor_plane.axis.y = 1;
    floor_plane.position.y = -1;
    floor_plane.orientation.w = 1;
    input.obstacles = &floor_plane;
    input.obstacle_count = 1;
    for (i = 0; i < 30; ++i) crumple_step(body, work, &input, NULL, &report);
    printf("%u tets, %u iterations, energy %g J\n", (unsigned)crumple_model_info(car).solver_tets,
           (unsigned)report.iterations, report.energy);
    crumple_instance_destroy(body);
    crumple_workspace_destroy(work);
    crumple_model_destroy(car);
    free(memory);
    return report.warnings & CRUMPLE_NOT_FINITE ? 1 : 0;
}
