// SPDX-License-Identifier: GPL-3.0-or-later
// A look at the file's own bytes before assimp reads it: refuses what assimp would silently spoil, and keeps what it
// loses: the numbers as the text states them (assimp's parser is up to a few ulp off) and the order of OBJ vertices.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/vec3.h"
#include "formats/format.h"
#include "formats/unread.h"

namespace crumple::formats {

using Affine = std::array<double, 12>;  // 3 x 4 row-major

enum class Purpose { shell, visual };

// A number of the text: the nearest float, and what assimp's parser makes of it.
struct ReadNumber {
    float read = 0;
    float exact = 0;
};

// A file that belongs to a glTF file.
struct ExternalBuffer {
    std::string uri;         // as the file says
    std::string name;        // in Prescan::surface_only
    std::uint64_t size = 0;  // bytes it must have at least
};

struct Prescan {
    std::vector<Vec3f> positions;         // the file's vertices in order, nearest float; empty: nothing to restore
    std::vector<Vec3f> assimp_positions;  // OBJ: the same as assimp's parser reads them, by which its corners are found
    std::vector<float> reds;              // OBJ, PLY, OFF: of positions, where all have colours
    std::vector<ReadNumber> numbers;      // every number of other text formats, ascending by read, then exact
    std::vector<Affine> transforms;       // glTF: of its nodes
    std::vector<ExternalBuffer> buffers;  // glTF: what it needs of other files
    std::vector<std::string> extensions;  // glTF: required, but not for surface and paint
    std::string surface_only;             // what assimp is to read instead of the file, empty: the file
    std::uint64_t expected_triangles = 0;  // from polygon sizes, 0: not counted
    Unread unread;
};

// Of that format. All throw Error(bad_input) that says where in the file.
[[nodiscard]] Prescan prescan(std::string_view bytes, FormatId format, Purpose purpose);

// A shell's `v` lines have 3 numbers, or all 6 (colours); a visual mesh's may have colours with alpha or a weight of 1
// besides. Objects and materials are not more than assimp can tell apart in a few seconds.
[[nodiscard]] Prescan prescan_obj(std::string_view text, Purpose purpose);

// The header makes sense, the body is as long as it says, holds faces rather than strips, and their indices exist. A
// shell's colours have names, red among them, and a type whose range is agreed upon, and values of that type.
[[nodiscard]] Prescan prescan_ply(std::string_view bytes, Purpose purpose);

// The counts of the header are those of the lines that follow, and each vertex of a shell has the numbers that the
// header's keyword says; one of a visual mesh has three at least.
[[nodiscard]] Prescan prescan_off(std::string_view text, Purpose purpose);

// Binary glTF: the chunks fit the file. Both: version 2, no extension that hides the geometry, no accessor reaches
// beyond its buffer, no node is its own parent. A shell's colours are as many as its vertices.
[[nodiscard]] Prescan prescan_gltf(std::string_view bytes, Purpose purpose = Purpose::shell);

// The files a glTF file needs, without a look at the rest.
[[nodiscard]] std::vector<ExternalBuffer> gltf_buffers(std::string_view bytes);

// COLLADA: the XML is well formed, arrays hold what they announce and are not read past their end, `<p>` holds indices
// of what is there, transforms are finite, what is drawn many times stays of a size, the unit is a length. Keeps
// numbers.
[[nodiscard]] Prescan prescan_dae(std::string_view text, Purpose purpose);

// FBX: the nodes fit the file, arrays hold what they announce, polygons end and name vertices that are there, the unit
// is a length; a shell's colours are mapped in a way that is read, as many as they must be. Keeps the numbers of text.
[[nodiscard]] Prescan prescan_fbx(std::string_view bytes, Purpose purpose);

// X: where it is text, its objects end, meshes hold what they announce and a shell's vertices one colour each. Keeps
// numbers.
[[nodiscard]] Prescan prescan_x(std::string_view bytes, Purpose purpose);

// Collects the numbers of a text file; nothing of another; never throws.
[[nodiscard]] Prescan prescan_numbers(std::string_view bytes);

}
