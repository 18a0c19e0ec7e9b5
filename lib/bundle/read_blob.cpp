// SPDX-License-Identifier: MIT
#include <algorithm>
#include <memory>
#include <new>

#include "bundle/blob_table.h"
#include "bundle/validate.h"
#include "core/error.h"

namespace crumple {
namespace {

// Copies arrays out of the blob. Those of a newer minor version that are not listed are left behind.
struct CopyArchive {
    const Blob& blob;

    template <class T>
    void array(BlobArray array, std::uint32_t item, std::vector<T>& values) {
        std::span<const T> span;
        BlobSpans{blob}.array(array, item, span);
        values.assign(span.begin(), span.end());
    }
};

void copy_provenance(const Blob& blob, BundleProvenance& provenance) {
    const BlobTexts texts = texts_of(blob.counts);
    const auto text = [&](std::uint64_t index) { return std::string(text_at(blob, index)); };
    provenance.tool_version = text(texts.provenance);
    provenance.recipe = text(texts.provenance + 1);
    for (std::uint64_t i = texts.stages; i < texts.inputs; i += 2) {
        provenance.stage_versions.push_back({text(i), text(i + 1)});
    }
    for (std::uint64_t i = texts.inputs; i < texts.end; i += 2) {
        provenance.input_digests.push_back({text(i), text(i + 1)});
    }
}

struct AlignedDelete {
    void operator()(std::byte* bytes) const { ::operator delete[](bytes, std::align_val_t{blob_alignment}); }
};

std::unique_ptr<std::byte[], AlignedDelete> aligned_copy(std::span<const std::byte> bytes) {
    void* memory = ::operator new[](std::max<std::size_t>(bytes.size(), 1), std::align_val_t{blob_alignment});
    std::unique_ptr<std::byte[], AlignedDelete> copy(static_cast<std::byte*>(memory));
    std::copy(bytes.begin(), bytes.end(), copy.get());
    return copy;
}

Bundle read_aligned(std::span<const std::byte> bytes, const std::string& name) {
    Blob blob;
    if (const char* problem = open_blob(bytes, blob)) throw Error(ErrorKind::bad_input, name + " " + problem);
    Bundle bundle = to_bundle(blob);
    const std::vector<Finding> wrong = validate(bundle);
    if (!wrong.empty()) {
        throw Error(ErrorKind::bad_input,
                    name + ": " + wrong.front().code + ": " + wrong.front().message + "; cook and export it again");
    }
    return bundle;
}

}

Bundle to_bundle(const Blob& blob) {
    Bundle bundle;
    CopyArchive archive{blob};
    bundle.solver_tet_count = blob.counts.solver_tets;
    visit_blob_mesh(archive, bundle);
    visit_blob_matrix(archive, bundle);
    for (std::uint32_t i = 0; i < blob.counts.regions; ++i) bundle.regions.emplace_back(region_name(blob, i));
    for (std::uint32_t i = 0; i < blob.counts.materials; ++i) {
        bundle.materials.push_back(material_numbers(blob, i));
        bundle.materials.back().name = material_name(blob, i);
    }
    for (std::uint32_t i = 0; i < blob.counts.visuals; ++i) {
        bundle.visuals.emplace_back().name = visual_of(blob, i).name;
        visit_blob_visual(archive, i, bundle.visuals.back());
    }
    for (std::uint32_t i = 0; i < blob.counts.sensors; ++i) {
        const BlobSensor s = sensor_of(blob, i);
        bundle.sensors.push_back({std::string(s.name), {}, {}, s.rest_origin, s.rest_axes});
        visit_blob_sensor(archive, i, bundle.sensors.back());
    }
    copy_provenance(blob, bundle.provenance);
    return bundle;
}

Bundle read_blob(std::span<const std::byte> bytes, const std::string& name) {
    if (reinterpret_cast<std::uintptr_t>(bytes.data()) % blob_alignment == 0) return read_aligned(bytes, name);
    const auto copy = aligned_copy(bytes);
    return read_aligned({copy.get(), bytes.size()}, name);
}

}
