// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/tet_fields.h"

#include "core/parallel_for.h"
#include "geometry/measures.h"
#include "quality/element_stiffness.h"
#include "quality/tet_measures.h"

namespace crumple::quality {

TetFields measure_fields(std::span<const Vec3> positions, std::span<const Tet> tets, const Context& context) {
    TetFields fields{std::vector<float>(tets.size()), std::vector<float>(tets.size()), std::vector<float>(tets.size())};
    double volume = 0;
    for (const auto& [a, b, c, d] : tets)
        volume += signed_volume(positions[a], positions[b], positions[c], positions[d]);
    const double regular = volume > 0 ? regular_step(volume / static_cast<double>(tets.size())) : 1;
    parallel_for(context, tets.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
            const auto& [a, b, c, d] = tets[t];
            const TetMeasures shape = measure_tet(positions[a], positions[b], positions[c], positions[d]);
            const double step = measure_stiffness(positions[a], positions[b], positions[c], positions[d]).step;
            fields.min_dihedral_deg[t] = static_cast<float>(degrees_of(shape.min_dihedral));
            fields.volume_lrms3[t] = static_cast<float>(shape.volume_lrms3);
            fields.element_step_ratio[t] = static_cast<float>(step / regular);
        }
    });
    return fields;
}

}
