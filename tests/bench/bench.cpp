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
    std::string text = "{\"name\": " + quoted(row.name) + ", \"input\": " + quoted(row.input);
    for (const auto& [key, value] : row.figures) text += ", " + quoted(key) + ": " + json_of(value);
    return text + '}';
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

void print(const std::vector<Row>& rows) {
    for (const auto& row : rows) {
        std::cout << row.name << "  " << row.input;
        for (const auto& [key, value] : row.figures) std::cout << "  " << key << " " << json_of(value);
        std::cout << '\n';
    }
}

}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

int run(int argc, char** argv, std::vector<Row> (*measure)(bool quick)) {
    bool quick = false;
    std::string path;
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        if (word == "--quick") {
            quick = true;
        } else if (word == "--json" && i + 1 < argc) {
            path = argv[++i];
        } else {
            std::cerr << "usage: " << argv[0] << " [--quick] [--json FILE]\n";
            return 1;
        }
    }
    const auto rows = measure(quick);
    print(rows);
    if (path.empty()) return 0;
    std::ofstream file(path);
    file << report_of(rows);
    file.close();
    if (file) return 0;
    std::cerr << path << ": cannot be written\n";
    return 2;
}

}
