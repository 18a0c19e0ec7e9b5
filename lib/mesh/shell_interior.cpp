// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/shell_interior.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/error.h"
#include "geometry/bvh.h"
#include "geometry/measures.h"
#include "geometry/winding_number.h"

namespace crumple {

namespace {

struct Part {
    std::vector<Triangle> triangles;
    Box box;
    double volume = 0;
    Vec3 first;  // lexicographically: tells apart components of one volume
};

void measure(Part& part, const std::vector<Vec3>& positions) {
    bool is_first = true;
    for (const Triangle& triangle : part.triangles) {
        for (const Index v : triangle) {
            part.box.add(positions[v]);
            if (is_first || lexicographic_less(positions[v], part.first)) part.first = positions[v];
            is_first = false;
        }
    }
    // From the box's centre an open component has a meaningful volume too, and nothing is lost to a far origin.
    const Vec3 centre = (part.box.low + part.box.high) * 0.5;
    for (const Triangle& t : part.triangles) {
        part.volume += signed_volume(centre, positions[t[0]], positions[t[1]], positions[t[2]]);
    }
    part.volume = std::fabs(part.volume);
}

std::vector<Part> split_by_component(const Shell& shell) {
    CRUMPLE_CHECK(shell.component.size() == shell.triangles.size(), "every shell triangle has a component");
    std::vector<Part> parts(shell.components.size());
    for (std::size_t f = 0; f < shell.triangles.size(); ++f) {
        CRUMPLE_CHECK(shell.component[f] < parts.size(), "a shell triangle's component exists");
        for (const Index v : shell.triangles[f])
            CRUMPLE_CHECK(v < shell.positions.size(), "a shell triangle's vertex exists");
        parts[shell.component[f]].triangles.push_back(shell.triangles[f]);
    }
    for (Part& part : parts) measure(part, shell.positions);
    return parts;
}

Box grown(const Box& box, double by) {
    const Vec3 margin{by, by, by};
    return {box.low - margin, box.high + margin};
}

}

// Components in their order, least volume first: the trees number them by rank.
struct ShellInterior::Parts {
    std::vector<WindingNumber> winding;  // C, by rank
    std::vector<Box> boxes;              // C, by rank
    std::vector<Box> near_boxes;         // C, by rank: grown by half a diagonal
    std::vector<Index> by_volume;        // C components
    std::vector<Index> ranks;            // C, by component
    std::vector<Role> roles;             // C, by component
    Bvh tree;                            // over boxes
    Bvh near_tree;                       // over near_boxes
};

ShellInterior::ShellInterior(const Shell& shell) : parts_(std::make_unique<Parts>()) {
    const std::vector<Part> parts = split_by_component(shell);
    for (const Component& component : shell.components) parts_->roles.push_back(component.role);
    parts_->by_volume.resize(parts.size());
    std::iota(parts_->by_volume.begin(), parts_->by_volume.end(), Index{0});
    std::stable_sort(parts_->by_volume.begin(), parts_->by_volume.end(), [&](Index a, Index b) {
        if (parts[a].volume != parts[b].volume) return parts[a].volume < parts[b].volume;
        return lexicographic_less(parts[a].first, parts[b].first);
    });
    parts_->ranks.resize(parts.size());
    for (const Index component : parts_->by_volume) {
        const Part& part = parts[component];
        parts_->ranks[component] = static_cast<Index>(parts_->winding.size());
        parts_->winding.emplace_back(shell.positions, part.triangles);
        parts_->boxes.push_back(part.box);
        parts_->near_boxes.push_back(grown(part.box, part.box.diagonal() / 2));
    }
    parts_->tree = Bvh(parts_->boxes);
    parts_->near_tree = Bvh(parts_->near_boxes);
}

ShellInterior::~ShellInterior() = default;

Index ShellInterior::innermost(Vec3 p, Index except) const {
    Index best = none;
    parts_->tree.containing(p, [&](Index rank) {
        if (rank >= best || parts_->by_volume[rank] == except) return false;
        // Nothing outside its box is inside a component, whatever an open one's winding number says there.
        if (parts_->boxes[rank].holds(p) && parts_->winding[rank].encloses(p)) best = rank;
        return false;
    });
    return best == none ? none : parts_->by_volume[best];
}

Index ShellInterior::material_at(Vec3 p) const {
    const Index component = innermost(p);
    return component != none && parts_->roles[component] == Role::cavity ? none : component;
}

double ShellInterior::winding(Index component, Vec3 p) const {
    return std::fabs(parts_->winding[parts_->ranks[component]].at(p));
}

double ShellInterior::material_winding(Vec3 p) const {
    double largest = 0;
    parts_->near_tree.containing(p, [&](Index rank) {
        const bool has_material = parts_->roles[parts_->by_volume[rank]] != Role::cavity;
        if (has_material && parts_->near_boxes[rank].holds(p))
            largest = std::max(largest, std::fabs(parts_->winding[rank].at(p, 0.01)));
        return false;
    });
    return largest;
}

bool ShellInterior::is_on_surface(Vec3 p) const {
    bool is_on = false;
    parts_->tree.containing(p, [&](Index rank) {
        is_on = parts_->winding[rank].is_on_surface(p);
        return is_on;
    });
    return is_on;
}

std::span<const Index> ShellInterior::by_volume() const { return parts_->by_volume; }

Index ShellInterior::rank(Index component) const { return parts_->ranks[component]; }

}
