// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/fbx_values.h"

#include <zlib.h>

#include <cstring>
#include <string>

#include "formats/text.h"

namespace crumple::formats::fbx {

namespace {

// zlib makes no more than this of a byte [zlib technical details].
constexpr std::uint64_t most_expansion = 1032;

std::size_t size_of(char type) {
    switch (type) {
        case 'C':
        case 'B':
        case 'b':
        case 'c':
            return 1;
        case 'Y':
            return 2;
        case 'I':
        case 'F':
        case 'i':
        case 'f':
            return 4;
        case 'L':
        case 'D':
        case 'l':
        case 'd':
            return 8;
        default:
            return 0;
    }
}

template <class Number>
Number read(const char* bytes) {
    Number number;
    std::memcpy(&number, bytes, sizeof number);
    return number;
}

double number_at(const char* bytes, char type) {
    switch (type) {
        case 'Y':
            return read<std::int16_t>(bytes);
        case 'I':
        case 'i':
            return read<std::int32_t>(bytes);
        case 'L':
        case 'l':
            return static_cast<double>(read<std::int64_t>(bytes));
        case 'F':
        case 'f':
            return static_cast<double>(read<float>(bytes));
        case 'D':
        case 'd':
            return read<double>(bytes);
        default:
            return static_cast<unsigned char>(*bytes);
    }
}

std::optional<std::string_view> take(std::string_view& values, std::size_t size) {
    if (values.size() < size) return std::nullopt;
    const std::string_view taken = values.substr(0, size);
    values.remove_prefix(size);
    return taken;
}

std::optional<std::uint32_t> take_size(std::string_view& values) {
    const auto bytes = take(values, sizeof(std::uint32_t));
    return bytes ? std::optional(read<std::uint32_t>(bytes->data())) : std::nullopt;
}

std::optional<BinaryValue> next_array(char type, std::string_view& values) {
    const auto count = take_size(values);
    const auto encoding = take_size(values);
    const auto size = take_size(values);
    if (!count || !encoding || !size || *encoding > 1) return std::nullopt;
    const auto bytes = take(values, *size);
    if (!bytes) return std::nullopt;
    return BinaryValue{type, *bytes, *count, *encoding == 1};
}

std::optional<std::string> inflated(std::string_view bytes, std::uint64_t size) {
    if (size > most_expansion * bytes.size()) return std::nullopt;
    std::string result(size, '\0');
    uLongf written = size;
    const int status = uncompress(reinterpret_cast<Bytef*>(result.data()), &written,
                                  reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
    return status == Z_OK && written == size ? std::optional(std::move(result)) : std::nullopt;
}

}

std::optional<BinaryValue> next_value(std::string_view& values) {
    const auto type = take(values, 1);
    if (!type) return std::nullopt;
    const char kind = (*type)[0];
    if (kind == 'S' || kind == 'R') {
        const auto size = take_size(values);
        const auto bytes = size ? take(values, *size) : std::nullopt;
        return bytes ? std::optional(BinaryValue{kind, *bytes}) : std::nullopt;
    }
    if (size_of(kind) == 0) return std::nullopt;
    if (is_array({kind, {}})) return next_array(kind, values);
    const auto bytes = take(values, size_of(kind));
    return bytes ? std::optional(BinaryValue{kind, *bytes}) : std::nullopt;
}

bool is_array(const BinaryValue& value) {
    return std::string_view("fdilbc").find(value.type) != std::string_view::npos;
}

std::optional<double> number_in(const BinaryValue& value) {
    if (is_array(value) || size_of(value.type) == 0) return std::nullopt;
    return number_at(value.bytes.data(), value.type);
}

std::optional<std::vector<double>> numbers_in(const BinaryValue& value) {
    if (!is_array(value)) return std::nullopt;
    const std::size_t size = size_of(value.type);
    const std::uint64_t wanted = std::uint64_t{value.count} * size;
    std::string buffer;
    std::string_view bytes = value.bytes;
    if (value.is_compressed) {
        auto content = inflated(bytes, wanted);
        if (!content) return std::nullopt;
        buffer = std::move(*content);
        bytes = buffer;
    }
    if (bytes.size() != wanted) return std::nullopt;
    std::vector<double> numbers;
    numbers.reserve(value.count);
    for (std::size_t i = 0; i < value.count; ++i) numbers.push_back(number_at(bytes.data() + i * size, value.type));
    return numbers;
}

std::string_view next_word_of(std::string_view& values) {
    std::size_t begin = 0;
    while (begin < values.size() && is_space(values[begin])) ++begin;
    std::size_t end = begin;
    for (bool is_quoted = false; end < values.size() && (is_quoted || values[end] != ','); ++end)
        is_quoted = is_quoted != (values[end] == '"');
    std::string_view word = values.substr(begin, end - begin);
    values.remove_prefix(end < values.size() ? end + 1 : end);
    while (!word.empty() && is_space(word.back())) word.remove_suffix(1);
    return word;
}

}
