// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay/sites.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <string>

#include "core/error.h"
#include "delaunay/hilbert.h"

namespace crumple::delaunay {
namespace {

// Six or seven facets a point and four corners a facet have to fit into 32 bits.
constexpr std::size_t most_points = std::size_t{1} << 27;

// Below this (largest coordinate 1) the products of facet_plane.h could underflow: see the proof there.
constexpr int lowest_exponent = -400;

// Exponents of the largest and smallest coordinate other than zero, and of the lowest bit set in any of them.
struct Exponents {
    int largest = -2000;
    int smallest = 2000;
    int lowest_bit = 2000;

    void add(double value) {
        constexpr int fraction_bits = 52;
        constexpr std::uint64_t fraction_mask = (std::uint64_t{1} << fraction_bits) - 1;
        const std::uint64_t bits = std::bit_cast<std::uint64_t>(value) & ~(std::uint64_t{1} << 63);
        if (bits == 0) return;
        const auto biased = static_cast<int>(bits >> fraction_bits);
        const std::uint64_t digits = (bits & fraction_mask) | (biased != 0 ? fraction_mask + 1 : 0);
        const int unit = std::max(biased, 1) - 1075;  // value = digits * 2^unit
        const int exponent = unit + static_cast<int>(std::bit_width(digits)) - 1;
        largest = std::max(largest, exponent);
        smallest = std::min(smallest, exponent);
        lowest_bit = std::min(lowest_bit, unit + std::countr_zero(digits));
    }
};

void refuse_bad_points(std::span<const Vec3> positions) {
    if (positions.size() > most_points) {
        throw Error(ErrorKind::bad_input,
                    "delaunay: " + std::to_string(positions.size()) + " points, at most 2^27 are possible");
    }
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const Vec3& p = positions[i];
        if (!is_finite(p)) {
            throw Error(ErrorKind::bad_input, "delaunay: point " + std::to_string(i) +
                                                  " has a coordinate that is not a finite number; remove or repair it");
        }
    }
}

void note_duplicate(Sites& sites, std::size_t point_count, Index point, Index first) {
    if (sites.duplicate_of.empty()) {
        sites.duplicate_of.resize(point_count);
        std::iota(sites.duplicate_of.begin(), sites.duplicate_of.end(), 0u);
    }
    sites.duplicate_of[point] = first;
}

}

Sites make_sites(std::span<const Vec3> positions) {
    refuse_bad_points(positions);
    Exponents exponents;
    for (const Vec3& p : positions) {
        for (int axis = 0; axis < 3; ++axis) exponents.add(p[axis]);
    }
    Sites sites;
    sites.exact_only = exponents.largest - exponents.smallest > -lowest_exponent;
    // Exact: no bit is lost, because no coordinate comes near the end of the range. Otherwise leave them alone.
    const int shift = sites.exact_only || exponents.largest < exponents.smallest ? 0 : -exponents.largest;
    const int grain_exponent = exponents.lowest_bit + shift;
    if (!sites.exact_only && grain_exponent > -200 && grain_exponent < 2) sites.grain = std::ldexp(1.0, grain_exponent);

    // In two steps, because 2^shift itself may be out of range.
    const double first_factor = std::ldexp(1.0, shift / 2);
    const double second_factor = std::ldexp(1.0, shift - shift / 2);

    const std::vector<Index> order = hilbert_order(positions);
    sites.at.reserve(positions.size() + 1);
    sites.source.reserve(positions.size());
    for (const Index point : order) {
        const Vec3& p = positions[point];
        if (!sites.source.empty() && positions[sites.source.back()] == p) {
            note_duplicate(sites, positions.size(), point, sites.source.back());
            continue;
        }
        const Vec3 scaled = p * first_factor * second_factor + Vec3{};  // + 0.0 turns -0.0 into 0.0
        sites.at.push_back({scaled.x, scaled.y, scaled.z, 0, 0});
        sites.source.push_back(point);
    }
    sites.at.push_back({0, 0, 0, 0, 0});
    return sites;
}

}
