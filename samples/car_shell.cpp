// SPDX-License-Identifier: MIT
#include <algorithm>

#include "samples/car.h"
#include "samples/car_cage.h"
#include "samples/car_profile.h"
#include "samples/curve.h"
#include "samples/loft.h"
#include "samples/off_circle.h"
#include "samples/solids.h"

namespace crumple::samples {
namespace {

constexpr Color paint_grey = {190, 200, 215, 255};
constexpr double edge = 0.19;  // metres between vertices of a cross-section
constexpr int station_count = 26;

// A whole cross-section as a dense closed polyline, counter-clockwise seen from the front, from the middle of the
// floor. Pulled in towards its own middle line by `inset` metres.
std::vector<Vec3> outline(double z, double inset) {
    const auto controls = car::shell_section(z);
    constexpr int steps = 64;
    std::vector<Vec3> half;
    for (int i = 0; i <= steps; ++i) {
        half.push_back(spline(controls, (car::section_points - 1.0) * i / steps));
    }
    const double low = half.front().y + inset;
    const double high = half.back().y - inset;
    const double scale = (high - low) / (half.back().y - half.front().y);
    for (auto& p : half) {
        p.y = low + (p.y - half.front().y) * scale;
        p.x = std::max(0.0, p.x - inset * std::min(1.0, p.x / 0.3));
    }
    std::vector<Vec3> whole = half;
    for (std::size_t i = half.size() - 2; i > 0; --i) whole.push_back({-half[i].x, half[i].y, half[i].z});
    return whole;
}

// How many edges go around; even, so that left and right are alike.
int even_count(const std::vector<Vec3>& outline) {
    double perimeter = 0;
    for (std::size_t i = 0; i < outline.size(); ++i)
        perimeter += length(outline[(i + 1) % outline.size()] - outline[i]);
    return 2 * static_cast<int>(perimeter / (2 * edge) + 0.5);
}

void close_end(Part& part, const Ring& ring, double z, double bulge, bool is_front) {
    auto inner_outline = outline(z, 0.16);
    for (auto& p : inner_outline) p.z += bulge;
    Ring inner = add_ring(part, inner_outline, even_count(inner_outline), 0, paint_grey);
    if (is_front) {
        stitch(part, ring, inner);
        close_by_zipping(part, inner);
    } else {
        stitch(part, reversed(ring), reversed(inner));
        close_by_zipping(part, reversed(inner));
    }
}

Part body() {
    Part part{"body", {}, {}, {}};
    const double begin = car::tail_z - car::shell_margin;
    const double end = car::nose_z + car::shell_margin;
    std::vector<Ring> rings;
    for (int i = 0; i < station_count; ++i) {
        const double z = begin + (end - begin) * i / (station_count - 1);
        const auto section = outline(z, 0);
        rings.push_back(add_ring(part, section, even_count(section), i % 2 ? 0.5 : 0, paint_grey));
        if (i > 0) stitch(part, rings[rings.size() - 2], rings.back());
    }
    close_end(part, rings.front(), begin, -0.03, false);
    close_end(part, rings.back(), end, 0.03, true);
    move_off_circles(part);
    return part;
}

// Four corners of a rectangle lie on a circle, and a tetrahedron of four such shell vertices is flat for ever. So rings
// are staggered, ends are domed, and no two triangles of these shells make a rectangle.
Part engine_block() {
    Part part{"engine_block", {}, {}, {}};
    constexpr Vec3 middle = {0, 0.47, 1.36};
    constexpr Vec3 half = {0.33, 0.24, 0.36};
    constexpr int stations = 5;
    Ring last;
    for (int i = 0; i < stations; ++i) {
        const double z = middle.z + half.z * (2.0 * i / (stations - 1) - 1);
        std::vector<Vec3> outline;  // a square with round corners, counter-clockwise from below
        for (int k = 0; k < 128; ++k) {
            const Turn t = turn((k + 96) % 128 / 128.0);
            const double square = 1 / std::max(std::abs(t.cosine), std::abs(t.sine));
            const double r = 0.32 + 0.60 * square;
            outline.push_back({middle.x + half.x * r * t.cosine, middle.y + half.y * r * t.sine, z});
        }
        const Ring ring = add_ring(part, outline, 12, i % 2 ? 0.5 : 0, locked);
        if (i == 0) close_with_point(part, reversed(ring), {middle.x, middle.y, z - 0.04}, locked);
        if (i > 0) stitch(part, last, ring);
        last = ring;
    }
    close_with_point(part, last, {middle.x, middle.y, middle.z + half.z + 0.04}, locked);
    return part;
}

// A drum around a wheel: the wheel keeps its shape whatever happens to the body.
Part wheel_house(const char* name, double side, double z) {
    constexpr int segments = 11;  // odd: no vertex faces another
    constexpr double half_width = 0.135;
    constexpr double dome = 0.03;
    const double rim = (car::wheel_radius + 0.02) / turn(0.5 / segments).cosine;  // the drum's flats clear the tyre
    Part part{name, {}, {}, {}};
    const Hoop profile[] = {{-half_width - dome, 0},      {-half_width - 0.7 * dome, 0.52 * rim, segments / 2},
                            {-half_width, rim, segments}, {0, 1.03 * rim, segments, 0.5},
                            {half_width, rim, segments},  {half_width + 0.7 * dome, 0.52 * rim, segments / 2},
                            {half_width + dome, 0}};
    add_revolved(part, {side * car::wheel_middle_x, car::wheel_radius, z}, profile, locked);
    return part;
}

}

Model car_shell() {
    return {body(),
            engine_block(),
            car::cage_shell(),
            wheel_house("wheel_house_front_left", 1, car::axle_z[0]),
            wheel_house("wheel_house_front_right", -1, car::axle_z[0]),
            wheel_house("wheel_house_rear_left", 1, car::axle_z[1]),
            wheel_house("wheel_house_rear_right", -1, car::axle_z[1])};
}

}
