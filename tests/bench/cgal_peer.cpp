// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/cgal_peer.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <optional>

#include "bench/cpu_time.h"

namespace crumple::bench {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

struct CgalPeer::Data {
    std::vector<Kernel::Point_3> points;
    std::optional<CGAL::Delaunay_triangulation_3<Kernel>> triangulation;
};

CgalPeer::CgalPeer(const std::vector<Vec3>& points) : data_(std::make_unique<Data>()) {
    for (const Vec3& p : points) data_->points.emplace_back(p.x, p.y, p.z);
}

CgalPeer::~CgalPeer() = default;

double CgalPeer::run() {
    data_->triangulation.reset();
    const double start = cpu_seconds();
    data_->triangulation.emplace(data_->points.begin(), data_->points.end());
    return cpu_seconds() - start;
}

std::size_t CgalPeer::tet_count() const { return data_->triangulation->number_of_finite_cells(); }

}
