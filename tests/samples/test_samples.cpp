// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "core/error.h"
#include "samples/blob.h"
#include "samples/broken.h"
#include "samples/ring.h"
#include "samples/samples.h"
#include "samples/write.h"

namespace crumple::samples {
namespace {

namespace fs = std::filesystem;

std::string content(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(Samples, UnknownNameListsWhatThereIs) {
    try {
        (void)find("lorry");
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
        EXPECT_NE(std::string(error.what()).find("'lorry'"), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("car, blob, ring, broken"), std::string::npos);
    }
}

TEST(Samples, FolderThatCannotBeMadeIsAnErrorThatNamesIt) {
    const auto file = fs::path(testing::TempDir()) / "crumple_sample_is_a_file";
    std::ofstream(file) << "x";
    try {
        write("blob", (file / "below").string());
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::file);
        EXPECT_NE(std::string(error.what()).find("crumple_sample_is_a_file"), std::string::npos);
    }
    fs::remove(file);
}

// The files in the repository are exactly what the generator writes, and there are no others.
TEST(Samples, FilesInTheRepositoryAreCurrent) {
    for (const auto& sample : list()) {
        const fs::path folder = fs::path(CRUMPLE_SAMPLES) / sample.name;
        std::set<std::string> expected;
        for (const auto& file : sample.make()) {
            expected.insert(file.name);
            EXPECT_TRUE(content(folder / file.name) == file.bytes)
                << sample.name << '/' << file.name << " differs: write it with crumple dev sample " << sample.name;
        }
        std::set<std::string> found;
        for (const auto& entry : fs::directory_iterator(folder)) found.insert(entry.path().filename().string());
        EXPECT_EQ(found, expected) << folder;
    }
}

TEST(Samples, WritingGivesTheFilesOfTheList) {
    const auto folder = fs::path(testing::TempDir()) / "crumple_samples_written";
    const auto paths = write("ring", folder.string());
    ASSERT_EQ(paths.size(), 2u);
    EXPECT_EQ(content(paths[0]), obj_bytes(ring_shell()));
    fs::remove_all(folder);
}

TEST(Samples, AllFormatsTogetherStaySmall) {
    std::size_t bytes = 0;
    for (const auto& sample : list()) {
        for (const auto& file : sample.make()) bytes += file.bytes.size();
    }
    EXPECT_LT(bytes, 8u << 20);
}

TEST(Writers, ObjStatesFloatsThatReadBackExactly) {
    Part part{"p", {}, {}, {{0, 1, 2}}};
    add_vertex(part, {0.1, -1e-6, 1e4}, {0, 96, 255, 255});
    add_vertex(part, {1, 0, 0}, unlocked);
    add_vertex(part, {0, 1, 0}, unlocked);
    EXPECT_EQ(obj_bytes({part}),
              "# written by crumple dev sample\no p\nv 0.1 -1e-06 10000 0 0.3764706 1\nv 1 0 0 1 1 1\nv 0 1 0 1 1 1\nf "
              "1 2 3\n");
}

TEST(Writers, GlbSaysItsOwnLength) {
    const std::string bytes = glb_bytes(blob_shell());
    ASSERT_GT(bytes.size(), 12u);
    EXPECT_EQ(bytes.substr(0, 4), "glTF");
    std::size_t length = 0;
    for (std::size_t i = 0; i < 4; ++i)
        length |= static_cast<std::size_t>(static_cast<unsigned char>(bytes[8 + i])) << (8 * i);
    EXPECT_EQ(length, bytes.size());
}

TEST(Broken, EveryShellHasANameOfItsOwnAndOneFault) {
    std::set<std::string_view> names;
    for (const auto& shell : broken_shells()) {
        EXPECT_TRUE(names.insert(shell.name).second) << shell.name;
        const Model model = shell.make();
        EXPECT_GT(vertex_count(model), 0u) << shell.name;
        const bool may_be_unpainted = shell.name == "nothing_painted";
        EXPECT_EQ(locked_count(model) == 0, may_be_unpainted) << shell.name;
    }
}

}
}
