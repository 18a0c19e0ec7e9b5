/* SPDX-License-Identifier: MIT */
/* Strict C99: if this file compiles, crumple.h is a header of C. */
#include "solver/use_c_interface.h"

#include <stdlib.h>
#include <string.h>

static void step_some(crumple_instance* body, crumple_workspace* work, const crumple_jobs* jobs, int steps,
                      used_c_interface* used) {
    crumple_obstacle hammer;
    crumple_input input = crumple_default_input();
    int i;
    memset(&hammer, 0, sizeof hammer);
    hammer.shape = CRUMPLE_PLANE;
    hammer.axis.y = -1; /* solid above */
    hammer.position.y = 3.9;
    hammer.orientation.w = 1;
    hammer.velocity.y = -1;
    input.obstacles = &hammer;
    input.obstacle_count = 1;
    for (i = 0; i < steps && used->failure == NULL; ++i) {
        if (crumple_step(body, work, &input, jobs, &used->last) != CRUMPLE_OK) used->failure = "step";
        used->contacts += used->last.contacts;
        hammer.position.y -= input.dt;
    }
}

static void save_and_restore(crumple_instance* body, crumple_workspace* work, const crumple_jobs* jobs,
                             used_c_interface* used) {
    const size_t size = crumple_state_size(body);
    char* start = malloc(2 * size);
    char* end = start + size;
    if (start == NULL || crumple_save(body, start, size) != CRUMPLE_OK) used->failure = "save";
    step_some(body, work, jobs, USED_STEPS / 2, used);
    if (crumple_save(body, end, size) != CRUMPLE_OK) used->failure = "save again";
    if (crumple_restore(body, start, size) != CRUMPLE_OK) used->failure = "restore";
    step_some(body, work, jobs, USED_STEPS / 2, used);
    if (crumple_save(body, start, size) != CRUMPLE_OK || memcmp(start, end, size) != 0)
        used->failure = "not the same bits";
    free(start);
}

static void draw(const crumple_model* model, crumple_instance* body, const crumple_jobs* jobs, used_c_interface* used) {
    const uint32_t paint = crumple_find_visual(model, "paint");
    const uint32_t count = crumple_visual_vertices(model, paint);
    crumple_vec3f* positions = malloc((count + 1) * sizeof *positions);
    crumple_vertices vertices;
    uint32_t first = 0;
    uint32_t last = 0;
    memset(&vertices, 0, sizeof vertices);
    vertices.positions = positions;
    if (strcmp(crumple_visual_name(model, paint), "paint") != 0) used->failure = "visual name";
    if (crumple_moved_vertices(body, paint, 0, &first, &last) != CRUMPLE_OK || first >= last || last > count) {
        used->failure = "moved vertices";
    }
    if (crumple_skin(body, paint, &vertices, first, last, jobs) != CRUMPLE_OK) used->failure = "skin";
    if (!(positions[first].y > 0 && positions[first].y < 5)) used->failure = "a drawn vertex is far away";
    if (crumple_skin(body, paint, &vertices, 0, count + 1, jobs) != CRUMPLE_BAD_ARGUMENT)
        used->failure = "skin too much";
    crumple_forget_moves(body);
    if (crumple_moved_vertices(body, paint, 0, &first, &last) != CRUMPLE_OK || first != last) used->failure = "forget";
    free(positions);
}

static void read_roof(const crumple_model* model, crumple_instance* body, used_c_interface* used) {
    const uint32_t roof = crumple_find_sensor(model, "roof");
    crumple_reading reading;
    crumple_carrier carrier = crumple_default_input().carrier;
    if (crumple_read_sensor(body, roof, NULL, 1.0f / 60, &reading) != CRUMPLE_OK) used->failure = "sensor";
    carrier.velocity.x = 1.5;
    if (crumple_read_sensor(body, roof, &carrier, 0.5f, &reading) != CRUMPLE_OK) used->failure = "sensor that rides";
    if (!(reading.acceleration.x > 2.999f && reading.acceleration.x < 3.001f)) used->failure = "carrier not felt";
    carrier.orientation.w = 0;
    if (crumple_read_sensor(body, roof, &carrier, 0.5f, &reading) != CRUMPLE_BAD_ARGUMENT)
        used->failure = "a carrier without orientation";
    if (!(reading.deformation > 0)) used->failure = "the sensor felt nothing";
    used->was_triggered = crumple_trigger(body, roof, reading.deformation, 1e-4f, 1e-5f);
    if (crumple_trigger(body, roof, reading.deformation, 1e-4f, 1e-5f) != 0) used->failure = "triggered twice";
    if (crumple_read_sensor(body, roof + 1, NULL, 1, &reading) != CRUMPLE_BAD_ARGUMENT)
        used->failure = "no such sensor";
}

/* Lifts the last node by a curve, and sees that it follows. */
static void lift_a_node(const crumple_model* model, crumple_instance* body, crumple_workspace* work,
                        used_c_interface* used) {
    const float times[] = {0, 0.1f, 0.2f};
    const float standing_still[] = {1, 1, 1};
    const crumple_vec3f values[] = {{0, 0, 0}, {0, 0.1f, 0}, {0, 0.1f, 0.1f}};
    crumple_vec3f slopes[3];
    float scratch[3];
    const uint32_t node = crumple_model_info(model).nodes - 1;
    const float* at = crumple_positions(body) + 4 * node;
    const crumple_vec3f rest = crumple_rest_positions(model)[node];
    crumple_constraint constraint;
    crumple_handle handle;
    crumple_input input = crumple_default_input();
    int i;
    memset(&handle, 0, sizeof handle);
    handle.nodes = &node;
    handle.node_count = 1;
    handle.shift.times = times;
    handle.shift.values = values;
    handle.shift.slopes = slopes;
    handle.shift.key_count = 3;
    input.constraints = &constraint;
    input.constraint_count = 1;
    input.may_sleep = 0;
    if (crumple_find_slopes(CRUMPLE_NATURAL_CUBIC, times, values, 3, slopes, scratch) != CRUMPLE_OK)
        used->failure = "slopes";
    for (i = 0; i < 20; ++i) {
        if (crumple_drive(body, &handle, (float)i * input.dt, input.dt, &constraint, 1) != CRUMPLE_OK)
            used->failure = "drive";
        if (crumple_step(body, work, &input, NULL, NULL) != CRUMPLE_OK) used->failure = "driven step";
    }
    /* The body is crushed, and steps that are cut short leave the node a little off. */
    if (!(at[1] - rest.y > 0.095f && at[1] - rest.y < 0.105f && at[2] - rest.z > 0.095f && at[2] - rest.z < 0.105f))
        used->failure = "the node did not follow";
    if (crumple_drive(body, &handle, 0, input.dt, &constraint, 0) != CRUMPLE_BAD_ARGUMENT) used->failure = "no room";
    handle.shift.times = standing_still;
    if (crumple_drive(body, &handle, 0, input.dt, &constraint, 1) != CRUMPLE_BAD_ARGUMENT)
        used->failure = "times that do not ascend";
    handle.shift.times = NULL;
    if (crumple_drive(body, &handle, 0, input.dt, &constraint, 1) != CRUMPLE_BAD_ARGUMENT)
        used->failure = "a curve without times";
}

void use_c_interface(const void* blob, size_t size, const crumple_allocator* allocator, const crumple_jobs* jobs,
                     used_c_interface* used) {
    crumple_model* model = NULL;
    crumple_workspace* work = NULL;
    crumple_instance* body = NULL;
    const char* problem = NULL;
    const crumple_settings settings = crumple_default_settings();
    if (crumple_model_create(blob, size, allocator, &model, &problem) != CRUMPLE_OK) {
        used->failure = problem ? problem : "model";
    } else if (crumple_workspace_create(model, allocator, &work) != CRUMPLE_OK) {
        used->failure = "workspace";
    } else if (crumple_instance_create(model, &settings, allocator, &body) != CRUMPLE_OK) {
        used->failure = "instance";
    } else {
        step_some(body, work, jobs, USED_STEPS / 2, used);
        save_and_restore(body, work, jobs, used);
        draw(model, body, jobs, used);
        read_roof(model, body, used);
        memcpy(used->positions, crumple_positions(body), 4 * sizeof(float) * crumple_model_info(model).nodes);
        lift_a_node(model, body, work, used);
    }
    crumple_instance_destroy(body);
    crumple_workspace_destroy(work);
    crumple_model_destroy(model);
}
