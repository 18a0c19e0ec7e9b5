// SPDX-License-Identifier: GPL-3.0-or-later
#include "recover/splits.h"

#include <algorithm>

#include "recover/cavity.h"

namespace crumple::recover {

Split split_segment(Constraints& constraints, Index a, Index b, Index node) {
    Split split{node, a, b, none, constraints.apexes(sorted_edge(a, b)), {}};
    for (const Index apex : split.apexes) {
        const Triangle facet = sorted_triangle(a, b, apex);
        const Index origin = constraints.origin(facet);
        split.origins.push_back(origin);
        constraints.remove_facet(facet);
        constraints.add_facet({a, node, apex}, origin);
        constraints.add_facet({node, b, apex}, origin);
    }
    return split;
}

Split split_facet(Constraints& constraints, const Triangle& facet, Index node) {
    const auto [a, b, c] = facet;
    const Index origin = constraints.origin(sorted_triangle(a, b, c));
    constraints.remove_facet(facet);
    constraints.add_facet({a, b, node}, origin);
    constraints.add_facet({b, c, node}, origin);
    constraints.add_facet({c, a, node}, origin);
    return {node, a, b, c, {}, {origin}};
}

namespace {

// What becomes of the faces around the node when the split is undone: a part of a facet, and the node to put in place
// of the split's for the whole facet; the other part of it vanishes.
struct Part {
    Triangle facet;  // ascending
    Index instead;   // none: vanishes
};

std::vector<Part> parts_of(const Split& split) {
    std::vector<Part> parts;
    const Index s = split.node;
    if (split.c != none) {
        parts.push_back({sorted_triangle(split.a, split.b, s), split.c});
        parts.push_back({sorted_triangle(split.b, split.c, s), none});
        parts.push_back({sorted_triangle(split.c, split.a, s), none});
        return parts;
    }
    for (const Index apex : split.apexes) {
        parts.push_back({sorted_triangle(split.a, s, apex), split.b});
        parts.push_back({sorted_triangle(s, split.b, apex), none});
    }
    return parts;
}

bool has_only(const Constraints& constraints, Index a, Index b, std::vector<Index> apexes) {
    std::sort(apexes.begin(), apexes.end());
    return constraints.has_segment(a, b) && constraints.apexes(sorted_edge(a, b)) == apexes;
}

// Whether the facets at the node are those the split made, none of them split further.
bool is_untouched(const Constraints& constraints, const Split& split) {
    const Index s = split.node;
    if (split.c != none) {
        return has_only(constraints, s, split.a, {split.b, split.c}) &&
               has_only(constraints, s, split.b, {split.c, split.a}) &&
               has_only(constraints, s, split.c, {split.a, split.b});
    }
    return has_only(constraints, s, split.a, split.apexes) && has_only(constraints, s, split.b, split.apexes) &&
           std::all_of(split.apexes.begin(), split.apexes.end(), [&](Index apex) {
               return has_only(constraints, s, apex, {split.a, split.b});
           });
}

// The star of a node cut along the facets at it. One cavity a side.
class Sides {
public:
    Sides(const TetComplex& complex, const Split& split) : complex_(complex), split_(split), parts_(parts_of(split)) {}

    // False when a part is not there, or the facets do not part the star from what they are to bound.
    bool find(std::vector<Cavity>& cavities) {
        std::vector<Index> star;
        complex_.star_of(split_.node, star);
        std::vector<Index> side(star.size(), none);
        std::size_t seen_parts = 0;
        for (std::size_t i = 0; i < star.size(); ++i) {
            if (side[i] != none) continue;
            cavities.emplace_back();
            if (!flood(star, i, side, static_cast<Index>(cavities.size() - 1), cavities.back(), seen_parts))
                return false;
        }
        return seen_parts == expected_sides();
    }

private:
    // Every part has two sides, one where it lies on the convex hull.
    [[nodiscard]] std::size_t expected_sides() const {
        std::size_t sides = 0;
        for (const Part& part : parts_) {
            const Index t = complex_.find_face(part.facet[0], part.facet[1], part.facet[2]);
            if (t == none) return none;
            const int corner = opposite(t, part.facet);
            sides += complex_.neighbour(t, corner) == none ? 1 : 2;
        }
        return sides;
    }
    [[nodiscard]] int opposite(Index tet, const Triangle& face) const {
        for (int i = 0; i < 4; ++i) {
            const Index v = complex_.corners(tet)[i];
            if (v != face[0] && v != face[1] && v != face[2]) return i;
        }
        return -1;
    }

    bool flood(const std::vector<Index>& star, std::size_t first, std::vector<Index>& side, Index number,
               Cavity& cavity, std::size_t& seen_parts) {
        std::vector<std::uint8_t> is_used(parts_.size(), 0);
        std::vector<std::size_t> stack{first};
        side[first] = number;
        while (!stack.empty()) {
            const Index t = star[stack.back()];
            stack.pop_back();
            cavity.tets.push_back(t);
            for (int corner = 0; corner < 4; ++corner) {
                Triangle face = outward_face(complex_.corners(t), corner);
                if (complex_.corners(t)[corner] == split_.node) {
                    cavity.faces.push_back(face);
                    continue;
                }
                const auto part = std::find_if(parts_.begin(), parts_.end(), [&](const Part& p) {
                    return p.facet == sorted_triangle(face[0], face[1], face[2]);
                });
                if (part != parts_.end()) {
                    // Both sides of one facet in one cavity: an open shell's rim.
                    if (is_used[part - parts_.begin()]++) return false;
                    ++seen_parts;
                    if (part->instead == none) continue;
                    std::replace(face.begin(), face.end(), split_.node, part->instead);
                    cavity.faces.push_back(face);
                    continue;
                }
                const Index next = complex_.neighbour(t, corner);
                if (next == none) return false;
                const auto at = static_cast<std::size_t>(std::find(star.begin(), star.end(), next) - star.begin());
                if (side[at] != none) continue;
                side[at] = number;
                stack.push_back(at);
            }
        }
        return true;
    }

    const TetComplex& complex_;
    const Split& split_;
    std::vector<Part> parts_;
};

void make_whole(Constraints& constraints, const Split& split) {
    for (const Part& part : parts_of(split)) constraints.remove_facet(part.facet);
    if (split.c != none) {
        constraints.add_facet({split.a, split.b, split.c}, split.origins[0]);
        return;
    }
    for (std::size_t i = 0; i < split.apexes.size(); ++i)
        constraints.add_facet({split.a, split.b, split.apexes[i]}, split.origins[i]);
}

}

bool undo_split(TetComplex& complex, Constraints& constraints, const Split& split) {
    if (!is_untouched(constraints, split)) return false;
    std::vector<Cavity> cavities;
    if (!Sides(complex, split).find(cavities)) return false;
    std::vector<Filling> fillings(cavities.size());
    for (std::size_t i = 0; i < cavities.size(); ++i) {
        fillings[i] = best_filling(complex, cavities[i], complex.position(split.node));
        if (fillings[i].quality <= 0) return false;
    }
    std::vector<Index> old;
    std::vector<Tet> fresh;
    for (std::size_t i = 0; i < cavities.size(); ++i) {
        const Index apex = fillings[i].node != none ? fillings[i].node : complex.add_node(fillings[i].place);
        append_cone(cavities[i], apex, fresh);
        old.insert(old.end(), cavities[i].tets.begin(), cavities[i].tets.end());
    }
    complex.replace(old, fresh);
    make_whole(constraints, split);
    return true;
}

bool drop_split(TetComplex& complex, Constraints& constraints, const Split& split) {
    if (!is_untouched(constraints, split)) return false;
    Cavity star;
    complex.star_of(split.node, star.tets);
    for (const Index t : star.tets) {
        const int corner = complex.corner_of(t, split.node);
        star.faces.push_back(outward_face(complex.corners(t), corner));
        for (int other = 0; other < 4; ++other) {
            if (other != corner && complex.neighbour(t, other) == none) return false;
        }
    }
    const Filling filling = best_filling(complex, star, complex.position(split.node));
    if (filling.quality <= 0 || filling.node == none) return false;
    std::vector<Tet> fresh;
    append_cone(star, filling.node, fresh);
    complex.replace(star.tets, fresh);
    make_whole(constraints, split);
    return true;
}

}
