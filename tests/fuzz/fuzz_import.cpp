// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes are what a damaged or hostile reader hands over, or a file a prescan looks at. Whatever they are, import
// refuses them or gives a shell that keeps its promises.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <span>
#include <string_view>

#include "core/error.h"
#include "formats/format.h"
#include "formats/prescan.h"
#include "importer/scene.h"
#include "importer/shell_from_scene.h"

namespace {

using namespace crumple;
using namespace crumple::formats;
using namespace crumple::importer;

void require(bool holds) {
    if (!holds) std::abort();
}

class Bytes {
public:
    Bytes(const std::uint8_t* data, std::size_t size) : left_(data, size) {}
    std::uint8_t next() {
        if (left_.empty()) return 0;
        const std::uint8_t value = left_.front();
        left_ = left_.subspan(1);
        return value;
    }
    [[nodiscard]] bool empty() const { return left_.empty(); }
    [[nodiscard]] std::span<const std::uint8_t> left() const { return left_; }

private:
    std::span<const std::uint8_t> left_;
};

Color some_color(Bytes& bytes) {
    constexpr float reds[] = {0, 1, 0.0019f, 0.5f, 255, -1, INFINITY, NAN};
    return {reds[bytes.next() % 8], 1, 0, 1};
}

SceneMesh some_mesh(Bytes& bytes, bool has_list, std::size_t list_size) {
    SceneMesh mesh;
    mesh.name = std::string(1, static_cast<char>('a' + bytes.next() % 3));
    const std::size_t vertex_count = bytes.next() % 24 + 3u;
    const bool has_color = bytes.next() % 2 == 0;
    if (has_color) mesh.colors.resize(1);
    for (std::size_t v = 0; v < vertex_count; ++v) {
        // A coarse grid with hairs: equal, nearly equal and collinear positions are common.
        Vec3f p;
        for (int axis = 0; axis < 3; ++axis) {
            const std::uint8_t value = bytes.next();
            p[axis] = static_cast<float>(value % 4) + (value % 16 == 15 ? 1e-6f : 0);
        }
        mesh.positions.push_back(p);
        if (has_color) mesh.colors[0].push_back(some_color(bytes));
        if (has_list) mesh.file_vertex.push_back(static_cast<Index>(bytes.next() % list_size));
    }
    const std::size_t triangle_count = bytes.next() % 48;
    for (std::size_t t = 0; t < triangle_count && !bytes.empty(); ++t) {
        Triangle corners;
        for (Index& corner : corners) corner = static_cast<Index>(bytes.next() % vertex_count);
        mesh.triangles.push_back(corners);
    }
    return mesh;
}

Scene some_scene(Bytes& bytes) {
    Scene scene;
    const bool has_list = bytes.next() % 4 == 0;
    if (has_list) scene.file_positions.resize(bytes.next() % 8 + 1u);
    const std::size_t mesh_count = bytes.next() % 3 + 1u;
    for (std::size_t m = 0; m < mesh_count; ++m)
        scene.meshes.push_back(some_mesh(bytes, has_list, scene.file_positions.size()));
    const std::size_t node_count = bytes.next() % 4 + 1u;
    for (std::size_t n = 0; n < node_count; ++n) {
        SceneNode node;
        node.name = std::string(1, static_cast<char>('a' + bytes.next() % 3));
        if (n > 0 && bytes.next() % 2) node.parent = static_cast<Index>(bytes.next() % n);
        for (double& number : node.transform) {
            const std::uint8_t change = bytes.next();
            if (change % 8 == 7) number = static_cast<double>(change / 8) - 16;
        }
        node.meshes.push_back(static_cast<Index>(bytes.next() % mesh_count));
        scene.nodes.push_back(std::move(node));
    }
    return scene;
}

bool is_float(double value) { return static_cast<double>(static_cast<float>(value)) == value; }

void check_shell(const Shell& shell, const Report& report) {
    const std::size_t vertex_count = shell.positions.size();
    require(!shell.triangles.empty() && shell.locked.size() == vertex_count &&
            shell.source_vertex.size() == vertex_count);
    require(shell.color.empty() || shell.color.size() == vertex_count);
    require(shell.component.size() == shell.triangles.size());
    std::vector<bool> used(vertex_count, false);
    for (const Triangle& t : shell.triangles) {
        require(t[0] != t[1] && t[1] != t[2] && t[2] != t[0]);
        for (const Index v : t) used.at(v) = true;
    }
    require(std::find(used.begin(), used.end(), false) == used.end());
    auto positions = shell.positions;
    for (const Vec3& p : positions) require(is_float(p.x) && is_float(p.y) && is_float(p.z));
    std::sort(positions.begin(), positions.end(),
              [](const Vec3& a, const Vec3& b) { return lexicographic_less(a, b); });
    require(std::adjacent_find(positions.begin(), positions.end()) == positions.end());
    for (const Index c : shell.component) require(c < shell.components.size());
    for (const Component& c : shell.components) require(c.parent == none || c.parent < shell.components.size());
    require(report.locked == static_cast<std::uint64_t>(std::count(shell.locked.begin(), shell.locked.end(), 1)));
    require(report.components.size() == shell.components.size());
    require(report.leak_share >= 0 && report.leak_share <= 1);
}

void import_scene(const Scene& scene, double thickness = 0) {
    static const Format& format = format_of("fuzzed.obj");
    Params params;
    params.memory_mb = 16;
    params.thicken = thickness;
    Report report;
    const Shell shell = shell_from_scene(scene, format, "fuzzed", params, {}, report);
    check_shell(shell, report);
}

constexpr int with_thickness = 7;

// Formats that assimp reads from the file itself.
void look_at_tree(int kind, Purpose purpose, std::string_view text) {
    if (kind == 0) (void)prescan_numbers(text);
    if (kind == 1) (void)prescan_dae(text, purpose);
    if (kind == 2) (void)prescan_fbx(text, purpose);
    if (kind == 3) (void)prescan_x(text, purpose);
}

void try_one(int kind, int tree_kind, Purpose purpose, Bytes bytes) {
    const std::span<const std::uint8_t> left = bytes.left();
    const std::string_view text(reinterpret_cast<const char*>(left.data()), left.size());
    switch (kind) {
        case 0:
            (void)prescan_obj(text, purpose);
            return;
        case 1:
            (void)prescan_ply(text, purpose);
            return;
        case 2:
            (void)prescan_off(text, purpose);
            return;
        case 3:
            (void)prescan_gltf(text, purpose);
            return;
        case 4:
            look_at_tree(tree_kind, purpose, text);
            return;
        case 5:
            import_scene(decode(std::as_bytes(left)));
            return;
        default:
            break;
    }
    const Scene scene = some_scene(bytes);
    const auto encoded = encode(scene);
    const Scene back = decode(encoded);
    require(encode(back) == encoded);
    import_scene(back, kind == with_thickness ? 0.25 : 0);
}

}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const Purpose purpose = data[0] / 8 % 2 == 0 ? Purpose::shell : Purpose::visual;
    try {
        try_one(data[0] % 8, data[0] / 16 % 4, purpose, Bytes(data + 1, size - 1));
    } catch (const Error& error) {
        // A thickness that floats cannot show at that place is asked for, not read.
        const bool is_thickness = data[0] % 8 == with_thickness && error.kind() == ErrorKind::usage;
        require(error.kind() == ErrorKind::bad_input || is_thickness);
    }
    return 0;
}
