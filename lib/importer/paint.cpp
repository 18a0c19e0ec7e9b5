// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/paint.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/counted.h"
#include "core/error.h"
#include "formats/color.h"

namespace crumple::importer {

namespace {

bool has_color(const Surface& surface, std::size_t v) { return surface.parts[surface.vertex_part[v]].has_color; }

// Only whole numbers, some above 1: colours 0..255. A high-dynamic-range red of 1.5 is not one of 255 parts.
bool holds_bytes(const Surface& surface) {
    bool any_above_one = false;
    for (std::size_t v = 0; v < surface.colors.size(); ++v) {
        if (!has_color(surface, v)) continue;
        for (int channel = 0; channel < 3; ++channel) {
            const float value = surface.colors[v][static_cast<std::size_t>(channel)];
            if (!(value >= 0) || value > 255 || value != std::floor(value)) return false;
            any_above_one = any_above_one || value > 1;
        }
    }
    return any_above_one;
}

void scale_bytes(Surface& surface) {
    for (std::size_t v = 0; v < surface.colors.size(); ++v) {
        if (!has_color(surface, v)) continue;
        for (std::size_t channel = 0; channel < 3; ++channel) surface.colors[v][channel] /= 255;
        if (surface.colors[v][3] > 1) surface.colors[v][3] /= 255;  // assimp fills in 1 where the file has no alpha
    }
}

// IEC 61966-2-1.
float linear_from_srgb(float value) {
    return value <= 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
}

void make_linear(Surface& surface) {
    for (std::size_t v = 0; v < surface.colors.size(); ++v) {
        if (!has_color(surface, v)) continue;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            surface.colors[v][channel] = linear_from_srgb(surface.colors[v][channel]);
        }
    }
}

Place place_of(const Surface& surface, std::size_t v) {
    return {surface.positions[v], surface.source_vertex[v],
            surface.objects[surface.parts[surface.vertex_part[v]].object].name};
}

// Vertices of the file, each once: formats split them by corner, and instances repeat them.
class FileVertices {
public:
    explicit FileVertices(const Surface& surface) : surface_(surface), is_met_(surface.source_vertex_count, false) {}

    // Whether v of the surface is the first copy that this is asked about.
    bool meets(std::size_t v) {
        const Index vertex = surface_.source_vertex[v];
        const bool is_first = !is_met_[vertex];
        is_met_[vertex] = true;
        return is_first;
    }

private:
    const Surface& surface_;
    std::vector<bool> is_met_;
};

// Counts vertices of which `is_odd` holds, and remembers where the first are.
template <class IsOdd>
void find_odd_vertices(const Surface& surface, const char* code, const char* message, IsOdd&& is_odd,
                       std::vector<Finding>& findings) {
    Finding finding{code, Severity::warning, message, 0, {}};
    FileVertices vertices(surface);
    for (std::size_t v = 0; v < surface.colors.size(); ++v) {
        if (has_color(surface, v) && is_odd(surface.colors[v][0]) && vertices.meets(v))
            count_one(finding, place_of(surface, v));
    }
    if (finding.count > 0) findings.push_back(std::move(finding));
}

std::size_t count_sets(const Scene& scene) {
    std::size_t count = 0;
    for (const SceneMesh& mesh : scene.meshes) count = std::max(count, mesh.colors.size());
    return count;
}

std::uint64_t locked_in_set(const Scene& scene, std::size_t set) {
    std::uint64_t count = 0;
    for (const SceneMesh& mesh : scene.meshes) {
        if (set >= mesh.colors.size()) continue;
        for (const Color& color : mesh.colors[set]) count += formats::is_locked(color[0]);
    }
    return count;
}

// Set 0 is what is read unless someone asks: only then can paint in another set be an oversight.
void find_other_sets(const Scene& scene, std::size_t set_count, std::uint32_t chosen, std::vector<Finding>& findings) {
    if (chosen != 0) return;
    for (std::size_t set = 0; set < set_count; ++set) {
        if (set == chosen) continue;
        const std::string name = std::to_string(set);
        const std::uint64_t locked = locked_in_set(scene, set);
        findings.push_back({"COLOR_SET_UNUSED",
                            Severity::warning,
                            "the file also has colour set " + name + " (COLOR_" + name + "), where " +
                                counted(locked, "vertex has", "vertices have") + " red 0; only set " +
                                std::to_string(chosen) + " is read (--color-set " + name + " reads the other)",
                            locked,
                            {}});
    }
}

void find_uncolored_parts(const Surface& surface, std::vector<Finding>& findings) {
    Finding finding{"COLOR_MISSING", Severity::warning, "", 0, {}};
    std::vector<bool> placed(surface.parts.size(), false);
    for (std::size_t p = 0; p < surface.parts.size(); ++p) finding.count += !surface.parts[p].has_color;
    if (finding.count == 0 || finding.count == surface.parts.size()) return;
    for (std::size_t v = 0; v < surface.positions.size() && wants_place(finding); ++v) {
        const Index part = surface.vertex_part[v];
        if (surface.parts[part].has_color || placed[part]) continue;
        placed[part] = true;
        finding.places.push_back(place_of(surface, v));
    }
    finding.message = std::to_string(finding.count) + " of " + std::to_string(surface.parts.size()) + " meshes " +
                      (finding.count == 1 ? "has" : "have") +
                      " no colours: nothing there is locked; paint all, white where free";
    findings.push_back(std::move(finding));
}

void check_set_exists(std::size_t set_count, std::uint32_t chosen) {
    if (chosen == 0 || chosen < set_count) return;
    std::string known = set_count == 0 ? "the file has no vertex colours" : "the file has set 0";
    for (std::size_t set = 1; set < set_count; ++set) known += ", " + std::to_string(set);
    throw Error(ErrorKind::usage,
                "import.color_set (--color-set): there is no colour set " + std::to_string(chosen) + "; " + known);
}

}

PaintedVertices read_paint(const Scene& scene, const formats::Format& format, const Params& params, Surface& surface) {
    PaintedVertices result;
    result.set_count = count_sets(scene);
    result.paint.assign(surface.positions.size(), Paint::none);
    check_set_exists(result.set_count, params.color_set);
    find_other_sets(scene, result.set_count, params.color_set, result.findings);
    const bool any =
        std::any_of(surface.parts.begin(), surface.parts.end(), [](const Part& part) { return part.has_color; });
    if (!any) {
        surface.colors.clear();
        return result;
    }
    find_uncolored_parts(surface, result.findings);
    if (format.may_hold_byte_colors && holds_bytes(surface)) scale_bytes(surface);
    FileVertices locked(surface);
    for (std::size_t v = 0; v < surface.colors.size(); ++v) {
        if (!has_color(surface, v)) continue;
        result.paint[v] = formats::is_locked(surface.colors[v][0]) ? Paint::locked : Paint::free;
        if (result.paint[v] == Paint::locked) result.locked_count += locked.meets(v);
    }
    find_odd_vertices(
        surface, "COLOR_NOT_FINITE", "red is not a finite number: these vertices are not locked",
        [](float red) { return !std::isfinite(red); }, result.findings);
    find_odd_vertices(
        surface, "LOCK_NEARLY_ZERO",
        "red is not 0 but below 0.5/255: these vertices are locked; an 8-bit colour converted from sRGB to "
        "linear can get there, so paint red 8 or more where free",
        [](float red) { return red != 0 && formats::is_locked(red); }, result.findings);
    if (params.color_space == ColorSpace::srgb) make_linear(surface);
    return result;
}

}
