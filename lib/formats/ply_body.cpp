// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/ply_body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "core/error.h"
#include "formats/printable.h"
#include "formats/text.h"

namespace crumple::formats::ply {

namespace {

[[noreturn]] void refuse(const std::string& what) { throw Error(ErrorKind::bad_input, what); }

bool fits(double value, Type type) {
    const bool is_signed = type.kind == Kind::signed_integer;
    const double end = std::ldexp(1.0, static_cast<int>(8 * type.size) - (is_signed ? 1 : 0));
    return value == std::floor(value) && value < end && value >= (is_signed ? -end : 0);
}

template <class T>
double as(const char* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return static_cast<double>(value);
}

double value_of(const char* bytes, Type type) {
    switch (type.kind) {
        case Kind::real:
            return type.size == 4 ? as<float>(bytes) : as<double>(bytes);
        case Kind::signed_integer:
            return type.size == 1   ? as<std::int8_t>(bytes)
                   : type.size == 2 ? as<std::int16_t>(bytes)
                                    : as<std::int32_t>(bytes);
        case Kind::unsigned_integer:
            break;
    }
    return type.size == 1   ? as<std::uint8_t>(bytes)
           : type.size == 2 ? as<std::uint16_t>(bytes)
                            : as<std::uint32_t>(bytes);
}

}

std::string place(const Element& element, std::uint64_t row) {
    return printable(element.name) + " " + std::to_string(row);
}

double Body::next(Type type, const Element& element, std::uint64_t row) {
    if (encoding_ == Encoding::ascii) return next_in_text(type, element, row);
    const std::string_view taken = take_bytes(type.size, element, row);
    std::array<char, 8> bytes{};
    if (encoding_ == Encoding::big)
        std::reverse_copy(taken.begin(), taken.end(), bytes.begin());
    else
        std::copy(taken.begin(), taken.end(), bytes.begin());
    return value_of(bytes.data(), type);
}

void Body::skip(Type type, const Element& element, std::uint64_t row) {
    if (encoding_ == Encoding::ascii)
        (void)take_word(element, row);
    else
        (void)take_bytes(type.size, element, row);
}

std::size_t Body::unread() const {
    std::string_view rest = left_;
    return next_word(rest).size() + rest.size();
}

std::string_view Body::take_word(const Element& element, std::uint64_t row) {
    const std::string_view word = next_word(left_);
    if (word.empty()) refuse("the file ends within " + place(element, row) + " of " + std::to_string(element.count));
    return word;
}

std::string_view Body::take_bytes(std::size_t size, const Element& element, std::uint64_t row) {
    if (left_.size() < size)
        refuse("the file ends within " + place(element, row) + " of " + std::to_string(element.count));
    const std::string_view bytes = left_.substr(0, size);
    left_.remove_prefix(size);
    return bytes;
}

double Body::next_in_text(Type type, const Element& element, std::uint64_t row) {
    const std::string_view word = take_word(element, row);
    const auto value = to_real(word);
    if (!value) refuse(line() + in_quotes(word) + " in " + place(element, row) + " is not a number");
    // Cut to fit, -1 would become 0, a lock.
    if (type.kind != Kind::real && !fits(*value, type))
        refuse(line() + in_quotes(word) + " in " + place(element, row) + " does not fit its type, a whole number of " +
               std::to_string(8 * type.size) + " bits; export colours from 0 to 255, or as float");
    return *value;
}

std::string Body::line() const {
    const std::string_view read = file_.substr(0, file_.size() - left_.size());
    return "line " + std::to_string(std::count(read.begin(), read.end(), '\n') + 1) + ": ";
}

}
