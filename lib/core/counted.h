// SPDX-License-Identifier: MIT
// "1 tet", "2 tets".
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace crumple {

[[nodiscard]] inline std::string counted(std::uint64_t count, std::string_view one, std::string_view many) {
    return std::to_string(count) + " " + std::string(count == 1 ? one : many);
}

}
