// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/fbx_mesh.h"

#include <algorithm>
#include <set>

#include "core/counted.h"
#include "core/error.h"
#include "formats/printable.h"

namespace crumple::formats::fbx {

namespace {

struct Counts {
    std::uint64_t vertices = 0;
    std::uint64_t corners = 0;
    std::uint64_t polygons = 0;
};

// An array of so many numbers an element; how many elements.
std::uint64_t count_elements(const Document& document, const Node& node, std::uint64_t numbers) {
    const std::uint64_t size = array_size(document, node);
    if (size % numbers != 0)
        refuse(document, node,
               "holds " + std::to_string(size) + " numbers, which is no multiple of " + std::to_string(numbers));
    return size / numbers;
}

// A corner is the index of its vertex, the last of a polygon -1 - index.
Counts check_polygons(const Document& document, const Node& vertices, const Node& polygons) {
    Counts counts;
    counts.vertices = count_elements(document, vertices, 3);
    const std::vector<double> corners = array_of(document, polygons);
    counts.corners = corners.size();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const double vertex = corners[i] < 0 ? -1 - corners[i] : corners[i];
        if (!(vertex < static_cast<double>(counts.vertices)))
            refuse(document, polygons,
                   "names vertex " + std::to_string(static_cast<std::int64_t>(vertex)) + " as number " +
                       std::to_string(i + 1) + ", where " + counted(counts.vertices, "vertex is", "vertices are") +
                       " there");
        counts.polygons += corners[i] < 0;
    }
    if (!corners.empty() && !(corners.back() < 0)) refuse(document, polygons, "does not end its last polygon");
    return counts;
}

class ColorLayers {
public:
    ColorLayers(const Document& document, Index geometry, const Counts& counts, Unread& unread)
        : document_(document), geometry_(geometry), counts_(counts), unread_(unread) {
        for_each_child(document_, geometry, "Layer", [&](Index layer) {
            for_each_child(document_, layer, "LayerElement", [&](Index element) { note_use(element); });
        });
    }

    void check() {
        for_each_child(document_, geometry_, "LayerElementColor", [&](Index layer) { check(layer); });
    }

private:
    void note_use(Index element) {
        const Index type = find_child(document_, element, "Type");
        const Index index = find_child(document_, element, "TypedIndex");
        if (type == none || index == none) return;
        if (text_of(document_, document_.nodes[type], 0) != "LayerElementColor") return;
        if (const auto number = number_of(document_, document_.nodes[index], 0)) used_.insert(*number);
    }

    [[nodiscard]] std::string word(Index layer, std::string_view name) const {
        const Index node = find_child(document_, layer, name);
        return node == none ? std::string() : text_of(document_, document_.nodes[node], 0).value_or(std::string());
    }

    // How many colours or, where they are chosen by index, how many choices; 0: the layer is empty.
    [[nodiscard]] std::uint64_t check_entries(Index layer) const {
        const Index colors = find_child(document_, layer, "Colors");
        if (colors == none) refuse(document_, document_.nodes[layer], "holds no Colors");
        const std::uint64_t color_count = count_elements(document_, document_.nodes[colors], 4);
        const Index choices = find_child(document_, layer, "ColorIndex");
        const std::string reference = word(layer, "ReferenceInformationType");
        if (reference != "Direct" && reference != "IndexToDirect")
            refuse(document_, document_.nodes[layer],
                   "is referred to by " + in_quotes(reference) + ", which is not read (Direct and IndexToDirect are)");
        if (reference == "Direct" || choices == none) return color_count;
        const std::vector<double> indices = array_of(document_, document_.nodes[choices]);
        for (const double index : indices) {
            if (!(index >= 0 && index < static_cast<double>(color_count)))
                refuse(document_, document_.nodes[choices],
                       "chooses colour " + std::to_string(static_cast<std::int64_t>(index)) + ", where " +
                           counted(color_count, "colour is", "colours are") + " there");
        }
        return indices.size();
    }

    void check(Index layer) {
        const Node& node = document_.nodes[layer];
        const std::uint64_t entries = check_entries(layer);
        if (entries == 0) return;
        const std::string mapping = word(layer, "MappingInformationType");
        const auto number = number_of(document_, node, 0);
        if (mapping == "ByPolygon") {
            unread_.colored_faces += counts_.polygons;
            return;
        }
        if (mapping != "ByVertice" && mapping != "ByPolygonVertex") {
            throw Error(ErrorKind::bad_input,
                        (document_.is_binary ? "byte " : "line ") + std::to_string(node.place) + ": the colour layer " +
                            in_quotes(word(layer, "Name")) + " (LayerElementColor) is mapped " + in_quotes(mapping) +
                            ", which is not read, and locks in it would be lost; export vertex colours mapped "
                            "ByPolygonVertex or ByVertice");
        }
        const std::uint64_t wanted = mapping == "ByVertice" ? counts_.vertices : counts_.corners;
        if (entries != wanted)
            refuse(document_, node,
                   in_quotes(word(layer, "Name")) + " holds " + std::to_string(entries) + " colours mapped " + mapping +
                       ", where the mesh has " + std::to_string(wanted) +
                       (mapping == "ByVertice" ? " vertices" : " corners of polygons"));
        if (!number || !used_.contains(*number))
            refuse(document_, node,
                   in_quotes(word(layer, "Name")) + " holds colours, but no Layer of the mesh names it");
    }

    const Document& document_;
    Index geometry_;
    Counts counts_;
    Unread& unread_;
    std::set<double> used_;  // TypedIndex of the colour layers that a Layer names
};

void check_geometry(const Document& document, Index geometry, Purpose purpose, Unread& unread) {
    const Index vertices = find_child(document, geometry, "Vertices");
    const Index polygons = find_child(document, geometry, "PolygonVertexIndex");
    if (vertices == none || polygons == none) return;  // nothing to read
    const Counts counts = check_polygons(document, document.nodes[vertices], document.nodes[polygons]);
    if (purpose == Purpose::shell) ColorLayers(document, geometry, counts, unread).check();
}

}

void check_meshes(const Document& document, Purpose purpose, Unread& unread) {
    for_each_child(document, 0, "Objects", [&](Index objects) {
        for_each_child(document, objects, "Geometry", [&](Index geometry) {
            if (text_of(document, document.nodes[geometry], 2) == "Mesh")
                check_geometry(document, geometry, purpose, unread);
        });
    });
}

}
