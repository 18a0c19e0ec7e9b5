// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the artist's files with assimp in a limited child process, welds, cleans and judges them. The only place with
// assimp. Locks: red < 0.5 / 255 of a finite value; keyed by position, so they survive every way a format splits
// vertices.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/context.h"
#include "core/fields.h"
#include "core/finding.h"
#include "mesh/asset.h"

namespace crumple::importer {

inline constexpr int version = 2;

// Which axis of the file points up. Y up is ours: z maps (x, y, z) to (x, z, -y), x maps it to (-y, x, z).
enum class Up { automatic, x, y, z };
inline constexpr EnumName<Up> up_names[] = {{Up::automatic, "auto"}, {Up::x, "x"}, {Up::y, "y"}, {Up::z, "z"}};
constexpr std::span<const EnumName<Up>> enum_names(Up) { return up_names; }

enum class ColorSpace { linear, srgb };
inline constexpr EnumName<ColorSpace> color_space_names[] = {{ColorSpace::linear, "linear"},
                                                             {ColorSpace::srgb, "srgb"}};
constexpr std::span<const EnumName<ColorSpace>> enum_names(ColorSpace) { return color_space_names; }

struct Params {
    double unit = 0;        // metres per unit of the files; 0: what the file says, else 1
    Up up = Up::automatic;  // automatic: what the file says, else Y
    std::uint32_t color_set = 0;
    ColorSpace color_space = ColorSpace::linear;  // of the stored colours; locks are judged on the stored values
    std::map<std::string, Role> roles;            // by component, mesh or material name
    std::map<std::string, std::string> owners;    // by visual mesh: the shell component it hangs on
    bool strict = false;
    double weld_tolerance = 1e-6;  // times the box diagonal
    double thicken = 0;            // metres given to single sheets, 0: none
    std::uint32_t cage = 0;        // cells of a lattice along the asset's longest side, 0: none
    std::uint32_t memory_mb = 8192;
    double time_s = 120;
};

template <class Visitor, FieldsOf<Params> P>
void describe(Visitor& visit, P& p) {
    visit.field("unit", p.unit, Range{0, 1e6}, "metres per unit of the files; 0: what the file says, else 1");
    visit.field("up", p.up, "axis of the files that points up; auto: what the file says, else y");
    visit.field("color_set", p.color_set, Range{0, 7}, "which vertex colour set holds the paint");
    visit.field("color_space", p.color_space, "of the stored colours; locks are judged on the stored red either way");
    visit.field("roles", p.roles,
                "solid, cavity or rigid by component, mesh or material name; else from winding and nesting");
    visit.field("owners", p.owners,
                "shell component that a visual mesh hangs on alone, by the mesh's name; else each vertex on whichever "
                "contains it or is nearest");
    visit.field("strict", p.strict, "copies of a vertex that disagree about its lock are an error");
    visit.field("weld_tolerance", p.weld_tolerance, Range{0, 0.01},
                "where exact welding leaves edges open, vertices this near merge; times the box diagonal");
    visit.field("thicken", p.thicken, Range{0, 1e6},
                "metres: parts of the shell that are not closed become solids of this thickness; 0: they stay open");
    visit.field(
        "cage", p.cage, Range{0, 64},
        "when above 0, a lattice with so many cells along the longest side takes the shell's place: for a shell "
        "that cannot be closed");
    visit.field("memory_mb", p.memory_mb, Range{16, 1048576}, "memory the reader of a file may use, MiB");
    visit.field("time_s", p.time_s, Range{0.001, 86400}, "seconds the reader of a file may take");
}

// What one file held, before anything was changed.
struct FileReport {
    std::string name;       // "shell" or the visual mesh's name
    std::string format;     // "Wavefront OBJ", ...
    std::string generator;  // the program that wrote it, where the file says
    double unit = 1;        // metres per unit of the file, as applied
    std::string up;         // axis that points up, as applied
    std::uint64_t meshes = 0;
    std::uint64_t vertices = 0;             // as the file counts them, where the format tells, else one a face corner
    std::uint64_t triangles = 0;            // after splitting polygons
    std::uint64_t points_and_lines = 0;     // dropped
    std::uint64_t unreadable_polygons = 0;  // dropped: no triangles came out of them
};

template <class Visitor, FieldsOf<FileReport> R>
void describe(Visitor& visit, R& r) {
    visit.field("name", r.name, "shell, or the visual mesh's name");
    visit.field("format", r.format, "file format");
    visit.field("generator", r.generator, "program that wrote the file, where the file says");
    visit.field("unit", r.unit, "metres per unit of the file, as applied");
    visit.field("up", r.up, "axis of the file that points up, as applied");
    visit.field("meshes", r.meshes, "mesh instances in the file");
    visit.field("vertices", r.vertices, "vertices in the file");
    visit.field("triangles", r.triangles, "triangles in the file, polygons split");
    visit.field("points_and_lines", r.points_and_lines, "points and lines, dropped");
    visit.field("unreadable_polygons", r.unreadable_polygons, "polygons that could not be split, dropped");
}

struct ComponentReport {
    std::string name;
    std::string material;
    Role role = Role::solid;
    std::string reason;
    std::string parent;  // name of the innermost component that contains it, empty: none
    std::uint64_t triangles = 0;
    double volume = 0;
    bool is_closed = false;
    bool is_inward = false;
};

template <class Visitor, FieldsOf<ComponentReport> R>
void describe(Visitor& visit, R& r) {
    visit.field("name", r.name, "node, mesh or group name of the file, made unique");
    visit.field("material", r.material, "material name of the file");
    visit.field("role", r.role, "what the space inside is");
    visit.field("reason", r.reason, "why it has that role");
    visit.field("parent", r.parent, "innermost component that contains it");
    visit.field("triangles", r.triangles, "triangles");
    visit.field("volume", r.volume, "cubic metres enclosed");
    visit.field("is_closed", r.is_closed, "no open edge");
    visit.field("is_inward", r.is_inward, "wound inwards in the file");
}

struct Report {
    FileReport shell;
    std::vector<FileReport> visuals;
    std::uint64_t vertices = 0;  // of the shell, welded
    std::uint64_t triangles = 0;
    double diagonal = 0;                    // of the shell's box, metres
    std::uint64_t welded = 0;               // copies merged for having the same position
    std::uint64_t welded_by_tolerance = 0;  // merged because edges stayed open
    double weld_distance = 0;               // the largest distance a vertex moved by that, metres
    std::uint64_t unused_vertices = 0;
    std::uint64_t repeated_index_triangles = 0;
    std::uint64_t zero_area_triangles = 0;
    std::uint64_t duplicate_triangles = 0;
    std::uint64_t flipped_triangles = 0;  // turned to agree with their neighbours
    std::uint64_t open_edges = 0;
    std::uint64_t non_manifold_edges = 0;
    std::uint64_t self_intersections = 0;  // pairs of triangles
    std::uint64_t holes = 0;               // boundary loops
    double largest_hole = 0;               // its box, in diagonals of the shell's
    double leak_share = 0;                 // of the volume, where inside and outside are a guess
    std::uint64_t thickened_triangles = 0;
    std::uint64_t color_sets = 0;
    std::uint64_t painted_copies = 0;  // vertices of the file with red below the threshold
    std::uint64_t locked = 0;          // vertices of the shell
    std::uint64_t lock_conflicts = 0;  // locked vertices with an unlocked copy
    std::vector<ComponentReport> components;
    std::vector<Finding> findings;
};

template <class Visitor, FieldsOf<Report> R>
void describe(Visitor& visit, R& r) {
    visit.field("shell", r.shell, "the shell's file");
    visit.field("visuals", r.visuals, "the visual meshes' files");
    visit.field("vertices", r.vertices, "vertices of the shell, welded");
    visit.field("triangles", r.triangles, "triangles of the shell");
    visit.field("diagonal", r.diagonal, "metres, of the shell's box");
    visit.field("welded", r.welded, "copies merged for having the same position");
    visit.field("welded_by_tolerance", r.welded_by_tolerance, "vertices merged because edges stayed open");
    visit.field("weld_distance", r.weld_distance, "metres, the farthest a vertex moved to be merged");
    visit.field("unused_vertices", r.unused_vertices, "vertices no triangle uses, dropped");
    visit.field("repeated_index_triangles", r.repeated_index_triangles, "triangles with a repeated vertex, dropped");
    visit.field("zero_area_triangles", r.zero_area_triangles, "triangles without area, flipped away");
    visit.field("duplicate_triangles", r.duplicate_triangles, "second copies of a triangle, dropped");
    visit.field("flipped_triangles", r.flipped_triangles, "triangles turned to agree with their neighbours");
    visit.field("open_edges", r.open_edges, "edges with one triangle");
    visit.field("non_manifold_edges", r.non_manifold_edges, "edges with more than two triangles");
    visit.field("self_intersections", r.self_intersections, "pairs of triangles that cross");
    visit.field("holes", r.holes, "loops of open edges");
    visit.field("largest_hole", r.largest_hole, "across the largest hole, share of the shell's diagonal");
    visit.field("leak_share", r.leak_share,
                "share of the volume whose winding number lies between 0.3 and 0.7 among what lies above 0.3, about");
    visit.field("thickened_triangles", r.thickened_triangles, "triangles of open parts that were given a thickness");
    visit.field("color_sets", r.color_sets, "vertex colour sets in the shell's file");
    visit.field("painted_copies", r.painted_copies, "vertices of the file whose red says locked");
    visit.field("locked", r.locked, "locked vertices of the shell");
    visit.field("lock_conflicts", r.lock_conflicts, "locked vertices of which a copy was painted unlocked");
    visit.field("components", r.components, "connected components of the shell");
    visit.field("findings", r.findings, "what a person should know");
}

struct Sources {
    std::string shell;  // path
    struct Visual {
        std::string name;  // as given by --visual NAME=PATH, empty: the file's stem
        std::string path;
    };
    std::vector<Visual> visuals;
};

struct Result {
    Asset asset;
    Report report;
};

// As given, else after the file. Throws Error(usage) for one that is no name, or there twice.
[[nodiscard]] std::vector<std::string> visual_names(const Sources& sources);

// Of the objects in the shell's file, which give the components their names; the file's stem for one it does not name.
// Throws as import_asset. REQUIRES: as import_asset.
[[nodiscard]] std::vector<std::string> shell_object_names(const Sources& sources, const Params& params);

// With params.thicken or params.cage the shell is what they say; otherwise
// vertices of the shell are in the file's order (of their first copy); those of a visual mesh are the file's own
// vertices in the file's order, where the format has an order (OBJ, PLY, OFF, glTF), else one a face corner. Throws
// Error(file) for a path that cannot be opened, Error(usage) for visual names that are not unique, Error(bad_input) for
// content that is refused, its message beginning with the file's name. REQUIRES: no other thread of this process is
// running (see sandbox.h).
[[nodiscard]] Result import_asset(const Sources& sources, const Params& params = {}, const Context& context = {});

}
