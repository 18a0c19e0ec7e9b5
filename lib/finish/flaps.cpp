// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/flaps.h"

#include <algorithm>
#include <vector>

#include "geometry/measures.h"
#include "quality/tet_measures.h"

namespace crumple::finish {

namespace {

// The corner that only this tet has: the three faces there are exposed, the fourth is not. -1 for none.
int tip_of(const WorkMesh& mesh, Index tet) {
    int tip = -1;
    for (int corner = 0; corner < 4; ++corner) {
        if (mesh.is_exposed(tet, corner)) continue;
        if (tip >= 0) return -1;
        tip = corner;
    }
    return tip;
}

Tet with(Tet corners, Index old, Index fresh) {
    std::replace(corners.begin(), corners.end(), old, fresh);
    return corners;
}

// All ways to seat one node.
class Seats {
public:
    Seats(const WorkMesh& mesh, const SurfaceGuard& guard, Index flap, Index node, Exchange& best)
        : mesh_(mesh), guard_(guard), flap_(flap), node_(node), best_(best) {
        best_.clear();
    }

    // The face of `tet` opposite a corner, counter-clockwise seen from outside.
    void try_face(Index tet, int corner) {
        const Tet& corners = mesh_.complex.corners(tet);
        const auto& face = tet_face_corners[corner];
        const Triangle at{corners[face[0]], corners[face[1]], corners[face[2]]};
        if (std::any_of(at.begin(), at.end(), [&](Index v) { return mesh_.is_pinched[v]; })) return;
        Exchange exchange;
        exchange.old = {flap_, tet};
        bool keeps_normals = true;
        for (const Index v : at) {
            exchange.fresh.push_back(with(corners, v, node_));
            keeps_normals &= keeps_normal(at, v);
        }
        if (keeps_normals) keep_if_better(exchange);
        for (int i = 0; i < 3; ++i) try_edge(tet, at, at[i], at[(i + 1) % 3]);
    }

    [[nodiscard]] bool is_found() const { return !best_.fresh.empty(); }

private:
    [[nodiscard]] bool keeps_normal(const Triangle& face, Index replaced) const {
        Triangle fresh = face;
        std::replace(fresh.begin(), fresh.end(), replaced, node_);
        const auto normal = [&](const Triangle& t) {
            return area_vector(mesh_.at(t[0]), mesh_.at(t[1]), mesh_.at(t[2]));
        };
        return dot(normal(face), normal(fresh)) > 0;
    }

    void try_edge(Index tet, const Triangle& face, Index a, Index b) {
        if (guard_.is_marked(a, b) || !keeps_normal(face, a) || !keeps_normal(face, b)) return;
        TetRing ring;
        mesh_.complex.ring_of(tet, a, b, ring);
        if (ring.is_closed) return;
        Exchange exchange;
        exchange.old = {flap_};
        for (const Index t : ring.tets) {
            if (t == flap_) continue;
            exchange.old.push_back(t);
            exchange.fresh.push_back(with(mesh_.complex.corners(t), a, node_));
            exchange.fresh.push_back(with(mesh_.complex.corners(t), b, node_));
        }
        keep_if_better(exchange);
    }

    void keep_if_better(Exchange& exchange) {
        exchange.least = 1;
        for (const Tet& tet : exchange.fresh) exchange.least = std::min(exchange.least, shape_of(mesh_, tet));
        if (exchange.least <= best_.least || !is_of_one_region(mesh_, exchange.old)) return;
        if (!keeps_marked_edges(exchange)) return;
        if (are_positive(mesh_, exchange.fresh)) std::swap(exchange, best_);
    }

    // Those by which the node hangs on the flap.
    [[nodiscard]] bool keeps_marked_edges(const Exchange& exchange) const {
        const Tet& flap = mesh_.complex.corners(flap_);
        return std::none_of(flap.begin(), flap.end(), [&](Index v) {
            return v != node_ && guard_.is_marked(node_, v) &&
                   std::none_of(exchange.fresh.begin(), exchange.fresh.end(),
                                [&](const Tet& tet) { return std::find(tet.begin(), tet.end(), v) != tet.end(); });
        });
    }

    const WorkMesh& mesh_;
    const SurfaceGuard& guard_;
    Index flap_;
    Index node_;
    Exchange& best_;
};

double distance_to_face(const WorkMesh& mesh, Index tet, int corner, Vec3 p) {
    const Tet& corners = mesh.complex.corners(tet);
    const auto& face = tet_face_corners[corner];
    return length(
        closest_point_on_triangle(mesh.at(corners[face[0]]), mesh.at(corners[face[1]]), mesh.at(corners[face[2]]), p) -
        p);
}

class Clipper {
public:
    Clipper(WorkMesh& mesh, const SurfaceGuard& guard, const PeelLimits& limits)
        : mesh_(mesh), guard_(guard), limits_(limits), sine_(shape_of_angle(limits.angle_deg)) {}

    PeelReport run(const Context& context) {
        bool has_clipped = true;
        while (has_clipped) {
            context.stop_if_cancelled();
            has_clipped = false;
            for (Index t = 0; t < mesh_.complex.slot_count(); ++t) has_clipped |= mesh_.complex.is_tet(t) && clip(t);
        }
        return report_;
    }

private:
    bool clip(Index tet) {
        const int tip = tip_of(mesh_, tet);
        // Where the surface touches itself, a node may have other tets that no face leads to.
        if (tip < 0 || mesh_.is_pinched[mesh_.complex.corners(tet)[tip]]) return false;
        const Tet corners = mesh_.complex.corners(tet);
        const Vec3 p[4] = {mesh_.at(corners[0]), mesh_.at(corners[1]), mesh_.at(corners[2]), mesh_.at(corners[3])};
        const double volume = signed_volume(p[0], p[1], p[2], p[3]);
        if (!is_flat(p, tip, volume)) return false;
        const Index node = corners[tip];
        exchange_.clear();
        exchange_.old.push_back(tet);
        if (!mesh_.is_surplus[node] && !may_seat(tet, node, mean_edge(p))) return false;
        (void)apply(mesh_, exchange_);
        report_.removed += 1;
        report_.volume += volume;
        report_.spent += volume;
        return true;
    }

    // A node of the mesh's own goes with its flap; one of the shell's needs another place to hang on. Where that is a
    // flap again, it stays one: this ends.
    bool may_seat(Index tet, Index node, double edge) {
        if (std::find(seated_.begin(), seated_.end(), node) != seated_.end()) return false;
        seated_.push_back(node);
        return plan_seat(mesh_, guard_, tet, node, guard_.surface_reach(edge), exchange_);
    }

    static double mean_edge(const Vec3 (&p)[4]) {
        double sum = 0;
        for (const auto& edge : tet_edge_corners) sum += length(p[edge[1]] - p[edge[0]]);
        return sum / 6;
    }

    [[nodiscard]] bool is_flat(const Vec3 (&p)[4], int tip, double volume) const {
        const auto& base = tet_face_corners[tip];
        const double area_2 = length(area_vector(p[base[0]], p[base[1]], p[base[2]]));
        return quality::min_dihedral_key(p[0], p[1], p[2], p[3]) < sine_ * sine_ &&
               6 * volume <= limits_.share_of_edge * mean_edge(p) * area_2 && report_.spent + volume <= limits_.volume;
    }

    WorkMesh& mesh_;
    const SurfaceGuard& guard_;
    const PeelLimits& limits_;
    double sine_;
    PeelReport report_;
    std::vector<Index> seated_;
    Exchange exchange_;
};

}

bool plan_seat(const WorkMesh& mesh, const SurfaceGuard& guard, Index flap, Index node, double reach,
               Exchange& exchange) {
    Seats seats(mesh, guard, flap, node, exchange);
    for (Index t = 0; t < mesh.complex.slot_count(); ++t) {
        if (!mesh.complex.is_tet(t) || t == flap) continue;
        for (int corner = 0; corner < 4; ++corner) {
            const Index beyond = mesh.complex.neighbour(t, corner);
            if ((beyond == none || beyond == flap) && distance_to_face(mesh, t, corner, mesh.at(node)) <= reach)
                seats.try_face(t, corner);
        }
    }
    return seats.is_found();
}

PeelReport clip_flaps(WorkMesh& mesh, const SurfaceGuard& guard, const PeelLimits& limits, const Context& context) {
    return Clipper(mesh, guard, limits).run(context);
}

}
