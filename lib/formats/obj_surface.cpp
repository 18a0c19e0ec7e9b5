// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/obj_surface.h"

#include <array>
#include <charconv>
#include <utility>

#include "formats/assimp_number.h"
#include "formats/text.h"

namespace crumple::formats::obj {

AsRead SurfaceWriter::add_vertex(Vec3f position, const std::optional<Vec3f>& color) {
    AsRead read;
    text_ += 'v';
    for (int axis = 0; axis < 3; ++axis) read.position[axis] = append(position[axis]);
    if (color) {
        read.red = append(color->x);
        append(color->y);
        append(color->z);
    }
    text_ += '\n';
    return read;
}

void SurfaceWriter::add_face(std::span<const std::uint64_t> corners) {
    text_ += 'f';
    for (const std::uint64_t corner : corners) (text_ += ' ') += std::to_string(corner + 1);
    text_ += '\n';
}

void SurfaceWriter::add_statement(std::string_view keyword, std::string_view rest) {
    while (!rest.empty() && is_space(rest.front())) rest.remove_prefix(1);
    ((text_.append(keyword) += ' ').append(rest)) += '\n';
}

std::string SurfaceWriter::take() { return std::move(text_); }

// The fewest digits that say the same float. Returns what assimp's parser makes of them.
float SurfaceWriter::append(float value) {
    std::array<char, 32> digits{};
    const char* end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    const std::string_view word(digits.data(), static_cast<std::size_t>(end - digits.data()));
    (text_ += ' ').append(word);
    return as_assimp_reads(word).value_or(value);
}

}
