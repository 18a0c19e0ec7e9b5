// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/golden_bar.h"

#include <fstream>

#include "core/error.h"
#include "solver/body.h"

namespace crumple::calculix {

Bundle golden_bar(const Material& material) {
    std::ifstream file(CRUMPLE_SOURCE_DIR "/tests/reference/bar_5k.txt");
    std::size_t node_count = 0, tet_count = 0;
    file >> node_count >> tet_count;
    if (node_count > 10000 || tet_count > 10000) throw Error(ErrorKind::bad_input, "bar_5k.txt: counts");
    std::vector<Vec3f> nodes(node_count);
    std::vector<Tet> tets(tet_count);
    for (Vec3f& p : nodes) file >> p.x >> p.y >> p.z;
    for (Tet& tet : tets) {
        for (Index& node : tet) file >> node;
    }
    if (!file || tets.empty()) throw Error(ErrorKind::bad_input, "bar_5k.txt: it is not there or ends early");
    return solver::test::bundle_of(std::move(nodes), std::move(tets), material, [](Vec3f p) { return p.x < 1e-4f; });
}

}
