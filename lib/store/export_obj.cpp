// SPDX-License-Identifier: MIT
#include "store/export_obj.h"

#include "store/boundary.h"
#include "store/text_file.h"

namespace crumple::store {

std::string export_surface_obj(std::span<const Vec3f> positions, std::span<const std::uint8_t> locked,
                               std::span<const Triangle> faces) {
    std::vector<std::uint8_t> is_on_boundary(positions.size(), 0);
    for (const Triangle& face : faces) {
        for (const Index node : face) is_on_boundary[node] = 1;
    }
    TextFile out;
    out << "# surface cooked by crumple; metres; vertex colours: red 0 is locked\n";
    std::vector<std::size_t> number(positions.size(), 0);
    std::size_t count = 0;
    for (std::size_t node = 0; node < positions.size(); ++node) {
        if (!is_on_boundary[node] && !locked[node]) continue;
        number[node] = ++count;
        out << "v " << positions[node] << (locked[node] ? " 0 0 1\n" : " 1 1 1\n");
    }
    for (const auto& [i, j, k] : faces) out << "f " << number[i] << ' ' << number[j] << ' ' << number[k] << '\n';
    for (std::size_t node = 0; node < positions.size(); ++node) {
        if (!is_on_boundary[node] && locked[node]) out << "p " << number[node] << '\n';
    }
    return out.take();
}

std::string export_obj(const Bundle& b) { return export_surface_obj(b.rest_positions, b.locked, boundary_faces(b)); }

}
