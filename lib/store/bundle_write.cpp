// SPDX-License-Identifier: MIT
#include <array>
#include <map>

#include "store/bundle_fields.h"
#include "store/bundle_file.h"
#include "store/grid_view.h"

namespace crumple::store {
namespace {

const std::string root = "/bundle/";

struct WriteArchive {
    FileWriter& file;

    template <class T>
    void rows(const std::string& path, const std::vector<T>& values) {
        file.write(root + path, values);
    }
    template <class T>
    void value(const std::string& path, const T& value) {
        file.write_value(root + path, value);
    }
    void texts(const std::string& path, const std::vector<std::string>& texts) { file.write_texts(root + path, texts); }
    void text(const std::string& path, const std::string& text) { file.write_text(root + path, text); }
};

// One dataset a field of Material, one row a material.
struct MaterialColumns {
    std::map<std::string, std::vector<std::string>> texts;
    std::map<std::string, std::vector<double>> numbers;

    void field(std::string_view name, const std::string& text, std::string_view) {
        texts[std::string(name)].push_back(text);
    }
    void field(std::string_view name, double number, Range, std::string_view) {
        numbers[std::string(name)].push_back(number);
    }
};

void write_materials(FileWriter& file, const std::vector<Material>& materials) {
    MaterialColumns columns;
    for (const Material& material : materials) describe(columns, material);
    for (const auto& [name, texts] : columns.texts) file.write_texts(root + "materials/" + name, texts);
    for (const auto& [name, numbers] : columns.numbers) file.write(root + "materials/" + name, numbers);
}

void write_entries(FileWriter& file, const std::string& group, const std::vector<BundleProvenance::Entry>& entries) {
    std::vector<std::string> names;
    std::vector<std::string> values;
    for (const auto& [name, value] : entries) {
        names.push_back(name);
        values.push_back(value);
    }
    file.write_texts(root + group + "/name", names);
    file.write_texts(root + group + "/value", values);
}

template <class Named>
std::vector<std::string> names_of(const std::vector<Named>& items) {
    std::vector<std::string> names;
    for (const Named& item : items) names.push_back(item.name);
    return names;
}

// Points and data by links, connectivity as lists of its own.
void write_view(FileWriter& file, const Bundle& b) {
    write_grid(file, grid_cells(b.tets), root + "rest_positions", b.rest_positions.size());
    for (const std::string name : {"locked", "mass"}) file.link("/VTKHDF/PointData/" + name, root + name);
    for (const std::string name : {"material", "region", "stiffness_scale", "volume"}) {
        file.link("/VTKHDF/CellData/" + name, root + name);
    }
}

}

void write_bundle(FileWriter& file, const Bundle& bundle) {
    WriteArchive archive{file};
    file.set_attribute("/bundle", "schema_version", std::array{schema_major, schema_minor});
    visit_mesh(archive, bundle);
    write_materials(file, bundle.materials);
    visit_matrix(archive, bundle);
    archive.texts("visual_names", names_of(bundle.visuals));
    for (const BundleVisual& visual : bundle.visuals)
        visit_visual(archive, "visual/" + encode_name(visual.name), visual);
    archive.texts("sensor_names", names_of(bundle.sensors));
    for (const BundleSensor& sensor : bundle.sensors)
        visit_sensor(archive, "sensor/" + encode_name(sensor.name), sensor);
    visit_provenance(archive, bundle.provenance);
    write_entries(file, "provenance/stage_versions", bundle.provenance.stage_versions);
    write_entries(file, "provenance/input_digests", bundle.provenance.input_digests);
    write_view(file, bundle);
}

std::vector<std::byte> to_image(const Bundle& bundle, Layout layout) {
    FileWriter file(layout);
    write_bundle(file, bundle);
    return file.finish();
}

std::string encode_name(const std::string& name) {
    constexpr char digits[] = "0123456789ABCDEF";
    std::string encoded;
    for (const char c : name) {
        const auto byte = static_cast<unsigned char>(c);
        const bool is_leading_dot = c == '.' && encoded.empty();
        if (c == '/' || c == '%' || byte < 0x20 || byte == 0x7f || is_leading_dot) {
            encoded += {'%', digits[byte >> 4], digits[byte & 15]};
        } else {
            encoded += c;
        }
    }
    return encoded;
}

}
