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

}

bool is_positive_towards(Vec3 node, std::span<const OppositeFace> faces) {
    return std::all_of(faces.begin(), faces.end(),
                       [&](const OppositeFace& f) { return orient3d(node, f[0], f[1], f[2]) > 0; });
}

std::vector<OppositeFace> opposite_faces(const WorkMesh& mesh, Index node, std::span<const Index> star) {
    std::vector<OppositeFace> faces;
    faces.reserve(star.size());
    for (const Index t : star)
        faces.push_back(places_of(mesh, facing(mesh.complex.corners(t), mesh.complex.corner_of(t, node))));
    return faces;
}

std::optional<BetterPlace> plan_move(const WorkMesh& mesh, Index node, std::span<const Index> star, double floor) {
    std::vector<OppositeFace> faces = opposite_faces(mesh, node, star);
    const auto better = find_better_place(mesh.at(node), faces, floor);
    if (!better || !is_positive_towards(better->place, faces)) return std::nullopt;
    return better;
}

namespace {

// Where the whole star is a few tets on their own, merging would take other nodes away with it.
bool keeps_neighbours(const WorkMesh& mesh, Index node, const Exchange& exchange) {
    const auto is_kept = [&](Index v) {
        return v == node || std::any_of(exchange.fresh.begin(), exchange.fresh.end(),
                                        [v](const Tet& t) { return std::find(t.begin(), t.end(), v) != t.end(); });
    };
    return std::all_of(exchange.old.begin(), exchange.old.end(), [&](Index t) {
        const Tet& corners = mesh.complex.corners(t);
        return std::all_of(corners.begin(), corners.end(), is_kept);
    });
}

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
    return keeps_neighbours(mesh, node, exchange) && are_positive(mesh, exchange.fresh);
}

namespace {

struct Rim {
    Triangle face;  // with the new node: a positive tet
    Index outer;    // the tet beyond, none at the surface
    double shape;   // of the tet that the new node makes with it
};

class Hole {
public:
    // Around `place`, which lies in `tets`.
    Hole(const WorkMesh& mesh, Vec3 place, std::span<const Index> tets) : mesh_(mesh), place_(round_to_float(place)) {
        for (const Index t : tets) add(t);
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

    [[nodiscard]] double least() const {
        double least = 1;
        for (const Rim& r : rim_) least = std::min(least, r.shape);
        return least;
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

namespace {

bool plan_in_hole(const WorkMesh& mesh, Hole hole, double floor, Insertion& insertion) {
    // A hole is good enough to start from when the node sees all of it; moving the node must do the rest.
    if (!hole.grow(0.3 * floor) || !hole.keeps_its_nodes()) return false;
    std::vector<OppositeFace> faces;
    for (const Rim& r : hole.rim()) faces.push_back(places_of(mesh, r.face));
    Vec3 place = hole.place();
    double least = hole.least();
    for (int step = 0; step < 3; ++step) {
        const auto better = find_better_place(place, faces, 0);
        if (!better) break;
        place = better->place;
        least = better->least;
    }
    if (!(least > floor) || !is_positive_towards(place, faces)) return false;
    insertion.exchange.clear();
    insertion.exchange.old = hole.tets();
    insertion.exchange.least = least;
    for (const Rim& r : hole.rim()) insertion.exchange.fresh.push_back({none, r.face[0], r.face[1], r.face[2]});
    insertion.place = place;
    return true;
}

}

bool plan_insertion_on_edge(const WorkMesh& mesh, const TetRing& ring, Index a, Index b, double floor,
                            Insertion& insertion) {
    if (!ring.is_closed || ring.tets.size() > largest_hole || !is_of_one_region(mesh, ring.tets)) return false;
    return plan_in_hole(mesh, Hole(mesh, (mesh.at(a) + mesh.at(b)) * 0.5, ring.tets), floor, insertion);
}

bool plan_insertion(const WorkMesh& mesh, Index tet, double floor, Insertion& insertion) {
    const Tet corners = mesh.complex.corners(tet);
    const Vec3 middle = (mesh.at(corners[0]) + mesh.at(corners[1]) + mesh.at(corners[2]) + mesh.at(corners[3])) * 0.25;
    bool is_found = plan_in_hole(mesh, Hole(mesh, middle, std::span(&tet, 1)), floor, insertion);
    TetRing ring;
    for (const auto& edge : tet_edge_corners) {
        const Index a = corners[edge[0]];
        const Index b = corners[edge[1]];
        mesh.complex.ring_of(tet, a, b, ring);
        if (is_found) floor = insertion.exchange.least;
        is_found |= plan_insertion_on_edge(mesh, ring, a, b, floor, insertion);
    }
    return is_found;
}

}
