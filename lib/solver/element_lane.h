// SPDX-License-Identifier: MIT
// The rare parts of the element kernels, one lane at a time and compiled for every processor. Not inline on purpose:
// what a kernel file inlines is compiled for its instruction set only.
#pragma once
#include "solver/kernels.h"

namespace crumple::solver {

// How tet `lane` of the packet collapsed on its way here.
[[nodiscard]] std::uint8_t collapse_of_lane(const ElementJob& job, const TetPacket& packet, int lane);

// Replaces lane l of the quaternions by the rotation of lane l of the row-major F.
void rotate_lane(RotationFunction function, const float (*f)[packet_size], float (*rotor)[packet_size], int l);

// Multiplicative plastic flow of tet `lane`, whose F is lane l of f; changes its shape.
void flow_lane(const ElementJob& job, const TetPacket& packet, TetState& state, TetShape& shape, int lane,
               const float (*f)[packet_size], int l);

// What multiplicative flow would leave of the deviatoric stress of a tet strained by lane l of xx yy zz xy xz yz, as a
// part of it.
[[nodiscard]] float left_of_lane(const ElementJob& job, const TetPacket& packet, const TetState& state,
                                 const TetShape& shape, int lane, const float (*strain)[packet_size], int l);

}
