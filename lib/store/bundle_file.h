// SPDX-License-Identifier: MIT
// A bundle in an HDF5 file: the group /bundle, described in lib/bundle/FORMAT.md, and /VTKHDF, the view of it that
// ParaView opens. Other groups of the file (a cook's work, reports) are none of this module's business.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "bundle/bundle.h"
#include "store/hdf5_file.h"

namespace crumple::store {

// A reader takes files of its own major version: of an older minor one, where what is missing has a stated default, and
// of a newer minor one, whose additions it ignores. Files of another major version are refused by name.
inline constexpr std::int64_t schema_major = 1;
inline constexpr std::int64_t schema_minor = 0;

// Adds both groups. REQUIRES: validate(bundle) is empty.
void write_bundle(FileWriter& file, const Bundle& bundle);

// The bundle as the sender meant it; not yet validated.
// Throws Error(bad_input): another schema, a dataset missing, unknown, or of the wrong type or shape.
[[nodiscard]] Bundle read_bundle(const FileReader& file);
[[nodiscard]] bool has_bundle(const FileReader& file);

// A file with nothing but the bundle.
[[nodiscard]] std::vector<std::byte> to_image(const Bundle& bundle, Layout layout = Layout::compressed);

// Reads, validates and returns what can be simulated. Throws Error(file), or Error(bad_input) with the first complaint.
[[nodiscard]] Bundle load_bundle(const std::string& path);

// Names of visuals and sensors are names of groups: '/', '%', control characters and leading dots become %XX.
[[nodiscard]] std::string encode_name(const std::string& name);

}
