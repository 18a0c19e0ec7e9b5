// SPDX-License-Identifier: GPL-3.0-or-later
// A shell as the text of an OBJ file.
#pragma once
#include <functional>
#include <sstream>
#include <string>

#include "mesh/shell.h"

namespace crumple::test {

// `v` and `f` lines; red: the red of a vertex, where the shell is to be painted.
inline std::string obj_text(const Shell& shell, const std::function<double(std::size_t)>& red = {}) {
    std::ostringstream text;
    text.precision(9);
    for (std::size_t v = 0; v < shell.positions.size(); ++v) {
        const Vec3& p = shell.positions[v];
        text << "v " << p.x << ' ' << p.y << ' ' << p.z;
        if (red) text << ' ' << red(v) << " 1 1";
        text << '\n';
    }
    for (const Triangle& t : shell.triangles) text << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
    return text.str();
}

}
