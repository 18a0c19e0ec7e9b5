// SPDX-License-Identifier: MIT
#include "samples/car_cage.h"

#include <algorithm>

namespace crumple::samples::car {
namespace {

constexpr Color steel = {255, 176, 32, 255};
constexpr double bar_step = 0.17;  // metres between rings of a bar's vertices

// Left, then right of each pair.
enum {
    floor_front,
    pillar_front,
    roof_front = 4,
    floor_main = 6,
    waist_main = 8,
    roof_main = 10,
    stay_rear = 12,
    joint_count = 14
};

constexpr Joint pair_of_joints[] = {
    {{0.60, 0.28, 0.72}, true},    // floor_front
    {{0.62, 0.66, 0.68}, false},   // pillar_front
    {{0.42, 1.20, 0.10}, false},   // roof_front
    {{0.60, 0.28, -0.45}, true},   // floor_main
    {{0.62, 0.66, -0.45}, false},  // waist_main
    {{0.42, 1.24, -0.45}, false},  // roof_main
    {{0.34, 0.62, -1.30}, true},   // stay_rear
};

constexpr Face up{1, 1}, down{1, -1}, front{2, 1}, back{2, -1}, left{0, 1}, right{0, -1};

std::vector<Joint> make_joints() {
    std::vector<Joint> joints;
    for (const auto& joint : pair_of_joints) {
        joints.push_back(joint);
        joints.push_back({{-joint.centre.x, joint.centre.y, joint.centre.z}, joint.is_foot});
    }
    return joints;
}

std::vector<Bar> make_bars() {
    constexpr std::size_t a = 0, b = 2, c = roof_front, d = floor_main, e = waist_main, f = roof_main, g = stay_rear;
    std::vector<Bar> bars;
    for (std::size_t side = 0; side < 2; ++side) {
        for (const Bar& bar : {Bar{a, b, up, down},
                               {b, c, up, front},
                               {c, f, back, front},
                               {d, e, up, down},
                               {e, f, up, down},
                               {f, g, back, up},
                               {b, e, back, front}}) {
            bars.push_back({bar.from + side, bar.to + side, bar.leaves, bar.arrives});
        }
    }
    for (const std::size_t across : {b, c, e, f, g}) bars.push_back({across, across + 1, right, left});
    return bars;
}

Vec3 direction(Face face) {
    Vec3 d;
    d[face.axis] = face.side;
    return d;
}

std::size_t corner_number(const std::array<int, 3>& signs) {
    return static_cast<std::size_t>((signs[0] > 0) + 2 * (signs[1] > 0) + 4 * (signs[2] > 0));
}

// Corners of a rectangle lie on a circle, and a tetrahedron of four such shell vertices is flat for ever. So the
// corners of a joint stand out unequally, and those of a bar's rings are pushed along the bar: no face is a rectangle.
constexpr double stand_out[8] = {0.86, 1.14, 1.08, 0.90, 1.16, 0.84, 0.92, 1.10};  // by corner_number
constexpr double push[4] = {0.28, -0.12, 0.10, -0.30};                             // by corner of a ring

Vec3 corner_offset(const std::array<int, 3>& signs) {
    return Vec3{double(signs[0]), double(signs[1]), double(signs[2])} * (half_bar * stand_out[corner_number(signs)]);
}

// Corners of a face, counter-clockwise seen from outside the joint.
std::array<std::array<int, 3>, 4> face_corners(Face face) {
    const auto axis = static_cast<std::size_t>(face.axis);
    std::array<std::array<int, 3>, 4> corners{};
    constexpr int around[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    for (std::size_t i = 0; i < 4; ++i) {
        corners[i][axis] = face.side;
        corners[i][(axis + 1) % 3] = around[i][face.side > 0 ? 0 : 1];
        corners[i][(axis + 2) % 3] = around[i][face.side > 0 ? 1 : 0];
    }
    return corners;
}

// Where a corner of the leaving face comes out at the arriving face, without twist. Around a turn the outer side stays
// outer.
std::array<int, 3> partner(const Bar& bar, std::array<int, 3> corner) {
    const auto from = static_cast<std::size_t>(bar.leaves.axis);
    const auto to = static_cast<std::size_t>(bar.arrives.axis);
    if (from != to) corner[from] = bar.leaves.side * bar.arrives.side * corner[to];
    corner[to] = bar.arrives.side;
    return corner;
}

struct Frame {
    Part part;
    std::vector<std::array<Index, 8>> corners;             // of each joint
    std::vector<std::array<std::array<bool, 2>, 3>> open;  // faces of each joint through which a bar leaves
};

void add_joints(Frame& frame) {
    for (const auto& joint : cage_joints()) {
        auto& corners = frame.corners.emplace_back();
        frame.open.emplace_back();
        for (const int z : {-1, 1}) {
            for (const int y : {-1, 1}) {
                for (const int x : {-1, 1}) {
                    corners[corner_number({x, y, z})] =
                        add_vertex(frame.part, joint.centre + corner_offset({x, y, z}), joint.is_foot ? locked : steel);
                }
            }
        }
    }
}

void add_bar(Frame& frame, const Bar& bar) {
    std::array<Index, 4> begin{}, end{};
    const auto loop = face_corners(bar.leaves);
    for (std::size_t i = 0; i < 4; ++i) {
        begin[i] = frame.corners[bar.from][corner_number(loop[i])];
        end[i] = frame.corners[bar.to][corner_number(partner(bar, loop[i]))];
    }
    const auto line = middle_line(bar);
    const int steps = std::max(1, static_cast<int>(length(line[2] - line[1]) / bar_step + 0.5));
    std::array<Index, 4> last = begin;
    for (int step = 1; step <= steps; ++step) {
        std::array<Index, 4> next = end;
        for (std::size_t i = 0; step < steps && i < 4; ++i) {
            const double t = (step + push[i]) / steps;
            const Vec3 p = frame.part.positions[begin[i]] * (1 - t) + frame.part.positions[end[i]] * t;
            next[i] = add_vertex(frame.part, p, steel);
        }
        for (std::size_t i = 0; i < 4; ++i)
            add_quad(frame.part, last[i], last[(i + 1) % 4], next[(i + 1) % 4], next[i]);
        last = next;
    }
    frame.open[bar.from][static_cast<std::size_t>(bar.leaves.axis)][bar.leaves.side > 0] = true;
    frame.open[bar.to][static_cast<std::size_t>(bar.arrives.axis)][bar.arrives.side > 0] = true;
}

void close_faces(Frame& frame) {
    for (std::size_t joint = 0; joint < frame.corners.size(); ++joint) {
        for (int axis = 0; axis < 3; ++axis) {
            for (const int side : {-1, 1}) {
                if (frame.open[joint][static_cast<std::size_t>(axis)][side > 0]) continue;
                const auto loop = face_corners({axis, side});
                const auto vertex = [&](std::size_t i) { return frame.corners[joint][corner_number(loop[i])]; };
                add_quad(frame.part, vertex(0), vertex(1), vertex(2), vertex(3));
            }
        }
    }
}

}

std::span<const Joint> cage_joints() {
    static const std::vector<Joint> joints = make_joints();
    return joints;
}

std::span<const Bar> cage_bars() {
    static const std::vector<Bar> bars = make_bars();
    return bars;
}

std::array<Vec3, 4> middle_line(const Bar& bar) {
    const Vec3 from = cage_joints()[bar.from].centre;
    const Vec3 to = cage_joints()[bar.to].centre;
    return {from, from + direction(bar.leaves) * half_bar, to + direction(bar.arrives) * half_bar, to};
}

Part cage_shell() {
    Frame frame{{"roll_cage", {}, {}, {}}, {}, {}};
    add_joints(frame);
    for (const auto& bar : cage_bars()) add_bar(frame, bar);
    close_faces(frame);
    return frame.part;
}

}
