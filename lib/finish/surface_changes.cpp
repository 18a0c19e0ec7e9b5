// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/surface_changes.h"

#include <algorithm>
#include <iterator>
#include <queue>
#include <set>

#include "finish/shape.h"
#include "geometry/measures.h"

namespace crumple::finish {

namespace {

// Funnels of more corners are wide: they mean something.
constexpr std::size_t largest_funnel = 6;

// A tet worse than this would be a new trouble: the sine of 6 degrees.
constexpr double least_added_shape = 0.1;

class Changes {
public:
    Changes(const TetSelection& tets, const OpenSpace& space, Index node, bool may_split)
        : tets_(tets), space_(space), node_(node), link_(tets.link_of(node)) {
        remove_parts(none);
        if (may_split) split_parts();
        for (const Index end : tets_.bad_ends_at(node_)) {
            remove_parts(end);
            add_between(end);
        }
        for (const Index t : tets_.tets_at(node_)) {
            if (!exposed_ends(t).empty()) remove({t});
        }
        open_path();
        close_funnels();
    }

    [[nodiscard]] std::vector<SurfaceChange> take() && { return std::move(all_); }

private:
    void remove(std::vector<Index> gone) {
        SurfaceChange change;
        for (const Index t : gone) change.cost += tets_.volume(t);
        change.gone = std::move(gone);
        all_.push_back(std::move(change));
    }

    void remove_parts(Index along) {
        for (std::vector<Index>& part : tets_.parts_at(node_, along)) remove(std::move(part));
    }

    // Parts that share the node but no face each get their own, the largest keeps it. That moves no surface, yet it
    // opens a joint: it counts like the loss of a tet.
    void split_parts() {
        std::vector<std::vector<Index>> parts = tets_.parts_at(node_, none);
        if (parts.size() < 2) return;
        double volume = 0;
        double largest = 0;
        std::size_t count = 0;
        for (auto& part : parts) {
            double of_part = 0;
            for (const Index t : part) of_part += tets_.volume(t);
            volume += of_part;
            count += part.size();
            if (of_part <= largest) continue;
            largest = of_part;
            std::swap(parts.front(), part);
        }
        for (std::size_t i = 1; i < parts.size(); ++i) {
            SurfaceChange change;
            change.split_node = node_;
            change.split_tets = std::move(parts[i]);
            change.cost = volume / static_cast<double>(count);
            all_.push_back(std::move(change));
        }
    }

    // A tet in the gap between two faces that meet along (node, end): both look into it.
    void add_between(Index end) {
        for (const Edge& going : link_) {
            for (const Edge& coming : link_) {
                if (going[0] == end && coming[1] == end && coming[0] != going[1])
                    add({{node_, end, going[1], coming[0]}});
            }
        }
    }

    // Where one sheet of the surface passes the node as a small funnel: tets that stop it, in a fan from each corner.
    void close_funnels() {
        for (const std::vector<Edge>& sheet : sheets()) {
            if (sheet.size() > largest_funnel) continue;
            for (const Edge& corner : sheet) {
                std::vector<Tet> fan;
                for (const auto& [from, to] : sheet) {
                    if (from != corner[0] && to != corner[0]) fan.push_back({node_, from, to, corner[0]});
                }
                if (fan.size() + 2 == sheet.size()) add(std::move(fan));
            }
        }
    }

    void add(std::vector<Tet> added) {
        const TetMesh& mesh = tets_.mesh();
        std::vector<Tet> before(mesh.tets.begin() + tets_.first_added(), mesh.tets.end());
        SurfaceChange change;
        for (const Tet& tet : added) {
            const auto& p = mesh.positions;
            if (shape_of(p[tet[0]], p[tet[1]], p[tet[2]], p[tet[3]]) < least_added_shape) return;
            if (!space_.has_room_for(p, tet, before)) return;
            before.push_back(tet);
            change.like.push_back(tet_along(tet[0], tet[1]));
            change.cost += signed_volume(p[tet[0]], p[tet[1]], p[tet[2]], p[tet[3]]);
        }
        change.added = std::move(added);
        all_.push_back(std::move(change));
    }

    // The first tet at an edge of the mesh.
    [[nodiscard]] Index tet_along(Index a, Index b) const {
        const std::vector<Index> tets = tets_.tets_at(a);
        return *std::find_if(tets.begin(), tets.end(), [&](Index t) { return tets_.has(t, b); });
    }

    // The ends of the exposed faces that a tet has at the node.
    [[nodiscard]] std::vector<Index> exposed_ends(Index tet) const {
        std::vector<Index> ends;
        const Tet& corners = tets_.mesh().tets[tet];
        for (int corner = 0; corner < 4; ++corner) {
            if (corners[corner] == node_ || tets_.neighbour(tet, corner) != none) continue;
            for (int i = 0; i < 4; ++i) {
                if (i != corner && corners[i] != node_) ends.push_back(corners[i]);
            }
        }
        return ends;
    }

    // Where the surface passes the node in two sheets with tets between: the tets of least volume that open the way
    // from one sheet to the other.
    void open_path() {
        const std::vector<Index> first = first_sheet();
        const auto is_first = [&](Index v) { return std::binary_search(first.begin(), first.end(), v); };
        struct Reached {
            double cost;
            Index tet;
            Index from;
            bool operator>(const Reached& b) const { return cost != b.cost ? cost > b.cost : tet > b.tet; }
        };
        std::priority_queue<Reached, std::vector<Reached>, std::greater<>> waiting;
        for (const Index t : tets_.tets_at(node_)) {
            const std::vector<Index> ends = exposed_ends(t);
            if (std::any_of(ends.begin(), ends.end(), is_first)) waiting.push({tets_.volume(t), t, none});
        }
        std::vector<Reached> settled;
        while (!waiting.empty()) {
            const Reached now = waiting.top();
            waiting.pop();
            const auto is_now = [&](const Reached& r) { return r.tet == now.tet; };
            if (std::any_of(settled.begin(), settled.end(), is_now)) continue;
            settled.push_back(now);
            const std::vector<Index> ends = exposed_ends(now.tet);
            if (std::any_of(ends.begin(), ends.end(), [&](Index v) { return !is_first(v); })) {
                std::vector<Index> path;
                for (Index t = now.tet; t != none;) {
                    path.push_back(t);
                    t = std::find_if(settled.begin(), settled.end(), [&](const Reached& r) {
                            return r.tet == t;
                        })->from;
                }
                remove(std::move(path));
                return;
            }
            for (int corner = 0; corner < 4; ++corner) {
                const Index next = tets_.neighbour(now.tet, corner);
                if (tets_.mesh().tets[now.tet][corner] == node_ || next == none) continue;
                waiting.push({now.cost + tets_.volume(next), next, now.tet});
            }
        }
    }

    // The link in parts that hang together by faces of the surface.
    [[nodiscard]] std::vector<std::vector<Edge>> sheets() const {
        std::vector<std::vector<Edge>> sheets;
        std::vector<Edge> left = link_;
        while (!left.empty()) {
            std::vector<Edge> sheet{left.front()};
            left.erase(left.begin());
            for (std::size_t i = 0; i < sheet.size(); ++i) {
                const Edge at = sheet[i];
                const auto meets = [&](const Edge& e) { return e[0] == at[1] || e[1] == at[0]; };
                std::copy_if(left.begin(), left.end(), std::back_inserter(sheet), meets);
                std::erase_if(left, meets);
            }
            sheets.push_back(std::move(sheet));
        }
        return sheets;
    }

    // The ends of the first sheet, ascending.
    [[nodiscard]] std::vector<Index> first_sheet() const {
        std::set<Index> ends;
        const std::vector<std::vector<Edge>> all = sheets();
        if (!all.empty()) {
            for (const Edge& edge : all.front()) ends.insert(edge.begin(), edge.end());
        }
        return {ends.begin(), ends.end()};
    }

    const TetSelection& tets_;
    const OpenSpace& space_;
    Index node_;
    std::vector<Edge> link_;
    std::vector<SurfaceChange> all_;
};

}

std::vector<SurfaceChange> surface_changes_at(const TetSelection& tets, const OpenSpace& space, Index node,
                                              bool may_split) {
    return Changes(tets, space, node, may_split).take();
}

}
