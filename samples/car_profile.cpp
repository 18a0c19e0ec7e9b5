// SPDX-License-Identifier: MIT
#include "samples/car_profile.h"

#include <algorithm>

#include "samples/curve.h"

namespace crumple::samples::car {
namespace {

// Metres, from tail to nose.
constexpr Key roof_y[] = {{-2.15, 0.86}, {-2.02, 0.96}, {-1.70, 1.00}, {-1.52, 1.03}, {-0.95, 1.33},
                          {-0.40, 1.41}, {0.10, 1.38},  {0.25, 1.33},  {0.92, 0.94},  {1.10, 0.90},
                          {1.70, 0.81},  {2.05, 0.70},  {2.15, 0.60}};
constexpr Key cant_y[] = {{-2.15, 0.84}, {-2.02, 0.93}, {-1.70, 0.97}, {-1.52, 0.99}, {-0.95, 1.26},
                          {-0.40, 1.34}, {0.10, 1.30},  {0.25, 1.25},  {0.92, 0.91},  {1.10, 0.87},
                          {1.70, 0.78},  {2.05, 0.67},  {2.15, 0.58}};
constexpr Key belt_y[] = {{-2.15, 0.74}, {-2.00, 0.88}, {-1.30, 0.93}, {0.00, 0.88},
                          {1.00, 0.83},  {1.70, 0.73},  {2.05, 0.60},  {2.15, 0.52}};
constexpr Key cant_x[] = {{-2.15, 0.55}, {-2.00, 0.62}, {-1.60, 0.62}, {-1.00, 0.54}, {0.10, 0.56},
                          {0.92, 0.66},  {1.70, 0.66},  {2.05, 0.58},  {2.15, 0.48}};
constexpr Key side_x[] = {{-2.15, 0.64}, {-2.05, 0.74}, {-1.80, 0.81}, {-1.28, 0.86}, {-0.60, 0.85},
                          {0.50, 0.85},  {1.30, 0.86},  {1.75, 0.81},  {2.05, 0.70},  {2.15, 0.58}};
constexpr Key floor_y[] = {{-2.15, 0.42}, {-2.05, 0.32}, {-1.60, 0.22}, {-0.90, 0.17},
                           {0.90, 0.17},  {1.70, 0.20},  {2.05, 0.26},  {2.15, 0.34}};

// 1 above an axle, 0 away from it.
double near_axle(double z) {
    double nearest = 1;
    for (const double axle : axle_z) nearest = std::min(nearest, std::abs(z - axle));
    const double t = std::clamp((0.62 - nearest) / 0.30, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

// Grown by a margin on every side; `dip` lowers the floor beside the middle.
Section section_at(double z, double margin, double dip) {
    const double side = interpolate(side_x, z) + margin;
    const double floor = interpolate(floor_y, z) - margin;
    const double belt_height = interpolate(belt_y, z);
    // The glass is slanted: its rim moves out and up, so that the margin holds across it as well.
    const double rim_x = interpolate(cant_x, z) + margin;
    const double rim_y = interpolate(cant_y, z) + margin;
    const double top = interpolate(roof_y, z) + 1.25 * margin;
    Section section;
    section[floor_middle] = {0, floor, z};
    section[floor_side] = {0.52, floor - dip, z};
    section[sill] = {side - 0.01, floor - dip, z};
    section[flank] = {side + 0.01, 0.5 * (floor - dip + belt_height), z};
    section[belt] = {side - 0.01, belt_height + 0.6 * margin, z};
    section[cant] = {rim_x, rim_y, z};
    section[crown] = {0.6 * rim_x, top, z};
    section[roof_middle] = {0, top, z};
    return section;
}

}

Section body_section(double z) { return section_at(z, 0, 0); }

Section shell_section(double z) {
    // Stretched, so that nose and tail keep their margin too.
    Section section = section_at(z * nose_z / (nose_z + shell_margin), shell_margin, 0.24 * near_axle(z));
    for (auto& point : section) point.z = z;
    return section;
}

}
