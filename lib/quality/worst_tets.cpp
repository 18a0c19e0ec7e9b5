// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/worst_tets.h"

#include <algorithm>
#include <cstdio>
#include <numeric>

#include "quality/element_stiffness.h"
#include "quality/quality.h"

namespace crumple::quality {

Vec3 centre_of(std::span<const Vec3> positions, const Tet& tet) {
    return (positions[tet[0]] + positions[tet[1]] + positions[tet[2]] + positions[tet[3]]) * 0.25;
}

std::vector<Index> least_tets(std::span<const Vec3> positions, std::span<const Tet> tets,
                              std::span<const double> values, std::size_t count) {
    std::vector<Index> order(tets.size());
    std::iota(order.begin(), order.end(), Index{0});
    count = std::min(count, order.size());
    const auto comes_first = [&](Index a, Index b) {
        if (values[a] != values[b]) return values[a] < values[b];
        const Vec3 at_a = centre_of(positions, tets[a]);
        const Vec3 at_b = centre_of(positions, tets[b]);
        return at_a != at_b ? lexicographic_less(at_a, at_b) : a < b;
    };
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end(), comes_first);
    order.resize(count);
    return order;
}

namespace {

template <class Measure>
std::vector<Place> places_of_least(std::span<const Vec3> positions, std::span<const Tet> tets, std::size_t count,
                                   const Measure& measure, const char* format, double (*shown)(double)) {
    std::vector<double> values;
    values.reserve(tets.size());
    for (const auto& [a, b, c, d] : tets)
        values.push_back(measure(positions[a], positions[b], positions[c], positions[d]));
    std::vector<Place> places;
    for (const Index t : least_tets(positions, tets, values, count)) {
        char text[32];
        std::snprintf(text, sizeof text, format, shown(values[t]));
        places.push_back({centre_of(positions, tets[t]), t, text});
    }
    return places;
}

}

std::vector<Place> worst_tets(std::span<const Vec3> positions, std::span<const Tet> tets, std::size_t count) {
    return places_of_least(positions, tets, count, min_dihedral_key, "%.3g degrees", degrees_of);
}

std::vector<Place> stiffest_tets(std::span<const Vec3> positions, std::span<const Tet> tets, std::size_t count) {
    const auto step = [](Vec3 a, Vec3 b, Vec3 c, Vec3 d) { return measure_stiffness(a, b, c, d).step; };
    return places_of_least(positions, tets, count, step, "step %.3g m", [](double metres) { return metres; });
}

}
