// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <stdexcept>

#include "core/error.h"
#include "store/hdf5_dataset.h"
#include "store/hdf5_image.h"
#include "store/seal.h"

namespace crumple::store {
namespace {

constexpr int max_depth = 8;                 // of groups
constexpr std::size_t max_entries = 100000;  // of datasets, groups and attributes: links can form loops

std::string parent_of(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    return slash == 0 ? "/" : path.substr(0, slash);
}

std::string join(const std::string& group, const std::string& name) {
    return group == "/" ? "/" + name : group + "/" + name;
}

Handle open_image(std::vector<std::byte>& image) {
    prepare_hdf5();
    const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    use_image(access.id(), image);
    return {H5Fopen(unique_file_name().c_str(), H5F_ACC_RDONLY, access.id()), H5Fclose};
}

}

struct FileReader::State {
    std::string name;
    std::vector<std::byte> image;
    Handle file;

    // Runs a function that says what is wrong in a std::runtime_error; adds where.
    template <class Function>
    auto at(const std::string& path, Function function) const {
        try {
            return function();
        } catch (const Error&) {
            throw;
        } catch (const std::runtime_error& error) {
            throw Error(ErrorKind::bad_input, name + ": " + path + ": " + error.what());
        }
    }

    // What was looked at once is not looked at again: the file does not change.
    mutable std::map<std::string, H5I_type_t> kinds = {{"/", H5I_GROUP}};
    mutable std::map<std::string, DatasetInfo> infos = {};

    // H5I_BADID where there is nothing. A soft or external link could lead anywhere: every step of the way must be a
    // hard one.
    [[nodiscard]] H5I_type_t find_kind(const std::string& path) const {
        if (const auto known = kinds.find(path); known != kinds.end()) return known->second;
        if (find_kind(parent_of(path)) != H5I_GROUP) return H5I_BADID;
        const htri_t is_there = H5Lexists(file.id(), path.c_str(), H5P_DEFAULT);
        require_hdf5(is_there >= 0);
        if (is_there == 0) return H5I_BADID;
        H5L_info_t link{};
        require_hdf5(H5Lget_info(file.id(), path.c_str(), &link, H5P_DEFAULT) >= 0);
        require(link.type == H5L_TYPE_HARD, "it is a link to elsewhere, this format has none");
        const Handle object(H5Oopen(file.id(), path.c_str(), H5P_DEFAULT), H5Oclose);
        require_hdf5(object.is_open());
        return kinds[path] = H5Iget_type(object.id());
    }

    [[nodiscard]] bool exists(const std::string& path) const { return find_kind(path) != H5I_BADID; }

    [[nodiscard]] H5I_type_t kind_of(const std::string& path) const {
        require(exists(path), "it is missing");
        return find_kind(path);
    }

    [[nodiscard]] Handle open_dataset(const std::string& path) const {
        require(kind_of(path) == H5I_DATASET, "it is not a dataset");
        Handle dataset(H5Dopen2(file.id(), path.c_str(), H5P_DEFAULT), H5Dclose);
        require_hdf5(dataset.is_open());
        return dataset;
    }

    [[nodiscard]] Handle open_group(const std::string& path) const {
        require(kind_of(path) == H5I_GROUP, "it is not a group");
        Handle group(H5Gopen2(file.id(), path.c_str(), H5P_DEFAULT), H5Gclose);
        require_hdf5(group.is_open());
        return group;
    }

    [[nodiscard]] std::vector<std::string> list(const std::string& path) const {
        const Handle group = open_group(path);
        std::vector<std::string> names;
        hsize_t position = 0;
        const auto add = [](hid_t, const char* entry, const H5L_info_t*, void* list) -> herr_t {
            auto& all = *static_cast<std::vector<std::string>*>(list);
            if (all.size() >= max_entries) return -1;
            all.emplace_back(entry);
            return 0;
        };
        require_hdf5(H5Literate(group.id(), H5_INDEX_NAME, H5_ITER_NATIVE, &position, add, &names) >= 0);
        std::sort(names.begin(), names.end());
        return names;
    }

    [[nodiscard]] std::vector<std::string> list_attributes(const std::string& path) const {
        const Handle object(H5Oopen(file.id(), path.c_str(), H5P_DEFAULT), H5Oclose);
        require_hdf5(object.is_open());
        std::vector<std::string> names;
        hsize_t position = 0;
        const auto add = [](hid_t, const char* attribute, const H5A_info_t*, void* list) -> herr_t {
            static_cast<std::vector<std::string>*>(list)->emplace_back(attribute);
            return 0;
        };
        require_hdf5(H5Aiterate2(object.id(), H5_INDEX_NAME, H5_ITER_NATIVE, &position, add, &names) >= 0);
        return names;
    }

    struct Contents {
        std::vector<std::string> datasets;
        std::vector<std::string> attributes;
    };

    void walk(const std::string& group, int depth, Contents& contents) const {
        require(depth <= max_depth && contents.datasets.size() + contents.attributes.size() < max_entries,
                "groups are nested too deep or hold too much");
        for (const std::string& attribute : list_attributes(group))
            contents.attributes.push_back(attribute_path(group, attribute));
        for (const std::string& entry : list(group)) {
            const std::string path = join(group, entry);
            const H5I_type_t kind = kind_of(path);
            require(kind == H5I_DATASET || kind == H5I_GROUP, path + " is neither a dataset nor a group");
            if (kind == H5I_GROUP) {
                walk(path, depth + 1, contents);
                continue;
            }
            contents.datasets.push_back(path);
            for (const std::string& attribute : list_attributes(path))
                contents.attributes.push_back(attribute_path(path, attribute));
        }
    }

    [[nodiscard]] Contents contents() const {
        Contents contents;
        walk("/", 0, contents);
        std::sort(contents.datasets.begin(), contents.datasets.end());
        std::sort(contents.attributes.begin(), contents.attributes.end());
        return contents;
    }

    [[nodiscard]] const DatasetInfo& info(const std::string& path) const {
        if (const auto known = infos.find(path); known != infos.end()) return known->second;
        return infos[path] = info_of(open_dataset(path).id(), image.size());
    }

    [[nodiscard]] Layout layout(const std::string& path) const {
        const Handle dataset = open_dataset(path);
        const Handle settings(H5Dget_create_plist(dataset.id()), H5Pclose);
        return H5Pget_layout(settings.id()) == H5D_CHUNKED ? Layout::compressed : Layout::contiguous;
    }

    void read_into(const std::string& path, const DatasetInfo& info, std::span<std::byte> bytes) const {
        if (bytes.empty()) return;
        const Handle dataset = open_dataset(path);
        // In memory as in the file: little-endian, texts padded with zeros.
        const Handle type(H5Dget_type(dataset.id()), H5Tclose);
        require(byte_count(info) == bytes.size(), "its size has changed");
        require_hdf5(H5Dread(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()) >= 0);
    }
};

FileReader::FileReader(std::vector<std::byte> image, std::string name)
    : state_(new State{std::move(name), std::move(image), Handle()}) {
    const std::string damage = find_damage(state_->image);
    if (!damage.empty()) throw Error(ErrorKind::bad_input, state_->name + ": damaged: " + damage);
    state_->file = open_image(state_->image);
    if (!state_->file.is_open()) {
        throw Error(ErrorKind::bad_input, state_->name + ": HDF5 cannot open it: " + last_hdf5_error());
    }
}

FileReader::~FileReader() = default;
FileReader::FileReader(FileReader&&) noexcept = default;
FileReader& FileReader::operator=(FileReader&&) noexcept = default;

const std::string& FileReader::name() const { return state_->name; }

bool FileReader::has(const std::string& path) const {
    return state_->at(path, [&] { return state_->exists(path); });
}

std::vector<std::string> FileReader::list(const std::string& group) const {
    return state_->at(group, [&] { return state_->list(group); });
}

std::vector<std::string> FileReader::all_datasets() const {
    return state_->at("/", [&] { return state_->contents().datasets; });
}

std::vector<std::string> FileReader::all_attributes() const {
    return state_->at("/", [&] { return state_->contents().attributes; });
}

DatasetInfo FileReader::info(const std::string& path) const {
    return state_->at(path, [&] { return state_->info(path); });
}

Layout FileReader::layout(const std::string& path) const {
    return state_->at(path, [&] { return state_->layout(path); });
}

Dataset FileReader::read_bytes(const std::string& path) const {
    Dataset dataset{info(path), {}};
    dataset.bytes.resize(state_->at(path, [&] { return byte_count(dataset.info); }));
    state_->at(path, [&] { state_->read_into(path, dataset.info, dataset.bytes); });
    return dataset;
}

std::uint64_t FileReader::require_rows(const std::string& path, Type type, std::uint64_t columns) const {
    const DatasetInfo found = info(path);
    if (found.type != type) {
        refuse(path, "holds " + std::string(name_of(found.type)) + ", expected " + std::string(name_of(type)));
    }
    const bool fits = columns == 0 ? found.shape.size() == 1 : found.shape.size() == 2 && found.shape[1] == columns;
    if (!fits) refuse(path, "does not have rows of " + std::to_string(columns == 0 ? 1 : columns));
    return found.shape[0];
}

void FileReader::read_into(const std::string& path, std::span<std::byte> bytes) const {
    const DatasetInfo found = info(path);
    state_->at(path, [&] { state_->read_into(path, found, bytes); });
}

std::vector<std::string> FileReader::read_texts(const std::string& path) const {
    const Dataset dataset = read_bytes(path);
    if (dataset.info.type != Type::text || dataset.info.shape.size() != 1) refuse(path, "is not a list of texts");
    std::vector<std::string> texts;
    for (std::uint64_t i = 0; i < dataset.info.shape[0]; ++i) {
        std::string text(reinterpret_cast<const char*>(dataset.bytes.data()) + i * dataset.info.element_size,
                         dataset.info.element_size);
        text.erase(std::find_if(text.rbegin(), text.rend(), [](char c) { return c != '\0'; }).base(), text.end());
        if (text.find('\0') != std::string::npos) refuse(path, "has a zero inside a text");
        texts.push_back(std::move(text));
    }
    return texts;
}

std::string FileReader::read_text(const std::string& path) const {
    std::vector<std::string> texts = read_texts(path);
    if (texts.size() != 1) refuse(path, "should hold one text");
    return std::move(texts.front());
}

Dataset FileReader::read_attribute(const std::string& group, const std::string& name) const {
    return state_->at(attribute_path(group, name), [&] {
        const Handle object(H5Oopen(state_->file.id(), group.c_str(), H5P_DEFAULT), H5Oclose);
        require(object.is_open() && H5Aexists(object.id(), name.c_str()) > 0, "it is missing");
        const Handle attribute(H5Aopen(object.id(), name.c_str(), H5P_DEFAULT), H5Aclose);
        require_hdf5(attribute.is_open());
        const Handle type(H5Aget_type(attribute.id()), H5Tclose);
        const Handle space(H5Aget_space(attribute.id()), H5Sclose);
        Dataset dataset{info_of_type(type.id()), {}};
        dataset.info.shape = shape_of(space.id());
        require(byte_count(dataset.info) <= state_->image.size(), "it claims more data than the file holds");
        dataset.bytes.resize(byte_count(dataset.info));
        require_hdf5(H5Aread(attribute.id(), type.id(), dataset.bytes.data()) >= 0);
        return dataset;
    });
}

std::vector<std::int64_t> FileReader::read_numbers(const std::string& group, const std::string& name) const {
    const Dataset dataset = read_attribute(group, name);
    if (dataset.info.type != Type::i64) refuse(attribute_path(group, name), "should hold i64");
    std::vector<std::int64_t> values(dataset.bytes.size() / sizeof(std::int64_t));
    std::copy(dataset.bytes.begin(), dataset.bytes.end(), std::as_writable_bytes(std::span(values)).begin());
    return values;
}

void FileReader::refuse(const std::string& path, const std::string& why) const {
    throw Error(ErrorKind::bad_input, state_->name + ": " + path + " " + why);
}

}
