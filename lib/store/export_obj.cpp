// SPDX-License-Identifier: MIT
#include "store/export_obj.h"

#include "store/boundary.h"
#include "store/text_file.h"

namespace crumple::store {

std::string export_obj(const Bundle& b) {
    const std::vector<Triangle> faces = boundary_faces(b);
    std::vector<std::uint8_t> is_on_boundary(b.rest_positions.size(), 0);
    for (const Triangle& face : faces) {
        for (const Index node : face) is_on_boundary[node] = 1;
    }
    TextFile out;
    out << "# boundary of a crumple bundle; metres; vertex colours: red 0 is locked\n";
    std::vector<std::size_t> number(b.rest_positions.size(), 0);
    std::size_t count = 0;
    for (std::size_t node = 0; node < b.rest_positions.size(); ++node) {
        if (!is_on_boundary[node] && !b.locked[node]) continue;
        number[node] = ++count;
        out << "v " << b.rest_positions[node] << (b.locked[node] ? " 0 0 1\n" : " 1 1 1\n");
    }
    for (const auto& [i, j, k] : faces) out << "f " << number[i] << ' ' << number[j] << ' ' << number[k] << '\n';
    for (std::size_t node = 0; node < b.rest_positions.size(); ++node) {
        if (!is_on_boundary[node] && b.locked[node]) out << "p " << number[node] << '\n';
    }
    return out.take();
}

}
