// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/ring_triangulation.h"

#include <algorithm>

#include "finish/shape.h"

namespace crumple::finish {

namespace {

struct Table {
    double least[max_ring][max_ring];  // of the best triangulation of ring[i..j], 0: none beats the floor
    int middle[max_ring][max_ring];    // third corner of the triangle at side (i, j)
};

void read_triangles(const Table& table, int i, int j, std::vector<std::array<int, 3>>& triangles) {
    if (j < i + 2) return;
    const int k = table.middle[i][j];
    triangles.push_back({i, k, j});
    read_triangles(table, i, k, triangles);
    read_triangles(table, k, j, triangles);
}

}

bool triangulate_ring(Vec3 a, Vec3 b, std::span<const Vec3> ring, double floor, RingTriangulation& best) {
    const int n = static_cast<int>(ring.size());
    best.triangles.clear();
    best.least = 0;
    if (n < 3 || n > max_ring) return false;
    Table table;
    for (int i = 0; i + 1 < n; ++i) table.least[i][i + 1] = 1;
    for (int span = 2; span < n; ++span) {
        for (int i = 0; i + span < n; ++i) {
            const int j = i + span;
            double least = floor;
            table.middle[i][j] = -1;
            for (int k = i + 1; k < j; ++k) {
                double here = std::min(table.least[i][k], table.least[k][j]);
                if (!(here > least)) continue;
                here = std::min(here, shape_of(ring[i], ring[k], ring[j], b));
                if (!(here > least)) continue;
                here = std::min(here, shape_of(ring[i], ring[j], ring[k], a));
                if (!(here > least)) continue;
                least = here;
                table.middle[i][j] = k;
            }
            table.least[i][j] = table.middle[i][j] < 0 ? 0 : least;
        }
    }
    if (table.middle[0][n - 1] < 0) return false;
    best.least = table.least[0][n - 1];
    read_triangles(table, 0, n - 1, best.triangles);
    return true;
}

}
