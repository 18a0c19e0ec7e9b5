// SPDX-License-Identifier: MIT
// A bundle as one flat block of bytes, for games that ship no HDF5: map the file, open it, step it where it lies. The
// layout is in FORMAT_BLOB.md beside this file. N nodes, T tets, S of them simulated, E edges, B blocks, V vertices.
#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bundle/blob_format.h"
#include "bundle/bundle.h"

namespace crumple {

// The arrays of a bundle (see bundle.h) inside the blob's bytes, which the caller keeps. Copies nothing, owns nothing.
struct Blob {
    std::span<const std::byte> bytes;
    std::span<const BlobEntry> table;
    BlobCounts counts;

    std::span<const Vec3f> rest_positions;  // N
    std::span<const float> mass;            // N
    std::span<const std::uint8_t> locked;   // N
    std::span<const Index> node_to_mesh;    // N
    std::span<const Index> mesh_to_node;
    std::span<const Vec3f> locked_positions;
    std::span<const Tet> tets;                                  // T, the first S = counts.solver_tets are simulated
    std::span<const std::array<float, 9>> inverse_rest;         // T
    std::span<const float> volume;                              // T
    std::span<const float> stiffness_scale;                     // T
    std::span<const std::uint16_t> material;                    // T
    std::span<const Index> region;                              // T
    std::span<const Index> row_start;                           // N + 1
    std::span<const Index> column;                              // B
    std::span<const Index> diagonal;                            // N
    std::span<const std::array<Index, 16>> element_slots;       // S
    std::span<const Edge> edges;                                // E
    std::span<const std::array<Index, 2>> edge_slots;           // E
    std::span<const Index> edge_start;                          // E + 1
    std::span<const Index> edge_tet;                            // 6 S
    std::span<const std::array<std::uint8_t, 2>> edge_corners;  // 6 S

    std::span<const BlobMaterial> materials;   // counts.materials
    std::span<const BlobFrame> sensor_frames;  // counts.sensors
    std::span<const Index> text_start;
    std::span<const std::uint8_t> text;
};

struct BlobVisual {
    std::string_view name;
    std::span<const Index> tet;                         // V
    std::span<const std::array<float, 4>> barycentric;  // V
    std::span<const std::uint8_t> inside;               // V
    std::span<const float> distance;                    // V
    std::span<const Index> tet_start;                   // T + 1
    std::span<const Index> vertices_by_tet;             // V
};

struct BlobSensor {
    std::string_view name;
    std::span<const Index> node;    // K
    std::span<const float> weight;  // K
    Vec3f rest_origin;
    std::array<float, 9> rest_axes{};
};

// Fills `blob` and returns null, or says in a sentence what is wrong with the bytes. Afterwards every array is as long
// as bundle.h says, and visual meshes and sensors refer to tets and nodes that exist. Whether the solver can step it is
// solver::first_problem's to say, whether it is true is read_blob's. Takes no memory, throws nothing, reads only
// inside. REQUIRES: nothing of the bytes; their first on a 64-byte boundary, else that is what is wrong.
[[nodiscard]] const char* open_blob(std::span<const std::byte> bytes, Blob& blob) noexcept;

// REQUIRES of all: an opened blob, an index below the count. A view of a name ends at a zero byte.
[[nodiscard]] BlobVisual visual_of(const Blob& blob, std::uint32_t visual) noexcept;
[[nodiscard]] BlobSensor sensor_of(const Blob& blob, std::uint32_t sensor) noexcept;
[[nodiscard]] std::string_view region_name(const Blob& blob, std::uint32_t region) noexcept;
[[nodiscard]] std::string_view material_name(const Blob& blob, std::uint32_t material) noexcept;
// Its name is left empty, so it takes no memory.
[[nodiscard]] Material material_numbers(const Blob& blob, std::uint32_t material) noexcept;

// The same bundle in memory of its own; not yet validated. REQUIRES: an opened blob.
[[nodiscard]] Bundle to_bundle(const Blob& blob);

// Opens, copies and proves every invariant, as load_bundle does with a file: for tools, and for games that want to know
// once. The bytes need no alignment. Throws Error(bad_input) that begins with `name` and says the first complaint.
[[nodiscard]] Bundle read_blob(std::span<const std::byte> bytes, const std::string& name);

// True of bytes that begin as a blob does, whole or not.
[[nodiscard]] bool is_blob(std::span<const std::byte> bytes) noexcept;

// Same bundle, same bytes. REQUIRES: validate(bundle) is empty. Throws Error(bad_input) where names or provenance take
// 4 GiB.
[[nodiscard]] std::vector<std::byte> write_blob(const Bundle& bundle);

}
