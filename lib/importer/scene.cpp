// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/scene.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>

#include "core/error.h"
#include "formats/printable.h"

namespace crumple::importer {

namespace {

constexpr std::uint32_t scene_magic = 0x34637363;
constexpr std::size_t max_color_sets = 8;

class Writer {
public:
    template <class T>
    void number(T value) {
        static_assert(std::is_trivially_copyable_v<T>);
        append(&value, sizeof value);
    }
    void text(const std::string& value) {
        number<std::uint64_t>(value.size());
        append(value.data(), value.size());
    }
    template <class T>
    void array(const std::vector<T>& values) {
        static_assert(std::is_trivially_copyable_v<T>);
        number<std::uint64_t>(values.size());
        append(values.data(), values.size() * sizeof(T));
    }
    std::vector<std::byte> take() { return std::move(bytes_); }

private:
    void append(const void* data, std::size_t size) {
        const auto* begin = static_cast<const std::byte*>(data);
        bytes_.insert(bytes_.end(), begin, begin + size);
    }
    std::vector<std::byte> bytes_;
};

[[noreturn]] void damaged(const char* what) {
    throw Error(ErrorKind::bad_input, std::string("the reader's answer is damaged: ") + what);
}

class Reader {
public:
    explicit Reader(std::span<const std::byte> bytes) : left_(bytes) {}

    template <class T>
    T number() {
        T value;
        copy(&value, sizeof value);
        return value;
    }
    // Of things that take at least min_size bytes each, so that a lying count is refused before memory is taken.
    std::size_t count(std::size_t min_size) {
        const auto value = number<std::uint64_t>();
        if (value > left_.size() / min_size) damaged("a count is larger than the data");
        return static_cast<std::size_t>(value);
    }
    std::string text() {
        std::string value(count(1), '\0');
        copy(value.data(), value.size());
        return value;
    }
    template <class T>
    std::vector<T> array() {
        std::vector<T> values(count(sizeof(T)));
        copy(values.data(), values.size() * sizeof(T));
        return values;
    }
    void expect_end() const {
        if (!left_.empty()) damaged("bytes are left over");
    }

private:
    void copy(void* to, std::size_t size) {
        if (size > left_.size()) damaged("it ends too early");
        if (size > 0) std::memcpy(to, left_.data(), size);
        left_ = left_.subspan(size);
    }
    std::span<const std::byte> left_;
};

void write_mesh(Writer& out, const SceneMesh& mesh) {
    out.text(mesh.name);
    out.text(mesh.material);
    out.array(mesh.positions);
    out.array(mesh.triangles);
    out.number<std::uint64_t>(mesh.colors.size());
    for (const auto& set : mesh.colors) out.array(set);
    out.array(mesh.file_vertex);
    out.number(mesh.points_and_lines);
    out.number(mesh.unreadable_polygons);
}

SceneMesh read_mesh(Reader& in) {
    SceneMesh mesh;
    mesh.name = formats::printable(in.text());
    mesh.material = formats::printable(in.text());
    mesh.positions = in.array<Vec3f>();
    mesh.triangles = in.array<Triangle>();
    mesh.colors.resize(in.count(sizeof(std::uint64_t)));
    if (mesh.colors.size() > max_color_sets) damaged("too many colour sets");
    for (auto& set : mesh.colors) set = in.array<Color>();
    mesh.file_vertex = in.array<Index>();
    mesh.points_and_lines = in.number<std::uint64_t>();
    mesh.unreadable_polygons = in.number<std::uint64_t>();
    return mesh;
}

void write_node(Writer& out, const SceneNode& node) {
    out.text(node.name);
    out.number(node.parent);
    out.number(node.transform);
    out.array(node.meshes);
}

SceneNode read_node(Reader& in) {
    SceneNode node;
    node.name = formats::printable(in.text());
    node.parent = in.number<Index>();
    node.transform = in.number<formats::Affine>();
    node.meshes = in.array<Index>();
    return node;
}

template <class Numbers>
bool all_finite(const Numbers& numbers) {
    for (const double number : numbers) {
        if (!std::isfinite(number)) return false;
    }
    return true;
}

void check_positions(const std::vector<Vec3f>& positions, const std::string& whose) {
    for (std::size_t v = 0; v < positions.size(); ++v) {
        const Vec3f& p = positions[v];
        if (is_finite(p)) continue;
        const bool is_no_number = std::isnan(p.x) || std::isnan(p.y) || std::isnan(p.z);
        throw Error(ErrorKind::bad_input,
                    "vertex " + std::to_string(v) + " of " + whose + " has a coordinate that is " +
                        (is_no_number ? "not a number" : "infinite or beyond the range of a float"));
    }
}

void check_mesh(const Scene& scene, const SceneMesh& mesh) {
    const std::size_t vertex_count = mesh.positions.size();
    check_positions(mesh.positions, mesh.name.empty() ? "the file" : "mesh '" + mesh.name + "'");
    for (const Triangle& triangle : mesh.triangles) {
        for (const Index v : triangle) {
            if (v >= vertex_count) damaged("a triangle refers to a vertex that is not there");
        }
    }
    for (const auto& set : mesh.colors) {
        if (!set.empty() && set.size() != vertex_count) damaged("a colour set has the wrong size");
    }
    const bool has_file_vertices = !scene.file_positions.empty();
    if (mesh.file_vertex.size() != (has_file_vertices ? vertex_count : 0))
        damaged("the source vertices have the wrong size");
    for (const Index v : mesh.file_vertex) {
        if (v >= scene.file_positions.size()) damaged("a source vertex is not there");
    }
}

void check(const Scene& scene) {
    if (!(scene.unit >= 0) || !std::isfinite(scene.unit)) damaged("the unit is no length");
    if (static_cast<std::uint32_t>(scene.up) > static_cast<std::uint32_t>(Up::z)) damaged("the up axis is none");
    if (!all_finite(scene.axes)) damaged("the axes are not finite");
    if (scene.meshes.size() >= none || scene.nodes.size() >= none) damaged("it has too many parts");
    check_positions(scene.file_positions, "the file");
    if (!scene.file_reds.empty() && scene.file_reds.size() != scene.file_positions.size())
        damaged("the colours have the wrong size");
    for (const SceneMesh& mesh : scene.meshes) check_mesh(scene, mesh);
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const SceneNode& node = scene.nodes[i];
        if (node.parent != none && node.parent >= i) damaged("a node comes before its parent");
        if (!all_finite(node.transform)) {
            throw Error(ErrorKind::bad_input, "the transform of node '" + node.name + "' is not finite");
        }
        for (const Index mesh : node.meshes) {
            if (mesh >= scene.meshes.size()) damaged("a node refers to a mesh that is not there");
        }
    }
}

}

std::array<double, 9> axes_of(Up up) {
    if (up == Up::x) return {0, -1, 0, 1, 0, 0, 0, 0, 1};
    if (up == Up::z) return {1, 0, 0, 0, 0, 1, 0, -1, 0};
    return {1, 0, 0, 0, 1, 0, 0, 0, 1};
}

std::uint64_t Scene::lost_triangles() const {
    std::uint64_t delivered = 0;
    for (const SceneMesh& mesh : meshes) delivered += mesh.triangles.size();
    return expected_triangles - std::min(delivered, expected_triangles);
}

std::vector<std::byte> encode(const Scene& scene) {
    Writer out;
    out.number(scene_magic);
    out.text(scene.generator);
    out.number(scene.unit);
    out.number(static_cast<std::uint32_t>(scene.up));
    out.number(scene.axes);
    out.number(scene.expected_triangles);
    out.number(scene.unread);
    out.number<std::uint64_t>(scene.extensions.size());
    for (const std::string& name : scene.extensions) out.text(name);
    out.array(scene.file_positions);
    out.array(scene.file_reds);
    out.number<std::uint64_t>(scene.meshes.size());
    for (const SceneMesh& mesh : scene.meshes) write_mesh(out, mesh);
    out.number<std::uint64_t>(scene.nodes.size());
    for (const SceneNode& node : scene.nodes) write_node(out, node);
    return out.take();
}

Scene decode(std::span<const std::byte> bytes) {
    Reader in(bytes);
    if (in.number<std::uint32_t>() != scene_magic) damaged("it is of another version");
    Scene scene;
    scene.generator = formats::printable(in.text());
    scene.unit = in.number<double>();
    scene.up = static_cast<Up>(in.number<std::uint32_t>());
    scene.axes = in.number<std::array<double, 9>>();
    scene.expected_triangles = in.number<std::uint64_t>();
    scene.unread = in.number<formats::Unread>();
    scene.extensions.resize(in.count(sizeof(std::uint64_t)));
    for (std::string& name : scene.extensions) name = formats::printable(in.text());
    scene.file_positions = in.array<Vec3f>();
    scene.file_reds = in.array<float>();
    constexpr std::size_t smallest_mesh = 8 * sizeof(std::uint64_t);
    scene.meshes.resize(in.count(smallest_mesh));
    for (SceneMesh& mesh : scene.meshes) mesh = read_mesh(in);
    constexpr std::size_t smallest_node = 2 * sizeof(std::uint64_t) + sizeof(Index) + sizeof(SceneNode::transform);
    scene.nodes.resize(in.count(smallest_node));
    for (SceneNode& node : scene.nodes) node = read_node(in);
    in.expect_end();
    check(scene);
    return scene;
}

}
