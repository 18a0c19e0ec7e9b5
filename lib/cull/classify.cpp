// SPDX-License-Identifier: GPL-3.0-or-later
#include "cull/classify.h"

#include <algorithm>

#include "core/parallel_for.h"
#include "mesh/tet_clearance.h"

namespace crumple::cull {

namespace {

using Weights = std::array<double, 4>;
using Corners4 = std::array<Vec3, 4>;

Vec3 place(const Corners4& tet, const Weights& w) {
    return tet[0] * w[0] + tet[1] * w[1] + tet[2] * w[2] + tet[3] * w[3];
}

// Few components meet in one tet, whatever their number.
class Votes {
public:
    // Returns how many that component has now.
    std::uint32_t add(Index component) {
        const auto found =
            std::find_if(votes_.begin(), votes_.end(), [&](const Vote& v) { return v.component == component; });
        if (found != votes_.end()) return ++found->count;
        votes_.push_back({component, 1});
        return 1;
    }

    // Of equally voted ones the innermost, as everywhere.
    [[nodiscard]] Index winner(const ShellInterior& interior) const {
        const auto before = [&](const Vote& a, const Vote& b) {
            return a.count != b.count ? a.count > b.count : interior.rank(a.component) < interior.rank(b.component);
        };
        return votes_.empty() ? none : std::min_element(votes_.begin(), votes_.end(), before)->component;
    }

private:
    struct Vote {
        Index component;
        std::uint32_t count;
    };
    std::vector<Vote> votes_;
};

class Classifier {
public:
    Classifier(const Shell& shell, const ShellInterior& interior, const ShellSolid& solid, const Params& params)
        : interior_(interior),
          all_closed_(solid.all_closed),
          estimates_volume_(!solid.is_exact()),
          clearance_(shell),
          few_(sample_pattern(4)),
          many_(sample_pattern(params.samples)),
          min_inside_(params.min_inside) {}

    [[nodiscard]] Verdict judge(const Corners4& tet) const {
        const Vec3 middle = place(tet, {0.25, 0.25, 0.25, 0.25});
        Verdict verdict;
        verdict.winding = all_closed_ ? 0 : interior_.material_winding(middle);
        if (clearance_.is_clear(tet)) {
            verdict.region = interior_.material_at(middle);
            verdict.inside = verdict.region == none ? 0 : 1;
            // No surface within: where every shell is closed one point speaks for all, else a few must agree.
            if (all_closed_ || agrees(tet, verdict.region)) return verdict;
        }
        return vote(tet, verdict);
    }

private:
    [[nodiscard]] bool agrees(const Corners4& tet, Index region) const {
        return std::all_of(few_.begin(), few_.end(),
                           [&](const Weights& w) { return interior_.material_at(place(tet, w)) == region; });
    }

    [[nodiscard]] Verdict vote(const Corners4& tet, Verdict verdict) const {
        verdict.straddles = true;
        Votes votes;
        std::uint32_t in_material = 0;
        std::uint32_t most = 0;
        const auto count = static_cast<double>(many_.size());
        for (std::size_t i = 0; i < many_.size(); ++i) {
            const Index region = interior_.material_at(place(tet, many_[i]));
            if (region != none) {
                ++in_material;
                most = std::max(most, votes.add(region));
            }
            // The share itself is needed only to estimate a volume that cannot be computed.
            if (estimates_volume_) continue;
            const auto reachable = static_cast<double>(in_material + many_.size() - 1 - i);
            if (reachable <= min_inside_ * count) return verdict;
            if (most > std::max(min_inside_, 0.5) * count) break;
        }
        verdict.inside = in_material / count;
        verdict.region = verdict.inside > min_inside_ ? votes.winner(interior_) : none;
        return verdict;
    }

    const ShellInterior& interior_;
    bool all_closed_;
    bool estimates_volume_;
    TetClearance clearance_;
    std::vector<Weights> few_;
    std::vector<Weights> many_;
    double min_inside_;
};

}

std::vector<Weights> sample_pattern(std::uint32_t count) {
    std::uint32_t steps = 0;
    while ((steps + 1) * (steps + 2) * (steps + 3) / 6 < count) ++steps;
    std::vector<Weights> pattern;
    // Half a step off every face; the corners of the tet itself would say nothing.
    const double whole = steps + 2.0;
    for (std::uint32_t i = 0; i <= steps; ++i) {
        for (std::uint32_t j = 0; i + j <= steps; ++j) {
            for (std::uint32_t k = 0; i + j + k <= steps; ++k) {
                pattern.push_back(
                    {(i + 0.5) / whole, (j + 0.5) / whole, (k + 0.5) / whole, (steps - i - j - k + 0.5) / whole});
            }
        }
    }
    return pattern;
}

std::vector<Verdict> classify_tets(const Shell& shell, const ShellInterior& interior, const ShellSolid& solid,
                                   const TetMesh& mesh, const Params& params, const Context& context) {
    const Classifier classifier(shell, interior, solid, params);
    std::vector<Verdict> verdicts(mesh.tets.size());
    parallel_for(context, mesh.tets.size(), 128, [&](std::size_t begin, std::size_t end) {
        context.stop_if_cancelled();
        for (std::size_t t = begin; t < end; ++t) {
            const auto& [a, b, c, d] = mesh.tets[t];
            verdicts[t] =
                classifier.judge({mesh.positions[a], mesh.positions[b], mesh.positions[c], mesh.positions[d]});
        }
    });
    return verdicts;
}

}
