// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a recipe, then any line of it as a setting: read or refused with exit 1, and what is read writes the
// same canonical text again.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/error.h"
#include "pipeline/recipe.h"

namespace {

void check_round_trip(const crumple::pipeline::Recipe& recipe) {
    const std::string canonical = crumple::pipeline::canonical_json(recipe);
    const auto again = crumple::pipeline::read_recipe(canonical, "canonical");
    if (crumple::pipeline::canonical_json(again) != canonical) std::abort();
}

template <class Work>
void expect_usage_at_worst(const Work& work) {
    try {
        work();
    } catch (const crumple::Error& error) {
        if (error.kind() != crumple::ErrorKind::usage) std::abort();
    }
}

}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    expect_usage_at_worst([&] { check_round_trip(crumple::pipeline::read_recipe(text, "fuzz")); });
    crumple::pipeline::Recipe recipe = crumple::pipeline::default_recipe();
    expect_usage_at_worst([&] {
        crumple::pipeline::apply_setting(recipe, text.substr(0, text.find('\n')));
        check_round_trip(recipe);
    });
    return 0;
}
