// SPDX-License-Identifier: MIT
// The loops of a step, one table per instruction set. Every loop runs over part of its range, writes only to its own
// part and so gives the same bits however the range is divided among threads. Vectors of nodes hold four floats a node.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "core/fields.h"
#include "core/index.h"
#include "solver/element_data.h"
#include "solver/slices.h"

namespace crumple::solver {

enum class Isa { automatic, scalar, avx2, avx512 };
inline constexpr EnumName<Isa> isa_names[] = {
    {Isa::automatic, "automatic"}, {Isa::scalar, "scalar"}, {Isa::avx2, "avx2"}, {Isa::avx512, "avx512"}};
constexpr std::span<const EnumName<Isa>> enum_names(Isa) { return isa_names; }

// Gradients and forces of the corners, from the positions. Over packets.
struct ElementJob {
    const TetPacket* packets;
    TetState* states;
    TetShape* shapes;  // null unless plasticity is multiplicative
    const float* positions;
    const float* velocities;
    float* gradients;  // per tet and corner: sqrt(V mu (beta dt + dt^2)) R g, and lambda / mu
    float* forces;     // per tet and corner: dt times the force at x + (beta + dt) v
    const StepMaterial* materials;
    ElementSettings settings;
};
struct ElementCounts {
    std::uint32_t degenerate = 0;
    std::uint32_t yielding = 0;
    std::uint32_t softened = 0;  // tets that will yield in this step
    double energy = 0;           // elastic, J: what the flow of this step leaves
};

// Right-hand side b - A v of the solve for the change of velocity. Over nodes.
struct LoadJob {
    const Index* node_start;   // N + 1
    const Index* node_corner;  // 4 tet + corner
    const float* forces;
    const float* outside;  // N x 4: dt (gravity and user forces) - dt alpha m v + m (v before constraints - v)
    float* load;           // N x 4
};

// Off-diagonal blocks, nine floats each, those of a group one after the other. Over edges.
struct EdgeJob {
    const Index* edge_start;
    const Index* incidence;    // 16 tet + 4 corner of i + corner of j
    const Index* edge_blocks;  // 2 per edge: block of (i, j) and of (j, i)
    const float* gradients;
    float* blocks;
    float ratio;  // lambda / mu where it is the same everywhere
    bool is_uniform;
};

// Diagonal blocks and their inverses; blocks from how edges leave them to how Slices has them. Over nodes.
struct RowJob {
    const Index* node;  // see Slices
    const Index* start;
    const Index* column;
    const float* damped_mass;  // N: (1 + alpha dt) m
    float* blocks;
    float* inverse;  // columns of the inverse diagonal blocks: 4 nodes x 3 columns x 4, see inverse_at()
};

// Conjugate gradients for A dv = load.
struct SolveJob {
    const Index* node;  // see Slices
    const Index* start;
    const Index* column;
    const std::uint8_t* is_fixed;  // N: the row has no freedom
    const float* blocks;
    const float* inverse;
    float* change;     // dv
    float* residual;   // r
    float* precise;    // z = P r
    float* direction;  // p
    float* product;    // q = A p
};

// The rigid motions of the whole, see rigid_modes.h. Over nodes.
inline constexpr std::size_t mode_floats = 24;  // three axes of six columns and two zeros
inline constexpr std::size_t mode_sums = 48;    // six rows of six columns and two zeros
struct ModeJob {
    const Index* node;  // see Slices
    const Index* start;
    const Index* column;
    const float* blocks;
    const float* positions;
    float* rows;           // N x 24: A Z
    const float* precise;  // z
    float* direction;      // p
};
// Minus a rigid motion, as what is added for one and for each coordinate; four times over, for vectors of four nodes.
struct RigidField {
    alignas(64) float constant[16];
    alignas(64) float by_x[16];
    alignas(64) float by_y[16];
    alignas(64) float by_z[16];
};

// Drawn vertices. Over the vertices of a visual mesh. Null where there are no normals or tangents.
struct SkinJob {
    const Tet* tets;
    const Index* tet;
    const std::array<float, 4>* barycentric;
    const float* positions;  // of the nodes, 4 each
    const TetState* states;
    std::size_t tet_count;  // simulated; the others never turn
    const Vec3f* normals;
    const std::array<float, 4>* tangents;
    Vec3f* drawn_positions;
    Vec3f* drawn_normals;
    std::array<float, 4>* drawn_tangents;
};

// Offset of column 0 of a node's inverse diagonal block; column c is 16 c floats further.
constexpr std::size_t inverse_at(std::size_t node) { return node / 4 * 48 + node % 4 * 4; }

struct Kernels {
    ElementCounts (*elements)(const ElementJob&, std::size_t begin, std::size_t end);
    double (*energies)(const ElementJob&, std::size_t begin,
                       std::size_t end);  // elastic, after the next flow; turns the tets
    void (*rotations)(RotationPacket*, std::size_t begin, std::size_t end);
    void (*loads)(const LoadJob&, std::size_t begin, std::size_t end);
    void (*edges)(const EdgeJob&, std::size_t begin, std::size_t end);
    std::uint32_t (*rows)(const RowJob&, std::size_t begin, std::size_t end);         // nodes too light for float
    void (*multiply)(const SolveJob&, std::size_t begin, std::size_t end);            // q = A p
    double (*product_dot)(const SolveJob&, std::size_t begin, std::size_t end);       // p . q
    double (*start)(const SolveJob&, std::size_t begin, std::size_t end);             // z = P r, p = z: r . z
    double (*descend)(const SolveJob&, float a, std::size_t begin, std::size_t end);  // dv += a p ...: r . z
    void (*turn)(const SolveJob&, float b, std::size_t begin, std::size_t end);       // p = z + b p
    void (*skin)(const SkinJob&, std::size_t begin, std::size_t end);
    void (*multiply_modes)(const ModeJob&, std::size_t begin, std::size_t end);              // A Z
    void (*dot_modes)(const ModeJob&, std::size_t begin, std::size_t end, float* sums);      // (A Z)^T z: 8 sums
    void (*mode_energies)(const ModeJob&, std::size_t begin, std::size_t end, float* sums);  // Z^T (A Z): mode_sums
    void (*subtract_motion)(const ModeJob&, const RigidField&, std::size_t begin, std::size_t end);  // p -= Z mu
};

// What the processor can run, at most `wanted`.
[[nodiscard]] Isa best_isa(Isa wanted = Isa::automatic);
[[nodiscard]] const Kernels& kernels(Isa isa);

extern const Kernels scalar_kernels;
#ifdef CRUMPLE_X86
extern const Kernels avx2_kernels;
extern const Kernels avx512_kernels;
#endif

}
