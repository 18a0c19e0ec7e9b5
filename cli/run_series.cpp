// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/run_series.h"

#include <algorithm>
#include <span>

#include "core/error.h"
#include "report/printable.h"
#include "store/bundle_file.h"
#include "store/write_file.h"

namespace crumple::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t digits_of_frame = 5;  // at least
constexpr std::string_view index_end = ".hdf.series";
constexpr std::string_view frame_end = ".hdf";

std::string number_of(std::size_t frame) {
    std::string digits = std::to_string(frame);
    digits.insert(0, digits_of_frame - std::min(digits_of_frame, digits.size()), '0');
    return digits;
}

// "..._00017"
bool ends_in_frame_number(std::string_view name) {
    const std::size_t last = name.find_last_not_of("0123456789");
    return last != std::string_view::npos && name[last] == '_' && name.size() - last - 1 >= digits_of_frame;
}

}

RunSeries::RunSeries(const std::string& output) {
    const fs::path path(output);
    stem_ = path.stem().string();
    folder_ = path.parent_path() / (stem_ + "_series");
}

bool RunSeries::is_name_of_ours(const std::string& name) const {
    if (!name.starts_with(stem_ + "_")) return false;
    if (name.ends_with(index_end)) return true;
    return name.ends_with(frame_end) &&
           ends_in_frame_number(std::string_view(name).substr(0, name.size() - frame_end.size()));
}

void RunSeries::check(const std::vector<std::string>& inputs) const {
    std::error_code error;
    const fs::file_status status = fs::status(folder_, error);
    if (!fs::exists(status)) return;  // whether it can be made is that of the output beside it
    if (!fs::is_directory(status)) {
        throw Error(ErrorKind::file, report::printable(folder_.string()) +
                                         ": is in the way of the folder for ParaView; move it, or give --no-series");
    }
    store::check_can_write((folder_ / (stem_ + "_control" + std::string(index_end))).string());
    for (const std::string& input : inputs) {
        const fs::path path(input);
        if (!is_name_of_ours(path.filename().string()) || !fs::equivalent(path.parent_path() / ".", folder_, error)) {
            continue;
        }
        throw Error(ErrorKind::usage,
                    report::printable(input) + ": lies where frames of the run go; move it, or give -o another name");
    }
}

void RunSeries::write_file(const std::string& name, std::span<const std::byte> bytes) {
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error) throw Error(ErrorKind::file, report::printable(folder_.string()) + ": " + error.message());
    try {
        store::write_file((folder_ / name).string(), bytes);
    } catch (const Error&) {
        fs::remove(folder_, error);  // if it is empty: it was made for nothing
        throw;
    }
    written_.insert(name);
}

void RunSeries::write(const std::string& mesh, const study::Run& run,
                      const std::function<std::vector<std::byte>(const study::Frame&)>& image_of) {
    const std::string start = stem_ + "_" + store::encode_name(mesh);
    std::vector<study::SeriesFile> files;
    for (const study::Frame& frame : run.frames) {
        files.push_back({start + "_" + number_of(files.size()) + std::string(frame_end), frame.time_s});
        write_file(files.back().name, image_of(frame));
    }
    const std::string index = study::series_index(files);
    write_file(start + std::string(index_end), std::as_bytes(std::span(index)));
}

void RunSeries::remove_stale() const {
    std::error_code error;
    std::vector<fs::path> stale;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_, error)) {
        const std::string name = entry.path().filename().string();
        if (is_name_of_ours(name) && !written_.contains(name) && entry.is_regular_file(error)) {
            stale.push_back(entry.path());
        }
    }
    for (const fs::path& path : stale) {
        if (!fs::remove(path, error) && error) {
            throw Error(ErrorKind::file, report::printable(path.string()) + ": cannot be removed: " + error.message());
        }
    }
}

}
