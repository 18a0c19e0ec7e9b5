// SPDX-License-Identifier: GPL-3.0-or-later
// The few lines of OBJ that the shared shells use, read without the importer: one component for each connected part; a
// part wound inwards is a cavity.
#pragma once
#include <fstream>
#include <numeric>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "geometry/measures.h"
#include "mesh/shell.h"
#include "shared_data.h"

namespace crumple::shapes {

inline void split_into_components(Shell& shell) {
    std::vector<Index> root(shell.positions.size());
    std::iota(root.begin(), root.end(), Index{0});
    const auto find = [&](Index v) {
        while (root[v] != v) v = root[v] = root[root[v]];
        return v;
    };
    for (const Triangle& t : shell.triangles) {
        root[find(t[1])] = find(t[0]);
        root[find(t[2])] = find(t[0]);
    }
    std::vector<Index> number(shell.positions.size(), none);
    std::vector<double> volume;
    for (const Triangle& t : shell.triangles) {
        Index& c = number[find(t[0])];
        if (c == none) {
            c = static_cast<Index>(volume.size());
            volume.push_back(0);
        }
        shell.component.push_back(c);
        volume[c] += signed_volume({}, shell.positions[t[0]], shell.positions[t[1]], shell.positions[t[2]]);
    }
    for (const double v : volume) {
        Component component;
        component.role = v < 0 ? Role::cavity : Role::solid;
        component.volume = std::abs(v);
        shell.components.push_back(component);
    }
}

inline std::optional<Shell> read_obj_shell(const std::filesystem::path& path) {
    std::ifstream file(path);
    if (!file) return std::nullopt;
    Shell shell;
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string kind;
        words >> kind;
        if (kind == "v") {
            Vec3 p;
            words >> p.x >> p.y >> p.z;
            shell.positions.push_back(round_to_float(p));
        } else if (kind == "f") {
            std::vector<Index> corners;
            for (std::string corner; words >> corner;) corners.push_back(static_cast<Index>(std::stoul(corner)) - 1);
            for (std::size_t i = 2; i < corners.size(); ++i) {
                shell.triangles.push_back({corners[0], corners[i - 1], corners[i]});
            }
        }
    }
    shell.locked.assign(shell.positions.size(), 0);
    split_into_components(shell);
    return shell;
}

}
