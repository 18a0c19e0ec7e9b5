// SPDX-License-Identifier: MIT
// Text that grows: numbers in the fewest digits that read back to the same value, whatever the locale.
#pragma once
#include <charconv>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "core/vec3.h"

namespace crumple::store {

class TextFile {
public:
    TextFile& operator<<(std::string_view text) {
        text_ += text;
        return *this;
    }
    TextFile& operator<<(const char* text) { return *this << std::string_view(text); }
    TextFile& operator<<(char c) {
        text_ += c;
        return *this;
    }
    template <class Number>
    requires std::is_arithmetic_v<Number> TextFile& operator<<(Number number) {
        char buffer[64];
        text_.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, number).ptr);
        return *this;
    }
    TextFile& operator<<(Vec3f p) { return *this << p.x << ' ' << p.y << ' ' << p.z; }

    [[nodiscard]] std::string take() { return std::move(text_); }

private:
    std::string text_;
};

}
