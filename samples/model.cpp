// SPDX-License-Identifier: MIT
#include "samples/model.h"

#include <algorithm>

namespace crumple::samples {

std::size_t vertex_count(const Model& model) {
    std::size_t count = 0;
    for (const auto& part : model) count += part.positions.size();
    return count;
}

std::size_t triangle_count(const Model& model) {
    std::size_t count = 0;
    for (const auto& part : model) count += part.triangles.size();
    return count;
}

std::size_t locked_count(const Model& model) {
    std::size_t count = 0;
    for (const auto& part : model) {
        count += static_cast<std::size_t>(
            std::count_if(part.colors.begin(), part.colors.end(), [](const Color& color) { return color[0] == 0; }));
    }
    return count;
}

Index add_vertex(Part& part, Vec3 position, Color color) {
    part.positions.push_back(round_to_float(position));
    part.colors.push_back(color);
    return static_cast<Index>(part.positions.size() - 1);
}

void add_quad(Part& part, Index a, Index b, Index c, Index d) {
    const auto& p = part.positions;
    const Vec3 ac = p[c] - p[a];
    const Vec3 bd = p[d] - p[b];
    if (dot(ac, ac) <= dot(bd, bd)) {
        part.triangles.push_back({a, b, c});
        part.triangles.push_back({a, c, d});
    } else {
        part.triangles.push_back({a, b, d});
        part.triangles.push_back({b, c, d});
    }
}

void paint(Part& part, Color color) { part.colors.assign(part.positions.size(), color); }

}
