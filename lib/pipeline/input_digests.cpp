// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/input_digests.h"

#include "store/read_file.h"
#include "store/sha256.h"

namespace crumple::pipeline {

BundleProvenance::Entry digest_input(const std::string& name, const std::string& path) {
    return {name, store::to_hex(store::sha256(store::read_file(path)))};
}

std::vector<BundleProvenance::Entry> digest_inputs(const importer::Sources& sources) {
    std::vector<BundleProvenance::Entry> digests{digest_input("shell", sources.shell)};
    const std::vector<std::string> names = importer::visual_names(sources);
    for (std::size_t i = 0; i < names.size(); ++i)
        digests.push_back(digest_input("visual/" + names[i], sources.visuals[i].path));
    return digests;
}

}
