// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a fuzz target without libFuzzer, so that every build's suite does, with any compiler: on each file of a corpus,
// then on a fixed number of inputs made from them, the same ones every time.
//
//   brief_hull [-rounds=N] [FILE or FOLDER]...
//
// Before each run the input is written to brief_hull.input; after a failure `brief_hull -rounds=0 brief_hull.input`
// runs it again.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "core/random.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

namespace fs = std::filesystem;
using crumple::Rng;
using Bytes = std::vector<std::uint8_t>;

constexpr std::uint32_t longest = 600;

Bytes read_file(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<Bytes> read_corpus(const std::vector<fs::path>& places) {
    std::vector<fs::path> files;
    for (const fs::path& place : places) {
        if (!fs::is_directory(place))
            files.push_back(place);
        else
            for (const auto& entry : fs::directory_iterator(place)) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    std::vector<Bytes> corpus;
    for (const fs::path& file : files) corpus.push_back(read_file(file));
    return corpus;
}

// Few distinct bytes make many equal numbers: coincident, collinear and coplanar points, repeated indices.
Bytes noise(Rng& rng) {
    Bytes bytes(1 + rng.next_below(longest));
    const std::uint32_t distinct = 1 + rng.next_below(256);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(rng.next_below(distinct));
    bytes[0] = static_cast<std::uint8_t>(rng.next_below(256));
    return bytes;
}

std::size_t place_in(const Bytes& bytes, Rng& rng) {
    return rng.next_below(static_cast<std::uint32_t>(bytes.size() + 1));
}

void overwrite(Bytes& bytes, Rng& rng) {
    if (!bytes.empty()) bytes[rng.next_below(static_cast<std::uint32_t>(bytes.size()))] ^= 1u << rng.next_below(8);
}

void insert_noise(Bytes& bytes, Rng& rng) {
    const Bytes more(1 + rng.next_below(8), static_cast<std::uint8_t>(rng.next_below(256)));
    bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(place_in(bytes, rng)), more.begin(), more.end());
}

void erase_run(Bytes& bytes, Rng& rng) {
    const std::size_t first = place_in(bytes, rng);
    const std::size_t last = std::min(bytes.size(), first + 1 + rng.next_below(16));
    bytes.erase(bytes.begin() + static_cast<std::ptrdiff_t>(first), bytes.begin() + static_cast<std::ptrdiff_t>(last));
}

// The beginning of one and the end of another.
void splice(Bytes& bytes, const Bytes& other, Rng& rng) {
    bytes.resize(place_in(bytes, rng));
    bytes.insert(bytes.end(), other.begin() + static_cast<std::ptrdiff_t>(place_in(other, rng)), other.end());
}

Bytes mutated(const std::vector<Bytes>& corpus, Rng& rng) {
    const auto some = [&]() -> const Bytes& {
        return corpus[rng.next_below(static_cast<std::uint32_t>(corpus.size()))];
    };
    Bytes bytes = some();
    for (std::uint32_t changes = 1 + rng.next_below(6); changes > 0; --changes) {
        switch (rng.next_below(4)) {
            case 0:
                insert_noise(bytes, rng);
                break;
            case 1:
                erase_run(bytes, rng);
                break;
            case 2:
                splice(bytes, some(), rng);
                break;
            default:
                overwrite(bytes, rng);
                break;
        }
    }
    return bytes;
}

void run(const Bytes& bytes, const fs::path& trace) {
    std::ofstream(trace, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    // A copy of just this size: reading past its end is an error the sanitizer sees.
    const Bytes input(bytes.begin(), bytes.end());
    (void)LLVMFuzzerTestOneInput(input.data(), input.size());
}

}

int main(int count, char** arguments) {
    std::uint64_t rounds = 1000;
    std::vector<fs::path> places;
    for (int i = 1; i < count; ++i) {
        const std::string_view word = arguments[i];
        if (word.starts_with("-rounds="))
            rounds = std::strtoull(arguments[i] + 8, nullptr, 10);
        else
            places.emplace_back(word);
    }
    try {
        const fs::path trace = fs::path(arguments[0]).filename().string() + ".input";
        const std::vector<Bytes> corpus = read_corpus(places);
        for (const Bytes& bytes : corpus) run(bytes, trace);
        for (std::uint64_t round = 0; round < rounds; ++round) {
            Rng rng(77, round);
            run(corpus.empty() || rng.next_below(2) == 0 ? noise(rng) : mutated(corpus, rng), trace);
        }
        fs::remove(trace);
        std::printf("%zu files and %llu inputs made from them\n", corpus.size(),
                    static_cast<unsigned long long>(rounds));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
