// SPDX-License-Identifier: MIT
#include "store/bundle_file.h"

#include <gtest/gtest.h>

#include "bundle/small_bundle.h"
#include "bundle/validate.h"
#include "core/error.h"
#include "store/check_file.h"
#include "store/temporary_folder.h"
#include "store/write_file.h"

using namespace crumple;
using namespace crumple::store;
using test::small_bundle;

namespace {

std::string complaint_of(std::vector<std::byte> image) {
    try {
        (void)read_bundle(FileReader(std::move(image), "test.hdf"));
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::bad_input);
        return error.what();
    }
    return "";
}

// The bundle's own datasets under another schema version, and perhaps more.
std::vector<std::byte> rewrite(const Bundle& bundle, std::array<std::int64_t, 2> version, const std::string& without,
                               const std::string& extra) {
    const FileReader original(to_image(bundle), "original");
    FileWriter writer;
    writer.set_attribute("/bundle", "schema_version", version);
    for (const std::string& path : original.all_datasets()) {
        if (!path.starts_with("/bundle/") || path == without) continue;
        const DatasetInfo info = original.info(path);
        if (info.type == Type::text) {
            writer.write_texts(path, original.read_texts(path));
        } else if (info.shape.size() == 2) {
            const auto copy_rows = [&]<std::size_t K>() {
                if (info.shape[1] != K) return;
                if (info.type == Type::f32) writer.write(path, original.read<std::array<float, K>>(path));
                if (info.type == Type::u32) writer.write(path, original.read<std::array<std::uint32_t, K>>(path));
                if (info.type == Type::u8) writer.write(path, original.read<std::array<std::uint8_t, K>>(path));
            };
            copy_rows.operator()<2>(), copy_rows.operator()<3>(), copy_rows.operator()<4>(), copy_rows.operator()<9>(),
                copy_rows.operator()<16>();
        } else {
            if (info.type == Type::u8) writer.write(path, original.read<std::uint8_t>(path));
            if (info.type == Type::u16) writer.write(path, original.read<std::uint16_t>(path));
            if (info.type == Type::u32) writer.write(path, original.read<std::uint32_t>(path));
            if (info.type == Type::f32) writer.write(path, original.read<float>(path));
            if (info.type == Type::f64) writer.write(path, original.read<double>(path));
        }
    }
    if (!extra.empty()) writer.write_value(extra, 1.0f);
    return writer.finish();
}

}

TEST(BundleFile, ComesBackTheSame) {
    const Bundle bundle = small_bundle(4);
    for (const Layout layout : {Layout::compressed, Layout::contiguous}) {
        const std::vector<std::byte> image = to_image(bundle, layout);
        const Bundle again = read_bundle(FileReader(image, "test.hdf"));
        EXPECT_TRUE(validate(again).empty());
        EXPECT_EQ(to_image(again, layout), image) << "every array is in the image";
        EXPECT_EQ(again.rest_positions, bundle.rest_positions);
        EXPECT_EQ(again.element_slots, bundle.element_slots);
        EXPECT_EQ(again.visuals[0].barycentric, bundle.visuals[0].barycentric);
        EXPECT_EQ(again.sensors[0].weight, bundle.sensors[0].weight);
        EXPECT_EQ(again.materials[0].name, "steel");
        EXPECT_EQ(again.materials[0].beta_s, bundle.materials[0].beta_s);
        EXPECT_EQ(again.provenance.stage_versions, bundle.provenance.stage_versions);
        EXPECT_EQ(again.provenance.input_digests, bundle.provenance.input_digests);
        EXPECT_EQ(again.provenance.recipe, bundle.provenance.recipe);
    }
}

TEST(BundleFile, WithoutVisualsSensorsAndProvenanceComesBackToo) {
    Bundle bundle = small_bundle();
    bundle.visuals.clear();
    bundle.sensors.clear();
    bundle.provenance = {};
    const std::vector<std::byte> image = to_image(bundle);
    EXPECT_EQ(to_image(read_bundle(FileReader(image, "test.hdf"))), image);
}

TEST(BundleFile, NamesMayHoldAnything) {
    Bundle bundle = small_bundle();
    bundle.visuals[0].name = "car/Käfer 50%\n";
    bundle.visuals.push_back(bundle.visuals[0]);
    bundle.visuals[1].name = "..";
    bundle.visuals.push_back(bundle.visuals[0]);
    bundle.visuals[2].name = "car%2FKäfer 50%\n";  // what a careless encoding would make of the first
    bundle.sensors[0].name = ".";
    const FileReader reader(to_image(bundle), "test.hdf");
    const Bundle again = read_bundle(reader);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(again.visuals[i].name, bundle.visuals[i].name);
    EXPECT_EQ(again.sensors[0].name, ".");
    EXPECT_TRUE(reader.has("/bundle/visual/car%2FKäfer 50%25%0A/tet"));
    EXPECT_TRUE(verify_digests(reader).empty());
}

TEST(BundleFile, AnotherMajorVersionIsRefusedByName) {
    const Bundle bundle = small_bundle();
    EXPECT_EQ(
        complaint_of(rewrite(bundle, {2, 3}, "", "")),
        "test.hdf: /bundle has schema 2.3, this program reads 1.0 and later 1.x; cook the asset with this version");
    EXPECT_NE(complaint_of(rewrite(bundle, {0, 9}, "", "")).find("has schema 0.9"), std::string::npos);
    EXPECT_NE(complaint_of(rewrite(bundle, {1, -1}, "", "")).find("schema_version"), std::string::npos);
}

TEST(BundleFile, ALaterMinorVersionIsReadWithoutItsAdditions) {
    EXPECT_EQ(complaint_of(rewrite(small_bundle(), {1, 7}, "", "/bundle/model/future")), "");
}

TEST(BundleFile, AMissingOrUnknownDatasetIsRefusedByName) {
    const Bundle bundle = small_bundle();
    EXPECT_EQ(complaint_of(rewrite(bundle, {1, 0}, "", "")), "");
    EXPECT_EQ(complaint_of(rewrite(bundle, {1, 0}, "/bundle/volume", "")), "test.hdf: /bundle/volume: it is missing");
    EXPECT_EQ(complaint_of(rewrite(bundle, {1, 0}, "", "/bundle/extra")),
              "test.hdf: /bundle/extra is not part of the format");
    EXPECT_EQ(complaint_of(FileWriter().finish()),
              "test.hdf: /bundle is missing: the file holds no bundle; cook it to the end");
}

TEST(BundleFile, OtherGroupsOfTheFileDoNotMatter) {
    const Bundle bundle = small_bundle();
    FileWriter writer;
    write_bundle(writer, bundle);
    writer.write("/points/positions", std::vector<Vec3>{{1, 2, 3}});
    const FileReader reader(writer.finish(), "test.hdf");
    EXPECT_EQ(to_image(read_bundle(reader)), to_image(bundle));
}

TEST(BundleFile, LoadRefusesABundleThatBreaksAnInvariant) {
    const test::TemporaryFolder folder;
    Bundle bundle = small_bundle();
    write_file(folder.file("good.hdf"), to_image(bundle));
    EXPECT_EQ(to_image(load_bundle(folder.file("good.hdf"))), to_image(bundle));
    bundle.element_slots[0][3] = none;
    write_file(folder.file("bad.hdf"), to_image(bundle));
    EXPECT_THROW((void)load_bundle(folder.file("bad.hdf")), Error);
    EXPECT_THROW((void)load_bundle(folder.file("none.hdf")), Error);
}
