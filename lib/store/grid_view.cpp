// SPDX-License-Identifier: MIT
#include "store/grid_view.h"

namespace crumple::store {
namespace {

void write_head(FileWriter& file, const GridCells& cells, std::size_t point_count) {
    const auto write_count = [&](const char* path, std::size_t count) {
        file.write_value(path, static_cast<std::int64_t>(count));
    };
    file.set_attribute("/VTKHDF", "Version", grid_version);
    file.set_attribute("/VTKHDF", "Type", std::string(grid_type));
    write_count("/VTKHDF/NumberOfPoints", point_count);
    write_count("/VTKHDF/NumberOfCells", cells.types.size());
    write_count("/VTKHDF/NumberOfConnectivityIds", cells.connectivity.size());
}

void write_cells(FileWriter& file, const GridCells& cells) {
    file.write("/VTKHDF/Connectivity", cells.connectivity);
    file.write("/VTKHDF/Offsets", cells.offsets);
    file.write("/VTKHDF/Types", cells.types);
}

}

void write_grid(FileWriter& file, const GridCells& cells, std::span<const Vec3f> points) {
    write_head(file, cells, points.size());
    file.write("/VTKHDF/Points", points);
    write_cells(file, cells);
}

void write_grid(FileWriter& file, const GridCells& cells, const std::string& points, std::size_t point_count) {
    write_head(file, cells, point_count);
    file.link("/VTKHDF/Points", points);
    write_cells(file, cells);
}

}
