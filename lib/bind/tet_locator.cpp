// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind/tet_locator.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "bind/spatial_order.h"
#include "bind/tet_side.h"
#include "geometry/measures.h"

namespace crumple::bind {

namespace {

// Neighbours in space become neighbours in memory, and no index of the input shows: two bodies that do not overlap
// never have the same centre, and the curve keeps the order of those in one cell.
std::vector<Index> order_by_place(const std::vector<Vec3>& centres) {
    std::vector<Index> order(centres.size());
    std::iota(order.begin(), order.end(), Index{0});
    std::sort(order.begin(), order.end(), [&](Index a, Index b) { return lexicographic_less(centres[a], centres[b]); });
    std::vector<Vec3> sorted;
    sorted.reserve(centres.size());
    for (const Index i : order) sorted.push_back(centres[i]);
    std::vector<Index> result;
    result.reserve(centres.size());
    for (const Index i : spatial_order(sorted)) result.push_back(order[i]);
    return result;
}

template <class T>
void rearrange(std::vector<T>& items, const std::vector<Vec3>& centres) {
    std::vector<T> arranged;
    arranged.reserve(items.size());
    for (const Index i : order_by_place(centres)) arranged.push_back(items[i]);
    items = std::move(arranged);
}

template <class Bodies>
Bvh tree_over(const Bodies& bodies) {
    std::vector<Box> boxes;
    boxes.reserve(bodies.size());
    for (const auto& body : bodies) boxes.push_back(bounding_box(body.corners));
    return Bvh(boxes);
}

double largest_of(const std::array<double, 4>& weights) {
    double largest = 0;
    for (const double w : weights) largest = std::max(largest, std::fabs(w));
    return largest;
}

// Corners in the order of their places, the last two exchanged where that would turn the tet inside out: so every
// figure comes out the same to the last bit whatever the numbers of the nodes.
Tet corners_by_place(const TetMesh& mesh, const Tet& tet) {
    Tet sorted = tet;
    int exchanges = 0;
    for (int end = 3; end > 0; --end) {
        for (int i = 0; i < end; ++i) {
            if (!lexicographic_less(mesh.positions[sorted[i + 1]], mesh.positions[sorted[i]])) continue;
            std::swap(sorted[i], sorted[i + 1]);
            ++exchanges;
        }
    }
    if (exchanges % 2 == 1) std::swap(sorted[2], sorted[3]);
    return sorted;
}

bool has_node(const Tet& tet, Index node) { return std::find(tet.begin(), tet.end(), node) != tet.end(); }

}

TetLocator::TetLocator(const TetMesh& mesh, Index region, Preferences preferences)
    : preferences_(std::move(preferences)) {
    collect_tets(mesh, region);
    link_neighbours(mesh);
    collect_faces();
    collect_surroundings(mesh.positions.size());
    tet_tree_ = tree_over(tets_);
    face_tree_ = tree_over(faces_);
}

void TetLocator::collect_tets(const TetMesh& mesh, Index region) {
    std::vector<Vec3> centres;
    for (Index t = 0; t < mesh.tets.size(); ++t) {
        if (region != none && mesh.region[t] != region) continue;
        const Tet nodes = corners_by_place(mesh, mesh.tets[t]);
        const auto& [a, b, c, d] = nodes;
        const auto& p = mesh.positions;
        LocalTet tet{{p[a], p[b], p[c], p[d]}, nodes, {none, none, none, none}, t, mesh.region[t], {}};
        for (int i = 0; i < 4; ++i) {
            const auto corner = std::find(nodes.begin(), nodes.end(), mesh.tets[t][i]) - nodes.begin();
            tet.corner_of_mesh[i] = static_cast<std::uint8_t>(corner);
        }
        tets_.push_back(tet);
        centres.push_back(p[a] + p[b] + p[c] + p[d]);
    }
    rearrange(tets_, centres);
}

Location TetLocator::located(const LocalTet& tet, bool inside, const std::array<double, 4>& weights, double distance) {
    Location location{tet.mesh_tet, inside, {}, distance};
    for (int i = 0; i < 4; ++i) location.weights[i] = weights[tet.corner_of_mesh[i]];
    return location;
}

void TetLocator::link_neighbours(const TetMesh& mesh) {
    std::vector<Index> local(mesh.tets.size(), none);
    for (Index t = 0; t < tets_.size(); ++t) local[tets_[t].mesh_tet] = t;
    for (LocalTet& tet : tets_) {
        for (int corner = 0; corner < 4; ++corner) {
            const Index across = mesh.neighbours[tet.mesh_tet][corner];
            if (across != none) tet.neighbours[tet.corner_of_mesh[corner]] = local[across];
        }
    }
}

void TetLocator::collect_faces() {
    std::vector<Vec3> centres;
    for (Index t = 0; t < tets_.size(); ++t) {
        for (int side = 0; side < 4; ++side) {
            if (tets_[t].neighbours[side] != none) continue;
            Face face;
            for (int i = 0; i < 3; ++i) {
                face.corners[i] = tets_[t].corners[tet_face_corners[side][i]];
                face.nodes[i] = tets_[t].nodes[tet_face_corners[side][i]];
            }
            face.tet = t;
            faces_.push_back(face);
            centres.push_back(face.corners[0] + face.corners[1] + face.corners[2]);
        }
    }
    rearrange(faces_, centres);
}

void TetLocator::collect_surroundings(std::size_t node_count) {
    around_start_.assign(node_count + 1, 0);
    for (const LocalTet& tet : tets_) {
        for (const Index node : tet.nodes) ++around_start_[node + 1];
    }
    std::partial_sum(around_start_.begin(), around_start_.end(), around_start_.begin());
    around_.resize(around_start_.back());
    std::vector<Index> next(around_start_.begin(), around_start_.end() - 1);
    for (Index t = 0; t < tets_.size(); ++t) {
        for (const Index node : tets_[t].nodes) around_[next[node]++] = t;
    }
}

Location TetLocator::locate(Vec3 p, Guess& guess) const {
    Location location;
    return contains(p, guess, location) ? location : nearest(p, guess);
}

Index TetLocator::rank(Index tet) const {
    const Index region = tets_[tet].region;
    return region < preferences_.region_rank.size() ? preferences_.region_rank[region] : region;
}

// From tet to tet through the face that p lies farthest beyond: a few steps lead to a vertex that is near the last one.
// none where the walk leaves the tets, gets long or ends on a border; a longer search then decides.
Index TetLocator::walk(Vec3 p, Index from) const {
    constexpr int most_steps = 8;
    for (int step = 0; from != none && step < most_steps; ++step) {
        const LocalTet& tet = tets_[from];
        const SubVolumes volume(tet.corners, p);
        const auto least = std::min_element(volume.of.begin(), volume.of.end());
        if (*least > volume.error) return from;
        if (*least >= -volume.error) return none;
        from = tet.neighbours[least - volume.of.begin()];
    }
    return none;
}

// Strictly inside one tet p is in no other; on a border the tet of least rank, then of least place, has it.
bool TetLocator::contains(Vec3 p, Guess& guess, Location& location) const {
    Index found = none;
    TetSide at;
    const auto try_tet = [&](Index t) {
        const TetSide side = side_of_tet(tets_[t].corners, p);
        if (side.side == Side::outside) return false;
        if (found == none || side.side == Side::inside || std::pair(rank(t), t) < std::pair(rank(found), found)) {
            found = t;
            at = side;
        }
        return side.side == Side::inside;
    };
    const Index near = walk(p, guess.tet);
    if (near == none || !try_tet(near)) tet_tree_.containing(p, try_tet);
    if (found == none) return false;
    guess.tet = found;
    location = located(tets_[found], true, at.weights, 0);
    return true;
}

TetLocator::Candidate TetLocator::candidate(Index tet, Vec3 p) const {
    const auto& [a, b, c, d] = tets_[tet].corners;
    const std::array<double, 4> weights = barycentric(a, b, c, d, p);
    const double largest = largest_of(weights);
    // A tet so flat that its weights overflow is the last choice, not an accident.
    return {tet, weights, std::isfinite(largest) ? largest : std::numeric_limits<double>::max()};
}

// The tets that have the nearest point: one at a face, all around an edge or a corner.
std::vector<TetLocator::Candidate> TetLocator::tets_at(const Face& face, unsigned corners, Vec3 p) const {
    if (corners == 7) return {candidate(face.tet, p)};
    std::vector<Index> nodes;
    for (int i = 0; i < 3; ++i) {
        if (corners >> i & 1) nodes.push_back(face.nodes[i]);
    }
    std::vector<Candidate> candidates;
    for (Index i = around_start_[nodes[0]]; i < around_start_[nodes[0] + 1]; ++i) {
        if (has_node(tets_[around_[i]].nodes, nodes.back())) candidates.push_back(candidate(around_[i], p));
    }
    return candidates;
}

// Tets of the owning region first, then the least extrapolating, then rank and place.
TetLocator::Candidate TetLocator::best_of(const std::vector<Candidate>& candidates, Vec3 p) const {
    const Index first_region = tets_[candidates[0].tet].region;
    const bool is_contested = std::any_of(candidates.begin(), candidates.end(),
                                          [&](const Candidate& c) { return tets_[c.tet].region != first_region; });
    const Index owner = is_contested && preferences_.owner ? preferences_.owner(p) : none;
    const auto key = [&](const Candidate& c) {
        return std::tuple(owner != none && tets_[c.tet].region != owner, c.largest, rank(c.tet), c.tet);
    };
    return *std::min_element(candidates.begin(), candidates.end(),
                             [&](const Candidate& a, const Candidate& b) { return key(a) < key(b); });
}

double TetLocator::distance_to(const LocalTet& tet, Vec3 p) const {
    double least_2 = std::numeric_limits<double>::infinity();
    for (const auto& [a, b, c] : tet_face_corners) {
        const Vec3 offset = closest_point_on_triangle(tet.corners[a], tet.corners[b], tet.corners[c], p) - p;
        least_2 = std::min(least_2, dot(offset, offset));
    }
    return std::sqrt(least_2);
}

// Among the tets of the same region that are farther by no more than the slack.
TetLocator::Candidate TetLocator::look_behind(Vec3 p, double distance, const Candidate& found) const {
    const double reach = distance + preferences_.slack;
    Candidate best = found;
    tet_tree_.within(p, reach, [&](Index t) {
        if (tets_[t].region != tets_[found.tet].region) return false;
        const Candidate other = candidate(t, p);
        const bool is_better = std::pair(other.largest, t) < std::pair(best.largest, best.tet);
        if (is_better && distance_to(tets_[t], p) <= reach) best = other;
        return false;
    });
    return best;
}

Location TetLocator::nearest(Vec3 p, Guess& guess) const {
    const auto distance_2 = [&](Index f) {
        const auto& [a, b, c] = faces_[f].corners;
        const Vec3 offset = closest_point_on_triangle(a, b, c, p) - p;
        return dot(offset, offset);
    };
    Bvh::Nearest known;
    if (guess.face != none) known = {guess.face, distance_2(guess.face)};
    const Bvh::Nearest found = face_tree_.nearest(p, distance_2, known);
    guess.face = found.element;
    const Face& face = faces_[found.element];
    guess.tet = face.tet;
    const auto& [a, b, c] = face.corners;
    Candidate best = best_of(tets_at(face, closest_on_triangle(a, b, c, p).corners, p), p);
    double distance = std::sqrt(found.distance_2);
    if (best.largest > preferences_.max_weight) {
        const Candidate behind = look_behind(p, distance, best);
        if (behind.tet != best.tet) {
            best = behind;
            distance = distance_to(tets_[best.tet], p);
        }
    }
    return located(tets_[best.tet], false, best.weights, distance);
}

}
