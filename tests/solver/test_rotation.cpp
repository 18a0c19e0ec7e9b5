// SPDX-License-Identifier: MIT
#include "solver/rotation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "solver/body.h"
#include "solver/kernels.h"

namespace crumple::solver::test {
namespace {

constexpr RotationMethod all_methods[] = {RotationMethod::apd, RotationMethod::qr, RotationMethod::polar,
                                          RotationMethod::svd_smallest, RotationMethod::svd_last};
// Those that give the nearest rotation for any F.
constexpr RotationMethod nearest_methods[] = {RotationMethod::apd, RotationMethod::svd_smallest};

double distance(const Mat3& a, const Mat3& b) { return norm(a - b); }
bool is_rotation(const Mat3& r) { return distance(transpose(r) * r, Mat3::identity()) < 1e-5 && determinant(r) > 0; }
Mat3 diagonal(float a, float b, float c) { return {{a, 0, 0, 0, b, 0, 0, 0, c}}; }

Mat3 random_matrix(Rng& rng) { return Mat3::from_columns(random_vector(rng), random_vector(rng), random_vector(rng)); }

// U diag(s) V^T with stretches in [low, high].
Mat3 random_stretch(Rng& rng, double low, double high) {
    const auto next = [&] { return static_cast<float>(low + (high - low) * rng.next_unit()); };
    const Mat3 v = random_rotation(rng);
    const float a = next();
    const float b = next();
    const float c = next();
    return random_rotation(rng) * (v * diagonal(a, b, c) * transpose(v));
}

std::vector<Isa> runnable() {
    std::vector<Isa> isas{Isa::scalar};
    for (const Isa isa : {Isa::avx2, Isa::avx512}) {
        if (best_isa(isa) == isa) isas.push_back(isa);
    }
    return isas;
}

std::vector<Mat3> by_kernel(Isa isa, const std::vector<Mat3>& f, const std::vector<Mat3>& last) {
    std::vector<RotationPacket> packets((f.size() + packet_size - 1) / packet_size);
    for (std::size_t i = 0; i < packets.size() * packet_size; ++i) {
        const std::size_t real = std::min(i, f.size() - 1);
        RotationPacket& packet = packets[i / packet_size];
        const std::size_t lane = i % packet_size;
        for (std::size_t k = 0; k < 9; ++k) packet.f[k][lane] = f[real].m[k];
        const Quaternion q = to_quaternion(last[real]);
        const float values[4] = {q.x, q.y, q.z, q.w};
        for (std::size_t k = 0; k < 4; ++k) packet.rotation[k][lane] = values[k];
    }
    kernels(isa).rotations(packets.data(), 0, packets.size());
    std::vector<Mat3> result;
    for (std::size_t i = 0; i < f.size(); ++i) {
        const auto& q = packets[i / packet_size].rotation;
        const std::size_t lane = i % packet_size;
        result.push_back(to_matrix({q[0][lane], q[1][lane], q[2][lane], q[3][lane]}));
    }
    return result;
}

}

TEST(Rotation, AnElementThatIsALineOrAPointKeepsItsLastRotation) {
    const Mat3 last = turn({1, 2, 3}, 1);
    const Vec3f a{1, 2, -1};
    for (const RotationMethod method : all_methods) {
        EXPECT_EQ(rotation_function(method)(Mat3{}, last), last) << name_of(method);
        const Mat3 line = rotation_function(method)(outer(a, a), last);
        EXPECT_TRUE(is_rotation(line)) << name_of(method);
    }
    EXPECT_EQ(rotation_svd_smallest(outer(a, a), last), last);
    EXPECT_EQ(rotation_polar(outer(a, a), last), last);
    EXPECT_EQ(rotation_qr(outer(a, a), last), last);
}

TEST(Rotation, NumbersThatAreNotFiniteKeepTheLastRotation) {
    const Mat3 last = turn({1, 2, 3}, 1);
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 1e30f}) {
        Mat3 f = Mat3::identity();
        f(1, 2) = bad;
        for (const RotationMethod method : all_methods) {
            EXPECT_TRUE(is_rotation(rotation_function(method)(f, last))) << name_of(method) << " " << bad;
        }
        for (const Isa isa : runnable()) EXPECT_TRUE(is_rotation(by_kernel(isa, {f}, {last})[0])) << bad;
    }
}

TEST(Rotation, EveryMethodReturnsTheRotationOfARotatedBody) {
    Rng rng(1);
    for (int i = 0; i < 200; ++i) {
        const Mat3 r = random_rotation(rng);
        for (const RotationMethod method : all_methods) {
            EXPECT_LT(distance(rotation_function(method)(r, Mat3::identity()), r), 3e-6) << name_of(method);
        }
    }
}

TEST(Rotation, SizeDoesNotMatter) {
    Rng rng(2);
    const Mat3 f = random_stretch(rng, 0.5, 2);
    for (const float size : {1e-12f, 1e-3f, 1e4f, 1e12f}) {
        for (const RotationMethod method : all_methods) {
            const auto function = rotation_function(method);
            EXPECT_LT(distance(function(f * size, Mat3::identity()), function(f, Mat3::identity())), 1e-5)
                << name_of(method) << " " << size;
        }
    }
}

TEST(Rotation, AllButQrFindTheNearestRotationOfAStretchedBody) {
    Rng rng(3);
    for (int i = 0; i < 1000; ++i) {
        const Mat3 f = random_stretch(rng, 0.2, 3);
        const Mat3 expected = rotation_svd_smallest(f, Mat3::identity());
        for (const RotationMethod method : {RotationMethod::apd, RotationMethod::polar, RotationMethod::svd_last}) {
            EXPECT_LT(distance(rotation_function(method)(f, random_rotation(rng)), expected), 2e-5) << name_of(method);
        }
    }
}

TEST(Rotation, AMirroredBodyStillGetsARotation) {
    Rng rng(4);
    for (int i = 0; i < 1000; ++i) {
        Mat3 f = random_matrix(rng);
        if (determinant(f) > 0) f = f * -1;
        const Mat3 last = random_rotation(rng);
        for (const RotationMethod method :
             {RotationMethod::apd, RotationMethod::qr, RotationMethod::svd_smallest, RotationMethod::svd_last}) {
            EXPECT_TRUE(is_rotation(rotation_function(method)(f, last))) << name_of(method);
        }
        const Mat3 reflection = rotation_polar(f, last);
        EXPECT_LT(determinant(reflection), 0);
    }
}

TEST(Rotation, TheNearestRotationHasTheLargestTrace) {
    Rng rng(5);
    for (int i = 0; i < 300; ++i) {
        const Mat3 f = random_matrix(rng);
        for (const RotationMethod method : nearest_methods) {
            const float best = trace(transpose(rotation_function(method)(f, random_rotation(rng))) * f);
            for (int k = 0; k < 30; ++k) {
                EXPECT_GE(best + 1e-4f, trace(transpose(random_rotation(rng)) * f)) << name_of(method);
            }
        }
    }
}

TEST(Rotation, TheSignOnTheLastDirectionStaysNearerToTheLastRotation) {
    Rng rng(6);
    for (int i = 0; i < 300; ++i) {
        Mat3 f = random_matrix(rng);
        if (determinant(f) > 0) f = f * -1;
        const Mat3 last = random_rotation(rng);
        EXPECT_LE(distance(rotation_svd_last(f, last), last), distance(rotation_svd_smallest(f, last), last) + 1e-5);
    }
}

TEST(Rotation, SingularValuesComposeToTheMatrix) {
    Rng rng(7);
    for (int i = 0; i < 300; ++i) {
        const Mat3 f = random_matrix(rng);
        const Svd svd = singular_values(f);
        EXPECT_TRUE(is_rotation(svd.u) && is_rotation(svd.v));
        EXPECT_GE(svd.s.x, svd.s.y);
        EXPECT_GE(svd.s.y, std::fabs(svd.s.z));
        EXPECT_LT(distance(svd.u * diagonal(svd.s.x, svd.s.y, svd.s.z) * transpose(svd.v), f), 1e-6);
    }
}

// Sets A and B of the speed targets: error p99 <= 1e-5 against the decomposition in double.
TEST(Rotation, WideKernelsAreAccurateOnTheBenchmarkSets) {
    struct Set {
        double low, high, off_rad;
    };
    for (const Set set : {Set{0.8, 1.25, 0.0524}, Set{0.3, 2, 0.1745}}) {
        Rng rng(8);
        std::vector<Mat3> f, last;
        for (int i = 0; i < 8192; ++i) {
            f.push_back(random_stretch(rng, set.low, set.high));
            const Mat3 off = turn(random_vector(rng), set.off_rad);
            last.push_back(off * rotation_svd_smallest(f.back(), Mat3::identity()));
        }
        for (const Isa isa : runnable()) {
            const auto r = by_kernel(isa, f, last);
            std::vector<double> errors;
            for (std::size_t i = 0; i < f.size(); ++i) {
                errors.push_back(distance(r[i], rotation_svd_smallest(f[i], Mat3::identity())));
            }
            std::sort(errors.begin(), errors.end());
            EXPECT_LT(errors[errors.size() * 99 / 100], 1e-5) << name_of(isa);
            EXPECT_LT(errors.back(), 1e-3) << name_of(isa);
            RecordProperty("p99_" + std::string(name_of(isa)), std::to_string(errors[errors.size() * 99 / 100]));
        }
    }
}

TEST(Rotation, WideKernelsFindTheNearestRotationFromAnywhere) {
    Rng rng(9);
    std::vector<Mat3> f, last;
    for (int i = 0; i < 4096; ++i) {
        f.push_back(random_matrix(rng));
        last.push_back(random_rotation(rng));
    }
    for (const Isa isa : runnable()) {
        const auto r = by_kernel(isa, f, last);
        int far = 0;
        for (std::size_t i = 0; i < f.size(); ++i) {
            EXPECT_TRUE(is_rotation(r[i]));
            const float best = trace(transpose(rotation_svd_smallest(f[i], last[i])) * f[i]);
            // Where s1 and -s2 of a mirrored F meet within 1 %, two rotations are about as near; either will do.
            far += trace(transpose(r[i]) * f[i]) < best - 2e-2f * norm(f[i]);
        }
        EXPECT_EQ(far, 0) << name_of(isa);
    }
}

TEST(Rotation, HalfATurnAwayIsNotMistakenForArrived) {
    // R^T F is symmetric at half a turn about the long axis too, and its trace positive.
    const Mat3 f = diagonal(3, 1, 0.5f);
    const Mat3 last = turn({1, 0, 0}, 3.14159265358979);
    EXPECT_LT(distance(rotation_apd(f, last), Mat3::identity()), 1e-5);
    for (const Isa isa : runnable()) EXPECT_LT(distance(by_kernel(isa, {f}, {last})[0], Mat3::identity()), 1e-5);
}

}
