// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstring>

#include "bundle/blob.h"
#include "bundle/hash64.h"
#include "core/error.h"

namespace crumple {
namespace {

struct ListedArray {
    BlobEntry entry;
    std::span<const std::byte> bytes;
};

struct ListArchive {
    std::vector<ListedArray> arrays = {};

    template <class T>
    void array(BlobArray array, std::uint32_t item, const std::vector<T>& values) {
        const BlobEntry entry{array, item, BlobElement<T>::type, BlobElement<T>::columns, 0, values.size()};
        arrays.push_back({entry, std::as_bytes(std::span(values))});
    }
};

struct NumberWriter {
    BlobMaterial row = {};
    std::size_t column = 0;

    void field(std::string_view, const std::string&, std::string_view) {}
    void field(std::string_view, const double& number, Range, std::string_view) { row[column++] = number; }
};

// Names and provenance in the order of BlobTexts, each with a zero behind it.
std::vector<std::string_view> list_texts(const Bundle& b) {
    std::vector<std::string_view> texts(b.regions.begin(), b.regions.end());
    for (const Material& material : b.materials) texts.push_back(material.name);
    for (const BundleVisual& visual : b.visuals) texts.push_back(visual.name);
    for (const BundleSensor& sensor : b.sensors) texts.push_back(sensor.name);
    texts.push_back(b.provenance.tool_version);
    texts.push_back(b.provenance.recipe);
    for (const auto* entries : {&b.provenance.stage_versions, &b.provenance.input_digests}) {
        for (const BundleProvenance::Entry& entry : *entries) {
            texts.push_back(entry.name);
            texts.push_back(entry.value);
        }
    }
    return texts;
}

// What is not an array of the bundle as it is.
struct Tables {
    std::vector<BlobCounts> counts;
    std::vector<Index> text_start = {0};
    std::vector<std::uint8_t> text;
    std::vector<BlobMaterial> materials;
    std::vector<BlobFrame> frames;
};

Tables make_tables(const Bundle& b) {
    const auto count = [](const auto& items) { return static_cast<std::uint32_t>(items.size()); };
    Tables tables;
    tables.counts.push_back({b.solver_tet_count, count(b.regions), count(b.materials), count(b.visuals),
                             count(b.sensors), count(b.provenance.stage_versions), count(b.provenance.input_digests)});
    for (const std::string_view text : list_texts(b)) {
        tables.text.insert(tables.text.end(), text.begin(), text.end());
        tables.text.push_back(0);
        if (tables.text.size() >= none)
            throw Error(ErrorKind::bad_input, "the bundle's names and provenance take 4 GiB");
        tables.text_start.push_back(static_cast<Index>(tables.text.size()));
    }
    for (const Material& material : b.materials) {
        NumberWriter writer;
        describe(writer, material);
        tables.materials.push_back(writer.row);
    }
    for (const BundleSensor& s : b.sensors) {
        BlobFrame frame{s.rest_origin.x, s.rest_origin.y, s.rest_origin.z};
        std::copy(s.rest_axes.begin(), s.rest_axes.end(), frame.begin() + 3);
        tables.frames.push_back(frame);
    }
    return tables;
}

std::vector<ListedArray> list_arrays(const Bundle& b, const Tables& tables) {
    ListArchive archive;
    archive.array(BlobArray::counts, 0, tables.counts);
    archive.array(BlobArray::text_start, 0, tables.text_start);
    archive.array(BlobArray::text, 0, tables.text);
    archive.array(BlobArray::materials, 0, tables.materials);
    archive.array(BlobArray::sensor_frames, 0, tables.frames);
    visit_blob_mesh(archive, b);
    visit_blob_matrix(archive, b);
    for (std::uint32_t i = 0; i < b.visuals.size(); ++i) visit_blob_visual(archive, i, b.visuals[i]);
    for (std::uint32_t i = 0; i < b.sensors.size(); ++i) visit_blob_sensor(archive, i, b.sensors[i]);
    std::sort(archive.arrays.begin(), archive.arrays.end(), [](const ListedArray& x, const ListedArray& y) {
        return std::pair(x.entry.array, x.entry.item) < std::pair(y.entry.array, y.entry.item);
    });
    return std::move(archive.arrays);
}

std::uint64_t aligned(std::uint64_t offset) { return (offset + blob_alignment - 1) / blob_alignment * blob_alignment; }

// Gives every array its place; returns the size of the whole.
std::uint64_t place_arrays(std::vector<ListedArray>& arrays) {
    std::uint64_t end = sizeof(BlobHeader) + arrays.size() * sizeof(BlobEntry);
    for (ListedArray& array : arrays) {
        array.entry.offset = aligned(end);
        end = array.entry.offset + array.bytes.size();
    }
    return aligned(end);
}

void write_header(std::span<std::byte> blob, std::size_t array_count) {
    BlobHeader header{blob_magic,
                      blob_major,
                      blob_minor,
                      blob_byte_order,
                      static_cast<std::uint32_t>(array_count),
                      blob.size(),
                      hash64(blob.subspan(sizeof(BlobHeader))),
                      {},
                      0};
    const auto bytes = std::as_bytes(std::span(&header, 1));
    header.header_hash = hash64(bytes.first(offsetof(BlobHeader, header_hash)));
    std::memcpy(blob.data(), bytes.data(), bytes.size());
}

}

std::vector<std::byte> write_blob(const Bundle& bundle) {
    const Tables tables = make_tables(bundle);
    std::vector<ListedArray> arrays = list_arrays(bundle, tables);
    std::vector<std::byte> blob(place_arrays(arrays));
    for (std::size_t i = 0; i < arrays.size(); ++i) {
        const BlobEntry& entry = arrays[i].entry;
        std::memcpy(blob.data() + sizeof(BlobHeader) + i * sizeof entry, &entry, sizeof entry);
        std::copy(arrays[i].bytes.begin(), arrays[i].bytes.end(),
                  blob.begin() + static_cast<std::ptrdiff_t>(entry.offset));
    }
    write_header(blob, arrays.size());
    return blob;
}

}
