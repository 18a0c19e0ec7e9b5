// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/dae_nodes.h"

#include <cmath>

#include "core/error.h"
#include "formats/printable.h"

namespace crumple::formats::dae {

namespace {

using xml::Element;

// A few hundred bytes each in the reader, and this look calls itself for each level.
constexpr std::uint64_t most_nodes = 1'000'000;
constexpr int deepest = 2000;

void check_transform(const Element& element) {
    constexpr std::pair<std::string_view, std::size_t> sizes[] = {{"matrix", 16}, {"translate", 3}, {"rotate", 4},
                                                                  {"scale", 3},   {"lookat", 9},    {"skew", 7}};
    for (const auto& [name, size] : sizes) {
        if (element.name != name) continue;
        const std::vector<double> values = reals(element);
        if (values.size() != size)
            refuse(element, "holds " + std::to_string(values.size()) + " numbers, not " + std::to_string(size));
        for (const double value : values) {
            if (!std::isfinite(value)) refuse(element, "holds a number that is not finite");
        }
    }
}

// Counts what the scene comes to once each <instance_node> stands for all below its node.
class NodeCount {
public:
    explicit NodeCount(const Document& document) : document_(document), state_(document.elements.size()) {
        for (std::size_t e = 0; e < document.elements.size(); ++e) {
            const Element& element = document.elements[e];
            const auto name = xml::attribute(element, "name");
            if (element.name == "node" && name) by_name_.try_emplace(*name, static_cast<Index>(e));
        }
    }

    std::uint64_t at_and_below(Index node, int depth) {
        const Element& element = document_.elements[node];
        State& state = state_[node];
        if (state.is_open) refuse(element, "is drawn within itself");
        if (state.count > 0) return state.count;
        if (depth > deepest) refuse(element, "is nested more than " + std::to_string(deepest) + " deep");
        state.is_open = true;
        std::uint64_t count = 1;
        for (Index c = element.first_child; c != none; c = document_.elements[c].next_sibling) {
            const Element& child = document_.elements[c];
            check_transform(child);
            const Index next = child.name == "node" ? c : child.name == "instance_node" ? target_of(child) : none;
            if (next != none) count += at_and_below(next, depth + 1);
            if (count > most_nodes) refuse_count(element);
        }
        state.is_open = false;
        return state.count = count;
    }

    [[noreturn]] static void refuse_count(const Element& element) {
        throw Error(ErrorKind::bad_input, xml::line(element) + xml::tag(element) + " and what is drawn in it come to " +
                                              "more than " + std::to_string(most_nodes) +
                                              " nodes; export fewer instances, or their meshes joined");
    }

private:
    struct State {
        std::uint64_t count = 0;  // 0: not counted yet
        bool is_open = false;     // being counted
    };

    // assimp takes the name of a node for an id too.
    [[nodiscard]] Index target_of(const Element& instance) const {
        std::string_view url = xml::attribute(instance, "url").value_or(std::string_view());
        const Index target = find(document_, url);
        if (target != none && document_.elements[target].name == "node") return target;
        if (url.starts_with('#')) url.remove_prefix(1);
        const auto named = by_name_.find(url);
        return named == by_name_.end() ? none : named->second;
    }

    const Document& document_;
    std::map<std::string_view, Index> by_name_;
    std::vector<State> state_;
};

}

void check_nodes(const Document& document) {
    NodeCount nodes(document);
    std::uint64_t count = 0;
    for (std::size_t e = 0; e < document.elements.size(); ++e) {
        if (document.elements[e].name != "visual_scene") continue;
        xml::for_each_child(document.elements, static_cast<Index>(e), "node",
                            [&](Index node) { count += nodes.at_and_below(node, 0); });
        if (count > most_nodes) NodeCount::refuse_count(document.elements[e]);
    }
}

void check_unit(const Document& document) {
    const Index asset = xml::find_child(document.elements, 0, "asset");
    const Index unit = asset == none ? none : xml::find_child(document.elements, asset, "unit");
    const auto meter = unit == none ? std::nullopt : xml::attribute(document.elements[unit], "meter");
    if (!meter) return;
    Element element = document.elements[unit];
    element.text = *meter;
    const std::vector<double> values = reals(element);
    if (values.size() != 1 || !(values[0] > 0) || !std::isfinite(values[0]) || meter->find(',') != meter->npos)
        refuse(document.elements[unit], "says that its unit is " + in_quotes(*meter) + " metres, which is no length");
}

}
