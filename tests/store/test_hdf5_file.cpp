// SPDX-License-Identifier: MIT
#include "store/hdf5_file.h"

#include <gtest/gtest.h>

#include <cstring>
#include <ctime>
#include <functional>
#include <limits>
#include <numeric>

#include "core/error.h"
#include "core/random.h"
#include "store/check_file.h"

using namespace crumple;
using namespace crumple::store;

namespace {

template <class Fill>
FileReader write_and_read(Fill fill, Layout layout = Layout::compressed) {
    FileWriter writer(layout);
    fill(writer);
    return {writer.finish(), "test.hdf"};
}

template <class T>
void expect_round_trip(const std::vector<T>& values) {
    for (const Layout layout : {Layout::compressed, Layout::contiguous}) {
        const FileReader reader = write_and_read([&](FileWriter& w) { w.write("/group/deep/values", values); }, layout);
        EXPECT_EQ(reader.read<T>("/group/deep/values"), values);
    }
}

std::string complaint_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::bad_input);
        return error.what();
    }
    return "nothing";
}

}

TEST(Hdf5File, EmptyFileHoldsNothing) {
    const FileReader reader = write_and_read([](FileWriter&) {});
    EXPECT_EQ(reader.list("/"), std::vector<std::string>{"digest"});
    EXPECT_TRUE(verify_digests(reader).empty());
}

TEST(Hdf5File, EmptyArraysKeepTypeAndColumns) {
    expect_round_trip(std::vector<float>{});
    const FileReader reader = write_and_read([](FileWriter& w) { w.write("/a", std::vector<Vec3f>{}); });
    EXPECT_EQ(reader.info("/a").shape, (Shape{0, 3}));
    EXPECT_TRUE(reader.read<Vec3f>("/a").empty());
    EXPECT_THROW((void)reader.read<Vec3>("/a"), Error);
}

TEST(Hdf5File, EveryTypeComesBackBitForBit) {
    expect_round_trip(std::vector<std::uint8_t>{0, 1, 255});
    expect_round_trip(std::vector<std::uint16_t>{0, 65535});
    expect_round_trip(std::vector<std::uint32_t>{0, 0xffffffffu});
    expect_round_trip(std::vector<std::uint64_t>{0, std::numeric_limits<std::uint64_t>::max()});
    expect_round_trip(std::vector<std::int64_t>{std::numeric_limits<std::int64_t>::min(), -1, 7});
    expect_round_trip(std::vector<float>{0.1f, 1e-45f, std::numeric_limits<float>::infinity()});
    expect_round_trip(std::vector<double>{0.1, 5e-324});
    expect_round_trip(std::vector<Vec3>{{1, 2, 3}, {4, 5, 6}});
    expect_round_trip(std::vector<std::array<std::uint32_t, 16>>(3, {1, 2, 3}));
}

TEST(Hdf5File, ArraysOfManyChunksComeBack) {
    std::vector<std::array<float, 9>> rows(100000);
    Rng rng(1);
    for (auto& row : rows) {
        for (float& x : row) x = static_cast<float>(rng.next_unit());
    }
    expect_round_trip(rows);
}

TEST(Hdf5File, TextsComeBack) {
    const std::vector<std::string> texts = {"", "Räder", "a longer one with spaces ", std::string(300000, 'x')};
    const FileReader reader = write_and_read([&](FileWriter& w) {
        w.write_texts("/texts", texts);
        w.write_texts("/none", {});
        w.write_text("/empty", "");
    });
    EXPECT_EQ(reader.read_texts("/texts"), texts);
    EXPECT_TRUE(reader.read_texts("/none").empty());
    EXPECT_EQ(reader.read_text("/empty"), "");
    EXPECT_TRUE(verify_digests(reader).empty());
}

TEST(Hdf5File, AttributesComeBack) {
    const FileReader reader = write_and_read([](FileWriter& w) {
        w.set_attribute("/group", "version", std::vector<std::int64_t>{1, 0});
        w.set_attribute("/group", "type", std::string("UnstructuredGrid"));
        w.set_attribute("/group", "empty", std::string());
    });
    EXPECT_EQ(reader.read_numbers("/group", "version"), (std::vector<std::int64_t>{1, 0}));
    EXPECT_EQ(reader.read_attribute("/group", "type").info.element_size, 16u);
    EXPECT_EQ(reader.all_attributes(), (std::vector<std::string>{"/group@empty", "/group@type", "/group@version"}));
    EXPECT_TRUE(verify_digests(reader).empty());
}

TEST(Hdf5File, ALinkIsASecondName) {
    const FileReader reader = write_and_read([](FileWriter& w) {
        w.write("/a/values", std::vector<float>{1, 2});
        w.link("/b/values", "/a/values");
    });
    EXPECT_EQ(reader.read<float>("/b/values"), (std::vector<float>{1, 2}));
    EXPECT_TRUE(verify_digests(reader).empty());
}

TEST(Hdf5File, WritingTwiceOrWithoutARootIsABug) {
    FileWriter writer;
    writer.write_value("/a", 1.0f);
    EXPECT_THROW(writer.write_value("/a", 2.0f), Error);
    EXPECT_THROW(writer.write_value("b", 2.0f), Error);
    EXPECT_THROW(writer.write_text("/c", std::string("a\0b", 3)), Error);
    EXPECT_THROW(writer.link("/d", "/nowhere"), Error);
}

TEST(Hdf5File, SameCallsGiveSameBytes) {
    const auto write = [] {
        FileWriter writer;
        for (int k = 0; k < 40; ++k)
            writer.write("/group/" + std::to_string(k), std::vector<double>(1000 + static_cast<std::size_t>(k), k));
        return writer.finish();
    };
    const auto first = write();
    // Other allocations in between: no byte may come from memory that happened to be there.
    std::vector<std::vector<int>> noise(100, std::vector<int>(10000, 0x55555555));
    noise.clear();
    EXPECT_EQ(first, write());
}

TEST(Hdf5File, HoldsNoTime) {
    const std::time_t begin = std::time(nullptr);
    FileWriter writer(Layout::contiguous);
    for (int k = 0; k < 40; ++k) writer.write("/group/" + std::to_string(k), std::vector<float>(1000, 1.0f));
    writer.set_attribute("/group", "type", std::string("text"));
    const std::vector<std::byte> image = writer.finish();
    const std::time_t end = std::time(nullptr);
    for (std::size_t i = 512; i + 4 <= image.size(); ++i) {
        std::uint32_t word = 0;
        std::memcpy(&word, image.data() + i, sizeof word);
        EXPECT_FALSE(word >= begin && word <= end) << "byte " << i << " begins a time of now";
    }
}

TEST(Hdf5File, ContentDigestDoesNotDependOnTheLayout) {
    const auto digest = [](Layout layout) {
        return content_digest(
            write_and_read([](FileWriter& w) { w.write("/a", std::vector<float>(5000, 1.5f)); }, layout));
    };
    EXPECT_EQ(digest(Layout::compressed), digest(Layout::contiguous));
}

TEST(Hdf5File, ReadingNamesWhatDoesNotFit) {
    const FileReader reader = write_and_read([](FileWriter& w) {
        w.write("/group/floats", std::vector<float>{1, 2});
        w.write("/group/rows", std::vector<Vec3f>{{1, 2, 3}});
    });
    EXPECT_EQ(complaint_of([&] { (void)reader.read<double>("/group/floats"); }),
              "test.hdf: /group/floats holds f32, expected f64");
    EXPECT_EQ(complaint_of([&] { (void)reader.read<float>("/group/rows"); }),
              "test.hdf: /group/rows does not have rows of 1");
    EXPECT_EQ((complaint_of([&] { (void)reader.read<std::array<float, 4>>("/group/rows"); })),
              "test.hdf: /group/rows does not have rows of 4");
    EXPECT_EQ(complaint_of([&] { (void)reader.read<float>("/group/none"); }), "test.hdf: /group/none: it is missing");
    EXPECT_EQ(complaint_of([&] { (void)reader.read<float>("/group"); }), "test.hdf: /group: it is not a dataset");
    EXPECT_EQ(complaint_of([&] { (void)reader.read_value<float>("/group/floats"); }),
              "test.hdf: /group/floats should hold one value");
    EXPECT_EQ(complaint_of([&] { (void)reader.read_texts("/group/floats"); }),
              "test.hdf: /group/floats is not a list of texts");
    EXPECT_EQ(complaint_of([&] { (void)reader.list("/group/floats"); }), "test.hdf: /group/floats: it is not a group");
    EXPECT_EQ(complaint_of([&] { (void)reader.read_numbers("/group", "none"); }),
              "test.hdf: /group@none: it is missing");
    EXPECT_FALSE(reader.has("/nothing/here"));
    EXPECT_TRUE(reader.has("/group/rows"));
}

TEST(Hdf5File, AnUnsealedFileIsRefusedByName) {
    EXPECT_EQ(complaint_of([] { FileReader({}, "none.hdf"); }),
              "none.hdf: damaged: it is not a file written by crumple, or its first bytes are damaged");
}
