// SPDX-License-Identifier: MIT
// An HDF5 file that lives in a byte vector of ours: written into it, or read from it without a copy.
// Not by H5Fget_file_image: HDF5 1.10.8 returns images of new-format files with a wrong checksum in the superblock.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "store/hdf5_handle.h"

namespace crumple::store {

// Makes `access`, a file access list, open files in `bytes`, which must outlive the file. For reading, bytes hold the
// whole file; for writing they grow as needed and, once the file is closed, begin with it.
void use_image(hid_t access, std::vector<std::byte>& bytes);

// HDF5 takes two files in memory of the same name for one and the same.
[[nodiscard]] std::string unique_file_name();

}
