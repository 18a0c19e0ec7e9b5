// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/gltf_scene.h"

#include <set>
#include <vector>

#include "core/counted.h"
#include "core/error.h"

namespace crumple::formats::gltf {

namespace {

[[noreturn]] void refuse(const std::string& what) { throw Error(ErrorKind::bad_input, what); }

// The node that an item of a list names; `whose` begins the message where it names none.
std::size_t node_in(const Json& item, std::size_t node_count, const std::string& whose) {
    const std::uint64_t node = item.is_number_unsigned() ? item.get<std::uint64_t>() : node_count;
    if (node >= node_count) refuse(whose + " that is not there");
    return node;
}

// By node: its parent, or the number of nodes.
std::vector<std::size_t> parents_of(const Json& nodes) {
    std::vector<std::size_t> parent(nodes.size(), nodes.size());
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        for (const Json& child : list(nodes[n], "children")) {
            const std::size_t c = node_in(child, nodes.size(), "node " + std::to_string(n) + " has a child");
            if (parent[c] < nodes.size()) refuse("node " + std::to_string(c) + " has two parents");
            parent[c] = n;
        }
    }
    return parent;
}

void check_depth(const std::vector<std::size_t>& parent) {
    constexpr std::size_t deepest = 1000;
    for (std::size_t n = 0; n < parent.size(); ++n) {
        std::size_t depth = 0;
        for (std::size_t above = parent[n]; above < parent.size(); above = parent[above]) {
            if (++depth > deepest) {
                refuse("node " + std::to_string(n) + " is nested more than " + std::to_string(deepest) +
                       " deep, or within itself");
            }
        }
    }
}

void check_scenes(const Json& document, std::size_t node_count) {
    const Json& scenes = list(document, "scenes");
    for (std::size_t s = 0; s < scenes.size(); ++s) {
        if (!scenes[s].is_object()) refuse("one of the scenes is not an object");
        std::vector<bool> is_named(node_count, false);
        for (const Json& item : list(scenes[s], "nodes")) {
            const std::size_t node = node_in(item, node_count, "scene " + std::to_string(s) + " has a node");
            if (is_named[node]) refuse("scene " + std::to_string(s) + " has node " + std::to_string(node) + " twice");
            is_named[node] = true;
        }
    }
    const std::uint64_t chosen = number(document, "scene", 0);
    if (chosen > 0 && chosen >= scenes.size()) refuse("its scene " + std::to_string(chosen) + " is not there");
}

Json all_roots(const Json& document) {
    const std::vector<std::size_t> parent = parents_of(list(document, "nodes"));
    Json roots = Json::array();
    for (std::size_t n = 0; n < parent.size(); ++n) {
        if (parent[n] == parent.size()) roots.push_back(n);
    }
    return roots;
}

std::uint64_t count_with_mesh(const Json& nodes) {
    std::uint64_t count = 0;
    for (const Json& node : nodes) count += node.contains("mesh");
    return count;
}

// The meshes of the nodes named and of those below.
std::vector<std::size_t> meshes_below(const Json& nodes, const Json& named) {
    std::vector<std::size_t> meshes;
    std::vector<std::size_t> pending;
    const auto wait = [&](const Json& items) {
        for (const Json& item : items) pending.push_back(item.get<std::size_t>());
    };
    wait(named);
    while (!pending.empty()) {
        const Json& node = nodes[pending.back()];
        pending.pop_back();
        if (node.contains("mesh")) meshes.push_back(node["mesh"].get<std::size_t>());
        wait(list(node, "children"));
    }
    return meshes;
}

// Those of the nodes named that no other one of them has below it: some programs name them all.
Json topmost(const Json& document, const Json& named) {
    const std::vector<std::size_t> parent = parents_of(list(document, "nodes"));
    std::vector<bool> is_named(parent.size(), false);
    for (const Json& item : named) is_named[item.get<std::size_t>()] = true;
    Json tops = Json::array();
    for (const Json& item : named) {
        bool is_below = false;
        for (std::size_t above = parent[item.get<std::size_t>()]; above < parent.size(); above = parent[above])
            is_below = is_below || is_named[above];
        if (!is_below) tops.push_back(item);
    }
    return tops;
}

void check_meshes(const Json& document) {
    const Json& nodes = list(document, "nodes");
    const std::size_t mesh_count = list(document, "meshes").size();
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        if (nodes[n].contains("mesh") && number(nodes[n], "mesh", 0) >= mesh_count)
            refuse("node " + std::to_string(n) + " has a mesh that is not there");
    }
}

}

void check_nodes(const Json& document) {
    const Json& nodes = list(document, "nodes");
    check_depth(parents_of(nodes));
    check_meshes(document);
    check_scenes(document, nodes.size());
}

std::set<std::size_t> choose_scene(Json& document, Unread& unread) {
    if (list(document, "scenes").empty()) {
        // A library of meshes that no node places: each where its file has it.
        if (list(document, "nodes").empty()) {
            document["nodes"] = Json::array();
            const std::size_t mesh_count = list(document, "meshes").size();
            for (std::size_t m = 0; m < mesh_count; ++m) document["nodes"].push_back({{"mesh", m}});
        }
        document["scenes"] = Json::array({{{"nodes", all_roots(document)}}});
        unread.nodes_of_no_scene = count_with_mesh(document["nodes"]);
    }
    const std::uint64_t chosen = number(document, "scene", 0);
    document["scene"] = chosen;
    Json& scene = document["scenes"][chosen];
    scene["nodes"] = topmost(document, list(scene, "nodes"));
    const Json& nodes = list(document, "nodes");
    const std::vector<std::size_t> read = meshes_below(nodes, scene["nodes"]);
    unread.nodes = count_with_mesh(nodes) - read.size();
    if (read.empty() && unread.nodes > 0)
        refuse("the scene that is read holds no mesh; " +
               counted(unread.nodes, "node with one is", "nodes with one are") +
               " outside it: export the scene that they belong to");
    return {read.begin(), read.end()};
}

}
