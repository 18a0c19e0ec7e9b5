// SPDX-License-Identifier: GPL-3.0-or-later
// What every stage makes of the samples, by digest. A stage that gives another result for the same input must have
// another version: caches and bundles rely on it. To accept new digests:
//
//     CRUMPLE_UPDATE_GOLDEN=1 test_pipeline --gtest_filter='Golden.*'
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>

#include "core/error.h"
#include "pipeline/builtin_recipes.h"
#include "pipeline/bundle_gates.h"
#include "pipeline/runner.h"
#include "pipeline/work_parts.h"
#include "report/json_reader.h"
#include "report/json_writer.h"
#include "samples/samples.h"
#include "store/bundle_file.h"
#include "store/check_file.h"
#include "store/read_file.h"
#include "store/write_file.h"

namespace golden {

struct Entry {
    int version = 0;
    std::string input;   // digest of what the stage read, with its parameters
    std::string output;  // digest of the group it wrote
};

template <class Visitor, crumple::FieldsOf<Entry> E>
void describe(Visitor& visit, E& e) {
    visit.field("version", e.version, "of the stage");
    visit.field("input", e.input, "digest of what the stage read, with its parameters");
    visit.field("output", e.output, "digest of the group it wrote");
}

struct Golden {
    std::map<std::string, std::map<std::string, Entry>> samples;  // sample -> stage -> digests
};

template <class Visitor, crumple::FieldsOf<Golden> G>
void describe(Visitor& visit, G& g) {
    visit.field("samples", g.samples, "sample, then stage");
}

}

namespace {

using crumple::pipeline::Group;
using crumple::pipeline::Stage;
using crumple::pipeline::Workspace;

const std::string golden_path = CRUMPLE_GOLDEN_FOLDER "/stages.json";

// Of the content only: how it is packed depends on the zlib that packs it.
std::string digest_of(const Workspace& work, Group group) {
    crumple::store::FileWriter file;
    switch (group) {
        case Group::asset:
            crumple::pipeline::write_asset(file, *work.asset);
            break;
        case Group::points:
            crumple::pipeline::write_points(file, *work.points);
            break;
        case Group::tets:
            crumple::pipeline::write_tets(file, *work.tets);
            break;
        case Group::bindings:
            crumple::pipeline::write_bindings(file, *work.bindings);
            break;
        case Group::bundle: {
            crumple::Bundle bundle = *work.bundle;
            bundle.provenance = {};  // names every other stage's version and parameters
            crumple::store::write_bundle(file, bundle);
        }
    }
    return crumple::store::content_digest(crumple::store::FileReader(file.finish(), "golden"));
}

// What gates makes is what it says: it writes nothing else.
std::string digest_of_figures(const Workspace& work) {
    const auto told = crumple::pipeline::told_gates(work.records);
    const std::string figures = crumple::report::write_json(crumple::report::Described::of(told->report.figures));
    return crumple::store::to_hex(crumple::store::sha256(std::as_bytes(std::span(figures))));
}

std::string input_of(const Stage& stage, const Workspace& work, const crumple::report::OwnedDescribed& params) {
    std::string text = crumple::report::write_json(params.view(), crumple::report::JsonStyle::compact);
    for (const auto& entry : work.input_digests) {
        if (stage.reads.empty()) text += entry.name + entry.value;
    }
    for (const Group group : stage.reads) text += digest_of(work, group);
    return crumple::store::to_hex(crumple::store::Sha256().update(std::string_view(text)).finish());
}

Workspace sample_on_disk(std::string_view name, const std::string& folder) {
    Workspace work;
    for (const std::string& path : crumple::samples::write(name, folder)) {
        const std::string file = std::filesystem::path(path).filename().string();
        if (file.find("shell") != std::string::npos && work.sources.shell.empty()) work.sources.shell = path;
        if (file.find("visual") != std::string::npos && work.sources.visuals.empty()) {
            work.sources.visuals.push_back({"visual", path});
        }
    }
    return work;
}

std::map<std::string, golden::Entry> cook_sample(std::string_view name) {
    const std::string folder = testing::TempDir() + "crumple_golden_" + std::string(name);
    std::filesystem::create_directories(folder);
    Workspace work = sample_on_disk(name, folder);
    work.input_digests = {
        {"shell", crumple::store::to_hex(crumple::store::sha256(crumple::store::read_file(work.sources.shell)))}};
    const auto text = crumple::pipeline::load_recipe_text("car_body");
    const auto recipe = crumple::pipeline::read_recipe(text.json, text.source);
    std::map<std::string, golden::Entry> entries;
    for (std::size_t i = 0; i < crumple::pipeline::stage_table().size(); ++i) {
        const Stage& stage = crumple::pipeline::stage_table()[i];
        golden::Entry entry{stage.version, input_of(stage, work, recipe.params[i]), ""};
        (void)run_stage(stage, recipe.params[i], work, 2);
        entry.output = stage.name == "gates" ? digest_of_figures(work) : digest_of(work, stage.writes);
        entries[std::string(stage.name)] = entry;
    }
    std::filesystem::remove_all(folder);
    return entries;
}

golden::Golden read_golden() {
    const auto bytes = crumple::store::read_file(golden_path);
    golden::Golden golden;
    crumple::report::read_json({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, golden_path,
                               crumple::report::Described::of(golden));
    return golden;
}

void expect_same(const std::string& stage, const golden::Entry& old, const golden::Entry& now) {
    if (old.version == now.version && old.input == now.input) {
        EXPECT_EQ(old.output, now.output)
            << "stage " << stage << " gives another result for the same input: raise `version` in "
            << "lib/" << stage << " and accept the new digests";
        return;
    }
    const bool is_same = old.version == now.version && old.output == now.output;
    EXPECT_TRUE(is_same) << stage
                         << ": its version or its input changed; accept the new digests with CRUMPLE_UPDATE_GOLDEN=1";
}

}

TEST(Golden, AStageWithAnotherResultHasAnotherVersion) {
    golden::Golden now;
    for (const char* sample : {"car", "blob"}) now.samples[sample] = cook_sample(sample);
    if (std::getenv("CRUMPLE_UPDATE_GOLDEN")) {
        const std::string json = crumple::report::write_json(crumple::report::Described::of(now));
        crumple::store::write_file(golden_path, std::as_bytes(std::span(json)));
        GTEST_SKIP() << "wrote " << golden_path;
    }
    const golden::Golden old = read_golden();
    for (const auto& [sample, stages] : now.samples) {
        for (const auto& [stage, entry] : stages) {
            ASSERT_TRUE(old.samples.contains(sample) && old.samples.at(sample).contains(stage))
                << sample << " " << stage;
            SCOPED_TRACE(sample);
            expect_same(stage, old.samples.at(sample).at(stage), entry);
        }
    }
}
