// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/repair.h"

#include <algorithm>
#include <set>

#include "geometry/bvh.h"
#include "geometry/measures.h"
#include "geometry/predicates.h"
#include "mesh/boundary.h"
#include "mesh/neighbours.h"

namespace crumple::finish {

namespace {

struct Change {
    std::vector<Index> gone;  // tets taken away
    std::vector<Tet> added;   // at most one
    Index region = none;      // of the added one
    double volume = 0;        // of both
};

class Repairer {
public:
    explicit Repairer(TetMesh mesh) : mesh_(std::move(mesh)), tets_at_(mesh_.positions.size()) {
        is_there_.assign(mesh_.tets.size(), 1);
        for (Index t = 0; t < mesh_.tets.size(); ++t) {
            for (const Index v : mesh_.tets[t]) tets_at_[v].push_back(t);
        }
    }

    Repaired run(const Context& context) {
        const Boundary boundary = boundary_of(mesh_);
        const NonManifold wrong = non_manifold(boundary.faces);
        report_.edges_before = wrong.edges.size();
        report_.nodes_before = wrong.vertices.size();
        plant_tree(boundary);
        std::set<Index> waiting(wrong.vertices.begin(), wrong.vertices.end());
        // Every change leaves fewer bad nodes than before, so this ends.
        while (!waiting.empty()) {
            context.stop_if_cancelled();
            const Change best = best_change(waiting);
            if (best.gone.empty() && best.added.empty()) break;
            carry_out(best, waiting);
        }
        report_.nodes_left = waiting.size();
        return finish();
    }

private:
    // --- the surface at a node

    [[nodiscard]] bool is_exposed(Index tet, int corner) const {
        const Index next = neighbour(tet, corner);
        return next == none || !is_there_[next];
    }

    // The tet across a face; added tets are found among the tets of a corner.
    [[nodiscard]] Index neighbour(Index tet, int corner) const {
        if (tet < mesh_.neighbours.size() && mesh_.neighbours[tet][corner] != none)
            return mesh_.neighbours[tet][corner];
        if (mesh_.tets.size() == mesh_.neighbours.size()) return none;
        const auto& face = tet_face_corners[corner];
        const Tet& corners = mesh_.tets[tet];
        for (const Index other : tets_at_[corners[face[0]]]) {
            if (other == tet || !is_there_[other]) continue;
            if (has(other, corners[face[1]]) && has(other, corners[face[2]])) return other;
        }
        return none;
    }

    [[nodiscard]] bool has(Index tet, Index node) const {
        const Tet& corners = mesh_.tets[tet];
        return std::find(corners.begin(), corners.end(), node) != corners.end();
    }

    // The exposed faces at a node, as the edges opposite it: one closed cycle on a manifold.
    [[nodiscard]] std::vector<Edge> link_of(Index node) const {
        std::vector<Edge> link;
        for (const Index t : tets_at_[node]) {
            if (!is_there_[t]) continue;
            for (int corner = 0; corner < 4; ++corner) {
                if (mesh_.tets[t][corner] == node || !is_exposed(t, corner)) continue;
                const auto& face = tet_face_corners[corner];
                Triangle at{mesh_.tets[t][face[0]], mesh_.tets[t][face[1]], mesh_.tets[t][face[2]]};
                std::rotate(at.begin(), std::find(at.begin(), at.end(), node), at.end());
                link.push_back({at[1], at[2]});
            }
        }
        std::sort(link.begin(), link.end());
        return link;
    }

    [[nodiscard]] bool is_manifold(Index node) const {
        const std::vector<Edge> link = link_of(node);
        if (link.empty()) return true;
        for (std::size_t i = 1; i < link.size(); ++i) {
            if (link[i][0] == link[i - 1][0]) return false;
        }
        Index at = link.front()[0];
        for (std::size_t step = 1; step <= link.size(); ++step) {
            const auto next = std::lower_bound(link.begin(), link.end(), Edge{at, 0});
            if (next == link.end() || (*next)[0] != at) return false;
            at = (*next)[1];
            if (at == link.front()[0]) return step == link.size();
        }
        return false;
    }

    // --- what could be changed at a node

    // Sets of tets at `node` connected across faces that hold the node and `along` (none: the node alone).
    [[nodiscard]] std::vector<std::vector<Index>> parts_at(Index node, Index along) const {
        std::vector<Index> left;
        for (const Index t : tets_at_[node]) {
            if (is_there_[t] && (along == none || has(t, along))) left.push_back(t);
        }
        std::vector<std::vector<Index>> parts;
        while (!left.empty()) {
            std::vector<Index> part{left.front()};
            left.erase(left.begin());
            for (std::size_t i = 0; i < part.size(); ++i) {
                for (int corner = 0; corner < 4; ++corner) {
                    const Index opposite = mesh_.tets[part[i]][corner];
                    if (opposite == node || opposite == along) continue;
                    const auto next = std::find(left.begin(), left.end(), neighbour(part[i], corner));
                    if (next == left.end()) continue;
                    part.push_back(*next);
                    left.erase(next);
                }
            }
            parts.push_back(std::move(part));
        }
        return parts;
    }

    // Neighbours of a node along which more than two faces of the surface meet.
    [[nodiscard]] std::vector<Index> bad_edges_at(Index node) const {
        const std::vector<Edge> link = link_of(node);
        std::vector<Index> ends;
        for (std::size_t i = 1; i < link.size(); ++i) {
            if (link[i][0] == link[i - 1][0] && (ends.empty() || ends.back() != link[i][0])) ends.push_back(link[i][0]);
        }
        return ends;
    }

    [[nodiscard]] double volume_of(const Tet& tet) const {
        const auto& p = mesh_.positions;
        return signed_volume(p[tet[0]], p[tet[1]], p[tet[2]], p[tet[3]]);
    }

    void offer_removal(std::vector<Index> gone, std::vector<Change>& changes) const {
        Change change;
        for (const Index t : gone) change.volume += volume_of(mesh_.tets[t]);
        change.gone = std::move(gone);
        changes.push_back(std::move(change));
    }

    // A tet in the gap between two faces of the surface that meet along (node, end).
    void offer_additions(Index node, Index end, std::vector<Change>& changes) const {
        for (const Edge& going : link_of(node)) {
            if (going[0] != end) continue;
            for (const Edge& coming : link_of(node)) {
                if (coming[1] != end || coming[0] == going[1]) continue;
                // Both faces look into the gap, so it is inside of neither.
                const Tet tet{node, end, going[1], coming[0]};
                if (!is_open_space(tet)) continue;
                Change change;
                change.added.push_back(tet);
                change.region = region_beside(node, end);
                change.volume = volume_of(tet);
                changes.push_back(change);
            }
        }
    }

    [[nodiscard]] Index region_beside(Index node, Index end) const {
        for (const Index t : tets_at_[node]) {
            if (is_there_[t] && has(t, end)) return mesh_.region.empty() ? none : mesh_.region[t];
        }
        return none;
    }

    [[nodiscard]] std::vector<Change> changes_at(Index node) const {
        std::vector<Change> changes;
        for (std::vector<Index>& part : parts_at(node, none)) offer_removal(std::move(part), changes);
        for (const Index end : bad_edges_at(node)) {
            for (std::vector<Index>& part : parts_at(node, end)) offer_removal(std::move(part), changes);
            offer_additions(node, end, changes);
        }
        for (const Index t : tets_at_[node]) {
            bool touches = false;
            for (int corner = 0; is_there_[t] && corner < 4; ++corner)
                touches |= mesh_.tets[t][corner] != node && is_exposed(t, corner);
            if (touches) offer_removal({t}, changes);
        }
        return changes;
    }

    // --- where an added tet would not run into others

    void plant_tree(const Boundary& boundary) {
        std::vector<Box> boxes;
        for (const Triangle& face : boundary.faces) {
            faces_.push_back(face);
            Box box;
            for (const Index v : face) box.add(mesh_.positions[v]);
            boxes.push_back(box);
        }
        tree_ = Bvh(boxes);
    }

    // Positive, and no face of the surface and no tet added before enters it, as planes through faces can prove.
    [[nodiscard]] bool is_open_space(const Tet& tet) const {
        const auto& p = mesh_.positions;
        if (orient3d(p[tet[0]], p[tet[1]], p[tet[2]], p[tet[3]]) <= 0) return false;
        Box box;
        for (const Index v : tet) box.add(p[v]);
        bool is_open = true;
        tree_.touching(box, [&](Index f) {
            is_open = is_apart(faces_[f], tet);
            return !is_open;
        });
        for (std::size_t t = mesh_.neighbours.size(); t < mesh_.tets.size(); ++t)
            is_open &= are_apart(mesh_.tets[t], tet);
        return is_open;
    }

    [[nodiscard]] int side_of(Index a, Index b, Index c, Index p) const {
        if (p == a || p == b || p == c) return 0;
        const auto& at = mesh_.positions;
        return orient3d(at[a], at[b], at[c], at[p]);
    }

    template <class Corners>
    [[nodiscard]] bool is_beyond_a_face(const Corners& corners, const Tet& tet) const {
        return std::any_of(std::begin(tet_face_corners), std::end(tet_face_corners), [&](const auto& face) {
            return std::all_of(corners.begin(), corners.end(),
                               [&](Index v) { return side_of(tet[face[0]], tet[face[1]], tet[face[2]], v) >= 0; });
        });
    }

    [[nodiscard]] bool is_apart(const Triangle& face, const Tet& tet) const {
        if (is_beyond_a_face(face, tet)) return true;
        int lowest = 0;
        int highest = 0;
        for (const Index v : tet) {
            lowest = std::min(lowest, side_of(face[0], face[1], face[2], v));
            highest = std::max(highest, side_of(face[0], face[1], face[2], v));
        }
        return (lowest == 0) != (highest == 0);
    }

    [[nodiscard]] bool are_apart(const Tet& a, const Tet& b) const {
        return is_beyond_a_face(a, b) || is_beyond_a_face(b, a);
    }

    // --- choosing and doing

    // The nodes whose surface a change may alter.
    [[nodiscard]] std::set<Index> nodes_of(const Change& change) const {
        std::set<Index> nodes;
        for (const Index t : change.gone) nodes.insert(mesh_.tets[t].begin(), mesh_.tets[t].end());
        for (const Tet& tet : change.added) nodes.insert(tet.begin(), tet.end());
        return nodes;
    }

    void put(const Change& change) {
        for (const Index t : change.gone) is_there_[t] = 0;
        for (const Tet& tet : change.added) {
            const Index t = static_cast<Index>(mesh_.tets.size());
            mesh_.tets.push_back(tet);
            if (!mesh_.region.empty()) mesh_.region.push_back(change.region);
            is_there_.push_back(1);
            for (const Index v : tet) tets_at_[v].push_back(t);
        }
    }

    void take_back(const Change& change) {
        for (const Index t : change.gone) is_there_[t] = 1;
        for (const Tet& tet : change.added) {
            mesh_.tets.pop_back();
            if (!mesh_.region.empty()) mesh_.region.pop_back();
            is_there_.pop_back();
            for (const Index v : tet) tets_at_[v].pop_back();
        }
    }

    [[nodiscard]] bool loses_shell_node(const Change& change) const {
        for (const Index t : change.gone) {
            for (const Index v : mesh_.tets[t]) {
                if (v >= mesh_.shell_vertex_count) continue;
                const bool is_used = std::any_of(tets_at_[v].begin(), tets_at_[v].end(), [&](Index other) {
                    return is_there_[other] &&
                           std::find(change.gone.begin(), change.gone.end(), other) == change.gone.end();
                });
                if (!is_used) return true;
            }
        }
        return false;
    }

    // How many fewer bad nodes there would be.
    [[nodiscard]] int gain_of(const Change& change, const std::set<Index>& waiting) {
        int gain = 0;
        put(change);
        for (const Index v : nodes_of(change))
            gain += static_cast<int>(waiting.contains(v)) - static_cast<int>(!is_manifold(v));
        take_back(change);
        return gain;
    }

    // The first bad node's best change: the least volume for each node mended. Nodes that no change helps wait for
    // others.
    Change best_change(const std::set<Index>& waiting) {
        for (const Index node : waiting) {
            Change best;
            double best_cost = 0;
            for (Change& change : changes_at(node)) {
                if (loses_shell_node(change)) continue;
                const int gain = gain_of(change, waiting);
                const double cost = change.volume / std::max(gain, 1);
                if (gain <= 0 || (!(best.gone.empty() && best.added.empty()) && cost >= best_cost)) continue;
                best_cost = cost;
                best = std::move(change);
            }
            if (!best.gone.empty() || !best.added.empty()) return best;
        }
        return {};
    }

    void carry_out(const Change& change, std::set<Index>& waiting) {
        const std::set<Index> nodes = nodes_of(change);
        put(change);
        for (const Index v : nodes) {
            if (is_manifold(v)) {
                waiting.erase(v);
            } else {
                waiting.insert(v);
            }
        }
        report_.removed += change.gone.size();
        report_.added += change.added.size();
        (change.added.empty() ? report_.volume_removed : report_.volume_added) += change.volume;
        places_.insert(nodes.begin(), nodes.end());
    }

    Repaired finish() {
        report_.places.assign(places_.begin(), places_.end());
        std::size_t kept = 0;
        for (std::size_t t = 0; t < mesh_.tets.size(); ++t) {
            if (!is_there_[t]) continue;
            mesh_.tets[kept] = mesh_.tets[t];
            if (!mesh_.region.empty()) mesh_.region[kept] = mesh_.region[t];
            ++kept;
        }
        mesh_.tets.resize(kept);
        if (!mesh_.region.empty()) mesh_.region.resize(kept);
        mesh_.neighbours = neighbours_of(mesh_.tets);
        return {std::move(mesh_), std::move(report_)};
    }

    TetMesh mesh_;  // added tets come at the end and have no entry in neighbours
    std::vector<std::vector<Index>> tets_at_;
    std::vector<std::uint8_t> is_there_;
    std::vector<Triangle> faces_;  // of the surface as it came
    Bvh tree_;
    std::set<Index> places_;
    RepairReport report_;
};

}

Repaired repair_surface(TetMesh mesh, const Context& context) { return Repairer(std::move(mesh)).run(context); }

}
