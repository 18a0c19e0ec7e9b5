// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "bundle/exact_volume.h"
#include "bundle/validate_parts.h"

namespace crumple {
namespace {

// Float rounding of a value computed in double is 6e-8 of it; six_volumes is good to 1e-7.
constexpr double float_tolerance = 1e-6;

// Of the norm of the inverse. Implies |inverse_rest Dm - I| <= 1e-5 cond(Dm).
constexpr double inverse_tolerance = 1e-5;

double six_volumes_of(const Bundle& b, const Tet& tet) {
    return six_volumes(b.rest_positions[tet[0]], b.rest_positions[tet[1]], b.rest_positions[tet[2]],
                       b.rest_positions[tet[3]]);
}

bool is_inverse_right(const Bundle& b, std::size_t t) {
    const Tet& tet = b.tets[t];
    const auto expected = inverse_rest_matrix(b.rest_positions[tet[0]], b.rest_positions[tet[1]],
                                              b.rest_positions[tet[2]], b.rest_positions[tet[3]]);
    double error = 0;
    double size = 0;
    for (std::size_t i = 0; i < 9; ++i) {
        const double difference = b.inverse_rest[t][i] - expected[i];
        error += difference * difference;
        size += expected[i] * expected[i];
    }
    return std::sqrt(error) <= inverse_tolerance * std::sqrt(size);
}

bool is_all_locked(const Bundle& b, const Tet& tet) {
    return std::all_of(tet.begin(), tet.end(), [&](Index node) { return b.locked[node] != 0; });
}

// A face with its corners in rising order; is_odd tells from which side its tet sees it.
struct Face {
    Triangle corners;
    bool is_odd;
    Index tet;
};

Face sorted_face(const Tet& tet, Index t, const int (&corners)[3]) {
    Face face{{tet[static_cast<std::size_t>(corners[0])], tet[static_cast<std::size_t>(corners[1])],
               tet[static_cast<std::size_t>(corners[2])]},
              false,
              t};
    const auto order = [&](std::size_t i, std::size_t j) {
        if (face.corners[i] <= face.corners[j]) return;
        std::swap(face.corners[i], face.corners[j]);
        face.is_odd = !face.is_odd;
    };
    order(0, 1);
    order(1, 2);
    order(0, 1);
    return face;
}

}

void check_tet_geometry(const Bundle& b, Complaints& complaints) {
    for (std::size_t t = 0; t < b.tets.size(); ++t) {
        const auto tet = static_cast<Index>(t);
        const Vec3f place = b.rest_positions[b.tets[t][0]];
        const double volume = six_volumes_of(b, b.tets[t]) / 6;
        if (!(volume > 0)) {
            complaints.add("BUNDLE_TET_NOT_POSITIVE", "a tet is flat or inside out", tet, place);
            continue;
        }
        if (!(b.volume[t] > 0) || std::fabs(b.volume[t] - volume) > float_tolerance * volume) {
            complaints.add("BUNDLE_VOLUME", "a tet's volume is not that of its corners", tet, place);
        }
        if (!is_inverse_right(b, t)) {
            complaints.add("BUNDLE_INVERSE_REST", "a tet's inverse rest matrix is not that of its corners", tet, place);
        }
        if (!(b.stiffness_scale[t] > 0)) {
            complaints.add("BUNDLE_STIFFNESS", "a tet's stiffness scale is not positive", tet, place);
        }
    }
}

void check_tet_order(const Bundle& b, Complaints& complaints) {
    for (std::size_t t = 0; t < b.tets.size(); ++t) {
        if (is_all_locked(b, b.tets[t]) != (t >= b.solver_tet_count)) {
            complaints.add("BUNDLE_TET_ORDER",
                           "tets with a free node come first, solver_tet_count of them, then the rest",
                           static_cast<Index>(t), b.rest_positions[b.tets[t][0]]);
        }
    }
}

void check_faces(const Bundle& b, Complaints& complaints) {
    std::vector<Face> faces;
    faces.reserve(4 * b.tets.size());
    for (Index t = 0; t < b.tets.size(); ++t) {
        for (const auto& corners : tet_face_corners) faces.push_back(sorted_face(b.tets[t], t, corners));
    }
    std::sort(faces.begin(), faces.end(), [](const Face& a, const Face& c) {
        return a.corners != c.corners ? a.corners < c.corners : a.tet < c.tet;
    });
    for (std::size_t i = 1; i < faces.size(); ++i) {
        if (faces[i].corners != faces[i - 1].corners) continue;
        const bool is_third = i >= 2 && faces[i].corners == faces[i - 2].corners;
        if (is_third || faces[i].is_odd == faces[i - 1].is_odd) {
            complaints.add("BUNDLE_FACE", "a face belongs to more than two tets or to two on the same side",
                           faces[i].tet, b.rest_positions[faces[i].corners[0]]);
        }
    }
}

void check_masses(const Bundle& b, Complaints& complaints) {
    std::vector<double> mass(b.mass.size(), 0.0);
    std::vector<std::uint8_t> is_used(b.mass.size(), 0);
    for (std::size_t t = 0; t < b.tets.size(); ++t) {
        const double quarter = b.materials[b.material[t]].density_kg_m3 * six_volumes_of(b, b.tets[t]) / 24;
        for (const Index node : b.tets[t]) {
            mass[node] += quarter;
            is_used[node] = 1;
        }
    }
    for (Index node = 0; node < mass.size(); ++node) {
        const Vec3f place = b.rest_positions[node];
        if (!(std::fabs(b.mass[node] - mass[node]) <= float_tolerance * mass[node]) ||
            (is_used[node] && !(b.mass[node] > 0))) {
            complaints.add("BUNDLE_MASS", "a node's mass is not a quarter of that of its tets", node, place);
        }
        if (!is_used[node] && !b.locked[node]) {
            complaints.add("BUNDLE_NODE_UNUSED", "a free node belongs to no tet", node, place);
        }
    }
}

}
