// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/run_file.h"

#include <array>

#include "report/json_writer.h"
#include "store/bundle_file.h"
#include "store/hdf5_file.h"

namespace crumple::study {
namespace {

using store::FileWriter;

constexpr std::uint8_t vtk_vertex = 1;
constexpr std::uint8_t vtk_triangle = 5;
constexpr std::uint8_t vtk_tetra = 10;

// VTKHDF 1.0 as VTK 9.1 reads it, all cells of one kind.
template <std::size_t corners>
void write_grid(FileWriter& file, const std::vector<Vec3f>& points,
                const std::vector<std::array<Index, corners>>& cells, std::uint8_t type) {
    const auto count = [](std::size_t n) { return std::array{static_cast<std::int64_t>(n)}; };
    std::vector<std::int64_t> connectivity;
    for (const auto& cell : cells) connectivity.insert(connectivity.end(), cell.begin(), cell.end());
    std::vector<std::int64_t> offsets(cells.size() + 1);
    for (std::size_t i = 0; i < offsets.size(); ++i) offsets[i] = static_cast<std::int64_t>(corners * i);
    file.set_attribute("/VTKHDF", "Version", std::array<std::int64_t, 2>{1, 0});
    file.set_attribute("/VTKHDF", "Type", std::string("UnstructuredGrid"));
    file.write("/VTKHDF/NumberOfPoints", count(points.size()));
    file.write("/VTKHDF/NumberOfCells", count(cells.size()));
    file.write("/VTKHDF/NumberOfConnectivityIds", count(connectivity.size()));
    file.write("/VTKHDF/Points", points);
    file.write("/VTKHDF/Connectivity", connectivity);
    file.write("/VTKHDF/Offsets", offsets);
    file.write("/VTKHDF/Types", std::vector<std::uint8_t>(cells.size(), type));
}

void write_control(FileWriter& file, const Bundle& bundle, const Frame& frame) {
    write_grid(file, frame.nodes, bundle.tets, vtk_tetra);
    file.write("/VTKHDF/PointData/locked", bundle.locked);
    file.write("/VTKHDF/CellData/plastic_strain", frame.plastic_strain);
    file.write("/VTKHDF/CellData/region", bundle.region);
}

// One number of every frame.
template <class Read>
auto column_of(const Run& run, Read&& read) {
    std::vector<std::decay_t<decltype(read(run.frames.front()))>> values;
    for (const Frame& frame : run.frames) values.push_back(read(frame));
    return values;
}

void write_columns(FileWriter& file, const Run& run) {
    file.write("/run/time_s", column_of(run, [](const Frame& f) { return f.time_s; }));
    file.write("/run/kinetic_j", column_of(run, [](const Frame& f) { return f.kinetic_j; }));
    file.write("/run/elastic_j", column_of(run, [](const Frame& f) { return f.elastic_j; }));
    file.write("/run/iterations", column_of(run, [](const Frame& f) { return f.iterations; }));
    file.write("/run/contacts", column_of(run, [](const Frame& f) { return f.contacts; }));
    file.write("/run/inverted", column_of(run, [](const Frame& f) { return f.inverted; }));
    file.write("/run/is_asleep", column_of(run, [](const Frame& f) { return static_cast<std::uint8_t>(f.is_asleep); }));
}

template <class List>
std::vector<Vec3f> rows_of(const Run& run, List&& list) {
    std::vector<Vec3f> rows;
    for (const Frame& frame : run.frames) rows.insert(rows.end(), list(frame).begin(), list(frame).end());
    return rows;
}

void write_sensor(FileWriter& file, const Run& run, const std::string& group, std::size_t i) {
    file.write(group + "/origin", column_of(run, [&](const Frame& f) { return f.sensors[i].origin; }));
    file.write(group + "/orientation", column_of(run, [&](const Frame& f) {
                   const solver::Quaternion q = f.sensors[i].orientation;
                   return std::array<float, 4>{q.x, q.y, q.z, q.w};
               }));
    file.write(group + "/deformation", column_of(run, [&](const Frame& f) { return f.sensors[i].deformation; }));
    file.write(group + "/plastic_strain", column_of(run, [&](const Frame& f) { return f.sensors[i].plastic_strain; }));
    file.write(group + "/acceleration", column_of(run, [&](const Frame& f) { return f.sensors[i].acceleration; }));
}

}

std::vector<std::byte> run_image(const Bundle& bundle, const Scene& scene, const Run& run) {
    FileWriter file;
    Scene described = scene;
    file.write_text("/run/scene", report::write_json(report::Described::of(described)));
    write_columns(file, run);
    file.write("/run/nodes", rows_of(
                                 run, [](const Frame& f) -> auto& { return f.nodes; }));
    for (std::size_t i = 0; i < bundle.visuals.size(); ++i) {
        file.write("/run/visual/" + store::encode_name(bundle.visuals[i].name),
                   rows_of(
                       run, [&](const Frame& f) -> auto& { return f.vertices[i]; }));
    }
    for (std::size_t i = 0; i < bundle.sensors.size(); ++i) {
        write_sensor(file, run, "/run/sensor/" + store::encode_name(bundle.sensors[i].name), i);
    }
    write_control(file, bundle, run.frames.back());
    return file.finish();
}

std::vector<std::byte> control_image(const Bundle& bundle, const Frame& frame) {
    FileWriter file;
    write_control(file, bundle, frame);
    return file.finish();
}

std::vector<std::byte> visual_image(const Frame& frame, std::size_t visual, const std::vector<Triangle>& triangles) {
    FileWriter file;
    if (!triangles.empty()) {
        write_grid(file, frame.vertices[visual], triangles, vtk_triangle);
        return file.finish();
    }
    std::vector<std::array<Index, 1>> points(frame.vertices[visual].size());
    for (std::size_t i = 0; i < points.size(); ++i) points[i] = {static_cast<Index>(i)};
    write_grid(file, frame.vertices[visual], points, vtk_vertex);
    return file.finish();
}

std::string series_index(const std::vector<SeriesFile>& files) {
    report::Json::List list;
    for (const SeriesFile& f : files) {
        report::Json entry;
        entry.add("name", f.name);
        entry.add("time", f.time_s);
        list.push_back(std::move(entry));
    }
    report::Json index;
    index.add("file-series-version", std::string("1.0"));
    index.add("files", std::move(list));
    return report::dump_json(index, report::JsonStyle::indented);
}

}
