// SPDX-License-Identifier: MIT
// embed BLOB [THREADS [FRAMES]]: twenty cars drive into a wall, and what each frame took.
// What a game does with crumple, in one file: memory for everything is taken before the first frame.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <memory>
#include <new>
#include <string>
#include <thread>
#include <vector>

#include "bundle/blob.h"
#include "solver/blob_view.h"
#include "solver/instance.h"
#include "solver/skin.h"

namespace embed {

using crumple::Blob;
using crumple::Material;
using crumple::Vec3;
using crumple::Vec3f;
namespace solver = crumple::solver;

constexpr int car_count = 20;
constexpr float dt = 1.0f / 60;

// Bytes on a 64-byte boundary: what the solver wants of every block of memory.
struct Memory {
    explicit Memory(std::size_t bytes) : bytes_(bytes), data_(new (std::align_val_t{64}) std::byte[bytes]()) {}
    [[nodiscard]] std::span<std::byte> get() const { return {data_.get(), bytes_}; }

private:
    struct Delete {
        void operator()(std::byte* data) const { ::operator delete[](data, std::align_val_t{64}); }
    };
    std::size_t bytes_;
    std::unique_ptr<std::byte[], Delete> data_;
};

Memory read_file(const char* path) {
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    Memory memory(text.size());
    std::transform(text.begin(), text.end(), memory.get().begin(), [](char c) { return static_cast<std::byte>(c); });
    return memory;
}

// What all cars share. The blob is used where it lies.
struct Asset {
    Memory file;
    Blob blob;
    std::vector<Material> materials;
    Memory memory{0};
    solver::Model model;

    explicit Asset(const char* path) : file(read_file(path)) {
        const char* problem = open_blob(file.get(), blob);
        if (problem == nullptr) {
            materials.resize(blob.materials.size());
            const solver::BundleView view = solver::view_of(blob, materials);
            problem = solver::first_problem(view);
            if (problem == nullptr) {
                memory = Memory(solver::model_bytes(view));
                model = solver::build_model(view, memory.get());
            }
        }
        if (problem != nullptr) {
            std::fprintf(stderr, "embed: %s: %s\n", path, problem);
            std::exit(1);
        }
    }
};

// Stands for the rigid body of a game's physics engine. All in the world but the centre of mass.
struct RigidBody {
    double mass = 0;
    Vec3 centre;  // of mass, in the frame of the asset
    solver::Mat3d inverse_inertia;
    Vec3 position;  // of the centre of mass
    Vec3 velocity;
    Vec3 spin;  // angular momentum
    Vec3 angular_velocity;
    solver::Quaternion orientation;

    // With the mass of all nodes, its frame at `place`.
    RigidBody(const Blob& blob, Vec3 place, Vec3 speed);
    [[nodiscard]] solver::Mat3d turn() const;
    // Of the frame's origin, as the solver wants it.
    [[nodiscard]] solver::CarrierMotion motion() const;
    void move(const solver::CarrierLoad& load);
};

RigidBody::RigidBody(const Blob& blob, Vec3 place, Vec3 speed) : velocity(speed) {
    for (std::size_t i = 0; i < blob.mass.size(); ++i) {
        mass += static_cast<double>(blob.mass[i]);
        centre += widen(blob.rest_positions[i]) * static_cast<double>(blob.mass[i]);
    }
    centre = centre / mass;
    position = place + centre;
    solver::Mat3d inertia;
    for (std::size_t i = 0; i < blob.mass.size(); ++i) {
        const Vec3 r = widen(blob.rest_positions[i]) - centre;
        inertia =
            inertia + (solver::Mat3d::identity() * dot(r, r) - solver::outer(r, r)) * static_cast<double>(blob.mass[i]);
    }
    inverse_inertia = transpose(cofactor(inertia)) * (1 / determinant(inertia));
}

solver::Mat3d RigidBody::turn() const {
    const solver::Mat3 rotation = to_matrix(orientation);
    solver::Mat3d wide;
    std::copy(rotation.m.begin(), rotation.m.end(), wide.m.begin());
    return wide;
}

solver::CarrierMotion RigidBody::motion() const {
    const Vec3 arm = turn() * centre;
    solver::CarrierMotion motion;
    motion.position = position - arm;
    motion.orientation = orientation;
    motion.velocity = velocity - cross(angular_velocity, arm);
    motion.angular_velocity = angular_velocity;
    return motion;
}

void RigidBody::move(const solver::CarrierLoad& load) {
    const double step = static_cast<double>(dt);
    const solver::Mat3d rotation = turn();
    velocity += load.force * (step / mass);
    spin += (load.torque - cross(rotation * centre, load.force)) * step;
    angular_velocity = rotation * (inverse_inertia * (transpose(rotation) * spin));
    position += velocity * step;
    const Vec3 w = angular_velocity * step;
    const solver::Mat3d tilt{{0, -w.z, w.y, w.z, 0, -w.x, -w.y, w.x, 0}};
    const solver::Mat3d turned = rotation + tilt * rotation;
    solver::Mat3 narrow;
    std::transform(turned.m.begin(), turned.m.end(), narrow.m.begin(), [](double x) { return static_cast<float>(x); });
    orientation = to_quaternion(solver::rotation_polar(narrow, to_matrix(orientation)));
}

// One car: its sheet metal and its rigid body.
struct Car {
    Memory memory;
    solver::State state;
    RigidBody body;
    std::vector<Vec3f> drawn;

    Car(const Asset& asset, int number)
        : memory(solver::state_bytes(asset.model, solver::Plasticity::additive)),
          state(solver::make_state(asset.model, solver::Plasticity::additive, memory.get())),
          body(asset.blob, {4.0 * number, 0, -3.0 - 0.2 * number}, {0, 0, 15}) {
        if (asset.blob.counts.visuals > 0) drawn.resize(visual_of(asset.blob, 0).tet.size());
    }
};

// What a thread needs for any car, one after the other.
struct Worker {
    Memory memory;
    solver::Workspace workspace;
    std::vector<solver::Constraint> room;

    explicit Worker(const Asset& asset)
        : memory(solver::workspace_bytes(asset.model)),
          workspace(solver::make_workspace(asset.model, memory.get())),
          room(asset.model.node_count) {}
};

void step_car(const Asset& asset, Car& car, Worker& worker) {
    solver::Obstacle wall;
    wall.axis = {0, 0, -1};  // solid beyond z = 0

    solver::InstanceInput input;
    input.dt = dt;
    input.carrier = car.body.motion();
    input.carrier_mass = car.body.mass;
    input.gravity = {};  // the wheels carry the weight
    input.obstacles = {&wall, 1};
    input.room = worker.room;
    const solver::InstanceReport report = solver::step_instance(asset.model, car.state, worker.workspace, input);

    car.body.move(report.load);  // before the next step

    // Only what moved is skinned and would be sent to the graphics processor.
    if (report.is_asleep || car.drawn.empty()) return;
    const solver::VisualView visual = solver::view_of(asset.blob, visual_of(asset.blob, 0));
    const solver::VertexRange range = solver::moved_vertices(asset.model, car.state, visual, 1e-3f);
    solver::skin(asset.model, car.state, visual, {}, {car.drawn, {}, {}}, range);
    solver::forget_moves(car.state);
}

// Threads take the next car until none is left. A game has a job system for this.
void step_all(const Asset& asset, std::vector<Car>& cars, std::vector<Worker>& workers) {
    std::atomic<std::size_t> next{0};
    const auto work = [&](Worker& worker) {
        for (std::size_t i = next++; i < cars.size(); i = next++) step_car(asset, cars[i], worker);
    };
    std::vector<std::thread> threads;
    for (std::size_t i = 1; i < workers.size(); ++i) threads.emplace_back(work, std::ref(workers[i]));
    work(workers[0]);
    for (std::thread& thread : threads) thread.join();
}

double milliseconds_of(const std::chrono::steady_clock::time_point& start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

float deepest_dent(const Asset& asset, const Car& car) {
    float deepest = 0;
    for (std::size_t node = 0; node < asset.model.node_count; ++node) {
        deepest = std::max(deepest, length(solver::position(car.state, node) - asset.blob.rest_positions[node]));
    }
    return deepest;
}

int count_asleep(const std::vector<Car>& cars) {
    return static_cast<int>(
        std::count_if(cars.begin(), cars.end(), [](const Car& car) { return solver::is_asleep(car.state); }));
}

void print_times(const char* when, std::vector<double>& times) {
    if (times.empty()) return;
    std::sort(times.begin(), times.end());
    std::printf("%s  %3zu frames: median %.3f ms, p99 %.3f ms, worst %.3f ms\n", when, times.size(),
                times[times.size() / 2], times[times.size() * 99 / 100], times.back());
}

// A whole number from 1 to `most`, or 0.
int count_of(const char* text, int most) {
    char* end = nullptr;
    const long count = std::strtol(text, &end, 10);
    return end != text && *end == 0 && count >= 1 && count <= most ? static_cast<int>(count) : 0;
}

int run(int argc, char** argv) {
    const int thread_count = argc > 2 ? count_of(argv[2], 64) : 1;
    const int frame_count = argc > 3 ? count_of(argv[3], 1000000) : 180;
    if (argc < 2 || argc > 4 || thread_count == 0 || frame_count == 0) {
        std::fprintf(stderr, "embed BLOB [THREADS [FRAMES]]: 1 to 64 threads, 1 to 1000000 frames\n");
        return 1;
    }

    const Asset asset(argv[1]);
    std::vector<Car> cars;
    for (int i = 0; i < car_count; ++i) cars.emplace_back(asset, i);
    std::vector<Worker> workers;
    for (int i = 0; i < thread_count; ++i) workers.emplace_back(asset);

    std::vector<double> busy;   // frames in which a car is awake
    std::vector<double> quiet;  // all asleep
    for (int frame = 0; frame < frame_count; ++frame) {
        const auto start = std::chrono::steady_clock::now();
        step_all(asset, cars, workers);
        (count_asleep(cars) == car_count ? quiet : busy).push_back(milliseconds_of(start));
    }
    std::printf("%d cars of %zu tets, %d frames of %.1f ms, %d thread%s\n", car_count, asset.model.tet_count,
                frame_count, 1000.0 * static_cast<double>(dt), thread_count, thread_count == 1 ? "" : "s");
    print_times("while cars crumple ", busy);
    print_times("while all are still", quiet);
    std::vector<float> dents;
    for (const Car& car : cars) dents.push_back(deepest_dent(asset, car));
    const auto [least, most] = std::minmax_element(dents.begin(), dents.end());
    std::printf("dents %.3f to %.3f m deep, the first car leaves the wall at %.2f m/s; %d of %d asleep at the end\n",
                static_cast<double>(*least), static_cast<double>(*most), -cars[0].body.velocity.z, count_asleep(cars),
                car_count);
    return 0;
}

}

int main(int argc, char** argv) { return embed::run(argc, argv); }
