// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay/delaunay.h"

#include <string>

#include "delaunay/canonical.h"
#include "delaunay/first_simplex.h"
#include "delaunay/lifted_hull.h"
#include "delaunay/order.h"
#include "delaunay/sites.h"

namespace crumple::delaunay {
namespace {

Finding flat_points(int dimension) {
    const char* const shape = dimension == 2   ? "lie in one plane"
                              : dimension == 1 ? "lie on one line"
                              : dimension == 0 ? "are all at one place"
                                               : "are none";
    return {"POINTS_FLAT",
            Severity::error,
            std::string("the points ") + shape + ": no tet can be made; give at least four points that span space",
            1,
            {}};
}

Finding duplicate_points(const std::vector<Vec3>& positions, const std::vector<Index>& duplicate_of) {
    Finding finding{"POINTS_DUPLICATE",
                    Severity::info,
                    "points at the place of an earlier point are in no tet; merge them if they should move together",
                    0,
                    {}};
    for (Index point = 0; point < duplicate_of.size(); ++point) {
        if (duplicate_of[point] != point) count_one(finding, {positions[point], point, {}});
    }
    return finding;
}

std::uint32_t count_hull_faces(const TetMesh& mesh) {
    std::uint32_t count = 0;
    for (const auto& neighbours : mesh.neighbours) {
        for (const Index neighbour : neighbours) count += neighbour == none;
    }
    return count;
}

}

Result tetrahedralize(const PointSet& points, const Params& params, const Context& context) {
    Sites sites = make_sites(points.positions);
    const FirstSimplex first = find_first_simplex(sites);
    Result result;
    result.mesh.positions = points.positions;
    result.mesh.shell_vertex_count = points.shell_vertex_count;
    Report& report = result.report;
    report.points = static_cast<std::uint32_t>(points.positions.size());
    report.duplicates = report.points - sites.count();
    report.dimension = first.dimension;
    report.order = choose_order(params.order, sites.count());
    if (first.dimension < 3) {
        report.findings.push_back(flat_points(first.dimension));
    } else {
        LiftedHull hull(sites);
        hull.start(first.vertex);
        insertion_of(report.order)(hull, first.vertex, context);
        hull.finish();
        write_canonical_tets(hull, result.mesh);
        report.uncertain_tests = hull.uncertain_tests();
        report.cospherical_tests = hull.tie_tests();
    }
    report.tets = static_cast<std::uint32_t>(result.mesh.tets.size());
    report.hull_faces = count_hull_faces(result.mesh);
    result.duplicate_of = std::move(sites.duplicate_of);
    if (report.duplicates > 0) {
        report.findings.push_back(duplicate_points(points.positions, result.duplicate_of));
    }
    return result;
}

}
