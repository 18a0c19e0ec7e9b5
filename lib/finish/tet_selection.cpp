// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/tet_selection.h"

#include <algorithm>

#include "geometry/measures.h"
#include "mesh/neighbours.h"

namespace crumple::finish {

TetSelection::TetSelection(TetMesh mesh)
    : mesh_(std::move(mesh)),
      first_added_(static_cast<Index>(mesh_.tets.size())),
      tets_at_(mesh_.positions.size()),
      is_there_(mesh_.tets.size(), 1) {
    for (Index t = 0; t < mesh_.tets.size(); ++t) {
        for (const Index v : mesh_.tets[t]) tets_at_[v].push_back(t);
    }
}

bool TetSelection::has(Index tet, Index node) const {
    const Tet& corners = mesh_.tets[tet];
    return std::find(corners.begin(), corners.end(), node) != corners.end();
}

std::vector<Index> TetSelection::tets_at(Index node) const {
    std::vector<Index> tets;
    for (const Index t : tets_at_[node]) {
        if (is_there_[t]) tets.push_back(t);
    }
    return tets;
}

// Neighbours from the start are known; added tets are found among the tets of a corner.
Index TetSelection::neighbour(Index tet, int corner) const {
    if (tet < first_added_) {
        const Index known = mesh_.neighbours[tet][corner];
        if (known != none && is_there_[known]) return known;
    }
    if (mesh_.tets.size() == first_added_) return none;
    const auto& face = tet_face_corners[corner];
    const Tet& corners = mesh_.tets[tet];
    for (const Index other : tets_at_[corners[face[0]]]) {
        if (other == tet || !is_there_[other]) continue;
        if (has(other, corners[face[1]]) && has(other, corners[face[2]])) return other;
    }
    return none;
}

double TetSelection::volume(Index tet) const {
    const auto& [a, b, c, d] = mesh_.tets[tet];
    return signed_volume(mesh_.positions[a], mesh_.positions[b], mesh_.positions[c], mesh_.positions[d]);
}

std::vector<Edge> TetSelection::link_of(Index node) const {
    std::vector<Edge> link;
    for (const Index t : tets_at_[node]) {
        if (!is_there_[t]) continue;
        for (int corner = 0; corner < 4; ++corner) {
            if (mesh_.tets[t][corner] == node || neighbour(t, corner) != none) continue;
            const auto& face = tet_face_corners[corner];
            Triangle at{mesh_.tets[t][face[0]], mesh_.tets[t][face[1]], mesh_.tets[t][face[2]]};
            std::rotate(at.begin(), std::find(at.begin(), at.end(), node), at.end());
            link.push_back({at[1], at[2]});
        }
    }
    std::sort(link.begin(), link.end());
    return link;
}

bool TetSelection::is_manifold(Index node) const {
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

std::vector<Index> TetSelection::bad_ends_at(Index node) const {
    const std::vector<Edge> link = link_of(node);
    std::vector<Index> ends;
    for (std::size_t i = 1; i < link.size(); ++i) {
        if (link[i][0] == link[i - 1][0] && (ends.empty() || ends.back() != link[i][0])) ends.push_back(link[i][0]);
    }
    return ends;
}

std::vector<std::vector<Index>> TetSelection::parts_at(Index node, Index along) const {
    std::vector<Index> left = tets_at(node);
    if (along != none) std::erase_if(left, [&](Index t) { return !has(t, along); });
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

std::vector<Index> TetSelection::nodes_of(const SurfaceChange& change) const {
    std::vector<Index> nodes;
    const auto add = [&](const Tet& tet) { nodes.insert(nodes.end(), tet.begin(), tet.end()); };
    for (const Index t : change.gone) add(mesh_.tets[t]);
    for (const Tet& tet : change.added) add(tet);
    for (const Index t : change.split_tets) add(mesh_.tets[t]);
    if (change.split_node != none) nodes.push_back(change.split_node);
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

void TetSelection::put(const SurfaceChange& change) {
    for (const Index t : change.gone) is_there_[t] = 0;
    mesh_.positions.insert(mesh_.positions.end(), change.places.begin(), change.places.end());
    tets_at_.resize(mesh_.positions.size());
    for (std::size_t i = 0; i < change.added.size(); ++i) {
        const Tet& tet = change.added[i];
        for (const Index v : tet) tets_at_[v].push_back(static_cast<Index>(mesh_.tets.size()));
        mesh_.tets.push_back(tet);
        if (!mesh_.region.empty()) mesh_.region.push_back(mesh_.region[change.like[i]]);
        is_there_.push_back(1);
    }
    if (change.split_node != none) split(change.split_node, change.split_tets);
}

void TetSelection::take_back(const SurfaceChange& change) {
    if (change.split_node != none) join(change.split_node, change.split_tets);
    for (const Index t : change.gone) is_there_[t] = 1;
    for (const Tet& tet : change.added) {
        mesh_.tets.pop_back();
        if (!mesh_.region.empty()) mesh_.region.pop_back();
        is_there_.pop_back();
        for (const Index v : tet) tets_at_[v].pop_back();
    }
    mesh_.positions.resize(mesh_.positions.size() - change.places.size());
    tets_at_.resize(mesh_.positions.size());
}

void TetSelection::split(Index node, const std::vector<Index>& tets) {
    const Index copy = static_cast<Index>(mesh_.positions.size());
    mesh_.positions.push_back(mesh_.positions[node]);
    tets_at_.push_back(tets);
    for (const Index t : tets) {
        std::replace(mesh_.tets[t].begin(), mesh_.tets[t].end(), node, copy);
        std::erase(tets_at_[node], t);
    }
}

void TetSelection::join(Index node, const std::vector<Index>& tets) {
    const Index copy = static_cast<Index>(mesh_.positions.size() - 1);
    for (const Index t : tets) {
        std::replace(mesh_.tets[t].begin(), mesh_.tets[t].end(), copy, node);
        tets_at_[node].push_back(t);
    }
    std::sort(tets_at_[node].begin(), tets_at_[node].end());
    mesh_.positions.pop_back();
    tets_at_.pop_back();
}

TetMesh TetSelection::take() && {
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
    return std::move(mesh_);
}

}
