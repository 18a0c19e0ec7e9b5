// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/bench.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string_view>
#include <thread>

namespace crumple::bench {
namespace {

std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') result += '\\';
        if (static_cast<unsigned char>(c) >= 0x20) result += c;
    }
    return result + '"';
}

std::string json_of(const Row::Value& value) {
    if (const auto* text = std::get_if<std::string>(&value)) return quoted(*text);
    const auto number = std::get<std::optional<double>>(value);
    if (!number || !std::isfinite(*number)) return "null";
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.6g", *number);
    return digits;
}

std::string json_of(const Row& row) {
    std::string text;
    const auto add = [&](const std::string& key, const Row::Value& value) {
        text += (text.empty() ? "" : ", ") + quoted(key) + ": " + json_of(value);
    };
    if (!row.name.empty()) add("name", row.name);
    if (!row.input.empty()) add("input", row.input);
    for (const auto& [key, value] : row.figures) add(key, value);
    return '{' + text + '}';
}

std::string processor() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);) {
        const auto colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
    }
    return "unknown";
}

std::string today() {
    const std::time_t now = std::time(nullptr);
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", std::gmtime(&now));
    return text;
}

std::string report_of(const std::vector<Row>& rows) {
    std::string text = "{\n  \"machine\": " +
                       quoted(processor() + ", " + std::to_string(std::thread::hardware_concurrency()) + " cores") +
                       ",\n  \"date\": " + quoted(today()) + ",\n  \"rows\": [";
    for (std::size_t i = 0; i < rows.size(); ++i) text += (i ? ",\n    " : "\n    ") + json_of(rows[i]);
    return text + "\n  ]\n}\n";
}

// The rows of every benchmark that ran, in the order they were registered.
std::vector<std::pair<std::string, std::vector<Row>>>& measured() {
    static std::vector<std::pair<std::string, std::vector<Row>>> rows;
    return rows;
}

std::vector<Row> all_rows() {
    std::vector<Row> all;
    for (const auto& [name, rows] : measured()) all.insert(all.end(), rows.begin(), rows.end());
    return all;
}

// Our own columns instead of Google Benchmark's: the figures of the rows are what the project is judged by.
class RowReporter : public benchmark::BenchmarkReporter {
public:
    bool ReportContext(const Context&) override { return true; }
    void ReportRuns(const std::vector<Run>& runs) override {
        for (const auto& [name, rows] : measured()) {
            if (runs.empty() || runs.front().run_name.function_name != name) continue;
            for (const Row& row : rows) print(row);
        }
    }

private:
    static void print(const Row& row) {
        if (!row.name.empty()) std::cout << row.name << "  " << row.input;
        for (const auto& [key, value] : row.figures) std::cout << "  " << key << ' ' << json_of(value);
        std::cout << std::endl;
    }
};

struct Options {
    bool quick = false;
    std::string json;
};

// What Google Benchmark left over; nothing when there is a word nobody knows.
std::optional<Options> read_options(int argc, char** argv) {
    Options options;
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        if (word == "--quick") {
            options.quick = true;
        } else if (word == "--json" && i + 1 < argc) {
            options.json = argv[++i];
        } else {
            return std::nullopt;
        }
    }
    return options;
}

}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

benchmark::internal::Benchmark* add(const std::string& name, Measure measure) {
    const std::size_t place = measured().size();
    measured().push_back({name, {}});
    return benchmark::RegisterBenchmark(name.c_str(),
                                        [place, measure = std::move(measure)](benchmark::State& state) {
                                            measured()[place].second = measure(state);
                                        })
        ->UseManualTime();
}

void add_once(const std::string& name, std::function<std::vector<Row>()> measure) {
    add(name, [measure = std::move(measure)](benchmark::State& state) {
        std::vector<Row> rows;
        while (state.KeepRunning()) state.SetIterationTime(seconds([&] { rows = measure(); }));
        return rows;
    })->Iterations(1);
}

int run(int argc, char** argv, void (*add_all)(bool quick)) {
    benchmark::Initialize(&argc, argv);
    const std::optional<Options> options = read_options(argc, argv);
    if (!options) {
        std::cerr << "usage: " << argv[0] << " [--quick] [--json FILE] [--benchmark_filter=REGEX]\n";
        return 1;
    }
    add_all(options->quick);
    RowReporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    if (options->json.empty()) return 0;
    std::ofstream file(options->json);
    file << report_of(all_rows());
    file.close();
    if (file) return 0;
    std::cerr << options->json << ": cannot be written\n";
    return 2;
}

}
