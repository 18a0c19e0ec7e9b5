// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/dae_mesh.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "core/counted.h"
#include "core/error.h"
#include "formats/printable.h"

namespace crumple::formats::dae {

namespace {

using xml::Element;

constexpr std::uint64_t no_limit = none;

std::string_view value_of(const Element& element, std::string_view name) {
    return xml::attribute(element, name).value_or(std::string_view());
}

// COLLADA 1.4.1, section 5: <source> holds an array and an <accessor> that says how to walk over it; <vertices> and the
// primitives name sources by <input>.
class MeshCheck {
public:
    MeshCheck(const Document& document, Purpose purpose) : document_(document), purpose_(purpose) {}

    void check(Index mesh) {
        for (const std::string_view name :
             {"lines", "linestrips", "polygons", "polylist", "triangles", "trifans", "tristrips"}) {
            xml::for_each_child(document_.elements, mesh, name, [&](Index primitive) { check_primitive(primitive); });
        }
    }

private:
    const Element& at(Index element) const { return document_.elements[element]; }

    [[nodiscard]] bool is_read(std::string_view semantic) const {
        return semantic == "POSITION" || (semantic == "COLOR" && purpose_ == Purpose::shell);
    }

    // How many numbers an array holds.
    std::uint64_t array_size(Index array) {
        const auto [known, is_new] = sizes_.try_emplace(array, 0);
        if (!is_new) return known->second;
        const std::uint64_t size = reals(at(array)).size();
        const std::uint64_t announced = number(at(array), "count", 0);
        if (size != announced)
            refuse(at(array), "announces " + std::to_string(announced) + " numbers and holds " + std::to_string(size));
        return known->second = size;
    }

    // How many elements a source has.
    std::uint64_t source_size(Index source) {
        const Index common = xml::find_child(document_.elements, source, "technique_common");
        const Index accessor = common == none ? none : xml::find_child(document_.elements, common, "accessor");
        if (accessor == none) refuse(at(source), "has no <accessor>");
        const Index array = find(document_, value_of(at(accessor), "source"));
        if (array == none || at(array).name != "float_array")
            refuse(at(accessor),
                   "refers to " + in_quotes(value_of(at(accessor), "source")) + ", which is no <float_array>");
        const std::uint64_t count = number(at(accessor), "count", 0);
        if (count > 0) check_reach(at(accessor), count, parameters_of(accessor), array_size(array));
        return count;
    }

    [[nodiscard]] std::uint64_t parameters_of(Index accessor) const {
        std::uint64_t count = 0;
        xml::for_each_child(document_.elements, accessor, "param", [&](Index) { ++count; });
        return count;
    }

    static void check_reach(const Element& accessor, std::uint64_t count, std::uint64_t parameters,
                            std::uint64_t array_size) {
        const std::uint64_t stride = number(accessor, "stride", 1);
        const std::uint64_t offset = number(accessor, "offset", 0);
        if (stride == 0 || stride < parameters)
            refuse(accessor, "has a stride of " + std::to_string(stride) + " under " +
                                 counted(parameters, "parameter", "parameters"));
        if (offset + (count - 1) * stride + std::max<std::uint64_t>(parameters, 1) > array_size)
            refuse(accessor, "reaches beyond its array of " + std::to_string(array_size) + " numbers");
    }

    // How many elements an <input> can be asked for.
    std::uint64_t limit_of(const Element& input) {
        const std::string_view semantic = value_of(input, "semantic");
        if (semantic != "VERTEX" && !is_read(semantic)) return no_limit;
        const Index target = find(document_, value_of(input, "source"));
        const std::string_view wanted = semantic == "VERTEX" ? "vertices" : "source";
        if (target == none || at(target).name != wanted)
            refuse(input,
                   "refers to " + in_quotes(value_of(input, "source")) + ", which is no <" + std::string(wanted) + ">");
        if (semantic != "VERTEX") return source_size(target);
        std::uint64_t limit = no_limit;
        xml::for_each_child(document_.elements, target, "input", [&](Index inner) {
            if (value_of(at(inner), "semantic") != "VERTEX") limit = std::min(limit, limit_of(at(inner)));
        });
        return limit;
    }

    // By place in a corner's group of indices: how many elements there are.
    std::vector<std::uint64_t> limits_of(Index primitive) {
        constexpr std::uint64_t most = 1000;
        std::vector<std::uint64_t> limits;
        xml::for_each_child(document_.elements, primitive, "input", [&](Index input) {
            const std::uint64_t offset = number(at(input), "offset", 0);
            if (offset > most) refuse(at(input), "has an offset of more than " + std::to_string(most));
            if (limits.size() <= offset) limits.resize(offset + 1, no_limit);
            limits[offset] = std::min(limits[offset], limit_of(at(input)));
        });
        if (limits.empty()) limits.push_back(no_limit);
        return limits;
    }

    void check_primitive(Index primitive) {
        const std::vector<std::uint64_t> limits = limits_of(primitive);
        const std::uint64_t corners = announced_corners(primitive);
        xml::for_each_child(document_.elements, primitive, "p",
                            [&](Index list) { check_indices(primitive, at(list), limits, corners); });
    }

    // In each <p>, or no_limit where only the list itself tells.
    std::uint64_t announced_corners(Index primitive) {
        const Element& element = at(primitive);
        const std::uint64_t count = number(element, "count", 0);
        if (element.name == "triangles") return 3 * count;
        if (element.name != "polylist") return no_limit;
        const Index list = xml::find_child(document_.elements, primitive, "vcount");
        const std::vector<Index> sizes = list == none ? std::vector<Index>() : indices(at(list));
        if (sizes.size() != count)
            refuse(element, "announces " + std::to_string(count) + " polygons, and its <vcount> holds " +
                                std::to_string(sizes.size()) + " numbers");
        return std::accumulate(sizes.begin(), sizes.end(), std::uint64_t{0});
    }

    void check_indices(Index primitive, const Element& list, const std::vector<std::uint64_t>& limits,
                       std::uint64_t corners) const {
        const std::vector<Index> values = indices(list);
        const bool fits =
            corners == no_limit ? values.size() % limits.size() == 0 : values.size() == corners * limits.size();
        if (!fits) {
            refuse(list, "holds " + std::to_string(values.size()) + " indices, " + std::to_string(limits.size()) +
                             " a corner, where <" + std::string(at(primitive).name) + "> announces " +
                             (corners == no_limit ? "whole corners" : counted(corners, "corner", "corners")));
        }
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (const std::uint64_t limit = limits[i % limits.size()]; values[i] >= limit && limit != no_limit)
                refuse(list, "holds " + std::to_string(values[i]) + " as number " + std::to_string(i + 1) + ", where " +
                                 counted(limit, "element is", "elements are") + " there");
        }
    }

    const Document& document_;
    Purpose purpose_;
    std::map<Index, std::uint64_t> sizes_;
};

}

void check_meshes(const Document& document, Purpose purpose) {
    MeshCheck check(document, purpose);
    for (std::size_t e = 0; e < document.elements.size(); ++e) {
        if (document.elements[e].name == "mesh") check.check(static_cast<Index>(e));
    }
}

}
