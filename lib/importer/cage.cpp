// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/cage.h"

#include <algorithm>
#include <cmath>

#include "core/counted.h"
#include "core/parallel_for.h"
#include "core/short_text.h"
#include "geometry/bvh.h"
#include "geometry/predicates.h"
#include "importer/lattice.h"
#include "mesh/boundary.h"
#include "mesh/neighbours.h"
#include "mesh/shell_interior.h"
#include "mesh/tet_clearance.h"

namespace crumple::importer {

namespace {

using Flags = std::vector<std::uint8_t>;

std::array<Vec3, 4> corners_of(const TetMesh& mesh, std::size_t t) {
    const auto& [a, b, c, d] = mesh.tets[t];
    return {mesh.positions[a], mesh.positions[b], mesh.positions[c], mesh.positions[d]};
}

bool holds(const std::array<Vec3, 4>& tet, Vec3 p) {
    return std::all_of(std::begin(tet_face_corners), std::end(tet_face_corners),
                       [&](const auto& face) { return orient3d(tet[face[0]], tet[face[1]], tet[face[2]], p) <= 0; });
}

// Finds the tets that hold a place.
class Locator {
public:
    explicit Locator(const TetMesh& mesh) : mesh_(mesh) {
        std::vector<Box> boxes;
        boxes.reserve(mesh.tets.size());
        for (std::size_t t = 0; t < mesh.tets.size(); ++t) boxes.push_back(bounding_box(corners_of(mesh, t)));
        tree_ = Bvh(boxes);
    }
    // Several where p lies on a face.
    template <class Visit>
    void for_each_holding(Vec3 p, Visit&& visit) const {
        tree_.containing(p, [&](Index t) {
            if (holds(corners_of(mesh_, t), p)) visit(t);
            return false;
        });
    }

private:
    const TetMesh& mesh_;
    Bvh tree_;
};

// A little larger, so that a triangle that only touches the tet, or lies along a face of it, passes through.
std::array<Vec3, 4> grown(std::array<Vec3, 4> tet) {
    const Vec3 middle = (tet[0] + tet[1] + tet[2] + tet[3]) * 0.25;
    for (Vec3& corner : tet) corner += (corner - middle) * 0.01;
    return tet;
}

Flags touched_tets(const TetMesh& mesh, const Shell& shell, const Context& context) {
    const TetClearance clearance(shell);
    Flags is_touched(mesh.tets.size(), 0);
    parallel_for(context, mesh.tets.size(), 512, [&](std::size_t begin, std::size_t end) {
        context.stop_if_cancelled();
        for (std::size_t t = begin; t < end; ++t) is_touched[t] = !clearance.is_clear(grown(corners_of(mesh, t)));
    });
    return is_touched;
}

// From the rim of the lattice through every tet that is not touched.
Flags reached_from_outside(const TetMesh& mesh, const Flags& is_touched) {
    Flags is_reached(mesh.tets.size(), 0);
    std::vector<Index> waiting;
    const auto reach = [&](Index t) {
        if (t == none || is_reached[t] || is_touched[t]) return;
        is_reached[t] = 1;
        waiting.push_back(t);
    };
    for (Index t = 0; t < mesh.tets.size(); ++t) {
        const auto& across = mesh.neighbours[t];
        if (std::find(across.begin(), across.end(), none) != across.end()) reach(t);
    }
    while (!waiting.empty()) {
        const Index t = waiting.back();
        waiting.pop_back();
        for (const Index next : mesh.neighbours[t]) reach(next);
    }
    return is_reached;
}

void keep_inside(const TetMesh& mesh, const Shell& shell, const Context& context, Flags& is_kept) {
    const ShellInterior interior(shell);
    parallel_for(context, mesh.tets.size(), 512, [&](std::size_t begin, std::size_t end) {
        context.stop_if_cancelled();
        for (std::size_t t = begin; t < end; ++t) {
            if (is_kept[t]) continue;
            const auto corners = corners_of(mesh, t);
            is_kept[t] = interior.material_at((corners[0] + corners[1] + corners[2] + corners[3]) * 0.25) != none;
        }
    });
}

TetMesh kept_tets(const TetMesh& mesh, const Flags& is_kept) {
    TetMesh kept;
    kept.positions = mesh.positions;
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
        if (is_kept[t]) kept.tets.push_back(mesh.tets[t]);
    }
    kept.neighbours = neighbours_of(kept.tets);
    return kept;
}

// Where the surface is no manifold all tets around the vertex join, until it is one. Each round adds tets, and the
// whole lattice is a box, so it ends.
TetMesh close_manifold(const TetMesh& mesh, Flags& is_kept) {
    for (;;) {
        TetMesh kept = kept_tets(mesh, is_kept);
        const std::vector<Triangle> faces = boundary_of(kept).faces;
        const NonManifold wrong = non_manifold(faces);
        if (wrong.vertices.empty()) return kept;
        Flags is_wrong(mesh.positions.size(), 0);
        for (const Index v : wrong.vertices) is_wrong[v] = 1;
        for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
            for (const Index v : mesh.tets[t]) is_kept[t] |= is_wrong[v];
        }
    }
}

void add_components(Shell& shell, const std::vector<Index>& piece) {
    shell.component = piece;
    const Index count = piece.empty() ? 0 : *std::max_element(piece.begin(), piece.end()) + 1;
    for (Index c = 0; c < count; ++c) {
        Component component;
        component.name = c == 0 ? "cage" : "cage." + std::to_string(c + 1);
        component.role = Role::solid;
        component.role_reason = "lattice around the file's shell";
        component.is_closed = true;
        shell.components.push_back(std::move(component));
    }
}

// Nodes in use, in their order; the surface as triangles.
Shell shell_of(const TetMesh& kept, const Flags& is_locked) {
    std::vector<Index> number(kept.positions.size(), none);
    for (const Tet& tet : kept.tets) {
        for (const Index v : tet) number[v] = 0;
    }
    Shell shell;
    for (Index v = 0; v < number.size(); ++v) {
        if (number[v] == none) continue;
        number[v] = static_cast<Index>(shell.positions.size());
        shell.positions.push_back(kept.positions[v]);
        shell.locked.push_back(is_locked[v]);
        shell.source_vertex.push_back(none);
    }
    const Boundary boundary = boundary_of(kept);
    const std::vector<Index> pieces = pieces_of(kept);
    std::vector<Index> piece;
    for (std::size_t f = 0; f < boundary.faces.size(); ++f) {
        const auto& [a, b, c] = boundary.faces[f];
        shell.triangles.push_back({number[a], number[b], number[c]});
        piece.push_back(pieces[boundary.tet[f]]);
    }
    add_components(shell, piece);
    for (std::size_t t = 0; t < kept.tets.size(); ++t) {
        const auto [a, b, c, d] = corners_of(kept, t);
        shell.components[pieces[t]].volume += signed_volume(a, b, c, d);
    }
    return shell;
}

Box box_of(const Asset& asset) {
    Box box = bounding_box(asset.shell.positions);
    for (const VisualMesh& visual : asset.visuals) {
        for (const Vec3& p : visual.positions) box.add(p);
    }
    return box;
}

Finding describe(const Asset& asset, std::size_t old_components, std::size_t tets, double cell) {
    const auto locked = static_cast<std::uint64_t>(std::count(asset.shell.locked.begin(), asset.shell.locked.end(), 1));
    const std::string text = "a lattice of " + std::to_string(tets) + " tets in cubes of " + short_text(cell) +
                             " m takes the place of the shell's " + counted(old_components, "component", "components") +
                             "; names, roles and colours are gone; " + counted(locked, "node is", "nodes are") +
                             " locked, around every locked vertex";
    return {"IMPORT_CAGED", Severity::warning, text, 1, {}};
}

}

Finding put_in_cage(Asset& asset, std::uint32_t cells, const Context& context) {
    const Lattice lattice = make_lattice(box_of(asset), cells);
    const TetMesh& mesh = lattice.mesh;
    const Flags is_touched = touched_tets(mesh, asset.shell, context);
    const Flags is_reached = reached_from_outside(mesh, is_touched);
    Flags is_kept(mesh.tets.size(), 0);
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) is_kept[t] = is_touched[t] || !is_reached[t];
    keep_inside(mesh, asset.shell, context, is_kept);
    const Locator locator(mesh);
    for (const VisualMesh& visual : asset.visuals) {
        for (const Vec3& p : visual.positions) locator.for_each_holding(p, [&](Index t) { is_kept[t] = 1; });
    }
    Flags is_locked(mesh.positions.size(), 0);
    for (std::size_t v = 0; v < asset.shell.positions.size(); ++v) {
        if (!asset.shell.locked[v]) continue;
        locator.for_each_holding(asset.shell.positions[v], [&](Index t) {
            is_kept[t] = 1;
            for (const Index node : mesh.tets[t]) is_locked[node] = 1;
        });
    }
    const TetMesh kept = close_manifold(mesh, is_kept);
    const std::size_t old_components = asset.shell.components.size();
    asset.shell = shell_of(kept, is_locked);
    return describe(asset, old_components, kept.tets.size(), lattice.cell);
}

}
