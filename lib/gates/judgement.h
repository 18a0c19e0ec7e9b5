// SPDX-License-Identifier: GPL-3.0-or-later
// The gates that are not met, as findings.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/finding.h"
#include "gates/limits.h"

namespace crumple::gates {

[[nodiscard, gnu::format(printf, 1, 2)]] std::string format(const char* pattern, ...);

class Judgement {
public:
    struct Told {
        std::string remedy;
        std::vector<Place> places;
        std::uint64_t count = 1;
    };

    // Calls `tell` for remedy and places only when the gate is not met; `what` names the figure.
    void ask(const char* code, const std::string& what, double value, const Gate& gate, Wanted wanted,
             const std::function<Told()>& tell);

    std::vector<Finding> findings;
};

}
