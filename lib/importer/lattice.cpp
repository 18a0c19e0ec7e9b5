// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/lattice.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "geometry/predicates.h"
#include "mesh/neighbours.h"

namespace crumple::importer {

namespace {

using Step = std::array<std::int64_t, 3>;  // in half cells

// Rounded up to 5 binary digits, so that multiples of up to 2^19 are floats.
double round_up(double size) {
    int exponent = 0;
    const double fraction = std::frexp(size, &exponent);
    return std::ldexp(std::ceil(fraction * 32), exponent - 5);
}

// Nodes whose steps are all even or all odd, numbered by place.
class Nodes {
public:
    Nodes(Step low, Step high) : low_(low) {
        for (std::size_t axis = 0; axis < 3; ++axis) size_[axis] = high[axis] - low[axis] + 1;
        number_.assign(static_cast<std::size_t>(size_[0] * size_[1] * size_[2]), none);
    }
    Index& at(const Step& step) {
        return number_[static_cast<std::size_t>(((step[0] - low_[0]) * size_[1] + step[1] - low_[1]) * size_[2] +
                                                step[2] - low_[2])];
    }

private:
    Step low_;
    Step size_{};
    std::vector<Index> number_;
};

Step moved(Step step, std::size_t axis, std::int64_t by) {
    step[axis] += by;
    return step;
}

// Four tets around the line between the centres of two cubes side by side.
void add_tets(Nodes& nodes, const Step& centre, std::size_t axis, TetMesh& mesh) {
    const std::size_t u = (axis + 1) % 3;
    const std::size_t v = (axis + 2) % 3;
    const Step face = moved(centre, axis, 1);
    const std::array<Step, 4> corners{moved(moved(face, u, -1), v, -1), moved(moved(face, u, 1), v, -1),
                                      moved(moved(face, u, 1), v, 1), moved(moved(face, u, -1), v, 1)};
    for (std::size_t k = 0; k < 4; ++k) {
        Tet tet{nodes.at(centre), nodes.at(moved(centre, axis, 2)), nodes.at(corners[k]),
                nodes.at(corners[(k + 1) % 4])};
        const auto& p = mesh.positions;
        if (orient3d(p[tet[0]], p[tet[1]], p[tet[2]], p[tet[3]]) < 0) std::swap(tet[2], tet[3]);
        mesh.tets.push_back(tet);
    }
}

// Visits steps of one parity, x slowest.
template <class Visit>
void for_each_step(const Step& low, const Step& high, int parity, Visit&& visit) {
    for (std::int64_t x = low[0]; x <= high[0]; ++x) {
        for (std::int64_t y = low[1]; y <= high[1]; ++y) {
            for (std::int64_t z = low[2]; z <= high[2]; ++z) {
                const bool is_even = x % 2 == 0 && y % 2 == 0 && z % 2 == 0;
                const bool is_odd = x % 2 != 0 && y % 2 != 0 && z % 2 != 0;
                if ((parity == 0 && is_even) || (parity == 1 && is_odd)) visit(Step{x, y, z});
            }
        }
    }
}

}

Lattice make_lattice(const Box& box, std::uint32_t cells) {
    const Vec3 size = box.high - box.low;
    const double half = round_up(std::max({size.x, size.y, size.z}) / (2.0 * cells));
    // Cube corners are even. Two cubes more on each side: the outermost layer has no tets of its own.
    constexpr std::int64_t farthest = 1 << 19;
    Step low{};
    Step high{};
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        if (!(std::max(std::fabs(box.low[axis]), std::fabs(box.high[axis])) / half <
              static_cast<double>(farthest - 16))) {
            throw Error(ErrorKind::bad_input,
                        "import.cage: the shell lies too far from the origin for an exact lattice; move it there");
        }
        low[i] = 2 * static_cast<std::int64_t>(std::floor(box.low[axis] / (2 * half))) - 4;
        high[i] = 2 * static_cast<std::int64_t>(std::ceil(box.high[axis] / (2 * half))) + 4;
    }
    Lattice lattice;
    lattice.cell = 2 * half;
    Nodes nodes(low, high);
    for (const int parity : {0, 1}) {
        for_each_step(low, high, parity, [&](const Step& step) {
            nodes.at(step) = static_cast<Index>(lattice.mesh.positions.size());
            const auto place = [&](std::size_t axis) { return static_cast<double>(step[axis]) * half; };
            lattice.mesh.positions.push_back({place(0), place(1), place(2)});
        });
    }
    for_each_step(low, high, 1, [&](const Step& centre) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (centre[axis] + 2 < high[axis]) add_tets(nodes, centre, axis, lattice.mesh);
        }
    });
    lattice.mesh.neighbours = neighbours_of(lattice.mesh.tets);
    return lattice;
}

}
