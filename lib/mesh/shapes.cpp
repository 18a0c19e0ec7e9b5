// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/shapes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include "core/error.h"
#include "geometry/measures.h"
#include "mesh/neighbours.h"

namespace crumple::shapes {

namespace {

// Fills in what every closed shell of one component has.
Shell finish(std::string name, std::vector<Vec3> positions, std::vector<Triangle> triangles) {
    Shell shell;
    for (Vec3& p : positions) p = round_to_float(p);
    shell.positions = std::move(positions);
    shell.triangles = std::move(triangles);
    shell.locked.assign(shell.positions.size(), 0);
    shell.component.assign(shell.triangles.size(), 0);
    for (Index v = 0; v < shell.positions.size(); ++v) shell.source_vertex.push_back(v);
    Component component;
    component.name = std::move(name);
    component.role_reason = "shape";
    component.is_closed = true;
    for (const Triangle& t : shell.triangles) {
        component.volume += signed_volume({}, shell.positions[t[0]], shell.positions[t[1]], shell.positions[t[2]]);
    }
    shell.components.push_back(std::move(component));
    return shell;
}

// Hands out one number a grid place, in the order of asking.
class GridNumbers {
public:
    GridNumbers(Vec3 low, Vec3 high, int cells) : low_(low), high_(high), cells_(cells) {}

    Index at(std::array<int, 3> place) {
        const auto [entry, is_new] = numbers_.try_emplace(place, static_cast<Index>(positions.size()));
        if (is_new) positions.push_back({on(0, place[0]), on(1, place[1]), on(2, place[2])});
        return entry->second;
    }

    std::vector<Vec3> positions;

private:
    // Both ends are exact.
    [[nodiscard]] double on(int axis, int step) const {
        const double t = static_cast<double>(step) / cells_;
        return low_[axis] * (1 - t) + high_[axis] * t;
    }

    Vec3 low_;
    Vec3 high_;
    int cells_;
    std::map<std::array<int, 3>, Index> numbers_;
};

// The two triangles of a cell on the side of a box across `axis`; side 0 is low, 1 is high.
void add_cell(std::vector<Triangle>& triangles, GridNumbers& grid, int axis, int side, int u, int v, int cells) {
    const auto corner = [&](int du, int dv) {
        std::array<int, 3> place{};
        place[axis] = side * cells;
        place[(axis + 1) % 3] = u + du;
        place[(axis + 2) % 3] = v + dv;
        return grid.at(place);
    };
    const Index a = corner(0, 0);
    const Index b = corner(1, 0);
    const Index c = corner(1, 1);
    const Index d = corner(0, 1);
    if (side == 1) {
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
    } else {
        triangles.push_back({a, c, b});
        triangles.push_back({a, d, c});
    }
}

Shell box_named(std::string name, int cells, Vec3 low, Vec3 high) {
    GridNumbers grid(low, high, cells);
    std::vector<Triangle> triangles;
    for (int axis = 0; axis < 3; ++axis) {
        for (int side = 0; side < 2; ++side) {
            for (int u = 0; u < cells; ++u) {
                for (int v = 0; v < cells; ++v) add_cell(triangles, grid, axis, side, u, v, cells);
            }
        }
    }
    return finish(std::move(name), grid.positions, std::move(triangles));
}

// Every triangle into four, vertices pushed out to the unit sphere.
void split_on_sphere(std::vector<Vec3>& positions, std::vector<Triangle>& triangles) {
    std::map<Edge, Index> middles;
    const auto middle = [&](Index a, Index b) {
        const auto [entry, is_new] =
            middles.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<Index>(positions.size()));
        if (is_new) {
            const Vec3 sum = positions[a] + positions[b];
            positions.push_back(sum / length(sum));
        }
        return entry->second;
    };
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : triangles) {
        const Index ab = middle(a, b);
        const Index bc = middle(b, c);
        const Index ca = middle(c, a);
        finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    triangles = std::move(finer);
}

std::string free_name(const Shell& shell, const std::string& wanted) {
    const auto is_taken = [&](const std::string& name) {
        return std::any_of(shell.components.begin(), shell.components.end(),
                           [&](const Component& c) { return c.name == name; });
    };
    std::string name = wanted;
    for (int number = 2; is_taken(name); ++number) name = wanted + "_" + std::to_string(number);
    return name;
}

}

Shell tetrahedron(double size) {
    return finish("tetrahedron", {{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {0, 0, size}},
                  {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}});
}

Shell box(Vec3 low, Vec3 high) { return box_named("box", 1, low, high); }

Shell subdivided_box(int cells, Vec3 low, Vec3 high) { return box_named("box", cells, low, high); }

Shell thin_plate(double thickness, int cells) { return box_named("plate", cells, {0, 0, 0}, {1, thickness, 1}); }

Shell icosphere(double radius, int levels, Vec3 centre) {
    constexpr double golden = std::numbers::phi;
    std::vector<Vec3> positions{{-1, golden, 0}, {1, golden, 0}, {-1, -golden, 0}, {1, -golden, 0},
                                {0, -1, golden}, {0, 1, golden}, {0, -1, -golden}, {0, 1, -golden},
                                {golden, 0, -1}, {golden, 0, 1}, {-golden, 0, -1}, {-golden, 0, 1}};
    for (Vec3& p : positions) p = p / length(p);
    std::vector<Triangle> triangles{{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    for (int level = 0; level < levels; ++level) split_on_sphere(positions, triangles);
    for (Vec3& p : positions) p = centre + p * radius;
    return finish("sphere", std::move(positions), std::move(triangles));
}

Shell torus(double major_radius, double minor_radius, int around, int across) {
    std::vector<Vec3> positions;
    std::vector<Triangle> triangles;
    const auto number = [&](int i, int j) { return static_cast<Index>((i % around) * across + j % across); };
    for (int i = 0; i < around; ++i) {
        const double angle = 2 * std::numbers::pi * i / around;
        for (int j = 0; j < across; ++j) {
            const double turn = 2 * std::numbers::pi * j / across;
            const double out = major_radius + minor_radius * std::cos(turn);
            positions.push_back({out * std::cos(angle), minor_radius * std::sin(turn), out * std::sin(angle)});
            triangles.push_back({number(i, j), number(i, j + 1), number(i + 1, j)});
            triangles.push_back({number(i + 1, j), number(i, j + 1), number(i + 1, j + 1)});
        }
    }
    return finish("torus", std::move(positions), std::move(triangles));
}

Shell nested_boxes(Role inner) {
    Shell shell = joined(box_named("outer", 1, {0, 0, 0}, {3, 3, 3}), box_named("inner", 1, {1, 1, 1}, {2, 2, 2}));
    shell.components[1].role = inner;
    shell.components[1].parent = 0;
    return shell;
}

Shell joined(Shell a, const Shell& b) {
    const auto first_vertex = static_cast<Index>(a.positions.size());
    const auto first_component = static_cast<Index>(a.components.size());
    a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
    a.locked.insert(a.locked.end(), b.locked.begin(), b.locked.end());
    for (const Index v : b.source_vertex) a.source_vertex.push_back(first_vertex + v);
    for (const Triangle& t : b.triangles)
        a.triangles.push_back({first_vertex + t[0], first_vertex + t[1], first_vertex + t[2]});
    for (const Index c : b.component) a.component.push_back(first_component + c);
    for (Component component : b.components) {
        component.name = free_name(a, component.name);
        if (component.parent != none) component.parent += first_component;
        a.components.push_back(std::move(component));
    }
    return a;
}

Shell inverted(Shell shell) {
    for (Triangle& t : shell.triangles) std::swap(t[1], t[2]);
    for (Component& component : shell.components) component.is_inward = !component.is_inward;
    return shell;
}

Shell without_triangle(Shell shell, Index triangle) {
    CRUMPLE_CHECK(triangle < shell.triangles.size(), "the triangle to leave out exists");
    shell.components[shell.component[triangle]].is_closed = false;
    shell.triangles.erase(shell.triangles.begin() + triangle);
    shell.component.erase(shell.component.begin() + triangle);
    return shell;
}

Shell moved(Shell shell, Vec3 offset, double scale) {
    for (Vec3& p : shell.positions) p = round_to_float(p * scale + offset);
    for (Component& component : shell.components) component.volume *= scale * scale * scale;
    return shell;
}

PointSet grid_points(int per_axis) {
    PointSet points;
    for (int x = 0; x < per_axis; ++x) {
        for (int y = 0; y < per_axis; ++y) {
            for (int z = 0; z < per_axis; ++z) points.positions.push_back({double(x), double(y), double(z)});
        }
    }
    return points;
}

PointSet points_of(const Shell& shell) { return {shell.positions, static_cast<Index>(shell.positions.size())}; }

TetMesh tet_grid(int cells, Vec3 low, Vec3 high) {
    TetMesh mesh;
    const Index row = static_cast<Index>(cells) + 1;
    for (Index x = 0; x < row; ++x) {
        for (Index y = 0; y < row; ++y) {
            for (Index z = 0; z < row; ++z) {
                const Vec3 t{double(x) / cells, double(y) / cells, double(z) / cells};
                mesh.positions.push_back(
                    round_to_float({low.x * (1 - t.x) + high.x * t.x, low.y * (1 - t.y) + high.y * t.y,
                                    low.z * (1 - t.z) + high.z * t.z}));
            }
        }
    }
    // A walk along three edges from the low to the high corner of a cube is a tet; odd walks are negative [Kuhn 1960].
    const Index step[3] = {row * row, row, 1};
    constexpr int walks[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    for (Index x = 0; x + 1 < row; ++x) {
        for (Index y = 0; y + 1 < row; ++y) {
            for (Index z = 0; z + 1 < row; ++z) {
                const Index corner = x * row * row + y * row + z;
                for (int walk = 0; walk < 6; ++walk) {
                    const Index a = corner + step[walks[walk][0]];
                    const Index b = a + step[walks[walk][1]];
                    const Index far = b + step[walks[walk][2]];
                    mesh.tets.push_back(walk < 3 ? Tet{corner, a, b, far} : Tet{corner, b, a, far});
                }
            }
        }
    }
    mesh.neighbours = neighbours_of(mesh.tets);
    return mesh;
}

}
