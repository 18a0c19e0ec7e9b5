// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/export_mesh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstring>
#include <span>

#include "core/error.h"

namespace crumple::pipeline {

namespace {

static_assert(std::endian::native == std::endian::little, "the VTU writer hands out memory as little-endian");

std::string decimal(double number) {
    // Positions are floats widened to double almost always: their own digits are shorter and read back the same.
    std::array<char, 32> text{};
    const auto single = static_cast<float>(number);
    const auto end = static_cast<double>(single) == number
                         ? std::to_chars(text.data(), text.data() + text.size(), single)
                         : std::to_chars(text.data(), text.data() + text.size(), number);
    return std::string(text.data(), end.ptr);
}

std::string decimal(Vec3 p) { return decimal(p.x) + " " + decimal(p.y) + " " + decimal(p.z); }

std::string base64(std::span<const std::byte> bytes) {
    static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t word = 0;
        for (std::size_t k = 0; k < 3; ++k)
            word = word << 8 | (k < count ? std::to_integer<std::uint32_t>(bytes[i + k]) : 0);
        for (std::size_t k = 0; k < 4; ++k) text += k <= count ? digits[word >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

template <class T>
std::string data_array(const char* type, const char* name, int components, const std::vector<T>& values) {
    const std::uint64_t size = values.size() * sizeof(T);
    std::vector<std::byte> bytes(sizeof size + size);
    std::memcpy(bytes.data(), &size, sizeof size);
    if (size > 0) std::memcpy(bytes.data() + sizeof size, values.data(), size);
    return std::string("<DataArray type=\"") + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
           std::to_string(components) + "\" format=\"binary\">" + base64(bytes) + "</DataArray>\n";
}

std::string cells_xml(const ExportMesh& mesh) {
    std::vector<std::int64_t> offsets(mesh.tets.size());
    for (std::size_t t = 0; t < offsets.size(); ++t) offsets[t] = 4 * static_cast<std::int64_t>(t + 1);
    std::vector<std::int64_t> corners;
    corners.reserve(4 * mesh.tets.size());
    for (const Tet& tet : mesh.tets) corners.insert(corners.end(), tet.begin(), tet.end());
    constexpr std::uint8_t vtk_tetra = 10;
    return "<Cells>\n" + data_array("Int64", "connectivity", 1, corners) + data_array("Int64", "offsets", 1, offsets) +
           data_array("UInt8", "types", 1, std::vector<std::uint8_t>(mesh.tets.size(), vtk_tetra)) + "</Cells>\n";
}

std::string vtu(const ExportMesh& mesh) {
    std::string text =
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
        "header_type=\"UInt64\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"" +
        std::to_string(mesh.positions.size()) + "\" NumberOfCells=\"" + std::to_string(mesh.tets.size()) + "\">\n";
    text += "<PointData>\n";
    if (!mesh.locked.empty()) text += data_array("UInt8", "locked", 1, mesh.locked);
    if (!mesh.mass.empty()) text += data_array("Float32", "mass", 1, mesh.mass);
    text += "</PointData>\n<CellData>\n";
    if (!mesh.region.empty()) text += data_array("UInt32", "region", 1, mesh.region);
    if (!mesh.material.empty()) text += data_array("UInt16", "material", 1, mesh.material);
    text += "</CellData>\n<Points>\n" + data_array("Float64", "Points", 3, mesh.positions) + "</Points>\n" +
            cells_xml(mesh);
    return text + "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

// The format has no way to write a quote inside a name.
std::string quoted(std::string name) {
    for (char& c : name) {
        if (c == '"' || static_cast<unsigned char>(c) < 0x20) c = '_';
    }
    return "\"" + name + "\"";
}

std::string msh(const ExportMesh& mesh) {
    std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
    if (!mesh.regions.empty()) {
        text += "$PhysicalNames\n" + std::to_string(mesh.regions.size()) + "\n";
        for (std::size_t r = 0; r < mesh.regions.size(); ++r)
            text += "3 " + std::to_string(r + 1) + " " + quoted(mesh.regions[r]) + "\n";
        text += "$EndPhysicalNames\n";
    }
    text += "$Nodes\n" + std::to_string(mesh.positions.size()) + "\n";
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        text += std::to_string(v + 1) + " " + decimal(mesh.positions[v]) + "\n";
    text += "$EndNodes\n$Elements\n" + std::to_string(mesh.tets.size()) + "\n";
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
        const std::string group = std::to_string(mesh.region.empty() ? 1 : mesh.region[t] + 1);
        text += std::to_string(t + 1) + " 4 2 " + group + " " + group;
        for (const Index corner : mesh.tets[t]) text += " " + std::to_string(corner + 1);
        text += "\n";
    }
    text += "$EndElements\n";
    if (mesh.locked.empty()) return text;
    text += "$NodeData\n1\n\"locked\"\n1\n0\n3\n0\n1\n" + std::to_string(mesh.locked.size()) + "\n";
    for (std::size_t v = 0; v < mesh.locked.size(); ++v)
        text += std::to_string(v + 1) + (mesh.locked[v] ? " 1\n" : " 0\n");
    return text + "$EndNodeData\n";
}

// Faces that one tet has and no other, in the order of their tets.
std::vector<Triangle> boundary_of(const std::vector<Tet>& tets) {
    struct Face {
        Triangle key;  // ascending
        Triangle outward;
        std::size_t order;
    };
    std::vector<Face> faces;
    faces.reserve(4 * tets.size());
    for (const Tet& tet : tets) {
        for (const auto& corners : tet_face_corners) {
            const auto at = [&](int i) { return tet[static_cast<std::size_t>(corners[i])]; };
            const Triangle outward{at(0), at(1), at(2)};
            Triangle key = outward;
            std::sort(key.begin(), key.end());
            faces.push_back({key, outward, faces.size()});
        }
    }
    std::sort(faces.begin(), faces.end(), [](const Face& a, const Face& b) { return a.key < b.key; });
    std::vector<Face> open;
    for (std::size_t i = 0; i < faces.size();) {
        std::size_t end = i + 1;
        while (end < faces.size() && faces[end].key == faces[i].key) ++end;
        if (end == i + 1) open.push_back(faces[i]);
        i = end;
    }
    std::sort(open.begin(), open.end(), [](const Face& a, const Face& b) { return a.order < b.order; });
    std::vector<Triangle> triangles;
    for (const Face& face : open) triangles.push_back(face.outward);
    return triangles;
}

std::string obj(const ExportMesh& mesh) {
    const std::vector<Triangle> boundary = boundary_of(mesh.tets);
    std::vector<Index> number(mesh.positions.size(), none);
    for (const Triangle& triangle : boundary) {
        for (const Index v : triangle) number[v] = 0;
    }
    std::string text = "# boundary of the tets; vertex colours: red 0 is locked\n";
    Index count = 0;
    for (std::size_t v = 0; v < number.size(); ++v) {
        if (number[v] == none) continue;
        number[v] = ++count;
        const bool is_locked = !mesh.locked.empty() && mesh.locked[v];
        text += "v " + decimal(mesh.positions[v]) + (is_locked ? " 0 0 0\n" : " 1 1 1\n");
    }
    for (const Triangle& triangle : boundary) {
        text += "f";
        for (const Index v : triangle) text += " " + std::to_string(number[v]);
        text += "\n";
    }
    return text;
}

ExportMesh from_bundle(const Bundle& bundle) {
    ExportMesh mesh;
    for (const Vec3f p : bundle.rest_positions) mesh.positions.push_back({p.x, p.y, p.z});
    mesh.tets = bundle.tets;
    mesh.locked = bundle.locked;
    mesh.mass = bundle.mass;
    mesh.region = bundle.region;
    mesh.material = bundle.material;
    mesh.regions = bundle.regions;
    return mesh;
}

ExportMesh from_tets(const Workspace& work) {
    ExportMesh mesh;
    mesh.positions = work.tets->positions;
    mesh.tets = work.tets->tets;
    mesh.region = work.tets->region;
    if (!work.asset) return mesh;
    mesh.locked = work.asset->shell.locked;
    mesh.locked.resize(mesh.positions.size(), 0);
    for (const Component& component : work.asset->shell.components) mesh.regions.push_back(component.name);
    return mesh;
}

}

ExportMesh export_mesh(const Workspace& workspace) {
    if (workspace.bundle) return from_bundle(*workspace.bundle);
    if (workspace.tets) return from_tets(workspace);
    throw Error(ErrorKind::bad_input, "there is no mesh to export yet; run crumple delaunay first");
}

std::string write_mesh(const ExportMesh& mesh, ExportFormat format) {
    switch (format) {
        case ExportFormat::vtu:
            return vtu(mesh);
        case ExportFormat::msh:
            return msh(mesh);
        case ExportFormat::obj:
            return obj(mesh);
    }
    return {};
}

}
