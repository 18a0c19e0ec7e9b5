// SPDX-License-Identifier: MIT
#include "store/view_fields.h"

#include "store/bundle_file.h"

namespace crumple::store {
namespace {

void write_group(FileWriter& file, const std::string& group, const std::vector<ViewField>& fields) {
    for (const ViewField& field : fields) {
        const std::string path = group + encode_name(field.name);
        std::visit([&](const auto& values) { file.write(path, values); }, field.values);
    }
}

}

void write_view_fields(FileWriter& file, const ViewFields& fields) {
    write_group(file, "/VTKHDF/PointData/", fields.points);
    write_group(file, "/VTKHDF/CellData/", fields.cells);
    write_group(file, "/VTKHDF/FieldData/", fields.loose);
}

}
