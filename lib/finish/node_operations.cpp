// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/node_operations.h"

#include <algorithm>

#include "geometry/predicates.h"

namespace crumple::finish {

namespace {

// Larger holes hardly ever pay and cost more to smooth.
constexpr std::size_t largest_hole = 16;

// The face opposite a corner, so that (corner, face) is a positive tet.
Triangle facing(const Tet& corners, int corner) {
    const auto& face = tet_face_corners[corner];
    return {corners[face[0]], corners[face[1]], corners[face[2]]};
}

OppositeFace places_of(const WorkMesh& mesh, const Triangle& face) {
    return {mesh.at(face[0]), mesh.at(face[1]), mesh.at(face[2])};
}

bool is_positive_towards(Vec3 node, const std::vector<OppositeFace>& faces) {
    return std::all_of(faces.begin(), faces.end(),
                       [&](const OppositeFace& f) { return orient3d(node, f[0], f[1], f[2]) > 0; });
}

}

std::optional<BetterPlace> plan_move(const WorkMesh& mesh, Index node, std::span<const Index> star, double floor) {
    std::vector<OppositeFace> faces;
    faces.reserve(star.size());
    for (const Index t : star)
        faces.push_back(places_of(mesh, facing(mesh.complex.corners(t), mesh.complex.corner_of(t, node))));
    const auto better = find_better_place(mesh.at(node), faces, floor);
    if (!better || !is_positive_towards(better->place, faces)) return std::nullopt;
    return better;
}

bool plan_contraction(const WorkMesh& mesh, Index node, std::span<const Index> star, Index target, double floor,
                      Exchange& exchange) {
    exchange.clear();
    exchange.least = 1;
    for (const Index t : star) {
        exchange.old.push_back(t);
        Tet corners = mesh.complex.corners(t);
        if (std::find(corners.begin(), corners.end(), target) != corners.end()) continue;
        *std::find(corners.begin(), corners.end(), node) = target;
        exchange.least = std::min(exchange.least, shape_of(mesh, corners));
        if (!(exchange.least > floor)) return false;
        exchange.fresh.push_back(corners);
    }
    return are_positive(mesh, exchange.fresh);
}

namespace {

struct Rim {
    Triangle face;  // with the new node: a positive tet
    Index outer;    // the tet beyond, none at the surface
    double shape;   // of the tet that the new node makes with it
};

class Hole {
public:
    Hole(const WorkMesh& mesh, Index tet) : mesh_(mesh) {
        Vec3 sum{};
        for (const Index v : mesh.complex.corners(tet)) sum += mesh.at(v);
        place_ = round_to_float(sum * 0.25);
        add(tet);
    }

    // Takes in the tet behind the worst face until that face makes a tet better than `floor`.
    bool grow(double floor) {
        while (tets_.size() < largest_hole) {
            const auto worst = std::min_element(rim_.begin(), rim_.end(),
                                                [](const Rim& a, const Rim& b) { return a.shape < b.shape; });
            if (worst->shape > floor) return true;
            const Index next = worst->outer;
            if (next == none || mesh_.complex.region(next) != mesh_.complex.region(tets_[0])) return false;
            add(next);
        }
        return false;
    }

    // A node that no face of the rim has would be lost.
    [[nodiscard]] bool keeps_its_nodes() const {
        for (const Index t : tets_) {
            for (const Index v : mesh_.complex.corners(t)) {
                const bool is_kept = std::any_of(rim_.begin(), rim_.end(), [v](const Rim& r) {
                    return std::find(r.face.begin(), r.face.end(), v) != r.face.end();
                });
                if (!is_kept) return false;
            }
        }
        return true;
    }

    [[nodiscard]] const std::vector<Index>& tets() const { return tets_; }
    [[nodiscard]] const std::vector<Rim>& rim() const { return rim_; }
    [[nodiscard]] Vec3 place() const { return place_; }

private:
    void add(Index tet) {
        tets_.push_back(tet);
        std::erase_if(rim_, [&](const Rim& r) { return r.outer == tet; });
        const Tet& corners = mesh_.complex.corners(tet);
        for (int corner = 0; corner < 4; ++corner) {
            const Index outer = mesh_.complex.neighbour(tet, corner);
            if (outer != none && std::find(tets_.begin(), tets_.end(), outer) != tets_.end()) continue;
            const Triangle face = facing(corners, corner);
            const OppositeFace at = places_of(mesh_, face);
            rim_.push_back({face, outer, shape_of(place_, at[0], at[1], at[2])});
        }
    }

    const WorkMesh& mesh_;
    Vec3 place_;
    std::vector<Index> tets_;
    std::vector<Rim> rim_;
};

}

bool plan_insertion(const WorkMesh& mesh, Index tet, double floor, Insertion& insertion) {
    Hole hole(mesh, tet);
    // A hole is good enough to start from when the node sees all of it; moving the node must do the rest.
    if (!hole.grow(0.3 * floor) || !hole.keeps_its_nodes()) return false;
    std::vector<OppositeFace> faces;
    for (const Rim& r : hole.rim()) faces.push_back(places_of(mesh, r.face));
    const auto better = find_better_place(hole.place(), faces, floor);
    if (!better || !is_positive_towards(better->place, faces)) return false;
    insertion.exchange.clear();
    insertion.exchange.old = hole.tets();
    insertion.exchange.least = better->least;
    for (const Rim& r : hole.rim()) insertion.exchange.fresh.push_back({none, r.face[0], r.face[1], r.face[2]});
    insertion.place = better->place;
    return true;
}

}
