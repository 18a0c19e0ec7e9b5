// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/shell_interior.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/error.h"
#include "geometry/measures.h"
#include "geometry/winding_number.h"

namespace crumple {

namespace {

// On a surface the winding number is one half to rounding: without a margin noise would decide there.
constexpr double inside_threshold = 0.5 + 1e-9;

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

bool contains(const Box& box, Vec3 p) {
    return p.x >= box.low.x && p.y >= box.low.y && p.z >= box.low.z && p.x <= box.high.x && p.y <= box.high.y &&
           p.z <= box.high.z;
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

}

struct ShellInterior::Parts {
    std::vector<WindingNumber> winding;  // C
    std::vector<Box> boxes;              // C
    std::vector<Role> roles;             // C
    std::vector<Index> by_volume;        // C components, least volume first
};

ShellInterior::ShellInterior(const Shell& shell) : parts_(std::make_unique<Parts>()) {
    const std::vector<Part> parts = split_by_component(shell);
    for (const Part& part : parts) {
        parts_->winding.emplace_back(shell.positions, part.triangles);
        parts_->boxes.push_back(part.box);
    }
    for (const Component& component : shell.components) parts_->roles.push_back(component.role);
    parts_->by_volume.resize(parts.size());
    std::iota(parts_->by_volume.begin(), parts_->by_volume.end(), Index{0});
    std::stable_sort(parts_->by_volume.begin(), parts_->by_volume.end(), [&](Index a, Index b) {
        if (parts[a].volume != parts[b].volume) return parts[a].volume < parts[b].volume;
        return lexicographic_less(parts[a].first, parts[b].first);
    });
}

ShellInterior::~ShellInterior() = default;

Index ShellInterior::innermost(Vec3 p) const {
    for (const Index component : parts_->by_volume) {
        // Nothing outside its box is inside a component, whatever an open one's winding number says there.
        if (contains(parts_->boxes[component], p) && winding(component, p) > inside_threshold) return component;
    }
    return none;
}

Index ShellInterior::material_at(Vec3 p) const {
    const Index component = innermost(p);
    return component != none && parts_->roles[component] == Role::cavity ? none : component;
}

double ShellInterior::winding(Index component, Vec3 p) const { return std::fabs(parts_->winding[component].at(p)); }

std::span<const Index> ShellInterior::by_volume() const { return parts_->by_volume; }

}
