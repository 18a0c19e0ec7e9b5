// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles that close the holes of a surface, and how much of the sphere around a point they cover: what the holes let
// through. Each boundary loop is halved again and again; a half is closed by a chord, so that far parts of a long rim,
// which hardly matter, can be left out together.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "core/index.h"
#include "core/vec3.h"

namespace crumple {

class HoleClosure {
public:
    HoleClosure() = default;
    // Each rim runs the way the triangles at it do, and so does its closure: the closed surface has it turned round.
    explicit HoleClosure(const std::vector<std::vector<Vec3>>& rims);

    [[nodiscard]] std::span<const std::array<Vec3, 3>> triangles() const { return triangles_; }
    [[nodiscard]] bool empty() const { return triangles_.empty(); }

    // Solid angle of all triangles seen from p as a share of the sphere, positive where they face away from p. Up to
    // `tolerance` may be missing; with 0 it is exact to 1e-9.
    [[nodiscard]] double share(Vec3 p, double tolerance = 0) const;

private:
    // In preorder: the first child is the next node.
    struct Node {
        Vec3 centre;
        double radius = 0;      // of a ball around centre that holds all triangles below
        double area = 0;        // of all triangles below, whichever way they face
        Index triangle = none;  // the node's own, none for a group of holes
        Index next = 0;         // node after all below
        double weight = 0;      // of the rim below, of all rims: the part of the tolerance it may use
    };
    struct Hole;

    void add_holes(std::span<Hole> holes);
    void add_section(std::span<const Vec3> rim);
    [[nodiscard]] Index open_node(double weight);
    void close_node(Index node, const std::vector<Vec3>& held);

    std::vector<std::array<Vec3, 3>> triangles_;
    std::vector<Node> nodes_;
    double edge_count_ = 0;
};

}
