// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstring>

#include "bundle/blob_table.h"
#include "bundle/hash64.h"

namespace crumple {
namespace {

std::uint64_t width_of(BlobType type) {
    switch (type) {
        case BlobType::u8:
            return 1;
        case BlobType::u16:
            return 2;
        case BlobType::u32:
        case BlobType::f32:
            return 4;
        case BlobType::f64:
            return 8;
    }
    return 0;
}

std::uint64_t aligned(std::uint64_t offset) { return (offset + blob_alignment - 1) / blob_alignment * blob_alignment; }

const char* header_problem(std::span<const std::byte> bytes, const BlobHeader& header) {
    if (header.byte_order != blob_byte_order) return "is not little-endian";
    if (header.major != blob_major) return "is of another major version: export the bundle with this one";
    const std::size_t hashed = offsetof(BlobHeader, header_hash);
    if (hash64(bytes.first(hashed)) != header.header_hash) return "is damaged: its header has another checksum";
    if (header.size != bytes.size()) return "is cut short or has something behind its end";
    if (header.array_count > (bytes.size() - sizeof(BlobHeader)) / sizeof(BlobEntry)) {
        return "has a longer table than bytes";
    }
    if (hash64(bytes.subspan(sizeof(BlobHeader))) != header.body_hash) return "is damaged: it has another checksum";
    return nullptr;
}

// Arrays lie in the table's order, each on the first boundary behind the one before: none overlap.
const char* table_problem(const Blob& blob) {
    std::uint64_t end = sizeof(BlobHeader) + blob.table.size_bytes();
    const BlobEntry* before = nullptr;
    for (const BlobEntry& entry : blob.table) {
        const std::uint64_t width = width_of(entry.type) * entry.columns;
        if (before && std::pair(before->array, before->item) >= std::pair(entry.array, entry.item)) {
            return "has a table that does not ascend";
        }
        if (width == 0 || entry.offset != aligned(end) || entry.offset > blob.bytes.size() ||
            entry.rows > (blob.bytes.size() - entry.offset) / width) {
            return "has an array that does not lie where it should";
        }
        end = entry.offset + entry.rows * width;
        before = &entry;
    }
    return aligned(end) == blob.bytes.size() ? nullptr : "has bytes behind its last array";
}

std::uint64_t known_arrays(const BlobCounts& counts) {
    constexpr std::uint64_t tables = 5;
    constexpr std::uint64_t mesh = 12;
    constexpr std::uint64_t matrix = 9;
    return tables + mesh + matrix + 6 * std::uint64_t{counts.visuals} + 2 * std::uint64_t{counts.sensors};
}

const char* fill_arrays(Blob& blob, std::uint32_t minor) {
    BlobSpans spans{blob};
    std::span<const BlobCounts> counts;
    spans.array(BlobArray::counts, 0, counts);
    if (counts.size() != 1) return "lacks its counts";
    blob.counts = counts[0];
    if (minor <= blob_minor && blob.table.size() != known_arrays(blob.counts)) return "has an array nobody knows";
    spans.array(BlobArray::text_start, 0, blob.text_start);
    spans.array(BlobArray::text, 0, blob.text);
    spans.array(BlobArray::materials, 0, blob.materials);
    spans.array(BlobArray::sensor_frames, 0, blob.sensor_frames);
    visit_blob_mesh(spans, blob);
    visit_blob_matrix(spans, blob);
    return spans.has_all ? nullptr : "lacks an array, or has it with other elements";
}

const char* text_problem(const Blob& blob) {
    const std::uint64_t count = texts_of(blob.counts).end;
    if (blob.text_start.size() != count + 1 || blob.text_start.front() != 0 ||
        blob.text_start.back() != blob.text.size()) {
        return "has another number of names than its counts say";
    }
    for (std::size_t i = 0; i < count; ++i) {
        const Index end = blob.text_start[i + 1];
        if (end <= blob.text_start[i] || end > blob.text.size() || blob.text[end - 1] != 0) {
            return "has a name without an end";
        }
    }
    return nullptr;
}

bool have_size(std::size_t size, std::initializer_list<std::size_t> sizes) {
    return std::all_of(sizes.begin(), sizes.end(), [&](std::size_t other) { return other == size; });
}

const char* size_problem(const Blob& b) {
    const std::size_t node_count = b.rest_positions.size();
    const std::size_t tet_count = b.tets.size();
    const std::size_t solver_tet_count = b.counts.solver_tets;
    if (node_count == 0 || tet_count == 0) return "has no tets";
    if (node_count >= none || tet_count >= none || solver_tet_count > tet_count)
        return "has more tets than indices allow";
    if (!have_size(node_count, {b.mass.size(), b.locked.size(), b.node_to_mesh.size(), b.diagonal.size()}) ||
        b.row_start.size() != node_count + 1) {
        return "has arrays over nodes that differ in length";
    }
    if (!have_size(tet_count, {b.inverse_rest.size(), b.volume.size(), b.stiffness_scale.size(), b.material.size(),
                               b.region.size()}) ||
        b.element_slots.size() != solver_tet_count ||
        !have_size(6 * solver_tet_count, {b.edge_tet.size(), b.edge_corners.size()})) {
        return "has arrays over tets that differ in length";
    }
    if (b.edge_slots.size() != b.edges.size() || b.edge_start.size() != b.edges.size() + 1) {
        return "has arrays over edges that differ in length";
    }
    if (b.materials.size() != b.counts.materials || b.sensor_frames.size() != b.counts.sensors) {
        return "has tables that differ from its counts";
    }
    return nullptr;
}

bool are_below(std::span<const Index> indices, std::size_t limit) {
    return std::all_of(indices.begin(), indices.end(), [&](Index i) { return i < limit; });
}

const char* tet_problem(const Blob& b) {
    for (const Tet& tet : b.tets) {
        if (!are_below(tet, b.rest_positions.size())) return "has a tet of nodes that are not there";
    }
    return nullptr;
}

const char* visual_problem(const Blob& b) {
    for (std::uint32_t i = 0; i < b.counts.visuals; ++i) {
        BlobVisual v;
        BlobSpans spans{b};
        visit_blob_visual(spans, i, v);
        const std::size_t vertex_count = v.tet.size();
        if (!spans.has_all || vertex_count >= none || v.tet_start.size() != b.tets.size() + 1 ||
            !have_size(vertex_count,
                       {v.barycentric.size(), v.inside.size(), v.distance.size(), v.vertices_by_tet.size()})) {
            return "has a visual mesh whose arrays differ in length";
        }
        const bool are_starts = v.tet_start.front() == 0 && v.tet_start.back() == vertex_count &&
                                std::is_sorted(v.tet_start.begin(), v.tet_start.end());
        if (!are_starts || !are_below(v.tet, b.tets.size()) || !are_below(v.vertices_by_tet, vertex_count)) {
            return "has a visual mesh bound to tets that are not there";
        }
    }
    return nullptr;
}

const char* sensor_problem(const Blob& b) {
    for (std::uint32_t i = 0; i < b.counts.sensors; ++i) {
        BlobSensor s;
        BlobSpans spans{b};
        visit_blob_sensor(spans, i, s);
        if (!spans.has_all || s.node.empty() || s.weight.size() != s.node.size() ||
            !are_below(s.node, b.rest_positions.size())) {
            return "has a sensor of nodes that are not there";
        }
    }
    return nullptr;
}

}

bool is_blob(std::span<const std::byte> bytes) noexcept {
    return bytes.size() >= blob_magic.size() && std::memcmp(bytes.data(), blob_magic.data(), blob_magic.size()) == 0;
}

const char* open_blob(std::span<const std::byte> bytes, Blob& blob) noexcept {
    blob = {};
    if (!is_blob(bytes)) return "is not a crumple blob";
    if (bytes.size() < sizeof(BlobHeader)) return "is cut short or has something behind its end";
    if (reinterpret_cast<std::uintptr_t>(bytes.data()) % blob_alignment != 0) return "lies off a 64-byte boundary";
    BlobHeader header;
    std::memcpy(&header, bytes.data(), sizeof header);
    if (const char* problem = header_problem(bytes, header)) return problem;
    blob.bytes = bytes;
    blob.table = {reinterpret_cast<const BlobEntry*>(bytes.data() + sizeof header), header.array_count};
    if (const char* problem = table_problem(blob)) return problem;
    if (const char* problem = fill_arrays(blob, header.minor)) return problem;
    for (const auto check : {text_problem, size_problem, tet_problem, visual_problem, sensor_problem}) {
        if (const char* problem = check(blob)) return problem;
    }
    return nullptr;
}

}
