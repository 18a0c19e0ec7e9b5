// SPDX-License-Identifier: MIT
// What a dataset may look like. Whatever FileWriter never writes is refused before anything is allocated or read: HDF5
// would follow it anywhere. Everything throws std::runtime_error with what is wrong; the reader adds where.
#pragma once
#include <cstdint>
#include <string>

#include "store/hdf5_handle.h"

namespace crumple::store {

void require(bool ok, const std::string& what);
void require_hdf5(bool ok);  // with HDF5's own words

[[nodiscard]] DatasetInfo info_of_type(hid_t type);  // without a shape
[[nodiscard]] Shape shape_of(hid_t space);           // {} for a scalar
[[nodiscard]] std::uint64_t byte_count(const DatasetInfo& info);

// Checks type, shape, layout, filters and that the file of file_size bytes can hold the data.
[[nodiscard]] DatasetInfo info_of(hid_t dataset, std::uint64_t file_size);

}
