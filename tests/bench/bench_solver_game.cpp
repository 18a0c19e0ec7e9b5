// SPDX-License-Identifier: GPL-3.0-or-later
// What a game feels besides a step: sleepers, skinning, loading, the caller's threads.
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "bench/bench_solver_rows.h"
#include "bench/second_worker.h"
#include "bench/solver_car.h"
#include "bench/stream_read.h"
#include "bundle/blob.h"
#include "solver/blob_view.h"
#include "solver/body.h"
#include "solver/instance.h"
#include "solver/skin.h"
#include "store/bundle_file.h"

namespace crumple::bench {
namespace {

using solver::test::Body;
using solver::test::grid_body;

Material bodywork() {
    Material m = solver::test::elastic_material(1e6, 0.3);
    m.yield_pa = 2e4;
    m.alpha_per_s = 1;
    m.beta_s = 0.004;
    return m;
}

Bundle car_sized() {
    return grid_body({18, 9, 9}, {0.25f, 0.2f, 0.15f}, bodywork(), [](Vec3f p) { return p.x > 4; });
}

// Read of as many bytes.
double read_seconds(std::size_t bytes) {
    const std::vector<float> data(bytes / 4, 1.0f);
    double best = 1e30;
    volatile float sink = 0;
    for (int round = 0; round < 10; ++round) best = std::min(best, seconds([&] { sink = sum_of(data); }));
    (void)sink;
    return best;
}

void write_bytes(const std::string& path, std::span<const std::byte> bytes) {
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

// What a game does with a blob on its disk: read, check, derive.
void open_and_build(const std::string& path) {
    const Block file(std::filesystem::file_size(path));
    std::ifstream(path, std::ios::binary)
        .read(reinterpret_cast<char*>(file.get().data()), static_cast<std::streamsize>(file.get().size()));
    Blob blob;
    if (open_blob(file.get(), blob) != nullptr) throw std::runtime_error("bench: a blob of ours is refused");
    std::vector<Material> materials(blob.materials.size());
    const solver::BundleView view = solver::view_of(blob, materials);
    if (first_problem(view) != nullptr) throw std::runtime_error("bench: a bundle of ours is refused");
    const Block memory(solver::model_bytes(view));
    (void)solver::build_model(view, memory.get());
}

}

void add_asleep(std::vector<Row>& rows) {
    Body body(car_sized());
    std::vector<solver::Constraint> room(body.node_count());
    solver::Obstacle wall;
    wall.axis = {1, 0, 0};
    wall.position = {-5, 0, 0};
    solver::InstanceInput input;
    input.obstacles = {&wall, 1};
    input.room = room;
    const auto step = [&] { return step_instance(body.model, body.state, body.workspace, input, body.settings); };
    for (int i = 0; i < 3000 && !step().is_asleep; ++i) {
    }
    constexpr int steps = 100000;
    const double begin = cpu_seconds();
    for (int i = 0; i < steps; ++i) step();
    const double time = (cpu_seconds() - begin) / steps;
    rows.push_back(row("asleep_us", "car_sized", is_asleep(body.state) ? 1e6 * time : -1, "us"));
}

void add_skin(std::vector<Row>& rows) {
    constexpr std::size_t count = 100000;
    Body body(car_sized());
    std::vector<Index> tet(count);
    std::vector<std::array<float, 4>> weights(count, {0.25f, 0.25f, 0.25f, 0.25f});
    std::vector<Vec3f> rest(count, {0, 1, 0}), positions(count), normals(count);
    // A drawn mesh is as local as the tets it hangs on.
    for (std::size_t v = 0; v < count; ++v) tet[v] = static_cast<Index>(v * body.bundle.tets.size() / count);
    const solver::VisualView view{body.bundle.tets, tet, weights};
    body.step(1.0f / 60);
    double best = 1e30;
    for (int round = 0; round < 30; ++round) {
        best = std::min(
            best, seconds([&] {
                skin(body.model, body.state, view, {rest, {}}, {positions, normals, {}}, {0, count}, body.settings);
            }));
    }
    rows.push_back(row("skin_100k", "grid", read_seconds(88 * count) / best, "of memory bandwidth"));
    rows.push_back(row("skin_100k_ms", "grid", 1e3 * best, "ms"));
}

void add_load(Rows& rows, const Bar& bar) {
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / "crumple_bench_load";
    std::filesystem::create_directories(folder);
    const std::string file = (folder / "bar.hdf").string(), packed = (folder / "bar.blob").string();
    write_bytes(file, store::to_image(bar.bundle));
    write_bytes(packed, write_blob(bar.bundle));
    std::vector<double> from_file, from_blob;
    for (int round = 0; round < 7; ++round) {
        from_file.push_back(seconds([&] { (void)store::load_bundle(file); }));
        from_blob.push_back(seconds([&] { open_and_build(packed); }));
    }
    std::filesystem::remove_all(folder);
    rows.push_back(row("load_50k", bar.name, 1e3 * median(from_file), "ms"));
    rows.push_back(row("load_50k_blob", bar.name, 1e3 * median(from_blob), "ms"));
}

void add_two_threads(Rows& rows, const Bar& bar, std::uint32_t iterations) {
    solver::Settings settings;
    settings.max_iterations = iterations;
    settings.plasticity = solver::Plasticity::off;
    Body body(bar.bundle, settings);
    SecondWorker worker;
    std::vector<double> ratios, times;
    for (int i = 0; i < 30; ++i) {
        const double alone = processor_seconds([&] { body.step(bar_input()); }, thread_cpu_seconds);
        const double together = worker.seconds_of([&] { body.step(bar_input(), worker.jobs()); });
        if (i < 5) continue;
        ratios.push_back(alone / together);
        times.push_back(1e3 * together);
    }
    rows.push_back(row("two_threads_50k", bar.name, median(times), "ms", median(ratios)));
}

}
