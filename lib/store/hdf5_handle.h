// SPDX-License-Identifier: MIT
// The thin layer over HDF5's C interface: identifiers that close themselves and errors that throw. Only for hdf5_*.cpp.
#pragma once
#include <hdf5.h>

#include <string>
#include <utility>

#include "store/hdf5_file.h"

namespace crumple::store {

// HDF5's own words for what went wrong last in this thread.
[[nodiscard]] std::string last_hdf5_error();

// Silences HDF5's printing of errors and forbids it to load filter plugins. Cheap; call before first use.
void prepare_hdf5();

class Handle {
public:
    Handle() = default;
    Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
    ~Handle() { reset(); }
    Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(id_, other.id_);
        std::swap(close_, other.close_);
        return *this;
    }

    [[nodiscard]] hid_t id() const { return id_; }
    [[nodiscard]] bool is_open() const { return id_ >= 0; }
    void reset() {
        if (id_ >= 0) close_(std::exchange(id_, H5I_INVALID_HID));
    }

private:
    hid_t id_ = H5I_INVALID_HID;
    herr_t (*close_)(hid_t) = nullptr;
};

// The type in the file (little-endian), owned by HDF5. REQUIRES: not Type::text.
[[nodiscard]] hid_t file_type(Type type);
// A fixed-length string type.
[[nodiscard]] Handle text_type(std::size_t size, H5T_cset_t encoding);
// Elements of a shape; throws std::overflow_error when they do not fit in 64 bits.
[[nodiscard]] std::uint64_t element_count(const Shape& shape);
[[nodiscard]] std::size_t size_of(Type type);  // bytes; 1 for text

// Pseudo-path of an attribute in /digest: "<group>@<name>".
[[nodiscard]] inline std::string attribute_path(const std::string& group, const std::string& name) {
    return group + "@" + name;
}

inline constexpr char digest_group[] = "/digest";

}
