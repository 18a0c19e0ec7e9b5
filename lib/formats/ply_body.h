// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers that follow the header of a PLY file, one by one, whichever way they are written.
#pragma once
#include <string>
#include <string_view>

#include "formats/ply_header.h"

namespace crumple::formats::ply {

class Body {
public:
    // Views into the whole file, and into what follows its header.
    Body(std::string_view file, std::string_view body, Encoding encoding)
        : file_(file), left_(body), encoding_(encoding) {}

    // Throws Error(bad_input) where the file ends, and in text for what is no number or does not fit the type.
    double next(Type type, const Element& element, std::uint64_t row);

    // The same for a number that nobody needs: in text it may be anything.
    void skip(Type type, const Element& element, std::uint64_t row);

    [[nodiscard]] std::size_t size_left() const { return left_.size(); }

    // Bytes from the first on that says something and that nobody asked for.
    [[nodiscard]] std::size_t unread() const;

private:
    std::string_view take_word(const Element& element, std::uint64_t row);
    std::string_view take_bytes(std::size_t size, const Element& element, std::uint64_t row);
    double next_in_text(Type type, const Element& element, std::uint64_t row);
    [[nodiscard]] std::string line() const;  // of the word just read

    std::string_view file_;
    std::string_view left_;
    Encoding encoding_;
};

// "vertex 7".
[[nodiscard]] std::string place(const Element& element, std::uint64_t row);

}
