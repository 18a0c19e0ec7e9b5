// SPDX-License-Identifier: GPL-3.0-or-later
// A run as ParaView takes it, a folder beside the run's own file:
//     run.hdf -> run_series/run_control_00000.hdf ... and run_series/run_control.hdf.series
#pragma once
#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "study/run_file.h"

namespace crumple::cli {

class RunSeries {
public:
    explicit RunSeries(const std::string& output);

    // Before any work: throws Error(file) when the folder cannot be one or be written to, Error(usage) when an input
    // lies where a frame may.
    void check(const std::vector<std::string>& inputs) const;

    // Every frame of one mesh, and its index.
    void write(const std::string& mesh, const study::Run& run,
               const std::function<std::vector<std::byte>(const study::Frame&)>& image_of);

    // What an earlier run left of the same name: more frames, other meshes. Files of other names stay.
    void remove_stale() const;

private:
    [[nodiscard]] bool is_name_of_ours(const std::string& name) const;
    void write_file(const std::string& name, std::span<const std::byte> bytes);

    std::filesystem::path folder_;
    std::string stem_;
    std::set<std::string> written_;
};

}
