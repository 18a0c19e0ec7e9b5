// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/embedding.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "core/parallel_for.h"
#include "geometry/bvh.h"
#include "geometry/measures.h"
#include "mesh/shell_interior.h"

namespace crumple::quality {

namespace {

// What a vertex could have hung on instead.
class Alternatives {
public:
    Alternatives(const Shell& shell, const TetMesh& mesh) : mesh_(mesh), has_tets_(shell.components.size(), 0) {
        for (const Index region : mesh.region) has_tets_[region] = 1;
        if (std::count(has_tets_.begin(), has_tets_.end(), std::uint8_t{1}) < 2) return;
        std::vector<Box> boxes(mesh.tets.size());
        for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
            for (const Index v : mesh.tets[t]) boxes[t].add(mesh.positions[v]);
        }
        tree_ = Bvh(boxes);
        interior_.emplace(shell);
    }

    // Whether p, `distance` away from its tet, should hang on another shell: on the named one, else, for none, on the
    // one whose material fills p.
    [[nodiscard]] bool is_wrong(Vec3 p, Index tet, double distance, Index named) const {
        const Index region = mesh_.region[tet];
        if (!interior_ || named == region || (named != none && !has_tets_[named])) return false;
        std::vector<Index> near;  // other regions with a tet no farther away
        tree_.within(p, distance, [&](Index other) {
            const Index candidate = mesh_.region[other];
            const bool is_asked = candidate != region && (named == none || candidate == named);
            if (is_asked && std::find(near.begin(), near.end(), candidate) == near.end() &&
                distance_to(other, p) <= distance) {
                near.push_back(candidate);
            }
            return false;
        });
        if (near.empty()) return false;
        if (named != none) return true;
        // On a surface either side may have it.
        return !interior_->is_on_surface(p) &&
               std::find(near.begin(), near.end(), interior_->material_at(p)) != near.end();
    }

private:
    [[nodiscard]] double distance_to(Index tet, Vec3 p) const {
        std::array<Vec3, 4> at;
        for (int i = 0; i < 4; ++i) at[i] = mesh_.positions[mesh_.tets[tet][i]];
        const std::array<double, 4> weights = barycentric(at[0], at[1], at[2], at[3], p);
        if (*std::min_element(weights.begin(), weights.end()) >= 0) return 0;
        double least = std::numeric_limits<double>::infinity();
        for (const auto& face : tet_face_corners) {
            least = std::min(least, length(p - closest_point_on_triangle(at[face[0]], at[face[1]], at[face[2]], p)));
        }
        return least;
    }

    const TetMesh& mesh_;
    std::vector<std::uint8_t> has_tets_;
    Bvh tree_;
    std::optional<ShellInterior> interior_;  // empty: there is but one region, nothing can be wrong
};

Index find_component(const Shell& shell, const std::string& name) {
    for (Index c = 0; c < shell.components.size(); ++c) {
        if (!name.empty() && shell.components[c].name == name) return c;
    }
    return none;
}

VertexEmbedding measure_vertices(const VisualMesh& visual, const VisualBinding& binding, Index named,
                                 const Alternatives& alternatives, const Context& context) {
    const std::size_t count = visual.positions.size();
    VertexEmbedding result{std::vector<float>(count), std::vector<float>(count), std::vector<std::uint8_t>(count)};
    parallel_for(context, count, 4096, [&](std::size_t begin, std::size_t end) {
        context.stop_if_cancelled();
        for (std::size_t v = begin; v < end; ++v) {
            double largest = 0;
            for (const double weight : binding.barycentric[v]) largest = std::max(largest, std::fabs(weight));
            const double distance = binding.inside[v] ? 0 : binding.distance[v];
            result.distance[v] = static_cast<float>(distance);
            result.max_weight[v] = static_cast<float>(largest);
            result.bound_wrongly[v] = alternatives.is_wrong(visual.positions[v], binding.tet[v], distance, named);
        }
    });
    return result;
}

struct Weighty {
    double weight;
    HungVertex vertex;
};

void collect(EmbeddingResult& result, std::vector<Weighty>& weighty, const VisualMesh& visual,
             const VisualBinding& binding, const VertexEmbedding& vertices) {
    for (Index v = 0; v < visual.positions.size(); ++v) {
        const HungVertex vertex{{visual.positions[v], v, visual.name}, binding.tet[v]};
        ++result.total.vertices;
        result.total.outside += binding.inside[v] ? 0 : 1;
        result.total.max_weight = std::max<double>(result.total.max_weight, vertices.max_weight[v]);
        if (vertices.max_weight[v] > 1) weighty.push_back({vertices.max_weight[v], vertex});
        if (!vertices.bound_wrongly[v]) continue;
        ++result.total.bound_wrongly;
        if (result.wrong.size() < max_places) result.wrong.push_back(vertex);
    }
}

std::vector<HungVertex> heaviest(std::vector<Weighty>& weighty) {
    const auto shown = std::min(weighty.size(), max_places);
    const auto end = weighty.begin() + static_cast<std::ptrdiff_t>(shown);
    std::partial_sort(weighty.begin(), end, weighty.end(), [](const Weighty& a, const Weighty& b) {
        if (a.weight != b.weight) return a.weight > b.weight;
        return lexicographic_less(a.vertex.place.position, b.vertex.place.position);
    });
    std::vector<HungVertex> vertices;
    for (auto at = weighty.begin(); at != end; ++at) {
        char text[32];
        std::snprintf(text, sizeof text, ", weight %.3g", at->weight);
        vertices.push_back(std::move(at->vertex));
        vertices.back().place.name += text;
    }
    return vertices;
}

}

EmbeddingResult measure_embedding(const Shell& shell, const TetMesh& mesh, std::span<const VisualMesh> visuals,
                                  const Bindings& bindings, const Context& context) {
    const Alternatives alternatives(shell, mesh);
    EmbeddingResult result;
    std::vector<Weighty> weighty;
    for (std::size_t i = 0; i < visuals.size() && i < bindings.size(); ++i) {
        const Index named = find_component(shell, visuals[i].shell_component);
        result.visuals.push_back(measure_vertices(visuals[i], bindings[i], named, alternatives, context));
        collect(result, weighty, visuals[i], bindings[i], result.visuals.back());
    }
    result.heaviest = heaviest(weighty);
    return result;
}

}
