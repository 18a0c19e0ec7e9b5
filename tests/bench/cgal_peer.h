// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL's Delaunay_triangulation_3 over Epick, its spatial sort included.
#pragma once
#include <cstddef>
#include <memory>
#include <vector>

#include "core/vec3.h"

namespace crumple::bench {

class CgalPeer {
public:
    explicit CgalPeer(const std::vector<Vec3>& points);  // copies them into CGAL's points
    ~CgalPeer();

    // Triangulates; the result lives until the next call. Returns CPU seconds.
    double run();
    [[nodiscard]] std::size_t tet_count() const;

private:
    struct Data;
    std::unique_ptr<Data> data_;
};

}
