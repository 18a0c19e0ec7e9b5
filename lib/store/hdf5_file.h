// SPDX-License-Identifier: MIT
// Named arrays in an HDF5 file, in and out of memory. The only way to HDF5 in the project; its header stays in here.
// Files have the same bytes for the same calls: no times, no free space, no strings of variable length. Every dataset
// and attribute has a SHA-256 in /digest, the file as a whole is sealed (seal.h). FORMAT.md in lib/bundle is the
// contract. HDF5 is not thread-safe: use one FileWriter or FileReader at a time.
#pragma once
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <ranges>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/vec3.h"
#include "store/sha256.h"

namespace crumple::store {

enum class Layout {
    compressed,  // chunks of about a megabyte, shuffle, deflate 1, fletcher32
    contiguous,  // plain little-endian arrays on 64-byte boundaries, to be mapped into memory
};

enum class Type : std::uint8_t { u8, u16, u32, u64, i64, f32, f64, text };

// Rows first: {N} for a list, {N, K} for N rows of K.
using Shape = std::vector<std::uint64_t>;

// How a C++ element is stored: a list of it has shape {N} where columns is 0, else {N, columns}.
template <class T>
struct Element;
template <Type type_, std::uint64_t columns_ = 0>
struct ElementAs {
    static constexpr Type type = type_;
    static constexpr std::uint64_t columns = columns_;
};
template <>
struct Element<std::uint8_t> : ElementAs<Type::u8> {};
template <>
struct Element<std::uint16_t> : ElementAs<Type::u16> {};
template <>
struct Element<std::uint32_t> : ElementAs<Type::u32> {};
template <>
struct Element<std::uint64_t> : ElementAs<Type::u64> {};
template <>
struct Element<std::int64_t> : ElementAs<Type::i64> {};
template <>
struct Element<float> : ElementAs<Type::f32> {};
template <>
struct Element<double> : ElementAs<Type::f64> {};
template <class T>
struct Element<Vec3T<T>> : ElementAs<Element<T>::type, 3> {};
template <class T, std::size_t K>
struct Element<std::array<T, K>> : ElementAs<Element<T>::type, K> {};

template <class T>
concept Stored = requires {
    Element<T>::type;
};

template <class R>
concept StoredRange = std::ranges::contiguous_range<R> && Stored<std::ranges::range_value_t<R>>;

class FileWriter {
public:
    explicit FileWriter(Layout layout = Layout::compressed);
    ~FileWriter();
    FileWriter(const FileWriter&) = delete;
    FileWriter& operator=(const FileWriter&) = delete;

    // Paths are absolute, "/points/positions"; groups on the way are made. Writing a path twice is an Error(internal).
    template <StoredRange Range>
    void write(const std::string& path, const Range& rows) {
        using T = std::ranges::range_value_t<Range>;
        const std::uint64_t count = std::ranges::size(rows);
        const Shape shape = Element<T>::columns == 0 ? Shape{count} : Shape{count, Element<T>::columns};
        write_bytes(path, Element<T>::type, shape, std::as_bytes(std::span(std::ranges::data(rows), count)));
    }
    template <Stored T>
    void write_value(const std::string& path, const T& value) {
        write(path, std::span(&value, 1));
    }
    // Fixed-length UTF-8, padded with zeros to the longest. Throws Error(internal) for a text with a zero in it.
    void write_texts(const std::string& path, const std::vector<std::string>& texts);
    void write_text(const std::string& path, const std::string& text) { write_texts(path, {text}); }

    // A second name for a dataset written before.
    void link(const std::string& path, const std::string& existing);
    // REQUIRES: nothing was written at the path; makes an empty group.
    void make_group(const std::string& path);

    // Attributes of groups. Texts are fixed-length ASCII, as VTK wants them.
    void set_attribute(const std::string& group, const std::string& name, std::span<const std::int64_t> values);
    void set_attribute(const std::string& group, const std::string& name, const std::string& text);

    // The whole file: adds /digest, closes, seals. Nothing can be written after it.
    [[nodiscard]] std::vector<std::byte> finish();

private:
    void write_bytes(const std::string& path, Type type, const Shape& shape, std::span<const std::byte> bytes);

    struct State;
    std::unique_ptr<State> state_;
};

struct DatasetInfo {
    Type type = Type::u8;
    std::uint64_t element_size = 1;  // bytes: of a text, its padded length
    Shape shape;

    friend bool operator==(const DatasetInfo&, const DatasetInfo&) = default;
};

struct Dataset {
    DatasetInfo info;
    std::vector<std::byte> bytes;  // row-major, little-endian
};

// Everything it throws about the content is an Error(bad_input) "<name>: ...". Refuses what FileWriter never writes:
// links of other kinds than hard ones, types and filters not listed above, data outside the file, sizes the file cannot
// hold.
class FileReader {
public:
    // Takes a sealed image; checks the seal before HDF5 sees it. The name is for messages only.
    FileReader(std::vector<std::byte> image, std::string name);
    ~FileReader();
    FileReader(FileReader&&) noexcept;
    FileReader& operator=(FileReader&&) noexcept;

    [[nodiscard]] const std::string& name() const;
    [[nodiscard]] bool has(const std::string& path) const;                        // a dataset or a group
    [[nodiscard]] std::vector<std::string> list(const std::string& group) const;  // names in it, sorted
    [[nodiscard]] std::vector<std::string> all_datasets() const;                  // paths, sorted
    [[nodiscard]] std::vector<std::string> all_attributes() const;                // "<group path>@<name>", sorted

    [[nodiscard]] DatasetInfo info(const std::string& path) const;
    [[nodiscard]] Layout layout(const std::string& path) const;  // contiguous for a dataset of no elements
    [[nodiscard]] Dataset read_bytes(const std::string& path) const;
    template <Stored T>
    [[nodiscard]] std::vector<T> read(const std::string& path) const {
        const std::uint64_t rows = require_rows(path, Element<T>::type, Element<T>::columns);
        std::vector<T> values(rows);
        read_into(path, std::as_writable_bytes(std::span(values)));
        return values;
    }
    template <Stored T>
    [[nodiscard]] T read_value(const std::string& path) const {
        const std::vector<T> values = read<T>(path);
        if (values.size() != 1) refuse(path, "should hold one value");
        return values.front();
    }
    [[nodiscard]] std::vector<std::string> read_texts(const std::string& path) const;
    [[nodiscard]] std::string read_text(const std::string& path) const;
    [[nodiscard]] Dataset read_attribute(const std::string& group, const std::string& name) const;
    [[nodiscard]] std::vector<std::int64_t> read_numbers(const std::string& group, const std::string& name) const;

    [[noreturn]] void refuse(const std::string& path, const std::string& why) const;

private:
    [[nodiscard]] std::uint64_t require_rows(const std::string& path, Type type, std::uint64_t columns) const;
    void read_into(const std::string& path, std::span<std::byte> bytes) const;

    struct State;
    std::unique_ptr<State> state_;
};

[[nodiscard]] std::string_view name_of(Type type);  // "f32"
// SHA-256 of "f32 5x3\n" (type and shape; a text's type is "text" and its padded length: "text12") and the bytes.
[[nodiscard]] Digest digest_of(const DatasetInfo& info, std::span<const std::byte> bytes);

}
