// SPDX-License-Identifier: MIT
#include "store/hdf5_image.h"

#include <atomic>
#include <cstring>
#include <new>

#include "core/error.h"

namespace crumple::store {
namespace {

using Bytes = std::vector<std::byte>;

// The file's size stays exact; the vector grows by factors on its own.
constexpr std::size_t growth = 1;

// HDF5 asks for memory several times over on the way to opening a file: it gets the same vector each time.
void* take(std::size_t size, H5FD_file_image_op_t, void* user) {
    auto& bytes = *static_cast<Bytes*>(user);
    try {
        if (bytes.size() < size) bytes.resize(size);
    } catch (const std::bad_alloc&) {
        return nullptr;
    }
    return bytes.data();
}

void* copy(void* to, const void* from, std::size_t size, H5FD_file_image_op_t, void*) {
    return to == from ? to : std::memcpy(to, from, size);
}

// New memory is zero, so that bytes HDF5 never writes are the same in every run.
void* grow(void*, std::size_t size, H5FD_file_image_op_t operation, void* user) { return take(size, operation, user); }

herr_t release(void*, H5FD_file_image_op_t, void*) { return 0; }
void* share(void* user) { return user; }
herr_t forget(void*) { return 0; }

}

void use_image(hid_t access, Bytes& bytes) {
    H5FD_file_image_callbacks_t callbacks{take, copy, grow, release, share, forget, &bytes};
    bool ok = H5Pset_fapl_core(access, growth, 0) >= 0 && H5Pset_file_image_callbacks(access, &callbacks) >= 0;
    if (!bytes.empty()) ok = ok && H5Pset_file_image(access, bytes.data(), bytes.size()) >= 0;
    CRUMPLE_CHECK(ok, last_hdf5_error());
}

std::string unique_file_name() {
    static std::atomic<unsigned long> count = 0;
    return "memory-" + std::to_string(++count);
}

}
