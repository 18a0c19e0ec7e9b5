// SPDX-License-Identifier: GPL-3.0-or-later
// A described struct with a field of every kind, as a stage might declare it.
#pragma once
#include <array>
#include <map>
#include <string>
#include <vector>

#include "core/fields.h"
#include "core/finding.h"
#include "report/described.h"

namespace example {

enum class Method { cpt, odt, lloyd };
inline constexpr crumple::EnumName<Method> method_names[] = {
    {Method::cpt, "cpt"}, {Method::odt, "odt"}, {Method::lloyd, "lloyd"}};
constexpr std::span<const crumple::EnumName<Method>> enum_names(Method) { return method_names; }

struct Box {
    crumple::Vec3 low{-1, -1, -1};
    crumple::Vec3 high{1, 1, 1};
};
template <class Visitor, crumple::FieldsOf<Box> B>
void describe(Visitor& visit, B& b) {
    visit.field("low", b.low, "smallest corner");
    visit.field("high", b.high, crumple::Range{-10, 10}, "largest corner");
}

struct Params {
    Method method = Method::cpt;
    int sweeps = 20;
    std::uint64_t seed = 1;
    std::uint8_t small = 7;
    crumple::Index element = crumple::none;
    double tolerance = 1e-3;
    float share = 0.1f;
    bool is_graded = true;
    std::string name = "body";
    Box box;
    std::vector<Box> sensors;
    std::map<std::string, Method> roles;
    std::map<std::string, Box> boxes;
    std::array<double, 2> pair{1, 2};
    std::vector<crumple::Finding> findings;
};

template <class Visitor, crumple::FieldsOf<Params> P>
void describe(Visitor& visit, P& p) {
    using crumple::Range;
    visit.field("method", p.method, "where a node moves to");
    visit.field("sweeps", p.sweeps, Range{0, 1000}, "passes of moving nodes");
    visit.field("seed", p.seed, "of the random numbers");
    visit.field("small", p.small, "a narrow integer");
    visit.field("element", p.element, "an index");
    visit.field("tolerance", p.tolerance, Range{0, 1}, "when to stop");
    visit.field("share", p.share, Range{0, 1}, "a float");
    visit.field("is_graded", p.is_graded, "a claim");
    visit.field("name", p.name, "some text");
    visit.field("box", p.box, "a struct");
    visit.field("sensors", p.sensors, "a list of structs");
    visit.field("roles", p.roles, "a map of choices");
    visit.field("boxes", p.boxes, "a map of structs");
    visit.field("pair", p.pair, Range{0, 5}, "two numbers");
    visit.field("findings", p.findings, "what a person should know");
}

}
