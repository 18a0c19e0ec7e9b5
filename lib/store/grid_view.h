// SPDX-License-Identifier: MIT
// The group /VTKHDF of a file, which ParaView opens: an unstructured grid with cells of one kind, as VTKHDF 1.0 says
// and VTK 9.1 reads it.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/index.h"
#include "core/vec3.h"
#include "store/hdf5_file.h"

namespace crumple::store {

inline constexpr std::array<std::int64_t, 2> grid_version{1, 0};
inline constexpr const char* grid_type = "UnstructuredGrid";

// C cells.
struct GridCells {
    std::vector<std::int64_t> connectivity;  // the points of one after the other
    std::vector<std::int64_t> offsets;       // C + 1: where each begins there
    std::vector<std::uint8_t> types;         // C: VTK's number of the kind
};

template <std::size_t corners>
[[nodiscard]] GridCells grid_cells(const std::vector<std::array<Index, corners>>& cells) {
    static_assert(corners == 1 || corners == 3 || corners == 4, "a point, a triangle or a tet");
    constexpr std::uint8_t type = corners == 1 ? 1 : corners == 3 ? 5 : 10;
    GridCells grid;
    grid.connectivity.reserve(corners * cells.size());
    grid.offsets.assign(1, 0);
    for (const auto& cell : cells) {
        grid.connectivity.insert(grid.connectivity.end(), cell.begin(), cell.end());
        grid.offsets.push_back(static_cast<std::int64_t>(grid.connectivity.size()));
    }
    grid.types.assign(cells.size(), type);
    return grid;
}

// With points of its own, or those of a dataset that was written before.
void write_grid(FileWriter& file, const GridCells& cells, std::span<const Vec3f> points);
void write_grid(FileWriter& file, const GridCells& cells, const std::string& points, std::size_t point_count);

}
