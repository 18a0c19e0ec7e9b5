// SPDX-License-Identifier: MIT
#include "samples/samples.h"

#include <filesystem>
#include <fstream>

#include "core/error.h"
#include "samples/blob.h"
#include "samples/broken.h"
#include "samples/car.h"
#include "samples/ring.h"
#include "samples/write.h"

namespace crumple::samples {
namespace {

std::vector<File> car_files() {
    const Model shell = car_shell();
    return {{"car_shell.glb", glb_bytes(shell)},
            {"car_shell.obj", obj_bytes(shell)},
            {"car_shell.ply", ply_bytes(shell)},
            {"car_visual.glb", glb_bytes(car_visual())}};
}

std::vector<File> blob_files() {
    return {{"blob_shell.ply", ply_bytes(blob_shell())}, {"blob_visual.ply", ply_bytes(blob_visual())}};
}

std::vector<File> ring_files() {
    return {{"ring_shell.obj", obj_bytes(ring_shell())}, {"ring_visual.ply", ply_bytes(ring_visual())}};
}

std::vector<File> broken_files() {
    std::vector<File> files;
    for (const auto& shell : broken_shells())
        files.push_back({std::string(shell.name) + ".obj", obj_bytes(shell.make())});
    return files;
}

constexpr Sample table[] = {
    {"car", "a car: body, locked engine block, roll cage, wheel houses; a detailed visual mesh", car_files},
    {"blob", "a four-legged blob with locked feet and a finer visual mesh", blob_files},
    {"ring", "a ring with one locked side and a finer visual mesh", ring_files},
    {"broken", "shells with one fault each: what the tool says about them is worth reading", broken_files},
};

void write_file(const std::filesystem::path& path, const std::string& bytes) {
    std::ofstream stream(path, std::ios::binary | std::ios::trunc);
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    stream.close();
    if (!stream)
        throw Error(ErrorKind::file,
                    path.string() + ": cannot be written; check the folder's permissions and free space");
}

}

std::span<const Sample> list() { return table; }

const Sample& find(std::string_view name) {
    std::string known;
    for (const auto& sample : table) {
        if (sample.name == name) return sample;
        known += (known.empty() ? "" : ", ") + std::string(sample.name);
    }
    throw Error(ErrorKind::usage, "no sample is called '" + std::string(name) + "'; there are: " + known);
}

std::vector<std::string> write(std::string_view name, const std::string& folder) {
    const auto& sample = find(name);
    std::error_code problem;
    std::filesystem::create_directories(folder, problem);
    if (problem) throw Error(ErrorKind::file, folder + ": cannot be made a folder: " + problem.message());
    std::vector<std::string> paths;
    for (const auto& file : sample.make()) {
        const auto path = std::filesystem::path(folder) / file.name;
        write_file(path, file.bytes);
        paths.push_back(path.string());
    }
    return paths;
}

}
