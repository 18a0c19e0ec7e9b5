// SPDX-License-Identifier: MIT
#include "samples/car_panels.h"

#include <algorithm>
#include <map>

#include "samples/car_profile.h"
#include "samples/curve.h"

namespace crumple::samples::car {
namespace {

constexpr Color yellow = {226, 118, 8, 255};
constexpr Color glass = {14, 22, 28, 255};
constexpr Color black = {10, 10, 11, 255};
constexpr Color lamp = {230, 230, 205, 255};
constexpr Color tail_lamp = {150, 6, 4, 255};

constexpr int station_count = 241;
constexpr int cap_rings = 9;                           // that close nose and tail
constexpr int span_rows[] = {6, 6, 12, 12, 16, 8, 8};  // between neighbours of SectionPoint
constexpr double arch_radius = wheel_radius + 0.055;
constexpr double shut_line = 0.008;     // depth
constexpr double grille_depth = 0.012;  // how far the nose's cap bulges where the grille begins

// The grid covers the body from tail to nose and around from the middle of the floor: left half, then right.
struct GridPoint {
    Vec3 position;
    double u = 0;  // place along the half section, in SectionPoint units
};
struct Grid {
    std::vector<std::vector<GridPoint>> rings;
};

std::vector<double> half_rows() {
    std::vector<double> rows{0};
    for (std::size_t span = 0; span < std::size(span_rows); ++span) {
        for (int i = 1; i <= span_rows[span]; ++i)
            rows.push_back(static_cast<double>(span) + static_cast<double>(i) / span_rows[span]);
    }
    return rows;
}

// One ring at station z, shrunk towards its middle by `scale` and moved along by `bulge`.
std::vector<GridPoint> make_ring(double z, double scale, double bulge) {
    const auto controls = body_section(z);
    const double middle_y = 0.5 * (controls[floor_middle].y + controls[roof_middle].y);
    std::vector<GridPoint> left;
    for (const double u : half_rows()) {
        Vec3 p = spline(controls, u);
        p = {p.x * scale, middle_y + (p.y - middle_y) * scale, z + bulge};
        left.push_back({p, u});
    }
    std::vector<GridPoint> ring = left;
    for (std::size_t i = left.size() - 2; i > 0; --i) {
        const Vec3 p = left[i].position;
        ring.push_back({{-p.x, p.y, p.z}, left[i].u});
    }
    return ring;
}

// Vertices near an arch's circle move onto it, so that the cut is round.
void snap_to_arch(Vec3& p, double axle) {
    if (std::abs(p.x) < 0.5) return;
    const double dy = p.y - wheel_radius;
    const double dz = p.z - axle;
    const double distance = std::sqrt(dy * dy + dz * dz);
    if (std::abs(distance - arch_radius) > 0.02 || distance == 0) return;
    p.y = wheel_radius + dy * arch_radius / distance;
    p.z = axle + dz * arch_radius / distance;
}

Grid make_grid() {
    Grid grid;
    const auto cap = [&](double z, int k, double side) {
        const double t = static_cast<double>(k) / cap_rings;  // 0 at the middle of the cap, 1 at its rim
        grid.rings.push_back(make_ring(z, t, side * 0.03 * (1 - t * t)));
    };
    for (int k = 1; k < cap_rings; ++k) cap(tail_z, k, -1);
    for (int i = 0; i < station_count; ++i) {
        grid.rings.push_back(make_ring(tail_z + (nose_z - tail_z) * i / (station_count - 1), 1, 0));
    }
    for (int k = cap_rings - 1; k > 0; --k) cap(nose_z, k, 1);
    for (auto& ring : grid.rings) {
        for (auto& point : ring) {
            for (const double axle : axle_z) snap_to_arch(point.position, axle);
        }
    }
    return grid;
}

struct Panel {
    const char* name;
    Color color;
};

constexpr Panel no_panel{nullptr, {}};

bool is_arch(Vec3 p) {
    for (const double axle : axle_z) {
        const double dy = p.y - wheel_radius;
        const double dz = p.z - axle;
        if (std::abs(p.x) > 0.45 && dy * dy + dz * dz < arch_radius * arch_radius) return true;
    }
    return false;
}

Panel front_end(Vec3 p, double u) {
    if (p.z < 2.13 && u > 3.95 && u < 4.95) return {"headlamps", lamp};
    if (u > 4.95 && p.z < nose_z) return {"front_bumper", yellow};
    return p.z > nose_z + grille_depth ? Panel{"grille", black} : Panel{"front_bumper", yellow};
}

Panel rear_end(Vec3 p, double u) {
    if (u > 3.3 && u < 4.5 && std::abs(p.x) > 0.3 && p.z > tail_z - 0.02) return {"tail_lamps", tail_lamp};
    return u < 2.6 && p.z > tail_z - 0.014 ? Panel{"diffuser", black} : Panel{"rear_bumper", yellow};
}

Panel top(double z) {
    if (z > 0.95) return {"hood", yellow};
    if (z > 0.12) return {"windscreen", glass};
    if (z > -0.97) return {"roof", yellow};
    if (z > -1.50) return {"rear_window", glass};
    return {"boot_lid", yellow};
}

Panel side_window(double z, bool is_left) {
    const bool is_pillar = std::abs(z + 0.40) < 0.04;
    if (is_pillar) return {"pillars", black};
    if (z > -0.40) return {is_left ? "window_front_left" : "window_front_right", glass};
    return {is_left ? "window_rear_left" : "window_rear_right", glass};
}

Panel flank_panel(double z, bool is_left) {
    if (z > 0.86) return {is_left ? "fender_left" : "fender_right", yellow};
    if (z > -0.40) return {is_left ? "door_front_left" : "door_front_right", yellow};
    if (z > -1.08) return {is_left ? "door_rear_left" : "door_rear_right", yellow};
    return {is_left ? "quarter_left" : "quarter_right", yellow};
}

// Which panel a place of the skin belongs to, by its middle and its row.
Panel panel_at(Vec3 p, double u) {
    if (is_arch(p)) return no_panel;
    if (u < 1.7 && p.z > tail_z && p.z < nose_z) return {"underbody", black};
    if (p.z > 1.97) return front_end(p, u);
    if (p.z < -1.99) return rear_end(p, u);
    if (u < 2.3) return {"sills", black};
    if (u > 5.1) return top(p.z);
    const bool is_cabin = p.z < 0.86 && p.z > -1.42;
    if (u > 4.85 && is_cabin) return {"roof_rails", yellow};
    if (u > 4.25 && p.z < 0.74 && p.z > -1.28) return side_window(p.z, p.x > 0);
    return flank_panel(p.z, p.x > 0);
}

// Panels own their vertices; a vertex that two panels meet at is pressed in, which draws the gap between them.
class PanelCutter {
public:
    explicit PanelCutter(const Grid& grid) : grid_(grid), width_(grid.rings.front().size()) {
        for (std::size_t i = 0; i + 1 < grid_.rings.size(); ++i) {
            for (std::size_t j = 0; j < width_; ++j) quads_.push_back(panel_at(middle(i, j), row(i, j)));
        }
    }

    Model cut() {
        for (std::size_t i = 0; i + 1 < grid_.rings.size(); ++i) {
            for (std::size_t j = 0; j < width_; ++j) add(i, j);
        }
        close_cap(0);
        close_cap(grid_.rings.size() - 1);
        return std::move(model_);
    }

private:
    [[nodiscard]] const GridPoint& at(std::size_t i, std::size_t j) const { return grid_.rings[i][j % width_]; }
    [[nodiscard]] Vec3 middle(std::size_t i, std::size_t j) const {
        return (at(i, j).position + at(i + 1, j).position + at(i, j + 1).position + at(i + 1, j + 1).position) * 0.25;
    }
    [[nodiscard]] double row(std::size_t i, std::size_t j) const { return 0.5 * (at(i, j).u + at(i, j + 1).u); }
    [[nodiscard]] const Panel& quad(std::size_t i, std::size_t j) const { return quads_[i * width_ + j % width_]; }

    [[nodiscard]] bool is_on_shut_line(std::size_t i, std::size_t j) const {
        const char* first = nullptr;
        for (std::size_t a = i > 0 ? i - 1 : 0; a <= i && a + 1 < grid_.rings.size(); ++a) {
            for (const std::size_t b : {j + width_ - 1, j}) {
                const char* name = quad(a, b).name;
                if (!name) continue;
                if (first && std::string(first) != name) return true;
                first = name;
            }
        }
        return false;
    }

    [[nodiscard]] Vec3 inward(std::size_t i, std::size_t j) const {
        const auto& rings = grid_.rings;
        const Vec3 along = rings[std::min(i + 1, rings.size() - 1)][j % width_].position -
                           rings[i > 0 ? i - 1 : 0][j % width_].position;
        const Vec3 around = at(i, j + 1).position - at(i, j + width_ - 1).position;
        const Vec3 normal = cross(along, around);
        const double size = length(normal);
        return size > 0 ? normal / size : Vec3{};
    }

    Index vertex(Part& part, std::size_t i, std::size_t j, Color color) {
        const auto [entry, is_new] = vertices_.try_emplace({part.name, i * width_ + j % width_}, none);
        if (is_new) {
            Vec3 p = at(i, j).position;
            if (is_on_shut_line(i, j)) p += inward(i, j) * shut_line;
            entry->second = add_vertex(part, p, color);
        }
        return entry->second;
    }

    Part& part_of(const Panel& panel) {
        const auto part =
            std::find_if(model_.begin(), model_.end(), [&](const Part& p) { return p.name == panel.name; });
        return part != model_.end() ? *part : model_.emplace_back(Part{panel.name, {}, {}, {}});
    }

    void add(std::size_t i, std::size_t j) {
        const Panel& panel = quad(i, j);
        if (!panel.name) return;
        Part& part = part_of(panel);
        const auto corner = [&](std::size_t a, std::size_t b) { return vertex(part, a, b, panel.color); };
        // In braces: the order in which vertices are made must not depend on the compiler.
        const std::array<Index, 4> c = {corner(i, j), corner(i, j + 1), corner(i + 1, j + 1), corner(i + 1, j)};
        add_quad(part, c[0], c[1], c[2], c[3]);
    }

    // The small hole that the innermost ring of a cap leaves.
    void close_cap(std::size_t i) {
        const Panel& panel = quad(std::min(i, grid_.rings.size() - 2), 0);
        Part& part = part_of(panel);
        Vec3 middle;
        for (const auto& point : grid_.rings[i]) middle += point.position / static_cast<double>(width_);
        const Index tip = add_vertex(part, middle, panel.color);
        for (std::size_t j = 0; j < width_; ++j) {
            const Index a = vertex(part, i, j, panel.color);
            const Index b = vertex(part, i, j + 1, panel.color);
            part.triangles.push_back(i == 0 ? Triangle{b, a, tip} : Triangle{a, b, tip});
        }
    }

    const Grid& grid_;
    std::size_t width_;
    std::vector<Panel> quads_;
    std::map<std::pair<std::string, std::size_t>, Index> vertices_;
    Model model_;
};

// How far out the skin is at a height: where the arch's lining meets it.
double skin_x(double z, double y) {
    const auto controls = body_section(z);
    double x = 0;
    for (int i = 0; i <= 200; ++i) {
        const Vec3 p = spline(controls, 1.5 + 3.0 * i / 200);
        if (p.y <= y) x = p.x;
    }
    return x;
}

// The inside of a wheel arch: a wall behind the wheel, then the tunnel out to the skin.
void add_lining(Part& part, double side, double axle) {
    constexpr int steps = 54;
    constexpr double wall_x = 0.53;
    std::vector<Index> last;
    for (int i = 0; i <= steps; ++i) {
        const Turn t = turn(0.92 + 0.66 * i / steps - (0.92 + 0.66 * i / steps >= 1 ? 1 : 0));
        const auto place = [&](double x, double r) {
            return add_vertex(part, {side * x, wheel_radius + r * t.sine, axle + r * t.cosine}, black);
        };
        std::vector<Index> next;
        for (const double r : {0.08, 0.16, 0.24, 0.32}) next.push_back(place(wall_x, r));
        const double rim_x =
            std::max(0.6, skin_x(axle + arch_radius * t.cosine, wheel_radius + arch_radius * t.sine) - 0.004);
        for (int k = 0; k <= 6; ++k) next.push_back(place(wall_x + (rim_x - wall_x) * k / 6, arch_radius));
        for (std::size_t k = 0; !last.empty() && k + 1 < next.size(); ++k) {
            if (side > 0) {
                add_quad(part, last[k], next[k], next[k + 1], last[k + 1]);
            } else {
                add_quad(part, last[k], last[k + 1], next[k + 1], next[k]);
            }
        }
        last = next;
    }
}

}

Model panels() {
    const Grid grid = make_grid();
    Model model = PanelCutter(grid).cut();
    Part linings{"wheel_arches", {}, {}, {}};
    for (const double axle : axle_z) {
        for (const double side : {1.0, -1.0}) add_lining(linings, side, axle);
    }
    model.push_back(linings);
    return model;
}

}
