// SPDX-License-Identifier: GPL-3.0-or-later
// A hole in the mesh and a place in it for a node that is to be joined to all faces around the hole. Hole and place are
// fitted to each other in turn: the hole takes in tets that the node would replace by better ones, the place moves to
// where its tets are best.
#pragma once
#include <span>
#include <vector>

#include "finish/smoothing.h"
#include "finish/work_mesh.h"

namespace crumple::finish {

// Shapes below `bad` count from a half to one tet each, the flatter the more: fewer bad tets are worth more than better
// ones.
[[nodiscard]] double badness_of(double shape, double bad);

class Hole {
public:
    // Keeps a reference to the mesh. Around `place`, rounded to float; tets: at least one, all of one region.
    Hole(const WorkMesh& mesh, Vec3 place, std::span<const Index> tets);

    // Takes in the tets behind the worst faces until every face makes a tet better than `least` with the place. False
    // when the surface, another region or a size of `most` tets is in the way.
    [[nodiscard]] bool open(double least, std::size_t most);

    // Takes in neighbours, the best first, as long as that lessens the badness.
    void grow(double bad, std::size_t most);

    // Moves the place to where the worst tet is best.
    void settle();

    // Moves the place to where the badness is least.
    void settle_badness(double bad);

    [[nodiscard]] double old_badness(double bad) const;  // of what goes
    [[nodiscard]] double new_badness(double bad) const;  // of what comes
    [[nodiscard]] double least() const;                  // shape of the worst that comes

    // What comes is exactly positive and has every node of what goes, free ones aside if they may be lost.
    [[nodiscard]] bool is_sound(bool may_lose_free_nodes) const;

    [[nodiscard]] Vec3 place() const { return place_; }
    [[nodiscard]] const std::vector<Index>& tets() const { return tets_; }

    // What goes and what comes, the node written as `none`.
    void write(Exchange& exchange) const;

private:
    struct Rim {
        Triangle face;    // with the node: a positive tet
        OppositeFace at;  // where it lies
        Index outer;      // the tet beyond, none at the surface
        double shape;     // of the tet that the node makes with it
    };

    void add(Index tet);
    void move_to(Vec3 place);
    [[nodiscard]] bool holds(Index tet) const;
    [[nodiscard]] bool may_take(Index tet, std::size_t most) const;
    [[nodiscard]] double gain_of(Index tet, double bad) const;
    [[nodiscard]] double lack_at(Vec3 place, double bad, double limit) const;
    [[nodiscard]] std::vector<OppositeFace> faces() const;

    const WorkMesh& mesh_;
    Vec3 place_;
    std::vector<Index> tets_;
    std::vector<Rim> rim_;
};

}
