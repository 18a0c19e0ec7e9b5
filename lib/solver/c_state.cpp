// SPDX-License-Identifier: MIT
// Saved states: the bytes of the state and, behind them, what tells whether they are whole and whose they are.
#include <cstring>

#include "bundle/hash64.h"
#include "solver/c_handles.h"
#include "solver/check_state.h"

namespace crumple::solver {
namespace {

constexpr std::uint32_t saved_state_version = 1;

// Behind the state, wherever that ends.
struct SavedTail {
    std::uint32_t version = saved_state_version;
    std::uint32_t plasticity = 0;  // which arrays there are
    std::uint64_t blob_hash = 0;   // body_hash of the blob
    std::uint64_t hash = 0;        // hash64 of all before it

    bool operator==(const SavedTail&) const = default;
};
static_assert(sizeof(SavedTail) == 24 && offsetof(SavedTail, hash) == 16);

SavedTail tail_of(const crumple_instance& instance) {
    SavedTail tail;
    tail.plasticity = static_cast<std::uint32_t>(instance.settings.plasticity);
    BlobHeader header;
    std::memcpy(&header, instance.model->blob.bytes.data(), sizeof header);
    tail.blob_hash = header.body_hash;
    return tail;
}

std::uint64_t hash_of_saved(const void* bytes, std::size_t size) {
    return hash64({static_cast<const std::byte*>(bytes), size - sizeof(SavedTail::hash)});
}

// Whether the bytes are what crumple_save gave for an instance like this.
bool is_saved_state(const crumple_instance& instance, const void* bytes, std::size_t size) {
    SavedTail tail;
    std::memcpy(&tail, static_cast<const std::byte*>(bytes) + (size - sizeof tail), sizeof tail);
    SavedTail expected = tail_of(instance);
    expected.hash = hash_of_saved(bytes, size);
    return tail == expected;
}

}

extern "C" {

size_t crumple_state_size(const crumple_instance* instance) {
    return instance ? instance->memory.get().size() + sizeof(SavedTail) : 0;
}

crumple_status crumple_save(const crumple_instance* instance, void* bytes, size_t size) {
    if (instance == nullptr || bytes == nullptr || size != crumple_state_size(instance)) return CRUMPLE_BAD_ARGUMENT;
    const std::span<const std::byte> state = instance->memory.get();
    std::byte* tail_bytes = static_cast<std::byte*>(bytes) + state.size();
    SavedTail tail = tail_of(*instance);
    std::memcpy(bytes, state.data(), state.size());
    std::memcpy(tail_bytes, &tail, sizeof tail);
    tail.hash = hash_of_saved(bytes, size);
    std::memcpy(tail_bytes, &tail, sizeof tail);
    return CRUMPLE_OK;
}

crumple_status crumple_restore(crumple_instance* instance, const void* bytes, size_t size) {
    if (instance == nullptr || bytes == nullptr || size != crumple_state_size(instance) ||
        !is_saved_state(*instance, bytes, size)) {
        return CRUMPLE_BAD_ARGUMENT;
    }
    const std::span<std::byte> state = instance->memory.get();
    const Model& model = instance->model->model;
    std::memcpy(state.data(), bytes, state.size());
    if (first_problem(model, instance->state) == nullptr) return CRUMPLE_OK;
    // A checksum is no protection against malice.
    instance->state = make_state(model, instance->settings.plasticity, state);
    return CRUMPLE_BAD_ARGUMENT;
}
}

}
