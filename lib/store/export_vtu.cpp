// SPDX-License-Identifier: MIT
#include "store/export_vtu.h"

#include "store/text_file.h"

namespace crumple::store {
namespace {

void open_array(TextFile& out, const char* type, std::string_view name, int components) {
    out << "<DataArray type=\"" << type << "\" Name=\"" << name << "\" NumberOfComponents=\"" << components
        << "\" format=\"ascii\">\n";
}

// Work that is not baked yet has no masses; an array that is not there is left out rather than invented.
template <class Values>
void write_list(TextFile& out, const char* type, std::string_view name, const Values& values) {
    if (values.empty()) return;
    open_array(out, type, name, 1);
    for (const auto value : values) out << +value << '\n';
    out << "</DataArray>\n";
}

void write_cells(TextFile& out, const Bundle& b) {
    out << "<Cells>\n";
    open_array(out, "Int64", "connectivity", 1);
    for (const Tet& tet : b.tets) out << tet[0] << ' ' << tet[1] << ' ' << tet[2] << ' ' << tet[3] << '\n';
    out << "</DataArray>\n";
    open_array(out, "Int64", "offsets", 1);
    for (std::size_t t = 1; t <= b.tets.size(); ++t) out << 4 * t << '\n';
    out << "</DataArray>\n";
    open_array(out, "UInt8", "types", 1);
    for (std::size_t t = 0; t < b.tets.size(); ++t) out << "10\n";
    out << "</DataArray>\n</Cells>\n";
}

}

std::string export_vtu(const Bundle& b) {
    TextFile out;
    out << "<?xml version=\"1.0\"?>\n"
           "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
           "<UnstructuredGrid>\n<Piece NumberOfPoints=\""
        << b.rest_positions.size() << "\" NumberOfCells=\"" << b.tets.size() << "\">\n<Points>\n";
    open_array(out, "Float32", "Points", 3);
    for (const Vec3f p : b.rest_positions) out << p << '\n';
    out << "</DataArray>\n</Points>\n";
    write_cells(out, b);
    out << "<PointData>\n";
    write_list(out, "UInt8", "locked", b.locked);
    write_list(out, "Float32", "mass", b.mass);
    out << "</PointData>\n<CellData>\n";
    write_list(out, "UInt32", "region", b.region);
    write_list(out, "UInt16", "material", b.material);
    write_list(out, "Float32", "volume", b.volume);
    write_list(out, "Float32", "stiffness_scale", b.stiffness_scale);
    out << "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
    return out.take();
}

}
