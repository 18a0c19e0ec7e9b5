// SPDX-License-Identifier: MIT
// The blob reader and the solver's own check against bytes from anywhere. The first byte chooses how the rest is used:
//   0: the rest is a blob
//   1: the rest is a blob that gets valid checksums
//   2, 3: the rest are edits (place, value) of the words of a good blob, with valid checksums
// What opens is read through all its indices; what the solver accepts is built and stepped.
#include <cstdint>
#include <cstdlib>
#include <cstring>

#include "bundle/aligned_bytes.h"
#include "bundle/forged_blob.h"
#include "bundle/small_bundle.h"
#include "core/error.h"
#include "solver/blob_view.h"
#include "solver/step.h"

namespace {

using namespace crumple;
using test::AlignedBytes;

AlignedBytes zeros(std::size_t size) { return AlignedBytes(std::vector<std::byte>(std::max<std::size_t>(size, 64))); }

void step_twice(const solver::BundleView& view) {
    const AlignedBytes model_memory = zeros(solver::model_bytes(view));
    const solver::Model model = solver::build_model(view, model_memory.get());
    const AlignedBytes state_memory = zeros(solver::state_bytes(model, solver::Plasticity::additive));
    const AlignedBytes work_memory = zeros(solver::workspace_bytes(model));
    solver::State state = solver::make_state(model, solver::Plasticity::additive, state_memory.get());
    solver::Workspace work = solver::make_workspace(model, work_memory.get());
    solver::StepInput input;
    input.gravity = {0, -9.81f, 0};
    for (int i = 0; i < 2; ++i) step(model, state, work, input);
    for (const float x : state.positions) {
        if (!(x - x == 0)) std::abort();
    }
}

// A blob that passes all checks holds what it was written from.
void check_round_trip(std::span<const std::byte> bytes) {
    try {
        const Bundle bundle = read_blob(bytes, "fuzz");
        const std::vector<std::byte> again = write_blob(bundle);
        if (write_blob(read_blob(again, "again")) != again) std::abort();
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::bad_input) throw;
    }
}

void check(std::span<const std::byte> bytes) {
    const AlignedBytes copy(bytes);
    Blob blob;
    if (open_blob(copy.get(), blob) != nullptr) return;
    (void)test::touch_all(blob);
    check_round_trip(copy.get());
    std::vector<Material> materials(blob.materials.size());
    const solver::BundleView view = solver::view_of(blob, materials);
    if (solver::first_problem(view) == nullptr) step_twice(view);
}

void check_sealed(std::vector<std::byte> bytes) {
    if (bytes.size() < sizeof(BlobHeader)) return;
    std::memcpy(bytes.data(), blob_magic.data(), blob_magic.size());
    test::write_checksums(bytes);
    check(bytes);
}

std::vector<std::byte> edited(std::span<const std::byte> edits) {
    static const std::vector<std::byte> good = write_blob(test::small_bundle());
    std::vector<std::byte> bytes = good;
    for (; edits.size() >= 6; edits = edits.subspan(6)) {
        std::uint16_t place = 0;
        std::memcpy(&place, edits.data(), 2);
        std::memcpy(bytes.data() + 4 * (place % (bytes.size() / 4)), edits.data() + 2, 4);
    }
    return bytes;
}

}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const auto rest = std::as_bytes(std::span(data + 1, size - 1));
    switch (data[0] % 4) {
        case 0:
            check(rest);
            break;
        case 1:
            check_sealed({rest.begin(), rest.end()});
            break;
        default:
            check_sealed(edited(rest));
            break;
    }
    return 0;
}
