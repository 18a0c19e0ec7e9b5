// SPDX-License-Identifier: MIT
// Files with a valid seal that FileWriter never writes: made with HDF5 itself, then sealed as an attacker would.
#include <gtest/gtest.h>
#include <hdf5.h>

#include <functional>

#include "core/error.h"
#include "store/check_file.h"
#include "store/hdf5_file.h"
#include "store/read_file.h"
#include "store/seal.h"
#include "store/temporary_folder.h"

using namespace crumple;
using namespace crumple::store;

namespace {

// A sealed file whose content the function makes.
std::vector<std::byte> hostile_file(const std::function<void(hid_t file)>& make) {
    const test::TemporaryFolder folder;
    const hid_t settings = H5Pcreate(H5P_FILE_CREATE);
    H5Pset_userblock(settings, seal_size);
    const hid_t file = H5Fcreate(folder.file("x.hdf").c_str(), H5F_ACC_TRUNC, settings, H5P_DEFAULT);
    make(file);
    H5Pclose(settings);
    H5Fclose(file);
    std::vector<std::byte> image = read_file(folder.file("x.hdf"));
    write_seal(image);
    return image;
}

// What reading /x as a list of floats says.
std::string complaint_of(const std::function<void(hid_t file)>& make) {
    try {
        const FileReader reader(hostile_file(make), "x");
        (void)reader.read<float>("/x");
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::bad_input);
        return error.what();
    }
    return "nothing";
}

// /x of a type, shape and creation list; written when there are values.
void make_dataset(hid_t file, hid_t type, std::vector<hsize_t> extents, const std::function<void(hid_t)>& set,
                  const void* values = nullptr, std::vector<hsize_t> max_extents = {}) {
    const hid_t space = H5Screate_simple(static_cast<int>(extents.size()), extents.data(),
                                         max_extents.empty() ? nullptr : max_extents.data());
    const hid_t settings = H5Pcreate(H5P_DATASET_CREATE);
    set(settings);
    const hid_t dataset = H5Dcreate2(file, "x", type, space, H5P_DEFAULT, settings, H5P_DEFAULT);
    ASSERT_GE(dataset, 0);
    if (values) {
        ASSERT_GE(H5Dwrite(dataset, H5T_NATIVE_FLOAT, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), 0);
    }
    H5Dclose(dataset);
    H5Pclose(settings);
    H5Sclose(space);
}

void set_nothing(hid_t) {}

void set_chunk(hid_t settings, hsize_t rows) { H5Pset_chunk(settings, 1, &rows); }

constexpr float four[4] = {1, 2, 3, 4};

}

TEST(HostileFiles, APlainArrayMadeElsewhereIsRead) {
    const FileReader reader(
        hostile_file([](hid_t file) { make_dataset(file, H5T_IEEE_F32LE, {4}, set_nothing, four); }), "x");
    EXPECT_EQ(reader.read<float>("/x"), (std::vector<float>{1, 2, 3, 4}));
}

TEST(HostileFiles, LinksToElsewhereAreRefused) {
    const std::string elsewhere = "x: /x: it is a link to elsewhere, this format has none";
    EXPECT_EQ(complaint_of([](hid_t file) { H5Lcreate_soft("/y", file, "x", H5P_DEFAULT, H5P_DEFAULT); }), elsewhere);
    EXPECT_EQ(
        complaint_of([](hid_t file) { H5Lcreate_external("/etc/passwd", "/x", file, "x", H5P_DEFAULT, H5P_DEFAULT); }),
        elsewhere);
}

TEST(HostileFiles, DataInAnotherFileAreRefused) {
    EXPECT_EQ(complaint_of([](hid_t file) {
                  make_dataset(file, H5T_IEEE_F32LE, {4}, [](hid_t s) { H5Pset_external(s, "/etc/passwd", 0, 16); });
              }),
              "x: /x: its data are not in this file");
}

TEST(HostileFiles, OtherTypesAreRefused) {
    const std::string strange = "x: /x: its type is none this format has";
    EXPECT_EQ(complaint_of([](hid_t file) { make_dataset(file, H5T_IEEE_F32BE, {4}, set_nothing, four); }), strange);
    EXPECT_EQ(complaint_of([](hid_t file) { make_dataset(file, H5T_STD_I16LE, {4}, set_nothing, four); }), strange);
    EXPECT_EQ(complaint_of([](hid_t file) {
                  const hid_t text = H5Tcopy(H5T_C_S1);
                  H5Tset_size(text, H5T_VARIABLE);
                  make_dataset(file, text, {4}, set_nothing);
                  H5Tclose(text);
              }),
              strange);
    EXPECT_EQ(complaint_of([](hid_t file) { make_dataset(file, H5T_STD_REF_OBJ, {4}, set_nothing); }), strange);
}

TEST(HostileFiles, OtherLayoutsAndShapesAreRefused) {
    EXPECT_EQ(complaint_of([](hid_t file) {
                  make_dataset(
                      file, H5T_IEEE_F32LE, {4}, [](hid_t s) { H5Pset_layout(s, H5D_COMPACT); }, four);
              }),
              "x: /x: its layout is none this format has");
    EXPECT_EQ(complaint_of([](hid_t file) {
                  make_dataset(file, H5T_IEEE_F32LE, {4}, [](hid_t s) { set_chunk(s, 4); }, four, {H5S_UNLIMITED});
              }),
              "x: /x: it can change its size");
    EXPECT_EQ(complaint_of([](hid_t file) {
                  make_dataset(file, H5T_IEEE_F32LE, {1, 1, 2, 2}, set_nothing, four);
              }),
              "x: /x: it has a strange number of dimensions");
}

TEST(HostileFiles, OtherFiltersAreRefused) {
    EXPECT_EQ(complaint_of([](hid_t file) {
                  make_dataset(
                      file, H5T_IEEE_F32LE, {4},
                      [](hid_t s) {
                          set_chunk(s, 4);
                          H5Pset_scaleoffset(s, H5Z_SO_FLOAT_DSCALE, 2);
                      },
                      four);
              }),
              "x: /x: it uses a filter this format does not have");
}

TEST(HostileFiles, LyingSizesAreRefusedBeforeMemoryIsTaken) {
    const std::string too_much = "x: /x: it claims more data than the file holds";
    constexpr hsize_t huge = hsize_t{1} << 40;
    EXPECT_EQ(complaint_of([](hid_t file) { make_dataset(file, H5T_IEEE_F32LE, {huge}, set_nothing); }), too_much);
    EXPECT_EQ(complaint_of([](hid_t file) {
                  make_dataset(file, H5T_IEEE_F32LE, {huge}, [](hid_t s) { set_chunk(s, 1 << 20); });
              }),
              too_much);
    EXPECT_EQ(complaint_of([](hid_t file) {
                  make_dataset(file, H5T_IEEE_F32LE, {huge, huge, huge}, [](hid_t s) {
                      const hsize_t chunk[3] = {1, 1, 1};
                      H5Pset_chunk(s, 3, chunk);
                  });
              }).substr(0, 6),
              "x: /x:");
}

TEST(HostileFiles, MissingChunksAreRefused) {
    const auto make = [](hid_t file) {
        make_dataset(file, H5T_IEEE_F32LE, {4}, [](hid_t s) { set_chunk(s, 2); });
        const hid_t dataset = H5Dopen2(file, "x", H5P_DEFAULT);
        const hsize_t offset = 0;
        H5Dwrite_chunk(dataset, H5P_DEFAULT, 0, &offset, 8, four);
        H5Dclose(dataset);
    };
    EXPECT_EQ(complaint_of(make), "x: /x: some of its chunks are missing");
}

TEST(HostileFiles, GroupsThatHoldThemselvesEnd) {
    const auto image = hostile_file([](hid_t file) {
        const hid_t group = H5Gcreate2(file, "a", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
        H5Lcreate_hard(file, "/a", group, "b", H5P_DEFAULT, H5P_DEFAULT);
        H5Lcreate_hard(file, "/", group, "c", H5P_DEFAULT, H5P_DEFAULT);
        H5Gclose(group);
    });
    EXPECT_THROW((void)FileReader(image, "x").all_datasets(), Error);
}

TEST(HostileFiles, DigestsFindWhatTheSealWasForgedFor) {
    const auto image = hostile_file([](hid_t file) {
        make_dataset(file, H5T_IEEE_F32LE, {4}, set_nothing, four);
        const hid_t group = H5Gcreate2(file, "digest", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
        H5Gclose(group);
    });
    EXPECT_FALSE(check_file(image, "x").findings.empty());
}
