// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/gltf.h"

#include <algorithm>
#include <cstring>
#include <functional>

#include "report/json.h"
#include "store/boundary.h"

namespace crumple::study {
namespace {

using report::Json;

constexpr int unsigned_int = 5125;
constexpr int floating = 5126;

template <class T>
Json number(T value) {
    return Json(static_cast<std::uint64_t>(value));
}

// The lists of the JSON while the binary chunk grows; every accessor has a view of its own.
struct Document {
    std::string binary;
    Json::List views, accessors, meshes, nodes, animations;

    template <class T>
    std::size_t add(const std::vector<T>& rows, int component, const char* type, bool has_bounds = false) {
        const std::size_t begin = binary.size();
        const std::size_t size = rows.size() * sizeof(T);
        binary.resize(begin + size);
        std::memcpy(binary.data() + begin, rows.data(), size);
        Json view;
        view.add("buffer", number(0));
        view.add("byteOffset", number(begin));
        view.add("byteLength", number(size));
        views.push_back(std::move(view));
        Json accessor;
        accessor.add("bufferView", number(views.size() - 1));
        accessor.add("componentType", number(component));
        const std::size_t width = std::strcmp(type, "VEC3") == 0 ? 3 : 1;
        accessor.add("count", number(size / 4 / width));
        accessor.add("type", std::string(type));
        if (has_bounds) add_bounds(accessor, binary.data() + begin, size / 4, width);
        accessors.push_back(std::move(accessor));
        return accessors.size() - 1;
    }

private:
    static void add_bounds(Json& accessor, const char* bytes, std::size_t count, std::size_t width) {
        std::vector<float> values(count);
        std::memcpy(values.data(), bytes, count * sizeof(float));
        Json::List low, high;
        for (std::size_t k = 0; k < width; ++k) {
            float least = values[k];
            float most = values[k];
            for (std::size_t i = k; i < count; i += width) {
                least = std::min(least, values[i]);
                most = std::max(most, values[i]);
            }
            low.emplace_back(static_cast<double>(least));
            high.emplace_back(static_cast<double>(most));
        }
        accessor.add("min", std::move(low));
        accessor.add("max", std::move(high));
    }
};

std::vector<std::size_t> kept_frames(std::size_t count) {
    std::vector<std::size_t> kept;
    const std::size_t most = std::min(count, max_morph_targets + 1);
    for (std::size_t i = 0; i < most; ++i) kept.push_back(most > 1 ? i * (count - 1) / (most - 1) : 0);
    return kept;
}

using VerticesOf = std::function<const std::vector<Vec3f>&(const Frame&)>;

void add_mesh(Document& doc, const std::string& name, const std::vector<Triangle>& triangles, const Run& run,
              const std::vector<std::size_t>& kept, const VerticesOf& vertices_of) {
    const std::vector<Vec3f>& first = vertices_of(run.frames.front());
    Json attributes;
    attributes.add("POSITION", number(doc.add(first, floating, "VEC3", true)));
    Json primitive;
    primitive.add("attributes", std::move(attributes));
    primitive.add("indices", number(doc.add(triangles, unsigned_int, "SCALAR")));
    Json::List targets, weights;
    for (std::size_t k = 1; k < kept.size(); ++k) {
        std::vector<Vec3f> moves = vertices_of(run.frames[kept[k]]);
        for (std::size_t v = 0; v < moves.size(); ++v) moves[v] -= first[v];
        Json target;
        target.add("POSITION", number(doc.add(moves, floating, "VEC3", true)));
        targets.push_back(std::move(target));
        weights.emplace_back(0.0);
    }
    Json mesh;
    if (!targets.empty()) primitive.add("targets", std::move(targets));
    mesh.add("name", name);
    mesh.add("primitives", Json::List{std::move(primitive)});
    if (!weights.empty()) mesh.add("weights", std::move(weights));
    doc.meshes.push_back(std::move(mesh));
    Json node;
    node.add("mesh", number(doc.meshes.size() - 1));
    node.add("name", name);
    doc.nodes.push_back(std::move(node));
}

// At the time of frame k target k has weight 1, the others 0.
void add_animation(Document& doc, const Run& run, const std::vector<std::size_t>& kept) {
    if (kept.size() < 2) return;
    const std::size_t targets = kept.size() - 1;
    std::vector<float> times;
    std::vector<float> weights(kept.size() * targets, 0.0f);
    for (std::size_t k = 0; k < kept.size(); ++k) {
        times.push_back(static_cast<float>(run.frames[kept[k]].time_s));
        if (k > 0) weights[k * targets + k - 1] = 1;
    }
    Json sampler;
    sampler.add("input", number(doc.add(times, floating, "SCALAR", true)));
    sampler.add("output", number(doc.add(weights, floating, "SCALAR")));
    sampler.add("interpolation", std::string("LINEAR"));
    Json::List channels;
    for (std::size_t i = 0; i < doc.nodes.size(); ++i) {
        Json target;
        target.add("node", number(i));
        target.add("path", std::string("weights"));
        Json channel;
        channel.add("sampler", number(0));
        channel.add("target", std::move(target));
        channels.push_back(std::move(channel));
    }
    Json animation;
    animation.add("channels", std::move(channels));
    animation.add("samplers", Json::List{std::move(sampler)});
    doc.animations.push_back(std::move(animation));
}

void append_u32(std::string& bytes, std::size_t value) {
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 255);
}

std::string pack(Document doc) {
    Json asset, buffer, scene, root;
    asset.add("version", std::string("2.0"));
    asset.add("generator", std::string("crumple"));
    Json::List in_scene;
    for (std::size_t i = 0; i < doc.nodes.size(); ++i) in_scene.push_back(number(i));
    scene.add("nodes", std::move(in_scene));
    buffer.add("byteLength", number(doc.binary.size()));
    root.add("asset", std::move(asset));
    root.add("scene", number(0));
    root.add("scenes", Json::List{std::move(scene)});
    root.add("nodes", std::move(doc.nodes));
    root.add("meshes", std::move(doc.meshes));
    root.add("accessors", std::move(doc.accessors));
    root.add("bufferViews", std::move(doc.views));
    root.add("buffers", Json::List{std::move(buffer)});
    if (!doc.animations.empty()) root.add("animations", std::move(doc.animations));
    std::string json = report::dump_json(root, report::JsonStyle::compact);
    json.resize((json.size() + 3) / 4 * 4, ' ');
    std::string glb = "glTF";
    append_u32(glb, 2);
    append_u32(glb, 12 + 8 + json.size() + 8 + doc.binary.size());
    append_u32(glb, json.size());
    glb += "JSON" + json;
    append_u32(glb, doc.binary.size());
    return glb + std::string("BIN\0", 4) + doc.binary;
}

}

std::string run_glb(const Bundle& bundle, const Run& run, const VisualTriangles& triangles) {
    Document doc;
    const std::vector<std::size_t> kept = kept_frames(run.frames.size());
    for (std::size_t i = 0; i < bundle.visuals.size() && i < triangles.size(); ++i) {
        if (triangles[i].empty()) continue;
        add_mesh(doc, bundle.visuals[i].name, triangles[i], run, kept,
                 [i](const Frame& f) -> const std::vector<Vec3f>& { return f.vertices[i]; });
    }
    if (doc.meshes.empty()) {
        add_mesh(doc, "control", store::boundary_faces(bundle), run, kept,
                 [](const Frame& f) -> const std::vector<Vec3f>& { return f.nodes; });
    }
    add_animation(doc, run, kept);
    return pack(std::move(doc));
}

}
