// SPDX-License-Identifier: MIT
// Arrays that are in a file only to be looked at in ParaView: they join what a bundle's or work file's view shows.
#pragma once
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "core/vec3.h"
#include "store/hdf5_file.h"

namespace crumple::store {

struct ViewField {
    std::string name;  // ParaView's name for it; none of a dataset under /bundle
    std::variant<std::vector<float>, std::vector<std::uint32_t>, std::vector<std::uint8_t>, std::vector<Vec3f>> values;
};

struct ViewFields {
    std::vector<ViewField> points;  // one row a node
    std::vector<ViewField> cells;   // one row a tet
    std::vector<ViewField> loose;   // of any length: what belongs to neither, such as visual vertices
};

// REQUIRES: the view was written before.
void write_view_fields(FileWriter& file, const ViewFields& fields);

}
