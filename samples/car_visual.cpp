// SPDX-License-Identifier: MIT
#include "samples/car.h"
#include "samples/car_cage.h"
#include "samples/car_panels.h"
#include "samples/car_profile.h"
#include "samples/curve.h"
#include "samples/solids.h"

namespace crumple::samples {
namespace {

constexpr Color rubber = {9, 9, 9, 255};
constexpr Color alloy = {150, 152, 158, 255};
constexpr Color iron = {70, 72, 76, 255};
constexpr Color cover_red = {140, 10, 8, 255};
constexpr Color cage_white = {215, 215, 215, 255};
constexpr Color cloth = {16, 18, 24, 255};

void turn_around_x(Part& part, std::size_t first, Vec3 centre, Turn t) {
    for (std::size_t v = first; v < part.positions.size(); ++v) {
        const Vec3 p = part.positions[v] - centre;
        part.positions[v] =
            round_to_float(centre + Vec3{p.x, p.y * t.cosine - p.z * t.sine, p.y * t.sine + p.z * t.cosine});
    }
}

// Half the profile of a tyre from its recessed middle to the tread, mirrored to the other side. The grooves are real.
std::vector<Hoop> tyre_profile(int segments) {
    constexpr Hoop half[] = {{-0.060, 0.000}, {-0.062, 0.120}, {-0.070, 0.180}, {-0.096, 0.188}, {-0.103, 0.205},
                             {-0.107, 0.230}, {-0.108, 0.250}, {-0.105, 0.270}, {-0.099, 0.287}, {-0.090, 0.298},
                             {-0.080, 0.304}, {-0.064, 0.308}, {-0.046, 0.310}, {-0.044, 0.301}, {-0.034, 0.301},
                             {-0.032, 0.310}, {-0.008, 0.310}, {-0.006, 0.301}};
    std::vector<Hoop> profile(std::begin(half), std::end(half));
    for (std::size_t i = std::size(half); i > 0; --i) profile.push_back({-half[i - 1].x, half[i - 1].radius});
    for (auto& hoop : profile) hoop.count = segments;
    return profile;
}

// Every other pair of segments is cut back across the tread. REQUIRES: the part holds the revolved tyre only.
void cut_tread(Part& part, Vec3 centre, std::size_t segments) {
    const std::size_t first_ring = segments + 1;  // behind the innermost ring and the middle of its disc
    for (std::size_t v = first_ring; v < part.positions.size(); ++v) {
        Vec3& p = part.positions[v];
        const double dy = p.y - centre.y;
        const double dz = p.z - centre.z;
        const bool is_tread = dy * dy + dz * dz > 0.302 * 0.302;
        if (is_tread && (v - first_ring) % segments % 4 < 2) {
            p = round_to_float({p.x, centre.y + dy * 0.975, centre.z + dz * 0.975});
        }
    }
}

Part wheel(const char* name, double side, double axle) {
    constexpr int segments = 72;
    constexpr int spokes = 5;
    const Vec3 centre{side * car::wheel_middle_x, car::wheel_radius, axle};
    Part part{name, {}, {}, {}};
    add_revolved(part, centre, tyre_profile(segments), rubber);
    cut_tread(part, centre, segments);
    const double face = side * 0.084;
    add_torus(part, {centre + Vec3{face, 0, 0}, 0, 0.178, 0.011, 60, 10}, alloy);
    for (int spoke = 0; spoke < spokes; ++spoke) {
        const std::size_t first = part.positions.size();
        add_box(part, {centre + Vec3{face - side * 0.006, 0.098, 0}, {0.012, 0.078, 0.020}, {2, 8, 4}, 0.15}, alloy);
        turn_around_x(part, first, centre, turn(static_cast<double>(spoke) / spokes));
    }
    const Hoop hub[] = {{-0.018, 0}, {-0.018, 0.040, 24}, {0.010, 0.038, 24}, {0.016, 0.024, 24}, {0.018, 0}};
    add_revolved(part, centre + Vec3{face, 0, 0}, hub, alloy);
    return part;
}

Part engine() {
    Part part{"engine", {}, {}, {}};
    const Vec3 middle{0, 0.46, 1.36};
    add_box(part, {middle + Vec3{0, -0.04, 0}, {0.15, 0.10, 0.22}, {10, 8, 14}, 0.05}, iron);
    add_box(part, {middle + Vec3{0, -0.155, 0.01}, {0.10, 0.03, 0.17}, {8, 3, 12}, 0.12}, iron);
    for (const double side : {1.0, -1.0}) {
        add_box(part, {middle + Vec3{side * 0.125, 0.085, 0}, {0.055, 0.045, 0.21}, {6, 5, 18}, 0.18}, cover_red);
        for (int cylinder = 0; cylinder < 4; ++cylinder) {
            const double z = -0.15 + 0.1 * cylinder;
            const Vec3 runner[] = {middle + Vec3{side * 0.09, 0.06, z}, middle + Vec3{side * 0.07, 0.11, z},
                                   middle + Vec3{side * 0.04, 0.145, z}, middle + Vec3{0, 0.155, z}};
            add_pipe(part, runner, 0.018, 14, alloy);
            const Vec3 exhaust[] = {middle + Vec3{side * 0.14, 0.02, z}, middle + Vec3{side * 0.19, 0.0, z},
                                    middle + Vec3{side * 0.205, -0.05, z - 0.02},
                                    middle + Vec3{side * 0.20, -0.11, z - 0.05}};
            add_pipe(part, exhaust, 0.016, 14, iron);
        }
    }
    add_box(part, {middle + Vec3{0, 0.155, 0}, {0.045, 0.025, 0.19}, {5, 4, 16}, 0.3}, alloy);
    for (const Vec3 pulley : {Vec3{0, -0.10, 0}, Vec3{0.09, 0.0, 0}, Vec3{-0.09, 0.02, 0}}) {
        add_torus(part, {middle + pulley + Vec3{0, 0, 0.245}, 2, 0.035, 0.013, 32, 10}, alloy);
    }
    return part;
}

Part cage() {
    Part part{"cage", {}, {}, {}};
    for (const auto& bar : car::cage_bars()) {
        const auto line = car::middle_line(bar);
        std::vector<Vec3> path;
        for (std::size_t leg = 0; leg + 1 < line.size(); ++leg) {
            const int steps = leg == 1 ? 10 : 2;
            for (int i = 0; i < steps; ++i)
                path.push_back(line[leg] + (line[leg + 1] - line[leg]) * (static_cast<double>(i) / steps));
        }
        path.push_back(line.back());
        add_pipe(part, path, 0.024, 14, cage_white);
    }
    return part;
}

Part seat(const char* name, double side) {
    Part part{name, {}, {}, {}};
    add_box(part, {{side * 0.33, 0.40, 0.05}, {0.21, 0.08, 0.24}, {14, 6, 16}, 0.25}, cloth);
    add_box(part, {{side * 0.33, 0.72, -0.20}, {0.20, 0.30, 0.07}, {14, 20, 6}, 0.25}, cloth);
    add_box(part, {{side * 0.33, 1.06, -0.21}, {0.10, 0.07, 0.05}, {8, 6, 5}, 0.4}, cloth);
    return part;
}

Part dashboard() {
    Part part{"dashboard", {}, {}, {}};
    add_box(part, {{0, 0.78, 0.72}, {0.52, 0.07, 0.12}, {36, 6, 8}, 0.2}, cloth);
    add_torus(part, {{0.33, 0.80, 0.46}, 2, 0.16, 0.014, 48, 12}, cloth);
    const Vec3 column[] = {{0.33, 0.80, 0.46}, {0.33, 0.79, 0.54}, {0.33, 0.78, 0.64}};
    add_pipe(part, column, 0.02, 14, cloth);
    return part;
}

}

Model car_visual() {
    Model model = car::panels();
    model.push_back(wheel("wheel_front_left", 1, car::axle_z[0]));
    model.push_back(wheel("wheel_front_right", -1, car::axle_z[0]));
    model.push_back(wheel("wheel_rear_left", 1, car::axle_z[1]));
    model.push_back(wheel("wheel_rear_right", -1, car::axle_z[1]));
    model.push_back(engine());
    model.push_back(cage());
    model.push_back(seat("seat_left", 1));
    model.push_back(seat("seat_right", -1));
    model.push_back(dashboard());
    return model;
}

}
