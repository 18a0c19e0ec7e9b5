// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces as flatten would give them, made in code.
#pragma once
#include <numeric>
#include <string>
#include <vector>

#include "importer/paint.h"
#include "importer/surface.h"
#include "importer/weld.h"
#include "mesh/shell.h"

namespace crumple::test {

// One object named "thing".
inline importer::Surface surface_of(std::vector<Vec3> positions, std::vector<Triangle> triangles) {
    importer::Surface surface;
    surface.positions = std::move(positions);
    surface.triangles = std::move(triangles);
    surface.source_vertex.resize(surface.positions.size());
    std::iota(surface.source_vertex.begin(), surface.source_vertex.end(), 0u);
    surface.vertex_part.assign(surface.positions.size(), 0);
    surface.part.assign(surface.triangles.size(), 0);
    surface.objects = {{"thing"}};
    surface.parts = {{0, "mesh", "paint", false}};
    surface.source_vertex_count = surface.positions.size();
    return surface;
}

inline importer::Surface surface_of(const Shell& shell) { return surface_of(shell.positions, shell.triangles); }

// Puts b's triangles behind a's as an object of its own.
inline void add_object(importer::Surface& a, const importer::Surface& b, const std::string& name) {
    const auto base = static_cast<Index>(a.positions.size());
    const auto part = static_cast<Index>(a.parts.size());
    a.parts.push_back({static_cast<Index>(a.objects.size()), name + " mesh", name + " paint", false});
    a.objects.push_back({name});
    a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
    for (const Triangle& t : b.triangles) a.triangles.push_back({base + t[0], base + t[1], base + t[2]});
    a.source_vertex.resize(a.positions.size());
    std::iota(a.source_vertex.begin(), a.source_vertex.end(), 0u);
    a.vertex_part.resize(a.positions.size(), part);
    a.part.resize(a.triangles.size(), part);
    a.source_vertex_count = a.positions.size();
}

// Each triangle with three vertices of its own, as flat-shaded formats write it.
inline importer::Surface split_corners(const importer::Surface& from) {
    importer::Surface surface = from;
    surface.positions.clear();
    surface.vertex_part.clear();
    for (std::size_t t = 0; t < from.triangles.size(); ++t) {
        const auto first = static_cast<Index>(surface.positions.size());
        for (const Index v : from.triangles[t]) surface.positions.push_back(from.positions[v]);
        surface.vertex_part.resize(surface.positions.size(), from.part[t]);
        surface.triangles[t] = {first, first + 1, first + 2};
    }
    surface.source_vertex.resize(surface.positions.size());
    std::iota(surface.source_vertex.begin(), surface.source_vertex.end(), 0u);
    surface.source_vertex_count = surface.positions.size();
    return surface;
}

inline importer::PaintedVertices unpainted(const importer::Surface& surface) {
    importer::PaintedVertices painted;
    painted.paint.assign(surface.positions.size(), importer::Paint::none);
    return painted;
}

inline importer::Welded weld_unpainted(const importer::Surface& surface, double tolerance = 1e-6) {
    return importer::weld(surface, unpainted(surface), tolerance);
}

}
