// SPDX-License-Identifier: MIT
// The flat form of a bundle, said once for writing and reading. FORMAT_BLOB.md lists the same numbers with their
// meaning.
#pragma once
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "core/index.h"
#include "core/vec3.h"

namespace crumple {

static_assert(std::endian::native == std::endian::little, "a blob is used where it lies and is little-endian");

inline constexpr std::array<char, 8> blob_magic = {'C', 'R', 'U', 'M', 'B', 'L', 'O', 'B'};
inline constexpr std::uint32_t blob_major = 1;  // another one is refused
inline constexpr std::uint32_t blob_minor = 0;  // what a newer one adds is ignored
inline constexpr std::uint32_t blob_byte_order = 0x01020304;
inline constexpr std::size_t blob_alignment = 64;

struct BlobHeader {
    std::array<char, 8> magic;
    std::uint32_t major;
    std::uint32_t minor;
    std::uint32_t byte_order;
    std::uint32_t array_count;
    std::uint64_t size;       // of the whole blob, bytes
    std::uint64_t body_hash;  // hash64 of bytes [64, size)
    std::array<std::uint64_t, 2> zeros;
    std::uint64_t header_hash;  // hash64 of bytes [0, 56)
};
static_assert(sizeof(BlobHeader) == 64 && offsetof(BlobHeader, header_hash) == 56);

enum class BlobType : std::uint32_t { u8 = 1, u16 = 2, u32 = 3, f32 = 4, f64 = 5 };

// Which array; numbers are never used again for something else.
enum class BlobArray : std::uint32_t {
    counts = 1,
    text_start = 2,
    text = 3,
    materials = 4,
    sensor_frames = 5,
    rest_positions = 16,
    mass = 17,
    locked = 18,
    node_to_mesh = 19,
    mesh_to_node = 20,
    locked_positions = 21,
    tets = 32,
    inverse_rest = 33,
    volume = 34,
    stiffness_scale = 35,
    material = 36,
    region = 37,
    row_start = 48,
    column = 49,
    diagonal = 50,
    element_slots = 51,
    edges = 52,
    edge_slots = 53,
    edge_start = 54,
    edge_tet = 55,
    edge_corners = 56,
    visual_tet = 64,
    visual_barycentric = 65,
    visual_inside = 66,
    visual_distance = 67,
    visual_tet_start = 68,
    visual_vertices_by_tet = 69,
    sensor_node = 80,
    sensor_weight = 81,
};

// A row of the table behind the header: ascending by (array, item), as the arrays themselves lie.
struct BlobEntry {
    BlobArray array;
    std::uint32_t item;  // which visual mesh or sensor, else 0
    BlobType type;
    std::uint32_t columns;
    std::uint64_t offset;  // from the start of the blob, a multiple of 64
    std::uint64_t rows;
};
static_assert(sizeof(BlobEntry) == 32);

// The array `counts`.
struct BlobCounts {
    std::uint32_t solver_tets = 0;
    std::uint32_t regions = 0;
    std::uint32_t materials = 0;
    std::uint32_t visuals = 0;
    std::uint32_t sensors = 0;
    std::uint32_t stages = 0;
    std::uint32_t inputs = 0;
    std::uint32_t zero = 0;
};

// A row of `materials`: the numbers of material.h in the order they are described.
using BlobMaterial = std::array<double, 9>;

// A row of `sensor_frames`: rest_origin, then rest_axes.
using BlobFrame = std::array<float, 12>;

template <class T>
struct BlobElement;
template <BlobType code>
struct BlobScalar {
    static constexpr BlobType type = code;
    static constexpr std::uint32_t columns = 1;
};
template <>
struct BlobElement<std::uint8_t> : BlobScalar<BlobType::u8> {};
template <>
struct BlobElement<std::uint16_t> : BlobScalar<BlobType::u16> {};
template <>
struct BlobElement<std::uint32_t> : BlobScalar<BlobType::u32> {};
template <>
struct BlobElement<float> : BlobScalar<BlobType::f32> {};
template <>
struct BlobElement<double> : BlobScalar<BlobType::f64> {};
template <class T, std::size_t count>
struct BlobElement<std::array<T, count>> {
    static constexpr BlobType type = BlobElement<T>::type;
    static constexpr std::uint32_t columns = count;
};
template <>
struct BlobElement<Vec3f> : BlobElement<std::array<float, 3>> {};
template <>
struct BlobElement<BlobCounts> : BlobElement<std::array<std::uint32_t, 8>> {};

// Archive offers array(BlobArray, item, member).
template <class Archive, class B>
void visit_blob_mesh(Archive& archive, B& b) {
    archive.array(BlobArray::rest_positions, 0, b.rest_positions);
    archive.array(BlobArray::mass, 0, b.mass);
    archive.array(BlobArray::locked, 0, b.locked);
    archive.array(BlobArray::node_to_mesh, 0, b.node_to_mesh);
    archive.array(BlobArray::mesh_to_node, 0, b.mesh_to_node);
    archive.array(BlobArray::locked_positions, 0, b.locked_positions);
    archive.array(BlobArray::tets, 0, b.tets);
    archive.array(BlobArray::inverse_rest, 0, b.inverse_rest);
    archive.array(BlobArray::volume, 0, b.volume);
    archive.array(BlobArray::stiffness_scale, 0, b.stiffness_scale);
    archive.array(BlobArray::material, 0, b.material);
    archive.array(BlobArray::region, 0, b.region);
}

template <class Archive, class B>
void visit_blob_matrix(Archive& archive, B& b) {
    archive.array(BlobArray::row_start, 0, b.row_start);
    archive.array(BlobArray::column, 0, b.column);
    archive.array(BlobArray::diagonal, 0, b.diagonal);
    archive.array(BlobArray::element_slots, 0, b.element_slots);
    archive.array(BlobArray::edges, 0, b.edges);
    archive.array(BlobArray::edge_slots, 0, b.edge_slots);
    archive.array(BlobArray::edge_start, 0, b.edge_start);
    archive.array(BlobArray::edge_tet, 0, b.edge_tet);
    archive.array(BlobArray::edge_corners, 0, b.edge_corners);
}

template <class Archive, class Visual>
void visit_blob_visual(Archive& archive, std::uint32_t item, Visual& visual) {
    archive.array(BlobArray::visual_tet, item, visual.tet);
    archive.array(BlobArray::visual_barycentric, item, visual.barycentric);
    archive.array(BlobArray::visual_inside, item, visual.inside);
    archive.array(BlobArray::visual_distance, item, visual.distance);
    archive.array(BlobArray::visual_tet_start, item, visual.tet_start);
    archive.array(BlobArray::visual_vertices_by_tet, item, visual.vertices_by_tet);
}

template <class Archive, class Sensor>
void visit_blob_sensor(Archive& archive, std::uint32_t item, Sensor& sensor) {
    archive.array(BlobArray::sensor_node, item, sensor.node);
    archive.array(BlobArray::sensor_weight, item, sensor.weight);
}

}
