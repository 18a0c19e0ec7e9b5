// SPDX-License-Identifier: MIT
#include "store/hdf5_dataset.h"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace crumple::store {
namespace {

constexpr std::uint64_t max_deflate_ratio = 1040;  // deflate cannot do better than 1032 : 1 [zlib's technical notes]
constexpr std::size_t max_rank = 3;
constexpr std::array numeric_types = {Type::u8, Type::u16, Type::u32, Type::u64, Type::i64, Type::f32, Type::f64};

}

void require(bool ok, const std::string& what) {
    if (!ok) throw std::runtime_error(what);
}

void require_hdf5(bool ok) {
    if (!ok) throw std::runtime_error(last_hdf5_error());
}

Shape shape_of(hid_t space) {
    if (H5Sget_simple_extent_type(space) == H5S_SCALAR) return {};
    require(H5Sget_simple_extent_type(space) == H5S_SIMPLE, "its shape is not a plain one");
    const int rank = H5Sget_simple_extent_ndims(space);
    require(rank >= 1 && rank <= static_cast<int>(max_rank), "it has a strange number of dimensions");
    std::array<hsize_t, max_rank> extents{};
    std::array<hsize_t, max_rank> max_extents{};
    require_hdf5(H5Sget_simple_extent_dims(space, extents.data(), max_extents.data()) == rank);
    require(extents == max_extents, "it can change its size");
    return Shape(extents.begin(), extents.begin() + rank);
}

DatasetInfo info_of_type(hid_t type) {
    for (const Type candidate : numeric_types) {
        if (H5Tequal(type, file_type(candidate)) > 0) return {candidate, size_of(candidate), {}};
    }
    require(H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) == 0 && H5Tget_strpad(type) == H5T_STR_NULLPAD,
            "its type is none this format has");
    return {Type::text, H5Tget_size(type), {}};
}

std::uint64_t byte_count(const DatasetInfo& info) {
    Shape shape = info.shape;
    shape.push_back(info.element_size);
    try {
        return element_count(shape);
    } catch (const std::overflow_error&) {
        throw std::runtime_error("its size does not fit in 64 bits");
    }
}

namespace {

std::uint64_t chunk_count(const Shape& shape, std::span<const hsize_t> chunk) {
    std::uint64_t count = 1;
    for (std::size_t axis = 0; axis < shape.size(); ++axis) count *= (shape[axis] + chunk[axis] - 1) / chunk[axis];
    return count;
}

void check_filters(hid_t settings) {
    for (int i = 0; i < H5Pget_nfilters(settings); ++i) {
        unsigned flags = 0;
        unsigned config = 0;
        std::size_t values = 0;
        const H5Z_filter_t filter =
            H5Pget_filter2(settings, static_cast<unsigned>(i), &flags, &values, nullptr, 0, nullptr, &config);
        require(filter == H5Z_FILTER_SHUFFLE || filter == H5Z_FILTER_DEFLATE || filter == H5Z_FILTER_FLETCHER32,
                "it uses a filter this format does not have");
    }
}

// Chunks may cut the rows only, must all be there, and cannot hold more than deflate can unpack.
void check_chunks(hid_t dataset, hid_t settings, const DatasetInfo& info, std::uint64_t stored) {
    std::array<hsize_t, max_rank> chunk{};
    const std::size_t rank = info.shape.size();
    require_hdf5(H5Pget_chunk(settings, static_cast<int>(rank), chunk.data()) == static_cast<int>(rank));
    require(chunk[0] >= 1 && chunk[0] <= info.shape[0] &&
                std::equal(info.shape.begin() + 1, info.shape.end(), chunk.begin() + 1),
            "its chunks have a strange shape");
    check_filters(settings);
    require(stored > 0 && byte_count(info) / max_deflate_ratio <= stored, "it claims more data than the file holds");
    const Handle space(H5Dget_space(dataset), H5Sclose);
    hsize_t present = 0;
    require_hdf5(H5Dget_num_chunks(dataset, space.id(), &present) >= 0);
    require(present == chunk_count(info.shape, chunk), "some of its chunks are missing");
}

// Sizes are checked here, before anyone allocates by them.
void check_storage(hid_t dataset, const DatasetInfo& info, std::uint64_t file_size) {
    const Handle settings(H5Dget_create_plist(dataset), H5Pclose);
    require_hdf5(settings.is_open());
    const std::uint64_t stored = H5Dget_storage_size(dataset);
    require(stored <= file_size && H5Pget_external_count(settings.id()) == 0, "its data are not in this file");
    switch (H5Pget_layout(settings.id())) {
        case H5D_CHUNKED:
            return check_chunks(dataset, settings.id(), info, stored);
        case H5D_CONTIGUOUS:
            return require(stored == byte_count(info), "it claims more data than the file holds");
        default:
            throw std::runtime_error("its layout is none this format has");
    }
}

}

DatasetInfo info_of(hid_t dataset, std::uint64_t file_size) {
    const Handle type(H5Dget_type(dataset), H5Tclose);
    const Handle space(H5Dget_space(dataset), H5Sclose);
    require_hdf5(type.is_open() && space.is_open());
    DatasetInfo info = info_of_type(type.id());
    info.shape = shape_of(space.id());
    require(!info.shape.empty(), "it is a scalar, this format has none");
    check_storage(dataset, info, file_size);
    return info;
}

}
