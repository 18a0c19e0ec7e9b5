// SPDX-License-Identifier: GPL-3.0-or-later
// The sample car from its files to a bundle on the disk with the recipe car_body, on one thread: per stage, and "cook"
// for the whole with writing. Medians over the rounds of CPU time, the reader's child process included.
#include <filesystem>
#include <map>
#include <string>

#include "bench/bench.h"
#include "pipeline/builtin_recipes.h"
#include "pipeline/cook.h"
#include "samples/samples.h"

namespace crumple {
namespace {

struct Times {
    std::vector<double> cpu_s;
    std::vector<double> wall_s;
    double peak_memory_mb = 0;

    void add(const pipeline::Usage& usage) {
        cpu_s.push_back(usage.cpu_s);
        wall_s.push_back(usage.wall_s);
        peak_memory_mb = std::max(peak_memory_mb, usage.peak_memory_mb);
    }
};

pipeline::CookRequest request_in(const std::filesystem::path& folder) {
    pipeline::CookRequest request;
    for (const std::string& path : samples::write("car", folder.string())) {
        if (path.find("shell.glb") != std::string::npos) request.sources.shell = path;
        if (path.find("visual.glb") != std::string::npos) request.sources.visuals.push_back({"", path});
    }
    request.output = (folder / "car.hdf").string();
    return request;
}

std::vector<bench::Row> measure(benchmark::State& state) {
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / "crumple_bench_cook";
    std::filesystem::create_directories(folder);
    const pipeline::CookRequest request = request_in(folder);
    const pipeline::RecipeText text = pipeline::load_recipe_text("car_body");
    const pipeline::Recipe recipe = pipeline::read_recipe(text.json, text.source);
    std::map<std::string, Times> times;
    std::vector<std::string> order;
    while (state.KeepRunning()) {
        pipeline::CookReport report;
        pipeline::cook(recipe, request, report);
        order.clear();
        for (const pipeline::StageRun& stage : report.stages) {
            times[stage.name].add(stage.usage);
            order.push_back(stage.name);
        }
        times["cook"].add(report.usage);
        state.SetIterationTime(report.usage.cpu_s);
    }
    order.push_back("cook");
    std::filesystem::remove_all(folder);
    std::vector<bench::Row> rows;
    for (const std::string& name : order) {
        const Times& t = times[name];
        rows.push_back({name,
                        "car_65k",
                        {{"cpu_s", bench::median(t.cpu_s)},
                         {"wall_s", bench::median(t.wall_s)},
                         {"peak_memory_mb", t.peak_memory_mb}}});
    }
    return rows;
}

void add_all(bool quick) { bench::add("cook/car_65k", measure)->Iterations(quick ? 3 : 11); }

}
}

int main(int argc, char** argv) { return crumple::bench::run(argc, argv, crumple::add_all); }
