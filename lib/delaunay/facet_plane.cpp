// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay/facet_plane.h"

#include <algorithm>
#include <limits>

#include "geometry/clones.h"

namespace crumple::delaunay {
namespace {

constexpr double unit_roundoff = 0x1p-53;
constexpr double smallest_normal = 0x1p-400;
constexpr double largest_curvature = 0x1p100;
constexpr double round_up = 1 + 0x1p-20;

struct Inputs {
    const double* __restrict x;
    const double* __restrict y;
    const double* __restrict z;
    const double* __restrict square;
    const double* __restrict largest;
    const std::uint32_t* __restrict a;
    const std::uint32_t* __restrict b;
    const std::uint32_t* __restrict c;
};

struct Outputs {
    float* __restrict nx;
    float* __restrict ny;
    float* __restrict nz;
    float* __restrict curvature;
    float* __restrict normal_error;
    float* __restrict curvature_error;
};

CRUMPLE_CLONES("avx512f", "avx2", "default")
void fill(const Inputs in, const Outputs out, const std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t a = in.a[i], b = in.b[i], c = in.c[i];
        const double ax = in.x[a], ay = in.y[a], az = in.z[a], aa = in.square[a], am = in.largest[a];
        const double bx = in.x[b], by = in.y[b], bz = in.z[b], bb = in.square[b], bm = in.largest[b];
        const double cx = in.x[c], cy = in.y[c], cz = in.z[c], cc = in.square[c], cm = in.largest[c];
        const double bcx = by * cz - bz * cy, bcy = bz * cx - bx * cz, bcz = bx * cy - by * cx;
        const double cax = cy * az - cz * ay, cay = cz * ax - cx * az, caz = cx * ay - cy * ax;
        const double abx = ay * bz - az * by, aby = az * bx - ax * bz, abz = ax * by - ay * bx;
        const double nx = aa * bcx + bb * cax + cc * abx;
        const double ny = aa * bcy + bb * cay + cc * aby;
        const double nz = aa * bcz + bb * caz + cc * abz;
        const double volume = ax * bcx + ay * bcy + az * bcz;
        const double xy = std::fabs(nx) > std::fabs(ny) ? std::fabs(nx) : std::fabs(ny);
        const double largest = xy > std::fabs(nz) ? xy : std::fabs(nz);
        const double inverse = 1 / largest;
        const double curvature = -volume * inverse;
        const double magnitude = std::fabs(curvature);
        const double normal_error = 32 * unit_roundoff * (aa * bm * cm + bb * cm * am + cc * am * bm) * inverse;
        const double volume_error = 60 * unit_roundoff * (am * bm * cm) * inverse;
        const bool usable = largest >= smallest_normal && magnitude <= largest_curvature;
        const double unusable = usable ? 0.0 : std::numeric_limits<double>::infinity();
        out.nx[i] = static_cast<float>(nx * inverse);
        out.ny[i] = static_cast<float>(ny * inverse);
        out.nz[i] = static_cast<float>(nz * inverse);
        out.curvature[i] = static_cast<float>(curvature);
        out.normal_error[i] = static_cast<float>((normal_error + (0x1p-25 + 0x1p-48)) * round_up + unusable);
        out.curvature_error[i] =
            static_cast<float>((volume_error + (0x1p-24 + 0x1p-48) * magnitude + 0x1p-120) * round_up + unusable);
    }
}

}

void StarVertices::resize(std::size_t count) {
    for (auto* values : {&x, &y, &z, &square, &largest}) values->resize(count);
}

void StarVertices::set(std::size_t i, double dx, double dy, double dz) {
    x[i] = dx;
    y[i] = dy;
    z[i] = dz;
    square[i] = dx * dx + dy * dy + dz * dz;
    largest[i] = std::max(std::max(std::fabs(dx), std::fabs(dy)), std::fabs(dz));
}

void StarVertices::set_infinite(std::size_t i) {
    x[i] = y[i] = z[i] = largest[i] = 0;
    square[i] = 1;
}

void StarPlanes::resize(std::size_t count) {
    for (auto& values : corner) values.resize(count);
    for (auto& values : normal) values.resize(count);
    for (auto* values : {&curvature, &normal_error, &curvature_error}) values->resize(count);
}

void make_planes(const StarVertices& vertices, StarPlanes& planes, std::size_t count) {
    const Inputs in{vertices.x.data(),       vertices.y.data(),       vertices.z.data(),       vertices.square.data(),
                    vertices.largest.data(), planes.corner[0].data(), planes.corner[1].data(), planes.corner[2].data()};
    const Outputs out{planes.normal[0].data(), planes.normal[1].data(),    planes.normal[2].data(),
                      planes.curvature.data(), planes.normal_error.data(), planes.curvature_error.data()};
    fill(in, out, count);
}

}
