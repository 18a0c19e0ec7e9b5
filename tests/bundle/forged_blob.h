// SPDX-License-Identifier: MIT
// Blobs that lie but have right checksums, and a reader that touches all they offer.
#pragma once
#include <cstring>
#include <string>

#include "bundle/blob.h"
#include "bundle/hash64.h"

namespace crumple::test {

// REQUIRES: at least a header of bytes.
inline void write_checksums(std::span<std::byte> blob) {
    const auto put = [&](std::size_t offset, std::uint64_t value) {
        std::memcpy(blob.data() + offset, &value, sizeof value);
    };
    put(offsetof(BlobHeader, body_hash), hash64(blob.subspan(sizeof(BlobHeader))));
    const std::size_t hashed = offsetof(BlobHeader, header_hash);
    put(hashed, hash64(blob.first(hashed)));
}

// Reads every array of an opened blob the way a game would, through the indices it holds.
inline double touch_all(const Blob& blob) {
    double sum = 0;
    for (const Tet& tet : blob.tets) {
        for (const Index node : tet) sum += blob.rest_positions[node].x;
    }
    for (std::uint32_t i = 0; i < blob.counts.regions; ++i) sum += static_cast<double>(region_name(blob, i).size());
    for (std::uint32_t i = 0; i < blob.counts.materials; ++i) {
        sum += material_numbers(blob, i).young_pa + *(material_name(blob, i).end());
    }
    for (std::uint32_t i = 0; i < blob.counts.visuals; ++i) {
        const BlobVisual v = visual_of(blob, i);
        for (std::size_t t = 0; t < blob.tets.size(); ++t) {
            for (Index k = v.tet_start[t]; k < v.tet_start[t + 1]; ++k) {
                const Index vertex = v.vertices_by_tet[k];
                sum += v.barycentric[vertex][3] + blob.volume[v.tet[vertex]] + v.distance[vertex] + v.inside[vertex];
            }
        }
    }
    for (std::uint32_t i = 0; i < blob.counts.sensors; ++i) {
        const BlobSensor s = sensor_of(blob, i);
        for (std::size_t k = 0; k < s.node.size(); ++k) sum += s.weight[k] * blob.mass[s.node[k]];
    }
    return sum;
}

}
