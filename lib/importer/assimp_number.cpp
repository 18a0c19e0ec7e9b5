// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/assimp_number.h"

#include <assimp/fast_atof.h>

#include <array>

namespace crumple::importer {

namespace {

// What the parser throws; assimp's own exception type is not exported from the library.
struct NoNumber {
    template <class... Parts>
    explicit NoNumber(Parts&&...) {}
};

}

std::optional<float> as_assimp_reads(std::string_view word) {
    std::array<char, 64> text{};  // the parser wants an end
    if (word.size() >= text.size()) return std::nullopt;
    word.copy(text.data(), word.size());
    try {
        return Assimp::fast_atof<NoNumber>(text.data());
    } catch (const NoNumber&) {
        return std::nullopt;
    }
}

}
