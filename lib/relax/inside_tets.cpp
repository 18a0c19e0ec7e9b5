// SPDX-License-Identifier: GPL-3.0-or-later
#include "relax/inside_tets.h"

#include <algorithm>

#include "core/parallel_for.h"

namespace crumple::relax {

namespace {

Vec3 centre_of(const TetMesh& mesh, const Tet& tet) {
    Vec3 sum;
    for (const Index node : tet) sum += mesh.positions[node];
    return sum * 0.25;
}

std::array<Index, 4> ascending(Tet tet) {
    std::sort(tet.begin(), tet.end());
    return tet;
}

}

const InsideTets::Known* InsideTets::look_up(const Corners& corners) const {
    const auto found =
        std::lower_bound(known_.begin(), known_.end(), corners,
                         [](const Known& known, const Corners& wanted) { return known.corners < wanted; });
    return found != known_.end() && found->corners == corners ? &*found : nullptr;
}

void InsideTets::remember(const TetMesh& mesh, const std::vector<std::uint8_t>& is_inside) {
    std::vector<Known> fresh;
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
        const Corners corners = ascending(mesh.tets[t]);
        if (corners[3] < mesh.shell_vertex_count && !look_up(corners)) fresh.push_back({corners, is_inside[t]});
    }
    const auto less = [](const Known& a, const Known& b) { return a.corners < b.corners; };
    std::sort(fresh.begin(), fresh.end(), less);
    const auto middle = static_cast<std::ptrdiff_t>(known_.size());
    known_.insert(known_.end(), fresh.begin(), fresh.end());
    std::inplace_merge(known_.begin(), known_.begin() + middle, known_.end(), less);
}

std::vector<std::uint8_t> InsideTets::find(const TetMesh& mesh, const Context& context) {
    std::vector<std::uint8_t> is_inside(mesh.tets.size());
    parallel_for(context, mesh.tets.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
            const Corners corners = ascending(mesh.tets[t]);
            const Known* known = corners[3] < mesh.shell_vertex_count ? look_up(corners) : nullptr;
            is_inside[t] = known ? known->is_inside : interior_.material_at(centre_of(mesh, mesh.tets[t])) != none;
        }
    });
    remember(mesh, is_inside);
    return is_inside;
}

}
