// SPDX-License-Identifier: MIT
// The arrays of a blob as a step takes them, where they lie.
#pragma once
#include "bundle/blob.h"
#include "solver/model.h"
#include "solver/sensor.h"
#include "solver/skin.h"

namespace crumple::solver {

// Fills `materials`, the only thing that is not used as it lies. REQUIRES: an opened blob, room for all its materials;
// both outlive the view. What the view says is not proved: ask first_problem before build_model. Takes no memory.
[[nodiscard]] BundleView view_of(const Blob& blob, std::span<Material> materials) noexcept;

// Skinning and sensors take these as they are: first_problem of either is for what open_blob does not look at.
[[nodiscard]] VisualView view_of(const Blob& blob, const BlobVisual& visual) noexcept;
[[nodiscard]] SensorView view_of(const BlobSensor& sensor) noexcept;

}
