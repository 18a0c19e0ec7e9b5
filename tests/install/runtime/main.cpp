// SPDX-License-Identifier: MIT
// A game that checks a bundle before it trusts it: an empty bundle has no elements, and validate says so.
#include <cstdio>

#include "bundle/bundle.h"
#include "bundle/validate.h"

int main() {
    const auto findings = crumple::validate(crumple::Bundle{});
    for (const auto& finding : findings) std::printf("%s: %s\n", finding.code.c_str(), finding.message.c_str());
    return 0;
}
