// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <cstring>
#include <map>
#include <set>

#include "core/error.h"
#include "store/hdf5_handle.h"
#include "store/hdf5_image.h"
#include "store/seal.h"

static_assert(std::endian::native == std::endian::little, "arrays go to the file as they lie in memory");

namespace crumple::store {
namespace {

constexpr std::uint64_t chunk_bytes = std::uint64_t{1} << 20;
constexpr unsigned deflate_level = 1;  // higher levels cost far more time than they save space
constexpr hsize_t alignment = 64;      // of contiguous arrays: a cache line

void require(bool ok, const std::string& what) {
    if (!ok) throw Error(ErrorKind::internal, "internal: " + what + ": " + last_hdf5_error());
}

Handle open_memory_file(std::vector<std::byte>& image) {
    prepare_hdf5();
    const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    const Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
    use_image(access.id(), image);
    // The format of HDF5 1.10: checksums on all metadata and a few bytes of index for an array of one chunk. Nothing
    // may be set in it that needs a superblock extension, which would store the time.
    require(H5Pset_libver_bounds(access.id(), H5F_LIBVER_V110, H5F_LIBVER_V110) >= 0 &&
                H5Pset_alignment(access.id(), alignment * 8, alignment) >= 0 &&
                H5Pset_userblock(creation.id(), seal_size) >= 0 && H5Pset_obj_track_times(creation.id(), 0) >= 0,
            "HDF5 settings");
    Handle file(H5Fcreate(unique_file_name().c_str(), H5F_ACC_TRUNC, creation.id(), access.id()), H5Fclose);
    require(file.is_open(), "HDF5 file in memory");
    return file;
}

// Rows a chunk; 0 where the array is better off in one piece.
std::uint64_t chunk_rows(const Shape& shape, std::size_t element_size) {
    const std::uint64_t count = element_count(shape);
    if (count == 0) return 0;
    const std::uint64_t row_bytes = count / shape[0] * element_size;
    return std::clamp<std::uint64_t>(chunk_bytes / row_bytes, 1, shape[0]);
}

Handle dataset_settings(Layout layout, const Shape& shape, std::size_t element_size) {
    Handle settings(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    require(H5Pset_obj_track_times(settings.id(), 0) >= 0 &&
                H5Pset_fill_time(settings.id(), H5D_FILL_TIME_NEVER) >= 0 &&
                H5Pset_alloc_time(settings.id(), H5D_ALLOC_TIME_EARLY) >= 0,
            "HDF5 settings");
    const std::uint64_t rows = layout == Layout::compressed ? chunk_rows(shape, element_size) : 0;
    if (rows == 0) return settings;
    std::vector<hsize_t> chunk(shape.begin(), shape.end());
    chunk[0] = rows;
    require(H5Pset_alloc_time(settings.id(), H5D_ALLOC_TIME_INCR) >= 0 &&
                H5Pset_chunk(settings.id(), static_cast<int>(chunk.size()), chunk.data()) >= 0 &&
                H5Pset_shuffle(settings.id()) >= 0 && H5Pset_deflate(settings.id(), deflate_level) >= 0 &&
                H5Pset_fletcher32(settings.id()) >= 0,
            "HDF5 settings");
    return settings;
}

Handle simple_space(const Shape& shape) {
    const std::vector<hsize_t> extents(shape.begin(), shape.end());
    return {H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr), H5Sclose};
}

std::string parent_of(const std::string& path) { return path.substr(0, path.rfind('/')); }

// Texts side by side, each padded with zeros to the longest.
std::string pad_texts(const std::vector<std::string>& texts, std::size_t size) {
    std::string padded(texts.size() * size, '\0');
    for (std::size_t i = 0; i < texts.size(); ++i)
        std::copy(texts[i].begin(), texts[i].end(), padded.begin() + static_cast<std::ptrdiff_t>(i * size));
    return padded;
}

std::size_t padded_length(const std::vector<std::string>& texts) {
    std::size_t size = 1;
    for (const std::string& text : texts) {
        CRUMPLE_CHECK(text.find('\0') == std::string::npos, "a text with a zero in it cannot be stored");
        size = std::max(size, text.size());
    }
    return size;
}

}

struct FileWriter::State {
    Layout layout;
    std::vector<std::byte> image = {};
    Handle file = open_memory_file(image);
    std::map<std::string, Digest> digests = {};  // of datasets and attributes
    std::set<std::string> groups = {};           // that exist

    void make_groups(const std::string& path) {
        if (path.empty() || groups.contains(path)) return;
        make_groups(parent_of(path));
        const Handle settings(H5Pcreate(H5P_GROUP_CREATE), H5Pclose);
        require(H5Pset_obj_track_times(settings.id(), 0) >= 0, "HDF5 settings");
        const Handle group(H5Gcreate2(file.id(), path.c_str(), H5P_DEFAULT, settings.id(), H5P_DEFAULT), H5Gclose);
        require(group.is_open(), "group " + path);
        groups.insert(path);
    }

    void note(const std::string& path, const DatasetInfo& info, std::span<const std::byte> bytes) {
        const bool is_new = digests.emplace(path, digest_of(info, bytes)).second;
        CRUMPLE_CHECK(is_new, path + " is written twice");
    }

    void write(const std::string& path, hid_t type, const DatasetInfo& info, std::span<const std::byte> bytes) {
        CRUMPLE_CHECK(path.size() > 1 && path.front() == '/' && path.back() != '/',
                      "'" + path + "' is not an absolute path");
        CRUMPLE_CHECK(element_count(info.shape) * info.element_size == bytes.size(),
                      path + " has another size than its shape");
        note(path, info, bytes);
        make_groups(parent_of(path));
        const Handle space = simple_space(info.shape);
        const Handle settings = dataset_settings(layout, info.shape, info.element_size);
        const Handle dataset(
            H5Dcreate2(file.id(), path.c_str(), type, space.id(), H5P_DEFAULT, settings.id(), H5P_DEFAULT), H5Dclose);
        require(dataset.is_open(), path);
        if (bytes.empty()) return;
        require(H5Dwrite(dataset.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()) >= 0, path);
    }

    void set_attribute(const std::string& group, const std::string& name, hid_t type, const DatasetInfo& info,
                       std::span<const std::byte> bytes) {
        note(attribute_path(group, name), info, bytes);
        make_groups(group);
        const Handle object(H5Gopen2(file.id(), group.c_str(), H5P_DEFAULT), H5Gclose);
        const Handle space =
            info.type == Type::text ? Handle(H5Screate(H5S_SCALAR), H5Sclose) : simple_space(info.shape);
        const Handle attribute(H5Acreate2(object.id(), name.c_str(), type, space.id(), H5P_DEFAULT, H5P_DEFAULT),
                               H5Aclose);
        require(attribute.is_open() && H5Awrite(attribute.id(), type, bytes.data()) >= 0, attribute_path(group, name));
    }
};

FileWriter::FileWriter(Layout layout) : state_(new State{layout}) {}
FileWriter::~FileWriter() = default;

void FileWriter::write_bytes(const std::string& path, Type type, const Shape& shape, std::span<const std::byte> bytes) {
    state_->write(path, file_type(type), {type, size_of(type), shape}, bytes);
}

void FileWriter::write_texts(const std::string& path, const std::vector<std::string>& texts) {
    const std::size_t size = padded_length(texts);
    const std::string padded = pad_texts(texts, size);
    const Handle type = text_type(size, H5T_CSET_UTF8);
    state_->write(path, type.id(), {Type::text, size, {texts.size()}}, std::as_bytes(std::span(padded)));
}

void FileWriter::link(const std::string& path, const std::string& existing) {
    const auto found = state_->digests.find(existing);
    CRUMPLE_CHECK(found != state_->digests.end(), existing + " is to be linked before it is written");
    const Digest digest = found->second;
    state_->make_groups(parent_of(path));
    const hid_t file = state_->file.id();
    require(H5Lcreate_hard(file, existing.c_str(), file, path.c_str(), H5P_DEFAULT, H5P_DEFAULT) >= 0, path);
    state_->digests[path] = digest;
}

void FileWriter::make_group(const std::string& path) { state_->make_groups(path); }

void FileWriter::set_attribute(const std::string& group, const std::string& name,
                               std::span<const std::int64_t> values) {
    state_->set_attribute(group, name, file_type(Type::i64), {Type::i64, 8, {values.size()}}, std::as_bytes(values));
}

void FileWriter::set_attribute(const std::string& group, const std::string& name, const std::string& text) {
    const std::size_t size = padded_length({text});
    const std::string padded = pad_texts({text}, size);
    const Handle type = text_type(size, H5T_CSET_ASCII);
    state_->set_attribute(group, name, type.id(), {Type::text, size, {}}, std::as_bytes(std::span(padded)));
}

std::vector<std::byte> FileWriter::finish() {
    std::vector<std::string> paths;
    std::vector<Digest> digests;
    Sha256 all;
    for (const auto& [path, digest] : state_->digests) {
        paths.push_back(path);
        digests.push_back(digest);
        all.update(path + "\t" + to_hex(digest) + "\n");
    }
    const std::string group = digest_group;
    write_texts(group + "/path", paths);
    write(group + "/sha256", digests);
    write_value(group + "/all", all.finish());
    require(H5Fflush(state_->file.id(), H5F_SCOPE_GLOBAL) >= 0, "HDF5 flush");
    hsize_t size = 0;
    require(H5Fget_filesize(state_->file.id(), &size) >= 0, "HDF5 file size");
    state_->file.reset();
    std::vector<std::byte> image = std::move(state_->image);
    require(image.size() >= size, "HDF5 image");
    image.resize(size);
    write_seal(image);
    return image;
}

}
