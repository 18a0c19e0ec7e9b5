// SPDX-License-Identifier: MIT
#include <charconv>

#include "samples/write.h"

namespace crumple::samples {
namespace {

// The shortest text that reads back as the same float, whatever the locale.
void append_number(std::string& text, float value) {
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
    text += ' ';
    text.append(digits, end);
}

void append_vertex(std::string& text, const Part& part, std::size_t v) {
    text += 'v';
    for (int axis = 0; axis < 3; ++axis) append_number(text, static_cast<float>(part.positions[v][axis]));
    if (!part.colors.empty()) {
        for (int channel = 0; channel < 3; ++channel)
            append_number(text, static_cast<float>(part.colors[v][channel]) / 255.0f);
    }
    text += '\n';
}

}

std::string obj_bytes(const Model& model) {
    std::string text = "# written by crumple dev sample\n";
    std::size_t first = 1;  // OBJ counts from one, over the whole file
    for (const auto& part : model) {
        text += "o " + part.name + '\n';
        for (std::size_t v = 0; v < part.positions.size(); ++v) append_vertex(text, part, v);
        for (const auto& triangle : part.triangles) {
            text += 'f';
            for (const auto corner : triangle) text += ' ' + std::to_string(first + corner);
            text += '\n';
        }
        first += part.positions.size();
    }
    return text;
}

}
