// SPDX-License-Identifier: MIT
#include "samples/blob.h"

#include "samples/icosphere.h"

namespace crumple::samples {
namespace {

// A bump of the radius around a direction: height at its middle, 0 beyond the angle whose cosine is `edge`.
struct Bump {
    Vec3 direction;
    double height;
    double edge;
};

constexpr Bump bumps[] = {
    {{0.55, -0.80, 0.60}, 0.55, 0.80},  {{-0.55, -0.80, 0.60}, 0.55, 0.80},   // fore feet
    {{0.55, -0.80, -0.60}, 0.55, 0.80}, {{-0.55, -0.80, -0.60}, 0.55, 0.80},  // hind feet
    {{0.00, 0.45, 1.00}, 0.60, 0.70},                                         // head
    {{0.00, 0.20, -1.00}, 0.20, 0.80},                                        // tail
};

double radius(Vec3 direction) {
    double r = 0.5;
    for (const auto& bump : bumps) {
        const double cosine = dot(direction, bump.direction) / length(bump.direction);
        const double t = (cosine - bump.edge) / (1 - bump.edge);
        if (t > 0) r += 0.5 * bump.height * t * t * (3 - 2 * t);
    }
    return r;
}

Part blob(const char* name, int level, double scale) {
    const Icosphere ball = icosphere(level);
    Part part{name, {}, {}, ball.triangles};
    for (const auto& d : ball.directions) {
        const Vec3 p = d * radius(d);
        add_vertex(part, Vec3{p.x, p.y + 0.6, p.z} * scale + Vec3{0, 0.6, 0} * (1 - scale), unlocked);
    }
    return part;
}

}

Model blob_shell() {
    Part part = blob("blob", 3, 1.0);
    for (std::size_t v = 0; v < part.positions.size(); ++v) {
        if (part.positions[v].y < 0.08) part.colors[v] = locked;
    }
    return {part};
}

Model blob_visual() { return {blob("blob", 5, 0.92)}; }

}
