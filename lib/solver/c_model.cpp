// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstring>
#include <exception>

#include "solver/blob_view.h"
#include "solver/c_handles.h"

namespace crumple::solver {
namespace {

void* heap_allocate(void*, std::size_t bytes, std::size_t alignment) {
    return ::operator new (bytes, std::align_val_t{alignment}, std::nothrow);
}

void heap_release(void*, void* memory, std::size_t) { ::operator delete (memory, std::align_val_t{Arena::alignment}); }

// Null, or why a step, skinning or a reading could go wrong.
const char* problem_of(const crumple_model& m, const BundleView& view) {
    if (const char* problem = first_problem(view)) return problem;
    for (std::uint32_t i = 0; i < m.blob.counts.visuals; ++i) {
        if (const char* problem = first_problem(view_of(m.blob, visual_of(m.blob, i)), view.rest_positions.size()))
            return problem;
    }
    for (std::uint32_t i = 0; i < m.blob.counts.sensors; ++i) {
        if (const char* problem = first_problem(view_of(sensor_of(m.blob, i)), view.rest_positions.size()))
            return problem;
    }
    return nullptr;
}

crumple_status fill_model(crumple_model& m, std::span<const std::byte> bytes, const char** problem) {
    *problem = open_blob(bytes, m.blob);
    if (*problem) return CRUMPLE_BAD_BLOB;
    if (!m.materials.allocate(m.allocator, m.blob.counts.materials)) return CRUMPLE_NO_MEMORY;
    const BundleView view = view_of(m.blob, m.materials.get());
    *problem = problem_of(m, view);
    if (*problem) return CRUMPLE_BAD_BLOB;
    if (!m.memory.allocate(m.allocator, model_bytes(view))) return CRUMPLE_NO_MEMORY;
    m.model = build_model(view, m.memory.get());
    return CRUMPLE_OK;
}

template <class NameOf>
std::uint32_t find_name(std::uint32_t count, const char* name, NameOf name_of) {
    for (std::uint32_t i = 0; name && i < count; ++i) {
        if (name_of(i) == name) return i;
    }
    return UINT32_MAX;
}

void copy_message(const char* text, char* message, std::size_t size) {
    if (message == nullptr || size == 0) return;
    const std::size_t length = std::min(size - 1, std::strlen(text));
    std::memcpy(message, text, length);
    message[length] = 0;
}

}

crumple_allocator allocator_or_heap(const crumple_allocator* allocator) {
    return allocator ? *allocator : crumple_allocator{heap_allocate, heap_release, nullptr};
}

// Functions of C linkage are the same in every namespace.
extern "C" {

uint32_t crumple_c_version(void) { return CRUMPLE_C_VERSION; }

crumple_status crumple_model_create(const void* blob, size_t size, const crumple_allocator* allocator,
                                    crumple_model** model, const char** problem) {
    const char* unread = nullptr;
    if (problem == nullptr) problem = &unread;
    *problem = nullptr;
    if (model == nullptr) return CRUMPLE_BAD_ARGUMENT;
    *model = nullptr;
    if (blob == nullptr) return CRUMPLE_BAD_ARGUMENT;
    auto* made = make_handle<crumple_model>(allocator_or_heap(allocator));
    if (made == nullptr) return CRUMPLE_NO_MEMORY;
    const crumple_status status = fill_model(*made, {static_cast<const std::byte*>(blob), size}, problem);
    if (status == CRUMPLE_OK)
        *model = made;
    else
        destroy_handle(made);
    return status;
}

void crumple_model_destroy(crumple_model* model) { destroy_handle(model); }

crumple_status crumple_check_blob(const void* blob, size_t size, char* message, size_t message_size) {
    copy_message("", message, message_size);
    if (blob == nullptr) return CRUMPLE_BAD_ARGUMENT;
    try {
        (void)read_blob({static_cast<const std::byte*>(blob), size}, "the blob");
        return CRUMPLE_OK;
    } catch (const std::bad_alloc&) {
        return CRUMPLE_NO_MEMORY;
    } catch (const std::exception& error) {
        copy_message(error.what(), message, message_size);
        return CRUMPLE_BAD_BLOB;
    }
}

crumple_info crumple_model_info(const crumple_model* model) {
    if (model == nullptr) return {};
    const Blob& b = model->blob;
    return {static_cast<uint32_t>(b.rest_positions.size()),
            static_cast<uint32_t>(b.tets.size()),
            b.counts.solver_tets,
            b.counts.visuals,
            b.counts.sensors,
            b.counts.materials};
}

const crumple_vec3f* crumple_rest_positions(const crumple_model* model) {
    return model ? reinterpret_cast<const crumple_vec3f*>(model->blob.rest_positions.data()) : nullptr;
}

const uint8_t* crumple_locked(const crumple_model* model) { return model ? model->blob.locked.data() : nullptr; }

uint32_t crumple_find_visual(const crumple_model* model, const char* name) {
    if (model == nullptr) return UINT32_MAX;
    return find_name(model->blob.counts.visuals, name, [&](uint32_t i) { return visual_of(model->blob, i).name; });
}

uint32_t crumple_find_sensor(const crumple_model* model, const char* name) {
    if (model == nullptr) return UINT32_MAX;
    return find_name(model->blob.counts.sensors, name, [&](uint32_t i) { return sensor_of(model->blob, i).name; });
}

const char* crumple_visual_name(const crumple_model* model, uint32_t visual) {
    if (model == nullptr || visual >= model->blob.counts.visuals) return nullptr;
    return visual_of(model->blob, visual).name.data();
}

const char* crumple_sensor_name(const crumple_model* model, uint32_t sensor) {
    if (model == nullptr || sensor >= model->blob.counts.sensors) return nullptr;
    return sensor_of(model->blob, sensor).name.data();
}

uint32_t crumple_visual_vertices(const crumple_model* model, uint32_t visual) {
    if (model == nullptr || visual >= model->blob.counts.visuals) return 0;
    return static_cast<uint32_t>(visual_of(model->blob, visual).tet.size());
}
}

}
