// SPDX-License-Identifier: MIT
#include <algorithm>
#include <set>

#include "bundle/validate_parts.h"

namespace crumple {

namespace {

// What is asked for by name must have one, and its own.
template <class Things, class NameOf>
void expect_own_names(const Things& things, NameOf&& name_of, Complaints& complaints) {
    std::set<std::string_view> taken;
    for (std::size_t i = 0; i < things.size(); ++i) {
        const std::string_view name = name_of(things[i]);
        if (!name.empty() && taken.insert(name).second) continue;
        complaints.add("BUNDLE_NAME", "a name is empty, or there twice; place is its row and the name",
                       static_cast<Index>(i), no_place, name);
    }
}

bool is_sha256(std::string_view digest) {
    constexpr std::size_t size = 64;
    const bool is_hex = std::all_of(digest.begin(), digest.end(),
                                    [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); });
    return digest.size() == size && is_hex;
}

}

void check_names(const Bundle& b, Complaints& complaints) {
    const auto name_of = [](const auto& thing) -> std::string_view { return thing.name; };
    expect_own_names(b.materials, name_of, complaints);
    expect_own_names(
        b.regions, [](const std::string& name) -> std::string_view { return name; }, complaints);
    expect_own_names(b.visuals, name_of, complaints);
    expect_own_names(b.sensors, name_of, complaints);
    expect_own_names(b.provenance.stage_versions, name_of, complaints);
    expect_own_names(b.provenance.input_digests, name_of, complaints);
    for (const BundleProvenance::Entry& input : b.provenance.input_digests) {
        if (is_sha256(input.value)) continue;
        complaints.add("BUNDLE_PROVENANCE",
                       "the digest of an input is no SHA-256 in hexadecimal digits; place names it", none, no_place,
                       input.name);
    }
}

}
