// SPDX-License-Identifier: MIT
// FORMAT.md is what other engines write their readers from: it must name every dataset with its type.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>

#include "bundle/small_bundle.h"
#include "store/bundle_file.h"

using namespace crumple;
using namespace crumple::store;

namespace {

// Rows "| `name` | `type` | ..." of the tables, by name.
std::map<std::string, std::string> documented_types() {
    std::ifstream file(CRUMPLE_SOURCE_DIR "/lib/bundle/FORMAT.md");
    std::map<std::string, std::string> types;
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with("| `")) continue;
        std::istringstream cells(line.substr(3));
        std::string name;
        std::string type;
        std::getline(cells, name, '`');
        std::getline(cells, type, '`');
        std::getline(cells, type, '`');
        types[name] = type;
    }
    return types;
}

std::string generic_name(std::string path) {
    for (const std::string name : {"/paint/", "/roof/"}) {
        if (const std::size_t at = path.find(name); at != std::string::npos) path.replace(at, name.size(), "/<name>/");
    }
    return path;
}

}

TEST(FormatDocument, NamesEveryDatasetAndItsType) {
    const auto types = documented_types();
    const FileReader file(to_image(test::small_bundle()), "test.hdf");
    std::size_t count = 0;
    for (const std::string& path : file.all_datasets()) {
        const auto entry = types.find(generic_name(path));
        ASSERT_NE(entry, types.end()) << path << " is not in FORMAT.md";
        EXPECT_EQ(entry->second, name_of(file.info(path).type)) << path;
        ++count;
    }
    EXPECT_EQ(count, types.size()) << "FORMAT.md describes datasets that are not written";
}

TEST(FormatDocument, NamesTheSchemaVersion) {
    std::ifstream file(CRUMPLE_SOURCE_DIR "/lib/bundle/FORMAT.md");
    std::stringstream text;
    text << file.rdbuf();
    const std::string version = std::to_string(schema_major) + "." + std::to_string(schema_minor);
    EXPECT_NE(text.str().find("schema " + version), std::string::npos);
}
