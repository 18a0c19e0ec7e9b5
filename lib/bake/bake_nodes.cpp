// SPDX-License-Identifier: GPL-3.0-or-later
#include "bake/bake_nodes.h"

#include <algorithm>

#include "bake/node_order.h"
#include "core/error.h"
#include "core/short_text.h"

namespace crumple::bake {
namespace {

// Adding zero turns -0 into 0, so that equal positions have equal bytes.
Vec3f narrow_to_bytes(Vec3 p) { return narrow(p) + Vec3f{}; }

std::vector<std::uint8_t> find_used_nodes(const TetMesh& mesh) {
    std::vector<std::uint8_t> is_used(mesh.positions.size(), 0);
    for (const Tet& tet : mesh.tets) {
        for (const Index node : tet) is_used[node] = 1;
    }
    return is_used;
}

bool is_locked(const Shell& shell, Index node) { return node < shell.locked.size() && shell.locked[node] != 0; }

// The kept nodes by mesh index, in rising order; what is left out is counted.
std::vector<Index> choose_nodes(const Shell& shell, const TetMesh& mesh, Report& report) {
    const std::vector<std::uint8_t> is_used = find_used_nodes(mesh);
    std::vector<Index> kept;
    for (Index node = 0; node < mesh.positions.size(); ++node) {
        if (is_used[node] || is_locked(shell, node)) {
            kept.push_back(node);
        } else {
            ++(node < shell.positions.size() ? report.dropped_shell : report.dropped_interior);
        }
    }
    return kept;
}

// Edges of the tets that have a free node, between mesh nodes, ascending, each once.
std::vector<Edge> list_solver_edges(const Shell& shell, const TetMesh& mesh) {
    std::vector<Edge> edges;
    for (const Tet& tet : mesh.tets) {
        if (std::all_of(tet.begin(), tet.end(), [&](Index node) { return is_locked(shell, node); })) continue;
        for (const auto& [a, b] : tet_edge_corners) {
            const auto [i, j] = std::minmax(tet[static_cast<std::size_t>(a)], tet[static_cast<std::size_t>(b)]);
            edges.push_back({i, j});
        }
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

// What the artist calls the part a shell vertex belongs to.
std::string component_name_of(const Shell& shell, Index vertex) {
    for (std::size_t f = 0; f < shell.triangles.size(); ++f) {
        const Triangle& corners = shell.triangles[f];
        if (std::find(corners.begin(), corners.end(), vertex) != corners.end())
            return shell.components[shell.component[f]].name;
    }
    return "";
}

void report_unused_locks(const Shell& shell, const TetMesh& mesh, const Bundle& bundle, Report& report) {
    const std::vector<std::uint8_t> is_used = find_used_nodes(mesh);
    Finding finding{
        "LOCK_UNUSED",
        Severity::warning,
        "locked shell vertices that no tet uses: they are kept as nodes without mass; element is the shell vertex",
        0,
        {}};
    for (const Index node : bundle.node_to_mesh) {
        if (!is_used[node]) count_one(finding, {mesh.positions[node], node, component_name_of(shell, node)});
    }
    if (finding.count > 0) report.findings.push_back(std::move(finding));
}

// Throws when wanted holds a position that present does not. Both lexicographic.
void require_all(const std::vector<Vec3f>& wanted, const std::vector<Vec3f>& present, const std::string& complaint) {
    for (const Vec3f p : wanted) {
        if (std::binary_search(present.begin(), present.end(), p, lexicographic_less<float>)) continue;
        throw Error(ErrorKind::bad_input, "bake: " + complaint + ", first at " + position_text({p.x, p.y, p.z}) +
                                              "; import the shell again and run the stages from there");
    }
}

}

void bake_nodes(const Shell& shell, const TetMesh& mesh, NodeOrder how, Bundle& bundle, Report& report) {
    report.mesh_nodes = mesh.positions.size();
    const std::vector<Index> kept = choose_nodes(shell, mesh, report);
    std::vector<Index> kept_of(mesh.positions.size(), none);
    std::vector<Vec3> positions;
    for (Index k = 0; k < kept.size(); ++k) {
        kept_of[kept[k]] = k;
        positions.push_back(mesh.positions[kept[k]]);
    }
    std::vector<Edge> edges = list_solver_edges(shell, mesh);
    for (auto& [i, j] : edges) {
        report.bandwidth_before = std::max<std::uint64_t>(report.bandwidth_before, j - i);
        i = kept_of[i];
        j = kept_of[j];
    }
    bundle.mesh_to_node.assign(mesh.positions.size(), none);
    for (const Index k : order_nodes(positions, edges, how)) {
        bundle.mesh_to_node[kept[k]] = static_cast<Index>(bundle.node_to_mesh.size());
        bundle.node_to_mesh.push_back(kept[k]);
        bundle.rest_positions.push_back(narrow_to_bytes(positions[k]));
        bundle.locked.push_back(is_locked(shell, kept[k]) ? 1 : 0);
    }
}

void bake_locks(const Asset& asset, const TetMesh& mesh, Bundle& bundle, Report& report) {
    std::vector<Vec3f> locked;
    for (std::size_t node = 0; node < bundle.locked.size(); ++node) {
        if (bundle.locked[node]) locked.push_back(bundle.rest_positions[node]);
    }
    std::sort(locked.begin(), locked.end(), lexicographic_less<float>);
    std::vector<Vec3f>& painted = bundle.locked_positions;
    for (const Vec3 p : asset.locked_positions) painted.push_back(narrow_to_bytes(p));
    std::sort(painted.begin(), painted.end(), lexicographic_less<float>);
    painted.erase(std::unique(painted.begin(), painted.end()), painted.end());
    require_all(painted, locked, "a painted lock has no locked node at its position");
    require_all(locked, painted, "a shell vertex is locked that nobody painted");
    report_unused_locks(asset.shell, mesh, bundle, report);
}

}
