// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/peel.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include "finish/surface_patch.h"
#include "geometry/measures.h"
#include "quality/tet_measures.h"

namespace crumple::finish {

namespace {

// A tet with two exposed faces: `outer` is the edge between those, `inner` the one between the two others.
struct Bandage {
    Edge outer;
    Edge inner;
};

bool read_bandage(const WorkMesh& mesh, Index tet, Bandage& bandage) {
    int exposed[4];
    int covered[4];
    int exposed_count = 0;
    int covered_count = 0;
    for (int corner = 0; corner < 4; ++corner) {
        if (mesh.is_exposed(tet, corner)) {
            exposed[exposed_count++] = corner;
        } else {
            covered[covered_count++] = corner;
        }
    }
    if (exposed_count != 2) return false;
    const Tet& corners = mesh.complex.corners(tet);
    bandage.outer = {corners[covered[0]], corners[covered[1]]};
    bandage.inner = {corners[exposed[0]], corners[exposed[1]]};
    return true;
}

// Both faces that would come to light are triangles of the shell, seen from outside: the tet lies outside the shell.
bool lies_outside(const WorkMesh& mesh, const SurfaceGuard& guard, Index tet) {
    const Tet& corners = mesh.complex.corners(tet);
    for (int face = 0; face < 4; ++face) {
        if (mesh.is_exposed(tet, face)) continue;
        const auto& corner = tet_face_corners[face];
        // Turned round: what is outward for the tet is inward for its neighbour.
        if (!guard.is_shell_triangle(corners[corner[0]], corners[corner[2]], corners[corner[1]])) return false;
    }
    return true;
}

double volume_of(const WorkMesh& mesh, Index tet) {
    const auto& [a, b, c, d] = mesh.complex.corners(tet);
    return signed_volume(mesh.at(a), mesh.at(b), mesh.at(c), mesh.at(d));
}

double mean_edge(const WorkMesh& mesh, Index tet) {
    const Tet& corners = mesh.complex.corners(tet);
    double sum = 0;
    for (const auto& edge : tet_edge_corners) sum += length(mesh.at(corners[edge[1]]) - mesh.at(corners[edge[0]]));
    return sum / 6;
}

bool has_small_angle(const WorkMesh& mesh, Index tet, double sine) {
    const auto& [a, b, c, d] = mesh.complex.corners(tet);
    return quality::min_dihedral_key(mesh.at(a), mesh.at(b), mesh.at(c), mesh.at(d)) < sine * sine;
}

double height_of(const WorkMesh& mesh, const Bandage& bandage) {
    return gap_between(mesh.at(bandage.outer[0]), mesh.at(bandage.outer[1]), mesh.at(bandage.inner[0]),
                       mesh.at(bandage.inner[1]));
}

class Peeler {
public:
    Peeler(WorkMesh& mesh, const SurfaceGuard& guard, const PeelLimits& limits)
        : mesh_(mesh), guard_(guard), limits_(limits), sine_(shape_of_angle(limits.angle_deg)) {}

    PeelReport run(const Context& context) {
        for (Index t = 0; t < mesh_.complex.slot_count(); ++t) offer(t);
        while (!waiting_.empty()) {
            const auto [shape, tet] = waiting_.top();
            waiting_.pop();
            context.stop_if_cancelled();
            if (mesh_.complex.is_tet(tet)) try_peel(tet);
        }
        return report_;
    }

private:
    using Entry = std::pair<double, Index>;

    void offer(Index tet) {
        Bandage bandage;
        if (mesh_.complex.is_tet(tet) && read_bandage(mesh_, tet, bandage)) waiting_.emplace(mesh_.shape(tet), tet);
    }

    void try_peel(Index tet) {
        Bandage bandage;
        if (!read_bandage(mesh_, tet, bandage) || !is_allowed(tet, bandage)) return;
        const double volume = volume_of(mesh_, tet);
        const bool is_outside = lies_outside(mesh_, guard_, tet);
        if (!is_outside && !is_flat(tet, bandage, volume)) return;
        report_.removed += 1;
        report_.restored += is_outside;
        report_.volume += volume;
        if (!is_outside) report_.spent += volume;
        remove(tet);
    }

    bool is_flat(Index tet, const Bandage& bandage, double volume) const {
        const double height = height_of(mesh_, bandage);
        return has_small_angle(mesh_, tet, sine_) && height <= limits_.share_of_edge * mean_edge(mesh_, tet) &&
               report_.spent + volume <= limits_.volume;
    }

    // The new edge of the surface must have been inside, and nothing that matters may lie on the old one.
    bool is_allowed(Index tet, const Bandage& bandage) {
        for (const Index v : mesh_.complex.corners(tet)) {
            if (mesh_.is_pinched[v]) return false;
        }
        const auto& [a, b] = bandage.inner;
        mesh_.complex.ring_of(tet, a, b, ring_);
        if (!ring_.is_closed || guard_.is_marked(bandage.outer[0], bandage.outer[1])) return false;
        const Index region = mesh_.complex.region(tet);
        for (int corner = 0; corner < 4; ++corner) {
            const Index next = mesh_.complex.neighbour(tet, corner);
            if (next != none && mesh_.complex.region(next) != region) return false;
        }
        return true;
    }

    void remove(Index tet) {
        std::array<Index, 4> across;
        for (int corner = 0; corner < 4; ++corner) across[corner] = mesh_.complex.neighbour(tet, corner);
        exchange_.clear();
        exchange_.old.push_back(tet);
        (void)apply(mesh_, exchange_);
        for (const Index next : across) {
            if (next != none) offer(next);
        }
    }

    WorkMesh& mesh_;
    const SurfaceGuard& guard_;
    const PeelLimits& limits_;
    double sine_;
    PeelReport report_;
    TetRing ring_;
    Exchange exchange_;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> waiting_;
};

}

PeelReport peel_flat_tets(WorkMesh& mesh, const SurfaceGuard& guard, const PeelLimits& limits, const Context& context) {
    return Peeler(mesh, guard, limits).run(context);
}

}
