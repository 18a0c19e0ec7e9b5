// SPDX-License-Identifier: MIT
#include "bundle/blob.h"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <sstream>

#include "bundle/aligned_bytes.h"
#include "bundle/forged_blob.h"
#include "bundle/small_bundle.h"
#include "core/error.h"
#include "core/random.h"

using namespace crumple;
using test::AlignedBytes;
using test::small_bundle;

namespace {

std::string problem_of(std::span<const std::byte> bytes) {
    Blob blob;
    const char* problem = open_blob(bytes, blob);
    return problem ? problem : "";
}

struct NumberList {
    std::vector<double> numbers = {};
    void field(std::string_view, const std::string&, std::string_view) {}
    void field(std::string_view, const double& number, Range, std::string_view) { numbers.push_back(number); }
};

void expect_same_mesh(const Bundle& a, const Bundle& b) {
    EXPECT_EQ(a.rest_positions, b.rest_positions);
    EXPECT_EQ(a.mass, b.mass);
    EXPECT_EQ(a.locked, b.locked);
    EXPECT_EQ(a.node_to_mesh, b.node_to_mesh);
    EXPECT_EQ(a.mesh_to_node, b.mesh_to_node);
    EXPECT_EQ(a.locked_positions, b.locked_positions);
    EXPECT_EQ(a.solver_tet_count, b.solver_tet_count);
    EXPECT_EQ(a.tets, b.tets);
    EXPECT_EQ(a.inverse_rest, b.inverse_rest);
    EXPECT_EQ(a.volume, b.volume);
    EXPECT_EQ(a.stiffness_scale, b.stiffness_scale);
    EXPECT_EQ(a.material, b.material);
    EXPECT_EQ(a.region, b.region);
    EXPECT_EQ(a.regions, b.regions);
}

void expect_same_matrix(const Bundle& a, const Bundle& b) {
    EXPECT_EQ(a.row_start, b.row_start);
    EXPECT_EQ(a.column, b.column);
    EXPECT_EQ(a.diagonal, b.diagonal);
    EXPECT_EQ(a.element_slots, b.element_slots);
    EXPECT_EQ(a.edges, b.edges);
    EXPECT_EQ(a.edge_slots, b.edge_slots);
    EXPECT_EQ(a.edge_start, b.edge_start);
    EXPECT_EQ(a.edge_tet, b.edge_tet);
    EXPECT_EQ(a.edge_corners, b.edge_corners);
}

void expect_same_tables(const Bundle& a, const Bundle& b) {
    ASSERT_EQ(a.materials.size(), b.materials.size());
    for (std::size_t i = 0; i < a.materials.size(); ++i) {
        NumberList first;
        NumberList second;
        describe(first, a.materials[i]);
        describe(second, b.materials[i]);
        EXPECT_EQ(first.numbers, second.numbers);
        EXPECT_EQ(a.materials[i].name, b.materials[i].name);
    }
    ASSERT_EQ(a.visuals.size(), b.visuals.size());
    for (std::size_t i = 0; i < a.visuals.size(); ++i) {
        const auto tie = [](const BundleVisual& v) {
            return std::tie(v.name, v.tet, v.barycentric, v.inside, v.distance, v.tet_start, v.vertices_by_tet);
        };
        EXPECT_TRUE(tie(a.visuals[i]) == tie(b.visuals[i])) << i;
    }
    ASSERT_EQ(a.sensors.size(), b.sensors.size());
    for (std::size_t i = 0; i < a.sensors.size(); ++i) {
        const auto tie = [](const BundleSensor& s) {
            return std::tie(s.name, s.node, s.weight, s.rest_origin, s.rest_axes);
        };
        EXPECT_TRUE(tie(a.sensors[i]) == tie(b.sensors[i])) << i;
    }
    EXPECT_EQ(a.provenance.tool_version, b.provenance.tool_version);
    EXPECT_EQ(a.provenance.recipe, b.provenance.recipe);
    EXPECT_EQ(a.provenance.stage_versions, b.provenance.stage_versions);
    EXPECT_EQ(a.provenance.input_digests, b.provenance.input_digests);
}

// Several of everything that can be several.
Bundle rich_bundle() {
    Bundle b = small_bundle(4);
    b.materials.push_back(b.materials[0]);
    b.materials[1].name = "a name much longer than a small string";
    b.materials[1].young_pa = 1e6;
    b.material[3] = 1;
    b.regions.push_back("r");
    b.visuals.push_back(b.visuals[0]);
    b.visuals[1].name = "glass";
    b.sensors.push_back(b.sensors[0]);
    b.sensors[1].name = "hood/\xc3\xbc";
    b.provenance.stage_versions.push_back({"bind", "3"});
    test::fill_rest_state(b);
    return b;
}

std::string error_of(const Bundle& bundle) {
    try {
        (void)read_blob(write_blob(bundle), "car.blob");
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::bad_input);
        return error.what();
    }
    return "";
}

BlobEntry& entry_of(std::span<std::byte> blob, BlobArray array) {
    auto* table = reinterpret_cast<BlobEntry*>(blob.data() + sizeof(BlobHeader));
    while (table->array != array) ++table;
    return *table;
}

// What the bytes say after a change that has right checksums.
std::string problem_after(const std::function<void(std::span<std::byte>)>& change) {
    const AlignedBytes bytes(write_blob(small_bundle()));
    change(bytes.get());
    test::write_checksums(bytes.get());
    return problem_of(bytes.get());
}

// Two empty arrays behind all others: their rows of the table move everything by 64 bytes.
std::vector<std::byte> with_two_arrays_more(std::uint32_t minor) {
    std::vector<std::byte> bytes = write_blob(small_bundle());
    BlobHeader header;
    std::memcpy(&header, bytes.data(), sizeof header);
    std::vector<BlobEntry> table(header.array_count);
    std::memcpy(table.data(), bytes.data() + sizeof header, table.size() * sizeof(BlobEntry));
    const auto table_end =
        bytes.begin() + static_cast<std::ptrdiff_t>(sizeof header + table.size() * sizeof(BlobEntry));
    bytes.insert(table_end, 2 * sizeof(BlobEntry), std::byte{});
    for (BlobEntry& entry : table) entry.offset += 2 * sizeof(BlobEntry);
    for (const std::uint32_t number : {999u, 1000u}) {
        table.push_back({static_cast<BlobArray>(number), 0, BlobType::u8, 1, bytes.size(), 0});
    }
    header.minor = minor;
    header.array_count = static_cast<std::uint32_t>(table.size());
    header.size = bytes.size();
    std::memcpy(bytes.data(), &header, sizeof header);
    std::memcpy(bytes.data() + sizeof header, table.data(), table.size() * sizeof(BlobEntry));
    test::write_checksums(bytes);
    return bytes;
}

}

TEST(Blob, NothingIsNotOne) {
    EXPECT_NE(problem_of({}), "");
    EXPECT_FALSE(is_blob({}));
    EXPECT_THROW((void)read_blob({}, "nothing"), Error);
}

TEST(Blob, HoldsWhatTheBundleHolds) {
    for (const Bundle& bundle : {small_bundle(2), small_bundle(7), rich_bundle()}) {
        const std::vector<std::byte> bytes = write_blob(bundle);
        const Bundle again = read_blob(bytes, "car.blob");
        expect_same_mesh(bundle, again);
        expect_same_matrix(bundle, again);
        expect_same_tables(bundle, again);
        EXPECT_EQ(write_blob(again), bytes);
    }
}

TEST(Blob, IsUsedWhereItLies) {
    const Bundle bundle = rich_bundle();
    const AlignedBytes bytes(write_blob(bundle));
    Blob blob;
    ASSERT_EQ(open_blob(bytes.get(), blob), nullptr);
    for (const BlobEntry& entry : blob.table) EXPECT_EQ(entry.offset % 64, 0u);
    const auto* tets = reinterpret_cast<const std::byte*>(blob.tets.data());
    EXPECT_GE(tets, bytes.get().data());
    EXPECT_LE(tets + blob.tets.size_bytes(), bytes.get().data() + bytes.get().size());
    EXPECT_EQ(visual_of(blob, 1).name, "glass");
    EXPECT_EQ(sensor_of(blob, 1).name, "hood/\xc3\xbc");
    EXPECT_EQ(region_name(blob, 1), "r");
    EXPECT_EQ(material_name(blob, 1), bundle.materials[1].name);
    EXPECT_EQ(material_numbers(blob, 1).young_pa, 1e6);
    EXPECT_EQ(*visual_of(blob, 1).name.end(), '\0') << "C reads names too";
}

TEST(Blob, RefusesEveryFlippedBit) {
    const AlignedBytes bytes(write_blob(small_bundle()));
    for (std::size_t bit = 0; bit < 8 * bytes.get().size(); ++bit) {
        const std::byte mask{static_cast<unsigned char>(1u << bit % 8)};
        bytes.get()[bit / 8] ^= mask;
        ASSERT_NE(problem_of(bytes.get()), "") << "bit " << bit;
        bytes.get()[bit / 8] ^= mask;
    }
    EXPECT_EQ(problem_of(bytes.get()), "");
}

TEST(Blob, RefusesEveryOtherLength) {
    const std::vector<std::byte> whole = write_blob(small_bundle());
    for (std::size_t size = 0; size < whole.size(); ++size) {
        const AlignedBytes bytes({whole.data(), size});
        ASSERT_NE(problem_of(bytes.get()), "") << size << " bytes";
    }
    std::vector<std::byte> longer = whole;
    longer.resize(whole.size() + 64);
    EXPECT_NE(problem_of(AlignedBytes(longer).get()), "");
}

TEST(Blob, WantsABoundaryToBeUsedWhereItLiesButNotToBeCopied) {
    std::vector<std::byte> shifted(8);
    const std::vector<std::byte> whole = write_blob(small_bundle());
    shifted.insert(shifted.end(), whole.begin(), whole.end());
    const AlignedBytes bytes(shifted);
    EXPECT_EQ(problem_of(bytes.get().subspan(8)), "lies off a 64-byte boundary");
    EXPECT_EQ(read_blob(bytes.get().subspan(8), "shifted").tets, small_bundle().tets);
}

TEST(Blob, SaysWhichVersionIsWrong) {
    const auto major = [](std::span<std::byte> bytes) { bytes[8] = std::byte{2}; };
    EXPECT_EQ(problem_after(major), "is of another major version: export the bundle with this one");
    const auto order = [](std::span<std::byte> bytes) { std::reverse(&bytes[16], &bytes[16] + 4); };
    EXPECT_EQ(problem_after(order), "is not little-endian");
}

TEST(Blob, IgnoresWhatANewerMinorVersionAdds) {
    const auto rename = [](std::span<std::byte> bytes) {
        entry_of(bytes, BlobArray::sensor_weight).array = static_cast<BlobArray>(999);
    };
    EXPECT_EQ(problem_after(rename), "has a sensor of nodes that are not there");

    for (const std::uint32_t minor : {0u, 1u}) {
        const AlignedBytes bytes(with_two_arrays_more(minor));
        EXPECT_EQ(problem_of(bytes.get()), minor == 0 ? "has an array nobody knows" : "");
        if (minor == 0) continue;
        EXPECT_EQ(read_blob(bytes.get(), "newer").tets, small_bundle().tets);
    }
}

TEST(Blob, RefusesSizesThatNobodyHasMemoryFor) {
    const auto with_rows = [](BlobArray array, std::uint64_t rows) {
        return problem_after([=](std::span<std::byte> bytes) { entry_of(bytes, array).rows = rows; });
    };
    for (const std::uint64_t rows : {std::uint64_t{1} << 62, ~std::uint64_t{0}, std::uint64_t{1} << 32}) {
        EXPECT_NE(with_rows(BlobArray::tets, rows), "") << rows;
        EXPECT_NE(with_rows(BlobArray::sensor_weight, rows), "") << rows;
    }
    const auto with_counts = [](std::uint32_t BlobCounts::*count) {
        return problem_after([=](std::span<std::byte> bytes) {
            reinterpret_cast<BlobCounts*>(bytes.data() + entry_of(bytes, BlobArray::counts).offset)->*count = none;
        });
    };
    for (const auto count : {&BlobCounts::solver_tets, &BlobCounts::regions, &BlobCounts::materials,
                             &BlobCounts::visuals, &BlobCounts::sensors, &BlobCounts::stages, &BlobCounts::inputs}) {
        EXPECT_NE(with_counts(count), "");
    }
}

TEST(Blob, IsCheckedLikeABundle) {
    const auto damaged = [](const std::function<void(Bundle&)>& damage) {
        Bundle bundle = small_bundle();
        damage(bundle);
        return error_of(bundle);
    };
    EXPECT_NE(damaged([](Bundle& b) { std::swap(b.tets[0][0], b.tets[0][1]); }).find("BUNDLE_TET_NOT_POSITIVE"),
              std::string::npos);
    EXPECT_NE(damaged([](Bundle& b) { b.locked[0] = 0; }).find("BUNDLE_LOCK_MISSING"), std::string::npos);
    EXPECT_NE(damaged([](Bundle& b) { std::swap(b.edge_slots[0][0], b.edge_slots[0][1]); }).find("BUNDLE_EDGES"),
              std::string::npos);
    EXPECT_NE(damaged([](Bundle& b) { b.visuals[0].tet[0] = 77; }).find("car.blob has a visual mesh"),
              std::string::npos);
    EXPECT_NE(damaged([](Bundle& b) { b.mass.pop_back(); }).find("car.blob has arrays over nodes"), std::string::npos);
}

// Words anywhere in a blob with right checksums: what opens can be read through all its indices (sanitizers watch), and
// what is read is a bundle that passes.
TEST(Blob, SurvivesForgery) {
    const std::vector<std::byte> good = write_blob(small_bundle());
    Rng rng(64);
    int opened = 0;
    for (int trial = 0; trial < 20000; ++trial) {
        const AlignedBytes bytes(good);
        for (std::uint32_t change = 0; change <= rng.next_below(3); ++change) {
            // Mostly the table and the counts: most of what can be said wrongly is said there.
            const std::uint32_t words = static_cast<std::uint32_t>(good.size() / 4);
            const std::uint32_t word = 16 + rng.next_below(rng.next_below(2) == 0 ? 350 : words - 16);
            const std::uint32_t value = rng.next_below(2) == 0 ? rng.next_below(20) : rng.next_u32();
            std::memcpy(bytes.get().data() + 4 * word, &value, sizeof value);
        }
        test::write_checksums(bytes.get());
        Blob blob;
        if (open_blob(bytes.get(), blob) != nullptr) continue;
        ++opened;
        (void)test::touch_all(blob);
        try {
            (void)read_blob(bytes.get(), "forged");
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::bad_input);
        }
    }
    EXPECT_GT(opened, 1000) << "or this tests little";
}

TEST(BlobDocument, NamesEveryArrayWithItsNumberTypeAndShape) {
    std::ifstream file(CRUMPLE_SOURCE_DIR "/lib/bundle/FORMAT_BLOB.md");
    const std::vector<std::string> types = {"", "u8", "u16", "u32", "f32", "f64"};
    const AlignedBytes bytes(write_blob(small_bundle()));
    Blob blob;
    ASSERT_EQ(open_blob(bytes.get(), blob), nullptr);
    auto entry = blob.table.begin();
    for (std::string line; std::getline(file, line);) {
        std::istringstream cells(line);
        std::string bar, number, name, type, columns;
        cells >> bar >> number >> bar >> name >> bar >> type >> bar;
        const bool is_number = !number.empty() && number.find_first_not_of("0123456789") == std::string::npos;
        const bool is_array = name.starts_with('`') && name != "`u32`" && name != "`u64`";  // not a header's field
        if (!is_number || !is_array) continue;
        ASSERT_NE(entry, blob.table.end()) << name;
        EXPECT_EQ(number, std::to_string(static_cast<std::uint32_t>(entry->array))) << name;
        EXPECT_EQ(type, "`" + types[static_cast<std::size_t>(entry->type)] + "`") << name;
        std::string shape;
        std::getline(cells, shape, '|');
        const std::string expected = entry->columns == 1 ? "" : "x " + std::to_string(entry->columns);
        EXPECT_TRUE(expected.empty() ? shape.find(" x ") == std::string::npos
                                     : shape.find(expected) != std::string::npos)
            << name << shape;
        ++entry;
    }
    EXPECT_EQ(entry, blob.table.end()) << "FORMAT_BLOB.md lacks arrays";
}
