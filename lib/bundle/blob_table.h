// SPDX-License-Identifier: MIT
// Finds arrays in a blob whose table was checked.
#pragma once
#include "bundle/blob.h"

namespace crumple {

// Null when the blob does not have it, or of another type.
[[nodiscard]] const BlobEntry* find_array(const Blob& blob, BlobArray array, std::uint32_t item, BlobType type,
                                          std::uint32_t columns) noexcept;

// Fills spans of the blob's bytes; remembers whether all were there.
struct BlobSpans {
    const Blob& blob;
    bool has_all = true;

    template <class T>
    void array(BlobArray array, std::uint32_t item, std::span<const T>& values) {
        const BlobEntry* entry = find_array(blob, array, item, BlobElement<T>::type, BlobElement<T>::columns);
        has_all = has_all && entry != nullptr;
        values = entry == nullptr ? std::span<const T>{} : span_of<T>(*entry);
    }

private:
    template <class T>
    [[nodiscard]] std::span<const T> span_of(const BlobEntry& entry) const {
        return {reinterpret_cast<const T*>(blob.bytes.data() + entry.offset), static_cast<std::size_t>(entry.rows)};
    }
};

// Names and provenance, in this order: regions, materials, visual meshes, sensors, tool version, recipe, name and
// version of each stage, name and digest of each input.
struct BlobTexts {
    std::uint64_t regions, materials, visuals, sensors, provenance, stages, inputs, end;
};
[[nodiscard]] BlobTexts texts_of(const BlobCounts& counts) noexcept;
[[nodiscard]] std::string_view text_at(const Blob& blob, std::uint64_t index) noexcept;

}
