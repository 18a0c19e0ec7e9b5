// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay/cgal_oracle.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace crumple::oracle {
namespace {

template <class Kernel>
using Triangulation = CGAL::Delaunay_triangulation_3<
    Kernel, CGAL::Triangulation_data_structure_3<CGAL::Triangulation_vertex_base_with_info_3<Index, Kernel>,
                                                 CGAL::Delaunay_triangulation_cell_base_3<Kernel>>>;

// The inexact kernel's filters are only right away from overflow and underflow.
bool is_moderate(const std::vector<Vec3>& points) {
    return std::all_of(points.begin(), points.end(), [](Vec3 p) {
        const auto fits = [](double v) { return v == 0 || (std::fabs(v) > 1e-40 && std::fabs(v) < 1e40); };
        return fits(p.x) && fits(p.y) && fits(p.z);
    });
}

struct ByCoordinates {
    bool operator()(const Vec3& a, const Vec3& b) const { return lexicographic_less(a, b); }
};

template <class Kernel>
Triangulation<Kernel> triangulate(const std::vector<Vec3>& points) {
    std::map<Vec3, Index, ByCoordinates> first;
    for (Index i = 0; i < points.size(); ++i) first.try_emplace(points[i], i);
    std::vector<std::pair<typename Kernel::Point_3, Index>> input;
    for (const auto& [p, i] : first) input.push_back({typename Kernel::Point_3(p.x, p.y, p.z), i});
    return {input.begin(), input.end()};
}

template <class Kernel>
std::vector<Tet> tets_of(const Triangulation<Kernel>& triangulation) {
    std::vector<Tet> tets;
    if (triangulation.dimension() < 3) return tets;
    for (const auto cell : triangulation.finite_cell_handles()) {
        Tet tet;
        for (int i = 0; i < 4; ++i) tet[i] = cell->vertex(i)->info();
        std::sort(tet.begin(), tet.end());
        tets.push_back(tet);
    }
    std::sort(tets.begin(), tets.end());
    return tets;
}

using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

}

std::vector<Tet> cgal_tets(const std::vector<Vec3>& points) {
    return is_moderate(points) ? tets_of<Inexact>(triangulate<Inexact>(points))
                               : tets_of<Exact>(triangulate<Exact>(points));
}

int cgal_dimension(const std::vector<Vec3>& points) { return triangulate<Exact>(points).dimension(); }

}
