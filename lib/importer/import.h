// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the artist's files with assimp in a limited child process, welds, cleans and judges them. The only place with
// assimp. Locks: red < 0.5 / 255 of a finite value; keyed by position, so they survive every way a format splits vertices.
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

inline constexpr int version = 1;

struct Params {};
struct Report {};

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

// Throws Error(file) for a path that cannot be opened, Error(bad_input) for content that is refused.
[[nodiscard]] Result import_asset(const Sources& sources, const Params& params = {}, const Context& context = {});

}
