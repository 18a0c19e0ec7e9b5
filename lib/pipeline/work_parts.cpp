// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/work_parts.h"

#include <algorithm>
#include <string>

#include "mesh/validate.h"

namespace crumple::pipeline {

namespace {

using store::FileReader;
using store::FileWriter;

void require_rows(const FileReader& file, const std::string& path, std::size_t rows, std::size_t expected) {
    if (rows != expected) {
        file.refuse(path, "has " + std::to_string(rows) + " rows, " + std::to_string(expected) + " were expected");
    }
}

void refuse_problems(const FileReader& file, const std::string& path, const std::vector<Finding>& problems) {
    if (!problems.empty()) file.refuse(path, problems.front().code + ": " + problems.front().message);
}

std::vector<Vec3> read_positions(const FileReader& file, const std::string& path) {
    auto positions = file.read<Vec3>(path);
    if (!std::all_of(positions.begin(), positions.end(), is_finite<double>))
        file.refuse(path, "a position is not finite");
    return positions;
}

template <class T>
std::vector<T> read_column(const FileReader& file, const std::string& path, std::size_t rows) {
    auto column = file.read<T>(path);
    require_rows(file, path, column.size(), rows);
    return column;
}

// Texts cannot be stored as an empty list: an absent dataset is one.
void write_names(FileWriter& file, const std::string& path, const std::vector<std::string>& names) {
    if (!names.empty()) file.write_texts(path, names);
}

std::vector<std::string> read_names(const FileReader& file, const std::string& path, std::size_t rows) {
    if (rows == 0 && !file.has(path)) return {};
    auto names = file.read_texts(path);
    require_rows(file, path, names.size(), rows);
    return names;
}

// Groups of a list: their names are numbers, so that what an artist called a thing never becomes a path.
std::string item_path(const std::string& list, std::size_t i) { return list + "/" + std::to_string(i); }

std::size_t count_items(const FileReader& file, const std::string& list) {
    return file.has(list) ? file.list(list).size() : 0;
}

template <class Member>
auto column_of(const std::vector<Component>& components, Member member) {
    std::vector<std::decay_t<decltype(member(components[0]))>> column;
    for (const Component& component : components) column.push_back(member(component));
    return column;
}

void write_components(FileWriter& file, const std::string& path, const std::vector<Component>& components) {
    file.make_group(path);
    write_names(file, path + "/name", column_of(components, [](const Component& c) { return c.name; }));
    write_names(file, path + "/material", column_of(components, [](const Component& c) { return c.material; }));
    write_names(file, path + "/role",
                column_of(components, [](const Component& c) { return std::string(name_of(c.role)); }));
    write_names(file, path + "/role_reason", column_of(components, [](const Component& c) { return c.role_reason; }));
    file.write(path + "/volume", column_of(components, [](const Component& c) { return c.volume; }));
    file.write(path + "/is_closed",
               column_of(components, [](const Component& c) -> std::uint8_t { return c.is_closed; }));
    file.write(path + "/is_inward",
               column_of(components, [](const Component& c) -> std::uint8_t { return c.is_inward; }));
    file.write(path + "/parent", column_of(components, [](const Component& c) { return c.parent; }));
}

Role role_of(const FileReader& file, const std::string& path, const std::string& name) {
    for (const auto& entry : role_names) {
        if (entry.name == name) return entry.value;
    }
    file.refuse(path, "'" + name + "' is no role");
}

std::vector<Component> read_components(const FileReader& file, const std::string& path) {
    const auto volume = file.read<double>(path + "/volume");
    const std::size_t count = volume.size();
    const auto names = read_names(file, path + "/name", count);
    const auto materials = read_names(file, path + "/material", count);
    const auto roles = read_names(file, path + "/role", count);
    const auto reasons = read_names(file, path + "/role_reason", count);
    const auto closed = read_column<std::uint8_t>(file, path + "/is_closed", count);
    const auto inward = read_column<std::uint8_t>(file, path + "/is_inward", count);
    const auto parent = read_column<Index>(file, path + "/parent", count);
    std::vector<Component> components;
    for (std::size_t i = 0; i < count; ++i) {
        components.push_back({names[i], materials[i], role_of(file, path + "/role", roles[i]), reasons[i], volume[i],
                              closed[i] != 0, inward[i] != 0, parent[i]});
    }
    return components;
}

void write_shell(FileWriter& file, const std::string& path, const Shell& shell) {
    file.write(path + "/positions", shell.positions);
    file.write(path + "/triangles", shell.triangles);
    file.write(path + "/color", shell.color);
    file.write(path + "/locked", shell.locked);
    file.write(path + "/source_vertex", shell.source_vertex);
    file.write(path + "/component", shell.component);
    write_components(file, path + "/components", shell.components);
}

Shell read_shell(const FileReader& file, const std::string& path) {
    Shell shell;
    shell.positions = file.read<Vec3>(path + "/positions");
    shell.triangles = file.read<Triangle>(path + "/triangles");
    shell.color = file.read<std::array<float, 4>>(path + "/color");
    shell.locked = file.read<std::uint8_t>(path + "/locked");
    shell.source_vertex = file.read<Index>(path + "/source_vertex");
    shell.component = file.read<Index>(path + "/component");
    shell.components = read_components(file, path + "/components");
    refuse_problems(file, path, validate(shell));
    return shell;
}

void write_visual(FileWriter& file, const std::string& path, const VisualMesh& visual) {
    file.write_text(path + "/name", visual.name);
    file.write_text(path + "/shell_component", visual.shell_component);
    file.write(path + "/positions", visual.positions);
    file.write(path + "/triangles", visual.triangles);
    file.write(path + "/source_vertex", visual.source_vertex);
}

VisualMesh read_visual(const FileReader& file, const std::string& path) {
    VisualMesh visual;
    visual.name = file.read_text(path + "/name");
    visual.shell_component = file.read_text(path + "/shell_component");
    visual.positions = read_positions(file, path + "/positions");
    visual.triangles = file.read<Triangle>(path + "/triangles");
    const std::size_t count = visual.positions.size();
    const auto is_inside = [&](const Triangle& t) { return t[0] < count && t[1] < count && t[2] < count; };
    if (!std::all_of(visual.triangles.begin(), visual.triangles.end(), is_inside)) {
        file.refuse(path + "/triangles", "an index is out of range");
    }
    visual.source_vertex = read_column<Index>(file, path + "/source_vertex", count);
    return visual;
}

}

void write_asset(FileWriter& file, const Asset& asset) {
    write_shell(file, "/asset/shell", asset.shell);
    file.write("/asset/locked_positions", asset.locked_positions);
    file.make_group("/asset/visual");
    for (std::size_t i = 0; i < asset.visuals.size(); ++i)
        write_visual(file, item_path("/asset/visual", i), asset.visuals[i]);
}

Asset read_asset(const FileReader& file) {
    Asset asset;
    asset.shell = read_shell(file, "/asset/shell");
    asset.locked_positions = read_positions(file, "/asset/locked_positions");
    for (std::size_t i = 0; i < count_items(file, "/asset/visual"); ++i) {
        asset.visuals.push_back(read_visual(file, item_path("/asset/visual", i)));
    }
    return asset;
}

void write_points(FileWriter& file, const PointSet& points) {
    file.write("/points/positions", points.positions);
    file.write_value("/points/shell_vertex_count", points.shell_vertex_count);
}

PointSet read_points(const FileReader& file) {
    PointSet points;
    points.positions = read_positions(file, "/points/positions");
    points.shell_vertex_count = file.read_value<std::uint32_t>("/points/shell_vertex_count");
    if (points.shell_vertex_count > points.positions.size())
        file.refuse("/points/shell_vertex_count", "is larger than there are points");
    return points;
}

void write_tets(FileWriter& file, const TetMesh& mesh) {
    file.write("/tets/positions", mesh.positions);
    file.write_value("/tets/shell_vertex_count", mesh.shell_vertex_count);
    file.write("/tets/tets", mesh.tets);
    file.write("/tets/neighbours", mesh.neighbours);
    file.write("/tets/region", mesh.region);
}

TetMesh read_tets(const FileReader& file) {
    TetMesh mesh;
    mesh.positions = read_positions(file, "/tets/positions");
    mesh.shell_vertex_count = file.read_value<std::uint32_t>("/tets/shell_vertex_count");
    mesh.tets = file.read<Tet>("/tets/tets");
    mesh.neighbours = file.read<std::array<Index, 4>>("/tets/neighbours");
    mesh.region = file.read<Index>("/tets/region");
    std::vector<Finding> problems = validate(mesh);
    // Points that never belonged to a shell keep their doubles: nothing will be baked from them.
    if (mesh.shell_vertex_count == 0)
        std::erase_if(problems, [](const Finding& f) { return f.code == "TETS_POSITION"; });
    refuse_problems(file, "/tets", problems);
    return mesh;
}

void write_bindings(FileWriter& file, const Bindings& bindings) {
    file.make_group("/bindings");
    for (std::size_t i = 0; i < bindings.size(); ++i) {
        const std::string path = item_path("/bindings", i);
        file.write_text(path + "/name", bindings[i].name);
        file.write(path + "/tet", bindings[i].tet);
        file.write(path + "/barycentric", bindings[i].barycentric);
        file.write(path + "/inside", bindings[i].inside);
        file.write(path + "/distance", bindings[i].distance);
    }
}

Bindings read_bindings(const FileReader& file) {
    Bindings bindings;
    for (std::size_t i = 0; i < count_items(file, "/bindings"); ++i) {
        const std::string path = item_path("/bindings", i);
        VisualBinding binding;
        binding.name = file.read_text(path + "/name");
        binding.tet = file.read<Index>(path + "/tet");
        binding.barycentric = read_column<std::array<double, 4>>(file, path + "/barycentric", binding.tet.size());
        binding.inside = read_column<std::uint8_t>(file, path + "/inside", binding.tet.size());
        binding.distance = read_column<double>(file, path + "/distance", binding.tet.size());
        bindings.push_back(std::move(binding));
    }
    return bindings;
}

}
