// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/run_file.h"

#include <array>

#include "report/json_writer.h"
#include "store/bundle_file.h"
#include "store/grid_view.h"
#include "store/hdf5_file.h"

namespace crumple::study {
namespace {

using store::FileWriter;

void write_control(FileWriter& file, const Bundle& bundle, const Frame& frame) {
    store::write_grid(file, store::grid_cells(bundle.tets), frame.nodes);
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
        store::write_grid(file, store::grid_cells(triangles), frame.vertices[visual]);
        return file.finish();
    }
    std::vector<std::array<Index, 1>> points(frame.vertices[visual].size());
    for (std::size_t i = 0; i < points.size(); ++i) points[i] = {static_cast<Index>(i)};
    store::write_grid(file, store::grid_cells(points), frame.vertices[visual]);
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
