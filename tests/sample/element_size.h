// SPDX-License-Identifier: GPL-3.0-or-later
// h and the distance to the shell by trying every vertex and triangle: what the stage computes with shortcuts.
#pragma once
#include <algorithm>
#include <limits>
#include <vector>

#include "geometry/measures.h"
#include "mesh/shell.h"

namespace crumple::shapes {

class ElementSize {
public:
    explicit ElementSize(const Shell& shell) : shell_(shell) {
        std::vector<int> edges(shell.positions.size());
        sizes_.resize(shell.positions.size());
        for (const Triangle& t : shell.triangles) {
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const Index a = t[corner];
                const Index b = t[(corner + 1) % 3];
                for (const Index v : {a, b}) {
                    sizes_[v] += length(shell.positions[a] - shell.positions[b]);
                    ++edges[v];
                }
            }
        }
        for (std::size_t v = 0; v < sizes_.size(); ++v) sizes_[v] /= std::max(edges[v], 1);
    }

    [[nodiscard]] double at(Vec3 p) const {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t v = 0; v < sizes_.size(); ++v) {
            if (sizes_[v] > 0) least = std::min(least, sizes_[v] + 0.3 * length(p - shell_.positions[v]));
        }
        return least;
    }

    [[nodiscard]] double distance(Vec3 p) const {
        double least = std::numeric_limits<double>::infinity();
        for (const auto& [a, b, c] : shell_.triangles) {
            const Vec3 nearest =
                closest_point_on_triangle(shell_.positions[a], shell_.positions[b], shell_.positions[c], p);
            least = std::min(least, length(nearest - p));
        }
        return least;
    }

private:
    const Shell& shell_;
    std::vector<double> sizes_;
};

}
