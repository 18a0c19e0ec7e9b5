// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <set>

#include "bundle/validate.h"
#include "core/error.h"
#include "store/bundle_fields.h"
#include "store/bundle_file.h"
#include "store/read_file.h"

namespace crumple::store {
namespace {

const std::string root = "/bundle/";

// Remembers what was read, so that what nobody asked for can be refused.
struct ReadArchive {
    const FileReader& file;
    std::set<std::string> read_paths = {};

    std::string path_of(const std::string& path) { return *read_paths.insert(root + path).first; }

    template <class T>
    void rows(const std::string& path, std::vector<T>& values) {
        values = file.read<T>(path_of(path));
    }
    template <class T>
    void value(const std::string& path, T& value) {
        value = file.read_value<T>(path_of(path));
    }
    void texts(const std::string& path, std::vector<std::string>& texts) { texts = file.read_texts(path_of(path)); }
    void text(const std::string& path, std::string& text) { text = file.read_text(path_of(path)); }
};

std::string version_text(std::int64_t major, std::int64_t minor) {
    return std::to_string(major) + "." + std::to_string(minor);
}

// Returns the minor version.
std::int64_t check_schema(const FileReader& file) {
    if (!file.has("/bundle")) file.refuse("/bundle", "is missing: the file holds no bundle; cook it to the end");
    const std::vector<std::int64_t> version = file.read_numbers("/bundle", "schema_version");
    if (version.size() != 2 || version[1] < 0) file.refuse("/bundle@schema_version", "should be two numbers");
    if (version[0] != schema_major) {
        file.refuse("/bundle", "has schema " + version_text(version[0], version[1]) + ", this program reads " +
                                   version_text(schema_major, 0) + " and later " + std::to_string(schema_major) +
                                   ".x; cook the asset with this version");
    }
    return version[1];
}

// Fills the field of one material from row `row` of the columns.
struct MaterialRow {
    ReadArchive& archive;
    std::map<std::string, std::vector<double>>& columns;
    std::size_t row;
    std::size_t count;

    void field(std::string_view, std::string&, std::string_view) {}
    void field(std::string_view name, double& number, Range, std::string_view) {
        const std::string path = "materials/" + std::string(name);
        const auto [column, is_new] = columns.try_emplace(path);
        if (is_new) archive.rows(path, column->second);
        if (column->second.size() != count) archive.file.refuse(root + path, "should have one row a material");
        number = column->second[row];
    }
};

void read_materials(ReadArchive& archive, std::vector<Material>& materials) {
    std::vector<std::string> names;
    archive.texts("materials/name", names);
    std::map<std::string, std::vector<double>> columns;
    for (const std::string& name : names) {
        Material& material = materials.emplace_back();
        MaterialRow fields{archive, columns, materials.size() - 1, names.size()};
        describe(fields, material);
        material.name = name;
    }
}

void read_entries(ReadArchive& archive, const std::string& group, std::vector<BundleProvenance::Entry>& entries) {
    std::vector<std::string> names;
    std::vector<std::string> values;
    archive.texts(group + "/name", names);
    archive.texts(group + "/value", values);
    if (names.size() != values.size()) archive.file.refuse(root + group, "should have one value a name");
    for (std::size_t i = 0; i < names.size(); ++i) entries.push_back({names[i], values[i]});
}

template <class Named, class Visit>
void read_named(ReadArchive& archive, const std::string& kind, std::vector<Named>& items, Visit visit) {
    std::vector<std::string> names;
    archive.texts(kind + "_names", names);
    for (const std::string& name : names) {
        if (name.empty()) archive.file.refuse(root + kind + "_names", "has an empty name");
        Named& item = items.emplace_back();
        item.name = name;
        visit(kind + "/" + encode_name(name), item);
    }
}

void refuse_strangers(const ReadArchive& archive) {
    for (const std::string& path : archive.file.all_datasets()) {
        if (path.starts_with(root) && !archive.read_paths.contains(path))
            archive.file.refuse(path, "is not part of the format");
    }
}

}

bool has_bundle(const FileReader& file) { return file.has("/bundle"); }

Bundle read_bundle(const FileReader& file) {
    const std::int64_t minor = check_schema(file);
    Bundle bundle;
    ReadArchive archive{file};
    visit_mesh(archive, bundle);
    read_materials(archive, bundle.materials);
    visit_matrix(archive, bundle);
    read_named(archive, "visual", bundle.visuals,
               [&](const std::string& group, BundleVisual& v) { visit_visual(archive, group, v); });
    read_named(archive, "sensor", bundle.sensors,
               [&](const std::string& group, BundleSensor& s) { visit_sensor(archive, group, s); });
    visit_provenance(archive, bundle.provenance);
    read_entries(archive, "provenance/stage_versions", bundle.provenance.stage_versions);
    read_entries(archive, "provenance/input_digests", bundle.provenance.input_digests);
    if (minor <= schema_minor) refuse_strangers(archive);
    return bundle;
}

Bundle load_bundle(const std::string& path) {
    Bundle bundle = read_bundle(FileReader(read_file(path), path));
    const std::vector<Finding> wrong = validate(bundle);
    if (!wrong.empty()) {
        throw Error(ErrorKind::bad_input,
                    path + ": " + wrong.front().code + ": " + wrong.front().message + "; cook it again");
    }
    return bundle;
}

}
