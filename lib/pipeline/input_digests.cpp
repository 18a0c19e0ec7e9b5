// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/input_digests.h"

#include "core/error.h"
#include "pipeline/stage_table.h"
#include "store/read_file.h"
#include "store/sha256.h"

namespace crumple::pipeline {

namespace {

// What a file of the artist's refers to is part of its content: that it is missing is no fault of the call.
BundleProvenance::Entry digest_of(const importer::InputFile& file) {
    if (file.owner.empty()) return digest_input(file.name, file.path);
    try {
        return digest_input(file.name, file.path);
    } catch (const Error& error) {
        throw Error(ErrorKind::bad_input, file.owner + ": it needs a file that is not to be had: " + error.what() +
                                              "; keep the files together, or export .glb");
    }
}

}

std::vector<importer::InputFile> input_files(const importer::Sources& sources, const Recipe& recipe) {
    return importer::input_files(sources, recipe.params[stage_index("import")].as<importer::Params>());
}

BundleProvenance::Entry digest_input(const std::string& name, const std::string& path) {
    return {name, store::to_hex(store::sha256(store::read_file(path)))};
}

std::vector<BundleProvenance::Entry> digest_inputs(const std::vector<importer::InputFile>& files) {
    std::vector<BundleProvenance::Entry> digests;
    for (const importer::InputFile& file : files) digests.push_back(digest_of(file));
    return digests;
}

}
