// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary.h"

#include <algorithm>

#include "core/error.h"

namespace crumple {

namespace {

// One side of the link of a vertex: in a triangle (vertex, from, to) the edge opposite the vertex.
struct LinkEdge {
    Index vertex;
    Index from;
    Index to;
};

bool by_vertex(const LinkEdge& a, const LinkEdge& b) {
    if (a.vertex != b.vertex) return a.vertex < b.vertex;
    return a.from != b.from ? a.from < b.from : a.to < b.to;
}

std::vector<LinkEdge> sorted_links(std::span<const Triangle> faces) {
    std::vector<LinkEdge> links;
    links.reserve(faces.size() * 3);
    for (const auto& [a, b, c] : faces) links.insert(links.end(), {{a, b, c}, {b, c, a}, {c, a, b}});
    std::sort(links.begin(), links.end(), by_vertex);
    return links;
}

// Whether the link edges of one vertex form a single closed cycle.
bool is_one_cycle(std::span<const LinkEdge> links) {
    for (std::size_t i = 1; i < links.size(); ++i) {
        if (links[i].from == links[i - 1].from) return false;
    }
    const auto following = [&](Index from) {
        return std::lower_bound(links.begin(), links.end(), from,
                                [](const LinkEdge& l, Index f) { return l.from < f; });
    };
    Index at = links.front().from;
    for (std::size_t step = 1; step <= links.size(); ++step) {
        const auto next = following(at);
        if (next == links.end() || next->from != at) return false;
        at = next->to;
        if (at == links.front().from) return step == links.size();
    }
    return false;
}

std::vector<Edge> edges_not_of_two(std::span<const Triangle> faces) {
    std::vector<Edge> edges;
    edges.reserve(faces.size() * 3);
    for (const auto& [a, b, c] : faces) {
        for (const auto& [from, to] : {Edge{a, b}, Edge{b, c}, Edge{c, a}})
            edges.push_back({std::min(from, to), std::max(from, to)});
    }
    std::sort(edges.begin(), edges.end());
    std::vector<Edge> odd;
    for (std::size_t i = 0, next = 0; i < edges.size(); i = next) {
        while (next < edges.size() && edges[next] == edges[i]) ++next;
        if (next - i != 2) odd.push_back(edges[i]);
    }
    return odd;
}

}

Boundary boundary_of(const TetMesh& mesh) {
    CRUMPLE_CHECK(mesh.neighbours.size() == mesh.tets.size(), "every tet has its neighbours");
    Boundary boundary;
    for (Index t = 0; t < mesh.tets.size(); ++t) {
        for (int face = 0; face < 4; ++face) {
            if (mesh.neighbours[t][face] != none) continue;
            const auto& corner = tet_face_corners[face];
            boundary.faces.push_back({mesh.tets[t][corner[0]], mesh.tets[t][corner[1]], mesh.tets[t][corner[2]]});
            boundary.tet.push_back(t);
        }
    }
    return boundary;
}

NonManifold non_manifold(std::span<const Triangle> faces) {
    NonManifold found;
    found.edges = edges_not_of_two(faces);
    const std::vector<LinkEdge> links = sorted_links(faces);
    for (std::size_t i = 0, next = 0; i < links.size(); i = next) {
        while (next < links.size() && links[next].vertex == links[i].vertex) ++next;
        if (!is_one_cycle(std::span(links).subspan(i, next - i))) found.vertices.push_back(links[i].vertex);
    }
    return found;
}

std::vector<Index> pieces_of(const TetMesh& mesh) {
    CRUMPLE_CHECK(mesh.neighbours.size() == mesh.tets.size(), "every tet has its neighbours");
    std::vector<Index> piece(mesh.tets.size(), none);
    std::vector<Index> waiting;
    Index count = 0;
    for (Index first = 0; first < mesh.tets.size(); ++first) {
        if (piece[first] != none) continue;
        piece[first] = count;
        waiting.push_back(first);
        while (!waiting.empty()) {
            const Index t = waiting.back();
            waiting.pop_back();
            for (const Index next : mesh.neighbours[t]) {
                if (next == none || piece[next] != none) continue;
                piece[next] = count;
                waiting.push_back(next);
            }
        }
        ++count;
    }
    return piece;
}

}
