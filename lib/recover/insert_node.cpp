// SPDX-License-Identifier: GPL-3.0-or-later
#include "recover/insert_node.h"

#include <algorithm>
#include <utility>

#include "geometry/predicates.h"
#include "recover/cavity.h"

namespace crumple::recover {

namespace {

// Grows a cavity around a place and shrinks it again until all of its surface is seen from there.
class Grower {
public:
    Grower(const TetComplex& complex, const Constraints& constraints, Vec3 place, std::vector<Index> holders)
        : complex_(complex), constraints_(constraints), place_(place), holders_(std::move(holders)) {}

    bool find(Cavity& cavity) {
        grow();
        while (tets_.size() > holders_.size()) {
            const Index bad = find_bad();
            if (bad == none) break;
            tets_.erase(std::find(tets_.begin(), tets_.end(), bad));
        }
        cavity.tets = tets_;
        cavity.faces.clear();
        return read_surface(cavity.faces) == none && keeps_what_must_stay(cavity.faces) == none;
    }

private:
    static constexpr std::size_t largest = 64;

    [[nodiscard]] bool has(Index t) const { return std::find(tets_.begin(), tets_.end(), t) != tets_.end(); }
    [[nodiscard]] bool is_holder(Index t) const {
        return std::find(holders_.begin(), holders_.end(), t) != holders_.end();
    }

    void grow() {
        tets_ = holders_;
        for (std::size_t i = 0; i < tets_.size() && tets_.size() < largest; ++i) {
            for (int corner = 0; corner < 4; ++corner) {
                const Index next = complex_.neighbour(tets_[i], corner);
                if (next == none || has(next)) continue;
                const Triangle face = outward_face(complex_.corners(tets_[i]), corner);
                if (constraints_.has_facet(face[0], face[1], face[2])) continue;
                const auto& [a, b, c, d] = complex_.corners(next);
                if (in_sphere(complex_.position(a), complex_.position(b), complex_.position(c), complex_.position(d),
                              place_) > 0) {
                    tets_.push_back(next);
                }
            }
        }
    }

    // The tet of a face that the place does not see, holders last; none when all is well.
    Index read_surface(std::vector<Triangle>& faces) const {
        for (const Index t : tets_) {
            for (int corner = 0; corner < 4; ++corner) {
                const Index next = complex_.neighbour(t, corner);
                if (next != none && has(next)) continue;
                const Triangle face = outward_face(complex_.corners(t), corner);
                if (orient3d(complex_.position(face[0]), complex_.position(face[2]), complex_.position(face[1]),
                             place_) <= 0) {
                    return t;
                }
                faces.push_back(face);
            }
        }
        return none;
    }

    // A tet whose loss would take a node, a segment or a facet away; none when all stay.
    Index keeps_what_must_stay(const std::vector<Triangle>& faces) const {
        const auto on_surface = [&](Index u, Index v) {
            return std::any_of(faces.begin(), faces.end(),
                               [&](const Triangle& f) { return has_corner(f, u) && has_corner(f, v); });
        };
        for (std::size_t i = tets_.size(); i-- > 0;) {
            const Tet& tet = complex_.corners(tets_[i]);
            for (const auto& [p, q] : tet_edge_corners) {
                if (on_surface(tet[p], tet[q])) continue;
                if (constraints_.has_segment(tet[p], tet[q]) || !on_surface(tet[p], tet[p]) ||
                    !on_surface(tet[q], tet[q])) {
                    return tets_[i];
                }
            }
            for (int corner = 0; corner < 4; ++corner) {
                const Index next = complex_.neighbour(tets_[i], corner);
                const Triangle face = outward_face(tet, corner);
                if (next != none && has(next) && constraints_.has_facet(face[0], face[1], face[2])) return tets_[i];
            }
        }
        return none;
    }

    [[nodiscard]] Index find_bad() const {
        std::vector<Triangle> faces;
        Index bad = read_surface(faces);
        if (bad == none) bad = keeps_what_must_stay(faces);
        if (bad == none || !is_holder(bad)) return bad;
        return tets_.back();  // the holders stay: whatever hides them goes, last come first
    }

    const TetComplex& complex_;
    const Constraints& constraints_;
    Vec3 place_;
    std::vector<Index> holders_;
    std::vector<Index> tets_;
};

}

std::vector<Index> holders_of(const TetComplex& complex, std::span<const Index> candidates, Vec3 place) {
    std::vector<Index> holders;
    for (const Index t : candidates) {
        bool holds = true;
        for (int corner = 0; corner < 4 && holds; ++corner) {
            const auto& face = tet_face_corners[corner];
            const Tet& tet = complex.corners(t);
            holds = orient3d(complex.position(tet[face[0]]), complex.position(tet[face[2]]),
                             complex.position(tet[face[1]]), place) >= 0;
        }
        if (holds) holders.push_back(t);
    }
    return holders;
}

Index insert_node(TetComplex& complex, const Constraints& constraints, Vec3 place, std::vector<Index> holders) {
    Cavity cavity;
    if (!Grower(complex, constraints, place, std::move(holders)).find(cavity)) return none;
    const Index node = complex.add_node(place);
    std::vector<Tet> fresh;
    append_cone(cavity, node, fresh);
    complex.replace(cavity.tets, fresh);
    return node;
}

}
