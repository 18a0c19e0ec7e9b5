// SPDX-License-Identifier: MIT
// Assets made by our own code, to try the tool on and to test it with. The files under samples/ are what these
// functions write, byte for byte, on every platform. `crumple dev sample NAME --out DIR` writes them again.
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace crumple::samples {

struct File {
    std::string name;   // without a folder: car_shell.glb
    std::string bytes;  // its whole content
};

struct Sample {
    std::string_view name;  // car
    std::string_view what;  // one line for a listing
    std::vector<File> (*make)();
};

// Every sample, in the order a reader should meet them. The files of one sample live in samples/<name>/.
[[nodiscard]] std::span<const Sample> list();

// Throws Error(usage), naming what there is, for an unknown name.
[[nodiscard]] const Sample& find(std::string_view name);

// Writes the files of one sample into an existing or new folder and returns their paths in order.
// Throws Error(usage) for an unknown name and Error(file) where the folder cannot be written.
std::vector<std::string> write(std::string_view name, const std::string& folder);

}
