// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/repair.h"

#include <algorithm>
#include <iterator>
#include <queue>
#include <set>

#include "finish/open_space.h"
#include "finish/shape.h"
#include "finish/tet_selection.h"
#include "geometry/measures.h"
#include "mesh/boundary.h"

namespace crumple::finish {

namespace {

// Funnels of more corners are wide: they mean something.
constexpr std::size_t largest_funnel = 6;

// A tet worse than this would be a new trouble: the sine of 6 degrees.
constexpr double least_added_shape = 0.1;

// Changes that mend one node and spoil another, at most: each asks all bad nodes.
constexpr int max_sideways = 50;

// Changes weighed at most: a mesh that is bad all over is not made good by taking it apart.
constexpr int max_weighed = 50000;

// What could be done about one node.
class Changes {
public:
    Changes(const TetSelection& tets, const OpenSpace& space, Index node, bool may_split)
        : tets_(tets), space_(space), node_(node), link_(tets.link_of(node)) {
        remove_parts(none);
        if (may_split) split_parts();
        for (const Index end : bad_ends()) {
            remove_parts(end);
            add_between(end);
        }
        for (const Index t : tets_.tets_at(node_)) {
            if (!exposed_ends(t).empty()) remove({t});
        }
        open_path();
        close_funnels();
    }

    [[nodiscard]] std::vector<SurfaceChange>& all() { return all_; }

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

    // Nodes along whose edge more than two faces of the surface meet.
    [[nodiscard]] std::vector<Index> bad_ends() const {
        std::vector<Index> ends;
        for (std::size_t i = 1; i < link_.size(); ++i) {
            if (link_[i][0] == link_[i - 1][0] && (ends.empty() || ends.back() != link_[i][0]))
                ends.push_back(link_[i][0]);
        }
        return ends;
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
            change.cost += signed_volume(p[tet[0]], p[tet[1]], p[tet[2]], p[tet[3]]);
        }
        change.added = std::move(added);
        all_.push_back(std::move(change));
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

class Repairer {
public:
    Repairer(TetMesh mesh, std::span<const std::uint8_t> locked)
        : surface_(boundary_of(mesh).faces),
          space_(mesh.positions, surface_),
          locked_(locked),
          tets_(std::move(mesh)) {}

    Repaired run(const Context& context) {
        const NonManifold wrong = non_manifold(surface_);
        report_.edges_before = wrong.edges.size();
        report_.nodes_before = wrong.vertices.size();
        waiting_.insert(wrong.vertices.begin(), wrong.vertices.end());
        // A change leaves fewer bad nodes than before, or is one of a limited number that do not: this ends.
        while (!waiting_.empty() && weighed_ < max_weighed) {
            context.stop_if_cancelled();
            const SurfaceChange best = best_change();
            if (best.is_empty()) break;
            carry_out(best);
        }
        report_.nodes_left = waiting_.size();
        return {std::move(tets_).take(), report_};
    }

private:
    [[nodiscard]] bool may_split(Index node) const { return node >= locked_.size() || !locked_[node]; }

    [[nodiscard]] bool loses_shell_vertex(const SurfaceChange& change) const {
        for (const Index v : tets_.nodes_of(change)) {
            if (v >= tets_.mesh().shell_vertex_count) continue;
            const std::vector<Index> tets = tets_.tets_at(v);
            const auto goes = [&](Index t) {
                return std::find(change.gone.begin(), change.gone.end(), t) != change.gone.end();
            };
            if (!tets.empty() && std::all_of(tets.begin(), tets.end(), goes)) return true;
        }
        return false;
    }

    // How many fewer bad nodes there would be.
    [[nodiscard]] int gain_of(const SurfaceChange& change) {
        ++weighed_;
        const std::vector<Index> nodes = tets_.nodes_of(change);
        int gain = 0;
        tets_.put(change);
        for (const Index v : nodes) gain += int{waiting_.contains(v)} - int{!tets_.is_manifold(v)};
        if (change.split_node != none) gain -= int{!tets_.is_manifold(last_node())};
        tets_.take_back(change);
        return gain;
    }

    [[nodiscard]] Index last_node() const { return static_cast<Index>(tets_.mesh().positions.size() - 1); }

    // The best change of the first bad node that has one: least cost for each node mended. Nodes without wait for their
    // neighbours to change; where all wait, tets go that mend one node and spoil another, for tets come to an end.
    SurfaceChange best_change() {
        SurfaceChange best = best_gaining_change();
        if (!best.is_empty() || sideways_ >= max_sideways) return best;
        for (const Index node : waiting_) {
            if (weighed_ >= max_weighed) break;
            Changes changes(tets_, space_, node, false);
            for (SurfaceChange& change : changes.all()) {
                const bool is_better = best.is_empty() || change.cost < best.cost;
                if (change.gone.empty() || loses_shell_vertex(change) || !is_better || gain_of(change) < 0) continue;
                best = std::move(change);
            }
        }
        ++sideways_;
        return best;
    }

    // Goes on where the last change was found, once around: a node that has none is not asked again for each change
    // elsewhere.
    SurfaceChange best_gaining_change() {
        const std::vector<Index> behind(waiting_.begin(), waiting_.lower_bound(next_));
        std::vector<Index> order(waiting_.lower_bound(next_), waiting_.end());
        order.insert(order.end(), behind.begin(), behind.end());
        for (const Index node : order) {
            if (weighed_ >= max_weighed) break;
            SurfaceChange best = best_gaining_change_at(node);
            if (best.is_empty()) continue;
            next_ = node;
            return best;
        }
        return {};
    }

    SurfaceChange best_gaining_change_at(Index node) {
        SurfaceChange best;
        double best_cost = 0;
        Changes changes(tets_, space_, node, may_split(node));
        for (SurfaceChange& change : changes.all()) {
            if (loses_shell_vertex(change)) continue;
            const int gain = gain_of(change);
            if (gain <= 0 || (!best.is_empty() && change.cost / gain >= best_cost)) continue;
            best_cost = change.cost / gain;
            best = std::move(change);
        }
        return best;
    }

    void carry_out(const SurfaceChange& change) {
        std::vector<Index> nodes = tets_.nodes_of(change);
        tets_.put(change);
        if (change.split_node != none) nodes.push_back(last_node());
        for (const Index v : nodes) {
            if (tets_.is_manifold(v)) {
                waiting_.erase(v);
            } else {
                waiting_.insert(v);
            }
        }
        report_.removed += change.gone.size();
        report_.added += change.added.size();
        report_.split += change.split_node != none;
        if (!change.gone.empty()) report_.volume_removed += change.cost;
        if (!change.added.empty()) report_.volume_added += change.cost;
    }

    std::vector<Triangle> surface_;  // as it came: tets that went since leave room, which nobody needs
    OpenSpace space_;
    std::span<const std::uint8_t> locked_;
    TetSelection tets_;
    std::set<Index> waiting_;
    int sideways_ = 0;  // changes that mended no more than they spoilt
    int weighed_ = 0;   // changes so far, done or not
    Index next_ = 0;    // bad node to ask first
    RepairReport report_;
};

}

Repaired repair_surface(TetMesh mesh, std::span<const std::uint8_t> locked, const Context& context) {
    return Repairer(std::move(mesh), locked).run(context);
}

}
