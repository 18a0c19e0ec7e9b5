/* SPDX-License-Identifier: MIT */
/* The solver for C99 and for whoever speaks C: opaque handles over the C++ interface of this folder, whose headers
 * (instance.h, contact.h, skin.h, sensor.h, step.h) say what each thing means. No function throws. Only create
 * functions take memory, all of it from the caller's allocator; a step takes none. Different instances may be stepped
 * at the same time, each with a workspace of its own.
 *
 *     crumple_model* car;
 *     const char* problem;
 *     if (crumple_model_create(blob, size, NULL, &car, &problem) != CRUMPLE_OK) puts(problem);
 *     crumple_instance_create(car, NULL, NULL, &body);
 *     crumple_workspace_create(car, NULL, &work);
 *     crumple_input input = crumple_default_input();
 *     crumple_step(body, work, &input, NULL, &report);   each frame
 */
#ifndef CRUMPLE_H
#define CRUMPLE_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define CRUMPLE_C_VERSION 1 /* of this header; crumple_c_version() is that of the library */
uint32_t crumple_c_version(void);

typedef enum crumple_status {
    CRUMPLE_OK = 0,
    CRUMPLE_BAD_ARGUMENT = 1, /* a null (also where a count says there is an array), a wrong size, an index out of
                                 range, a kind or shape that is none: nothing was done */
    CRUMPLE_BAD_BLOB = 2,     /* the blob is refused */
    CRUMPLE_NO_MEMORY = 3     /* the allocator gave none */
} crumple_status;

typedef struct crumple_vec3f {
    float x, y, z;
} crumple_vec3f;
typedef struct crumple_vec3 {
    double x, y, z;
} crumple_vec3;
typedef struct crumple_quaternion {
    float x, y, z, w; /* the identity is 0, 0, 0, 1 */
} crumple_quaternion;

/* allocate: `bytes` at a multiple of `alignment` (64 at most), or null. Copied into each handle made with it. Null in
 * place of an allocator: the C++ heap. */
typedef struct crumple_allocator {
    void* (*allocate)(void* user, size_t bytes, size_t alignment);
    void (*release)(void* user, void* memory, size_t bytes);
    void* user;
} crumple_allocator;

/* run: task(context, i) for every i below count, in any order on any threads, returning when all are done. Null in
 * place of jobs: the calling thread does all. The results have the same bits either way. */
typedef struct crumple_jobs {
    void (*run)(void* user, size_t count, void (*task)(void* context, size_t index), void* context);
    void* user;
} crumple_jobs;

/* ---- A model: what all instances of one asset share. ---- */

typedef struct crumple_model crumple_model;

/* The blob (`crumple export --blob`) lies on a 64-byte boundary, unchanged until the model is destroyed. It is opened
 * and checked so that nothing reads outside it. What a step needs of it is copied: only names, skinning and sensors
 * read it afterwards, so most pages of a mapped file leave memory by themselves. `problem` may be null; it receives a
 * text that is never freed, or null. */
crumple_status crumple_model_create(const void* blob, size_t size, const crumple_allocator* allocator,
                                    crumple_model** model, const char** problem);
/* After everything made from it. Null is fine, as for all destroy functions. */
void crumple_model_destroy(crumple_model* model);

/* Every rule of a bundle proved from scratch. Slow, uses the C++ heap: for tools and for a first look. `message` (of
 * message_size characters, may be null) receives the first complaint. */
crumple_status crumple_check_blob(const void* blob, size_t size, char* message, size_t message_size);

typedef struct crumple_info {
    uint32_t nodes;
    uint32_t tets;
    uint32_t solver_tets;
    uint32_t visuals;
    uint32_t sensors;
    uint32_t materials;
} crumple_info;
crumple_info crumple_model_info(const crumple_model* model);

const crumple_vec3f* crumple_rest_positions(const crumple_model* model); /* nodes */
const uint8_t* crumple_locked(const crumple_model* model);               /* nodes: 1 where locked */

/* Index by name, or UINT32_MAX. Names are UTF-8 and end with a zero; null for an index out of range. */
uint32_t crumple_find_visual(const crumple_model* model, const char* name);
uint32_t crumple_find_sensor(const crumple_model* model, const char* name);
const char* crumple_visual_name(const crumple_model* model, uint32_t visual);
const char* crumple_sensor_name(const crumple_model* model, uint32_t sensor);
uint32_t crumple_visual_vertices(const crumple_model* model, uint32_t visual);

/* ---- A workspace: what does not outlive a step. One a thread, for any instance of its model. ---- */

typedef struct crumple_workspace crumple_workspace;
crumple_status crumple_workspace_create(const crumple_model* model, const crumple_allocator* allocator,
                                        crumple_workspace** workspace);
void crumple_workspace_destroy(crumple_workspace* workspace);

/* ---- An instance: one body in motion. ---- */

typedef struct crumple_instance crumple_instance;

enum {
    CRUMPLE_ROTATION_APD,
    CRUMPLE_ROTATION_QR,
    CRUMPLE_ROTATION_POLAR,
    CRUMPLE_ROTATION_SVD_SMALLEST,
    CRUMPLE_ROTATION_SVD_LAST
};
enum { CRUMPLE_REFLECT, CRUMPLE_PROJECT, CRUMPLE_SMOOTH, CRUMPLE_TREATMENT_OFF };
enum { CRUMPLE_ADDITIVE, CRUMPLE_MULTIPLICATIVE, CRUMPLE_PLASTICITY_OFF };
enum { CRUMPLE_ISA_AUTOMATIC, CRUMPLE_ISA_SCALAR, CRUMPLE_ISA_AVX2, CRUMPLE_ISA_AVX512 };

/* Numbers out of range are taken as the nearest in range. */
typedef struct crumple_settings {
    uint32_t rotation;
    uint32_t treatment;
    uint32_t plasticity;
    uint32_t isa;
    double degenerate_threshold;
    double min_plastic_stretch;
    double max_plastic_stretch;
    uint32_t max_iterations;
    double tolerance;
} crumple_settings;
crumple_settings crumple_default_settings(void);

/* settings may be null: the defaults. At rest, awake. */
crumple_status crumple_instance_create(const crumple_model* model, const crumple_settings* settings,
                                       const crumple_allocator* allocator, crumple_instance** instance);
void crumple_instance_destroy(crumple_instance* instance);

/* In the carrier's frame; four floats a node, the fourth 0. */
const float* crumple_positions(const crumple_instance* instance);
const float* crumple_velocities(const crumple_instance* instance);
/* Refused: what is not finite or beyond 1e18. */
crumple_status crumple_set_velocity(crumple_instance* instance, uint32_t node, crumple_vec3f velocity);

/* The state as bytes: equal bytes are equal states. Restore takes what save gave for the same blob and plasticity.
 * Other bytes are refused with CRUMPLE_BAD_ARGUMENT by their checksum, and the body stays as it was; bytes forged
 * to have the right one never harm a step, but may leave the body as after crumple_instance_create. What sensors
 * remember, triggers among it, is not part of the state. */
size_t crumple_state_size(const crumple_instance* instance);
crumple_status crumple_save(const crumple_instance* instance, void* bytes, size_t size);
crumple_status crumple_restore(crumple_instance* instance, const void* bytes, size_t size);

void crumple_wake(crumple_instance* instance);
int crumple_is_asleep(const crumple_instance* instance);

/* ---- A step. ---- */

enum { CRUMPLE_FIXED, CRUMPLE_ON_PLANE, CRUMPLE_ON_RAIL, CRUMPLE_IN_CONTACT };
typedef struct crumple_constraint {
    uint32_t node;
    uint8_t kind;
    crumple_vec3f velocity;
    crumple_vec3f normal;
    crumple_vec3f second;
} crumple_constraint;

enum { CRUMPLE_PLANE, CRUMPLE_CAPSULE, CRUMPLE_BOX };
typedef struct crumple_obstacle {
    uint8_t shape;
    crumple_vec3 position;
    crumple_vec3 axis;
    double radius;
    crumple_quaternion orientation;
    crumple_vec3 velocity;
    crumple_vec3 angular_velocity;
    float restitution;
} crumple_obstacle;

typedef struct crumple_hit {
    crumple_vec3 position;
    crumple_vec3 momentum; /* N s */
} crumple_hit;

typedef struct crumple_wind {
    crumple_vec3f velocity;
    float density_kg_m3;
    float drag;
} crumple_wind;

typedef struct crumple_carrier {
    crumple_vec3 position;
    crumple_quaternion orientation;
    crumple_vec3 velocity;
    crumple_vec3 angular_velocity;
    crumple_vec3 acceleration;
    crumple_vec3 angular_acceleration;
} crumple_carrier;

/* Obstacles, hits, gravity and wind in the world, all else in the carrier's frame.
 *
 * A step refuses an input as a whole, with CRUMPLE_BAD_INPUT in the report, nothing done and no load, when
 * - a number it would use is not finite or beyond 1e18 in size;
 * - dt is not above 0; the carrier's mass, a radius, a box's half edge, density or drag is below 0; a restitution is
 *   not in 0 to 1;
 * - the carrier's or a box's orientation is 0, or a plane's axis is (it may have any other length);
 * - a sleep setting is not a number (infinite ones mean never or always).
 * Not used, so not looked at: accelerations without has_inertia, the mass of a carrier that is not free, an orientation
 * where the shape has none; by a sleeping body also dt, wind, forces and constraints.
 * A single constraint that is bad is left out, with CRUMPLE_BAD_CONSTRAINT. */
typedef struct crumple_input {
    float dt;
    crumple_carrier carrier;
    int is_carrier_free;
    double carrier_mass;
    int has_inertia;
    crumple_vec3 gravity;
    const crumple_obstacle* obstacles;
    size_t obstacle_count;
    const crumple_hit* hits;
    size_t hit_count;
    const crumple_wind* wind;    /* may be null */
    const crumple_vec3f* forces; /* a node each, newtons; may be null */
    const crumple_constraint* constraints;
    size_t constraint_count;
    crumple_vec3f* reactions; /* a node each, newtons its constraint or lock pushes with, 0 where free; may be null. A
                               * body that sleeps leaves them as they are. */
    float sleep_speed;
    float sleep_after_s;
    float wake_speed;
    float wake_pull;
    int may_sleep;
} crumple_input;
crumple_input crumple_default_input(void);

/* Bits of warnings. */
enum {
    CRUMPLE_TOO_STIFF = 1,      /* float lost the positive definiteness: the solve stopped early */
    CRUMPLE_NOT_FINITE = 2,     /* a node's velocity, or the load, overflowed and was set to 0 */
    CRUMPLE_BAD_CONSTRAINT = 4, /* a constraint was left out */
    CRUMPLE_BAD_INPUT = 8,      /* the input was refused: nothing was done */
    CRUMPLE_RESTRAINED = 16     /* the step was cut short, or it would have made energy */
};

typedef struct crumple_report {
    uint32_t iterations;
    float residual;
    uint32_t degenerate;
    uint32_t yielding;
    uint32_t warnings;
    double energy;
    crumple_vec3 force;  /* on the rigid body that carries it, world; always finite */
    crumple_vec3 torque; /* about the frame's origin */
    size_t contacts;
    int is_room_too_small;
    int is_asleep;
} crumple_report;

/* jobs and report may be null. */
crumple_status crumple_step(crumple_instance* instance, crumple_workspace* workspace, const crumple_input* input,
                            const crumple_jobs* jobs, crumple_report* report);

/* ---- Keyframes: nodes that follow curves (spline.h). ---- */

enum { CRUMPLE_CATMULL_ROM, CRUMPLE_NATURAL_CUBIC };

/* Times ascend, in seconds. No keys: it stays 0. */
typedef struct crumple_spline {
    const float* times;
    const crumple_vec3f* values;
    const crumple_vec3f* slopes; /* of crumple_find_slopes */
    size_t key_count;
} crumple_spline;

/* Fills the slopes. scratch: a number a key, of no use afterwards. */
crumple_status crumple_find_slopes(uint32_t kind, const float* times, const crumple_vec3f* values, size_t key_count,
                                   crumple_vec3f* slopes, float* scratch);

/* Nodes moved as one rigid thing: x = pivot + R(turn) (rest - pivot) + shift, turn a rotation vector in radians. */
typedef struct crumple_handle {
    const uint32_t* nodes;
    size_t node_count;
    crumple_vec3f pivot;
    crumple_spline shift;
    crumple_spline turn;
} crumple_handle;

/* Constraints, one a node, that bring the nodes to where the handle is at time + dt: for crumple_input. Room for fewer
 * is refused. */
crumple_status crumple_drive(const crumple_instance* instance, const crumple_handle* handle, float time, float dt,
                             crumple_constraint* constraints, size_t room);

/* ---- What is drawn. ---- */

/* [*first, *last): vertices of a visual mesh that hang on a node which moved more than `tolerance` metres since
 * crumple_forget_moves. */
crumple_status crumple_moved_vertices(const crumple_instance* instance, uint32_t visual, float tolerance,
                                      uint32_t* first, uint32_t* last);
void crumple_forget_moves(crumple_instance* instance);

/* Each array over all vertices of the visual mesh. Normals and tangents may be null, in rest and drawn alike. */
typedef struct crumple_vertices {
    const crumple_vec3f* rest_normals;
    const float* rest_tangents; /* four floats a vertex */
    crumple_vec3f* positions;
    crumple_vec3f* normals;
    float* tangents;
} crumple_vertices;

/* Fills the vertices [first, last). */
crumple_status crumple_skin(const crumple_instance* instance, uint32_t visual, const crumple_vertices* vertices,
                            uint32_t first, uint32_t last, const crumple_jobs* jobs);

/* ---- Sensors. ---- */

/* In the carrier's frame. The acceleration is that of the place in the world, along the carrier's axes, mean since the
 * last reading: the carrier's own is in it, so a locked part feels the crash too. Gravity is not taken out. */
typedef struct crumple_reading {
    crumple_quaternion orientation;
    crumple_vec3f origin;
    crumple_vec3f velocity;
    crumple_vec3f acceleration;
    float deformation;
    float plastic_strain;
} crumple_reading;

/* dt: since the last reading of this sensor of this instance. carrier: as it is now, a free one with the load of the
 * step in its velocities; its accelerations are not used. Null: it stands still. Refused where a step would refuse it.
 */
crumple_status crumple_read_sensor(crumple_instance* instance, uint32_t sensor, const crumple_carrier* carrier,
                                   float dt, crumple_reading* reading);

/* On when the value reaches `on`, off when it falls below `off`. 1 when it just went on, else 0. */
int crumple_trigger(crumple_instance* instance, uint32_t sensor, float value, float on, float off);

#ifdef __cplusplus
}
#endif

#endif
