// SPDX-License-Identifier: MIT
#include "bundle/blob_table.h"

#include <algorithm>
#include <utility>

namespace crumple {

const BlobEntry* find_array(const Blob& blob, BlobArray array, std::uint32_t item, BlobType type,
                            std::uint32_t columns) noexcept {
    const auto key = std::pair(array, item);
    const auto entry =
        std::lower_bound(blob.table.begin(), blob.table.end(), key,
                         [](const BlobEntry& e, const auto& wanted) { return std::pair(e.array, e.item) < wanted; });
    if (entry == blob.table.end() || std::pair(entry->array, entry->item) != key) return nullptr;
    return entry->type == type && entry->columns == columns ? &*entry : nullptr;
}

BlobTexts texts_of(const BlobCounts& counts) noexcept {
    BlobTexts texts{};
    texts.materials = texts.regions + counts.regions;
    texts.visuals = texts.materials + counts.materials;
    texts.sensors = texts.visuals + counts.visuals;
    texts.provenance = texts.sensors + counts.sensors;
    texts.stages = texts.provenance + 2;
    texts.inputs = texts.stages + 2 * std::uint64_t{counts.stages};
    texts.end = texts.inputs + 2 * std::uint64_t{counts.inputs};
    return texts;
}

std::string_view text_at(const Blob& blob, std::uint64_t index) noexcept {
    const Index start = blob.text_start[static_cast<std::size_t>(index)];
    const Index end = blob.text_start[static_cast<std::size_t>(index) + 1] - 1;  // before the zero
    return {reinterpret_cast<const char*>(blob.text.data()) + start, end - start};
}

BlobVisual visual_of(const Blob& blob, std::uint32_t visual) noexcept {
    BlobVisual v;
    v.name = text_at(blob, texts_of(blob.counts).visuals + visual);
    BlobSpans spans{blob};
    visit_blob_visual(spans, visual, v);
    return v;
}

BlobSensor sensor_of(const Blob& blob, std::uint32_t sensor) noexcept {
    BlobSensor s;
    s.name = text_at(blob, texts_of(blob.counts).sensors + sensor);
    BlobSpans spans{blob};
    visit_blob_sensor(spans, sensor, s);
    const BlobFrame& frame = blob.sensor_frames[sensor];
    s.rest_origin = {frame[0], frame[1], frame[2]};
    std::copy(frame.begin() + 3, frame.end(), s.rest_axes.begin());
    return s;
}

std::string_view region_name(const Blob& blob, std::uint32_t region) noexcept {
    return text_at(blob, texts_of(blob.counts).regions + region);
}

std::string_view material_name(const Blob& blob, std::uint32_t material) noexcept {
    return text_at(blob, texts_of(blob.counts).materials + material);
}

namespace {

struct NumberReader {
    const BlobMaterial& row;
    std::size_t column = 0;

    void field(std::string_view, std::string&, std::string_view) {}
    void field(std::string_view, double& number, Range, std::string_view) { number = row[column++]; }
};

}

Material material_numbers(const Blob& blob, std::uint32_t material) noexcept {
    Material m;
    m.name.clear();
    NumberReader reader{blob.materials[material]};
    describe(reader, m);
    return m;
}

}
