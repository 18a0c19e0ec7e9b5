// SPDX-License-Identifier: MIT
#include <new>
#include <stdexcept>

#include "core/error.h"
#include "store/hdf5_handle.h"

namespace crumple::store {

std::string_view name_of(Type type) {
    switch (type) {
        case Type::u8:
            return "u8";
        case Type::u16:
            return "u16";
        case Type::u32:
            return "u32";
        case Type::u64:
            return "u64";
        case Type::i64:
            return "i64";
        case Type::f32:
            return "f32";
        case Type::f64:
            return "f64";
        case Type::text:
            return "text";
    }
    return "?";
}

std::size_t size_of(Type type) {
    switch (type) {
        case Type::u16:
            return 2;
        case Type::u32:
        case Type::f32:
            return 4;
        case Type::u64:
        case Type::i64:
        case Type::f64:
            return 8;
        default:
            return 1;
    }
}

Digest digest_of(const DatasetInfo& info, std::span<const std::byte> bytes) {
    std::string header(name_of(info.type));
    if (info.type == Type::text) header += std::to_string(info.element_size);
    for (std::size_t axis = 0; axis < info.shape.size(); ++axis) {
        header += (axis == 0 ? " " : "x") + std::to_string(info.shape[axis]);
    }
    return Sha256().update(header + "\n").update(bytes).finish();
}

hid_t file_type(Type type) {
    switch (type) {
        case Type::u8:
            return H5T_STD_U8LE;
        case Type::u16:
            return H5T_STD_U16LE;
        case Type::u32:
            return H5T_STD_U32LE;
        case Type::u64:
            return H5T_STD_U64LE;
        case Type::i64:
            return H5T_STD_I64LE;
        case Type::f32:
            return H5T_IEEE_F32LE;
        case Type::f64:
            return H5T_IEEE_F64LE;
        case Type::text:
            break;
    }
    throw Error(ErrorKind::internal, "internal: a text needs its length");
}

Handle text_type(std::size_t size, H5T_cset_t encoding) {
    Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
    CRUMPLE_CHECK(type.is_open() && H5Tset_size(type.id(), size) >= 0 &&
                      H5Tset_strpad(type.id(), H5T_STR_NULLPAD) >= 0 && H5Tset_cset(type.id(), encoding) >= 0,
                  last_hdf5_error());
    return type;
}

std::uint64_t element_count(const Shape& shape) {
    std::uint64_t count = 1;
    for (const std::uint64_t extent : shape) {
        if (__builtin_mul_overflow(count, extent, &count)) throw std::overflow_error("shape");
    }
    return count;
}

void prepare_hdf5() {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    H5PLset_loading_state(0);
}

std::string last_hdf5_error() {
    struct Reason {
        std::string text = "HDF5 gives no reason";
        bool is_want_of_memory = false;
    } reason;
    // Upward: the call that failed first comes first.
    H5Ewalk2(
        H5E_DEFAULT, H5E_WALK_UPWARD,
        [](unsigned depth, const H5E_error2_t* error, void* data) -> herr_t {
            Reason& first = *static_cast<Reason*>(data);
            if (depth == 0 && error->desc) first.text = error->desc;
            if (depth == 0) first.is_want_of_memory = error->maj_num == H5E_RESOURCE && error->min_num == H5E_NOSPACE;
            return 0;
        },
        &reason);
    if (reason.is_want_of_memory) throw std::bad_alloc();
    return reason.text;
}

}
