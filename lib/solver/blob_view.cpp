// SPDX-License-Identifier: MIT
#include "solver/blob_view.h"

namespace crumple::solver {

BundleView view_of(const Blob& b, std::span<Material> materials) noexcept {
    const std::size_t tet_count = b.counts.solver_tets;
    for (std::uint32_t i = 0; i < b.counts.materials; ++i) materials[i] = material_numbers(b, i);
    return {b.rest_positions,
            b.mass,
            b.locked,
            b.tets.first(tet_count),
            b.inverse_rest.first(tet_count),
            b.volume.first(tet_count),
            b.stiffness_scale.first(tet_count),
            b.material.first(tet_count),
            materials.first(b.counts.materials),
            b.row_start,
            b.column,
            b.diagonal,
            b.edges,
            b.edge_slots,
            b.edge_start,
            b.edge_tet,
            b.edge_corners};
}

VisualView view_of(const Blob& blob, const BlobVisual& visual) noexcept {
    return {blob.tets, visual.tet, visual.barycentric};
}

SensorView view_of(const BlobSensor& sensor) noexcept {
    return {sensor.node, sensor.weight, sensor.rest_origin, sensor.rest_axes};
}

}
