// SPDX-License-Identifier: GPL-3.0-or-later
// A COLLADA file as elements that refer to each other by id, for the files of this folder that look into it.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "formats/xml_document.h"

namespace crumple::formats::dae {

struct Document {
    xml::Document elements;
    std::map<std::string_view, Index> by_id;  // the last of an id, as assimp has it
};

[[nodiscard]] Document parse(std::string_view text);

// The element that "#id" refers to, or none.
[[nodiscard]] Index find(const Document& document, std::string_view url);

// An attribute that is a non-negative whole number of 32 bits, or the value given where it is absent. Throws
// Error(bad_input).
[[nodiscard]] std::uint64_t number(const xml::Element& element, std::string_view name, std::uint64_t absent);

// The numbers between an element's tags, all of them read. Throws Error(bad_input) for a word that assimp does not read
// as one.
[[nodiscard]] std::vector<double> reals(const xml::Element& element);
[[nodiscard]] std::vector<Index> indices(const xml::Element& element);

[[noreturn]] void refuse(const xml::Element& element, const std::string& what);

}
