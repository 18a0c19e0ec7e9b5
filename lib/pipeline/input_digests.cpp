// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/input_digests.h"

#include <filesystem>

#include "store/read_file.h"
#include "store/sha256.h"

namespace crumple::pipeline {

BundleProvenance::Entry digest_input(const std::string& name, const std::string& path) {
    return {name, store::to_hex(store::sha256(store::read_file(path)))};
}

std::vector<BundleProvenance::Entry> digest_inputs(const importer::Sources& sources) {
    std::vector<BundleProvenance::Entry> digests{digest_input("shell", sources.shell)};
    for (const auto& visual : sources.visuals) {
        const std::string name = visual.name.empty() ? std::filesystem::path(visual.path).stem().string() : visual.name;
        digests.push_back(digest_input("visual/" + name, visual.path));
    }
    return digests;
}

}
