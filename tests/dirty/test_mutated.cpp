// SPDX-License-Identifier: GPL-3.0-or-later
// Shells broken at random in every way a modelling program can: each gives a valid mesh or a refusal with a reason.
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "core/random.h"
#include "dirty/dirty_bundle.h"
#include "mesh/shapes.h"

namespace crumple {
namespace {

using test::Cooked;

std::uint32_t below(Rng& random, std::size_t count) {
    return static_cast<std::uint32_t>(random.next_unit() * static_cast<double>(count));
}

Vec3 anywhere(Rng& random, double size) {
    const double x = random.next_unit() - 0.5;
    const double y = random.next_unit() - 0.5;
    return round_to_float(Vec3{x, y, random.next_unit() - 0.5} * size);
}

Shell base_shell(Rng& random) {
    switch (below(random, 6)) {
        case 0:
            return shapes::icosphere(1, 2);
        case 1:
            return shapes::torus(1, 0.3, 16, 8);
        case 2:
            return shapes::subdivided_box(3);
        case 3:
            return shapes::nested_boxes(Role::cavity);
        case 4:
            return shapes::thin_plate(0.03, 5);
        default:
            return shapes::joined(shapes::icosphere(1, 1), shapes::torus(1.2, 0.4, 12, 6));
    }
}

using Mutation = void (*)(Shell&, Rng&);

Triangle& any_triangle(Shell& shell, Rng& random) { return shell.triangles[below(random, shell.triangles.size())]; }
Vec3& any_place(Shell& shell, Rng& random) { return shell.positions[below(random, shell.positions.size())]; }

const Mutation mutations[] = {
    [](Shell& s, Rng& r) { s.triangles.erase(s.triangles.begin() + below(r, s.triangles.size())); },
    [](Shell& s, Rng& r) {  // a large hole
        const std::size_t first = below(r, s.triangles.size());
        const std::size_t count = std::min<std::size_t>(below(r, 40), s.triangles.size() - first - 1);
        s.triangles.erase(s.triangles.begin() + static_cast<std::ptrdiff_t>(first),
                          s.triangles.begin() + static_cast<std::ptrdiff_t>(first + count));
    },
    [](Shell& s, Rng& r) {
        Triangle& t = any_triangle(s, r);
        std::swap(t[0], t[1]);
    },
    [](Shell& s, Rng& r) {
        for (Triangle& t : s.triangles) {
            if (r.next_unit() < 0.3) std::swap(t[0], t[1]);
        }
    },
    [](Shell& s, Rng& r) {
        const Triangle t = any_triangle(s, r);
        s.triangles.push_back(t);
    },
    [](Shell& s, Rng& r) { any_triangle(s, r)[below(r, 3)] = below(r, s.positions.size()); },
    [](Shell& s, Rng& r) { any_place(s, r) = anywhere(r, 4); },
    [](Shell& s, Rng& r) {
        const Vec3 other = any_place(s, r);
        any_place(s, r) = other;
    },
    [](Shell& s, Rng& r) {  // a vertex pulled onto the middle of an edge
        const Triangle t = any_triangle(s, r);
        any_place(s, r) = round_to_float((s.positions[t[0]] + s.positions[t[1]]) * 0.5);
    },
    [](Shell& s, Rng& r) {  // noise on every vertex
        const double size = r.next_unit() * 0.3;
        for (Vec3& p : s.positions) p = round_to_float(p + anywhere(r, size));
    },
    [](Shell& s, Rng& r) {  // flattened
        const int axis = static_cast<int>(below(r, 3));
        const double to = r.next_unit() < 0.5 ? 0 : 1e-4;
        for (Vec3& p : s.positions) p[axis] = round_to_float({p[axis] * to, 0, 0}).x;
    },
    [](Shell& s, Rng& r) { s = shapes::joined(s, shapes::moved(s, anywhere(r, 1))); },
    [](Shell& s, Rng& r) {
        s = shapes::joined(s, shapes::inverted(shapes::moved(s, {0, 0, 0}, r.next_unit())));
    },
    [](Shell& s, Rng&) { s = shapes::joined(s, s); },
    [](Shell& s, Rng& r) { s = shapes::moved(s, anywhere(r, 1e6), 1); },
    [](Shell& s, Rng& r) {
        s = shapes::moved(s, {0, 0, 0}, std::ldexp(1.0, static_cast<int>(below(r, 60)) - 30));
    },
    [](Shell& s, Rng& r) {  // a fin
        s.positions.push_back(anywhere(r, 3));
        const Triangle t = any_triangle(s, r);
        s.triangles.push_back({t[0], t[1], static_cast<Index>(s.positions.size() - 1)});
        s.component.push_back(0);
        s.locked.push_back(0);
        s.source_vertex.push_back(0);
    },
    [](Shell& s, Rng& r) {  // every triangle on its own, all slightly apart; of many about a hundred stay
        Shell torn;
        const std::size_t stride = 1 + s.triangles.size() / 100;
        for (std::size_t i = 0; i < s.triangles.size(); i += stride) {
            const auto first = static_cast<Index>(torn.positions.size());
            for (const Index v : s.triangles[i])
                torn.positions.push_back(round_to_float(s.positions[v] + anywhere(r, 1e-3)));
            torn.triangles.push_back({first, first + 1, first + 2});
        }
        torn.component.assign(torn.triangles.size(), 0);
        torn.locked.assign(torn.positions.size(), 0);
        torn.source_vertex.assign(torn.positions.size(), 0);
        torn.components = {s.components[0]};
        s = torn;
    },
};

// The helpers of shapes need arrays of matching sizes.
void make_consistent(Shell& shell) {
    shell.component.resize(shell.triangles.size(), 0);
    shell.locked.resize(shell.positions.size(), 0);
    shell.source_vertex.resize(shell.positions.size(), 0);
}

Shell mutated(Rng& random) {
    Shell shell = base_shell(random);
    const std::uint32_t count = 1 + below(random, 4);
    for (std::uint32_t i = 0; i < count && !shell.triangles.empty(); ++i) {
        mutations[below(random, std::size(mutations))](shell, random);
        make_consistent(shell);
        if (shell.triangles.size() > 4000) break;
    }
    return shell;
}

importer::Params fallback(Rng& random) {
    importer::Params params;
    const double which = random.next_unit();
    if (which < 0.2) params.thicken = 0.05;
    if (which > 0.8) params.cage = 6;
    return params;
}

// Every eighth vertex is painted, so that locks get lost if any can.
double red_of(std::size_t vertex) { return vertex % 8 == 0 ? 0 : 1; }

// Counts what became of them.
struct Outcomes {
    std::uint64_t cooked = 0;
    std::uint64_t bundled = 0;
    std::uint64_t touching = 0;  // of the cooked, those whose surface still touches itself
};

// Where surfaces of the shell run through each other, touch or all but coincide, repair may find no way in floats to
// part them. Then it says so. Returns how many nodes are left.
std::size_t expect_manifold_or_told(const Cooked& cooked) {
    const NonManifold left = test::touching(cooked);
    if (left.vertices.empty()) {
        EXPECT_TRUE(left.edges.empty());
        EXPECT_FALSE(cooked.has("FINISH_NON_MANIFOLD"));
        return 0;
    }
    const bool crosses = cooked.has("SHELL_SELF_INTERSECTING") || cooked.has("SHELL_OVERLAPPING");
    const bool touches = !non_manifold(cooked.asset.shell.triangles).vertices.empty();
    EXPECT_TRUE(crosses || touches || cooked.warns("SAMPLE_THIN"));
    EXPECT_TRUE(cooked.warns("FINISH_NON_MANIFOLD"));
    EXPECT_EQ(cooked.finish.repair.nodes_left, left.vertices.size());
    return left.vertices.size();
}

// And on to what a game loads.
void expect_bundle_or_reason(Cooked cooked, std::size_t touching, Outcomes& outcomes) {
    const test::Bundled bundled = test::bundle_of(std::move(cooked));
    if (!bundled.refusal.empty()) {
        EXPECT_GT(bundled.refusal.size(), 40u) << bundled.refusal;
        return;
    }
    ++outcomes.bundled;
    EXPECT_EQ(test::fault_of(bundled), "");
    EXPECT_EQ(bundled.gates.figures.topology.non_manifold_vertices, touching);
}

void expect_mesh_or_reason(std::uint64_t seed, Outcomes& outcomes) {
    Rng random(seed, 0);
    const Shell shell = mutated(random);
    const importer::Params params = fallback(random);
    Cooked cooked;
    try {
        cooked = test::cook_shell(shell, params, red_of);
    } catch (const Error& error) {  // a thickness too small for the place is the one usage error there is
        EXPECT_EQ(error.kind(), ErrorKind::usage) << error.what();
        EXPECT_GT(params.thicken, 0) << error.what();
        return;
    }
    if (!cooked.refusal.empty()) {
        EXPECT_GT(cooked.refusal.size(), 40u) << cooked.refusal;
        return;
    }
    ++outcomes.cooked;
    EXPECT_EQ(test::fault_but_for_touching(cooked), "");
    const std::size_t touching = expect_manifold_or_told(cooked);
    outcomes.touching += touching > 0;
    expect_bundle_or_reason(std::move(cooked), touching, outcomes);
}

#ifdef NDEBUG
constexpr std::uint64_t full_count = 1000;
#else
constexpr std::uint64_t full_count = 200;  // with sanitizers each takes six times as long
#endif

TEST(Mutated, EveryShellGivesAValidMeshOrAReason) {
    const std::uint64_t count = std::getenv("CRUMPLE_FULL_TESTS") != nullptr ? full_count : 50;
    Outcomes outcomes;
    for (std::uint64_t seed = 0; seed < count; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        expect_mesh_or_reason(seed, outcomes);
    }
    EXPECT_GT(outcomes.cooked, count / 3);  // the mutations are not all fatal
    EXPECT_GT(outcomes.bundled, count / 5);
    EXPECT_LE(outcomes.touching, count / 50);
}

}
}
