// SPDX-License-Identifier: MIT
#include "store/check_view.h"

#include <algorithm>
#include <cstring>
#include <string_view>

#include "store/grid_view.h"

namespace crumple::store {
namespace {

const std::string view = "/VTKHDF/";

class Comparison {
public:
    explicit Comparison(const FileReader& file) : file_(file) {}

    template <class T>
    void expect(const std::string& name, const std::vector<T>& values) {
        if (file_.read<T>(view + name) != values) different_.push_back(view + name);
    }
    void expect_count(const std::string& name, std::size_t count) {
        expect(name, std::vector<std::int64_t>{static_cast<std::int64_t>(count)});
    }
    void expect_same(const std::string& name, const std::string& dataset) {
        const Dataset shown = file_.read_bytes(view + name);
        const Dataset meant = file_.read_bytes(dataset);
        if (shown.info != meant.info || shown.bytes != meant.bytes) different_.push_back(view + name);
    }
    void expect_rows(const std::string& path, std::size_t count) {
        const Shape shape = file_.info(path).shape;
        if (shape.empty() || shape.front() != count) different_.push_back(path);
    }
    void add(const std::string& path) { different_.push_back(path); }
    [[nodiscard]] std::vector<std::string> take() { return std::move(different_); }

private:
    const FileReader& file_;
    std::vector<std::string> different_;
};

void compare_kind(const FileReader& file, Comparison& comparison) {
    const std::string group = "/VTKHDF";
    const std::vector<std::int64_t> version(grid_version.begin(), grid_version.end());
    if (file.read_numbers(group, "Version") != version) comparison.add(group + "@Version");
    constexpr std::string_view type = grid_type;
    const Dataset attribute = file.read_attribute(group, "Type");
    const bool agrees =
        attribute.bytes.size() == type.size() && std::memcmp(attribute.bytes.data(), type.data(), type.size()) == 0;
    if (!agrees) comparison.add(group + "@Type");
}

void compare_cells(const Bundle& bundle, Comparison& comparison) {
    const GridCells cells = grid_cells(bundle.tets);
    comparison.expect_count("NumberOfPoints", bundle.rest_positions.size());
    comparison.expect_count("NumberOfCells", bundle.tets.size());
    comparison.expect_count("NumberOfConnectivityIds", cells.connectivity.size());
    comparison.expect("Points", bundle.rest_positions);
    comparison.expect("Connectivity", cells.connectivity);
    comparison.expect("Offsets", cells.offsets);
    comparison.expect("Types", cells.types);
}

// Fields that the bundle has under the same name, and those it has not.
void compare_fields(const FileReader& file, const std::string& group, std::size_t rows, Comparison& comparison) {
    if (!file.has(view + group)) return;
    for (const std::string& name : file.list(view + group)) {
        const std::string path = group + "/" + name;
        if (file.has("/bundle/" + name))
            comparison.expect_same(path, "/bundle/" + name);
        else
            comparison.expect_rows(view + path, rows);
    }
}

void compare_names(const FileReader& file, Comparison& comparison) {
    static const std::vector<std::string> known{
        "CellData",       "Connectivity", "FieldData", "NumberOfCells", "NumberOfConnectivityIds",
        "NumberOfPoints", "Offsets",      "PointData", "Points",        "Types"};
    for (const std::string& name : file.list("/VTKHDF")) {
        if (std::find(known.begin(), known.end(), name) == known.end()) comparison.add(view + name);
    }
}

}

std::vector<std::string> find_view_differences(const FileReader& file, const Bundle& bundle) {
    if (!file.has("/VTKHDF")) return {};
    Comparison comparison(file);
    compare_kind(file, comparison);
    compare_names(file, comparison);
    compare_cells(bundle, comparison);
    compare_fields(file, "PointData", bundle.rest_positions.size(), comparison);
    compare_fields(file, "CellData", bundle.tets.size(), comparison);
    return comparison.take();
}

}
