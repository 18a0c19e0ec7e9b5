// SPDX-License-Identifier: MIT
#include "core/fields.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/index.h"

namespace crumple::fields_test {

enum class Colour { red, green };
inline constexpr EnumName<Colour> colour_names[] = {{Colour::red, "red"}, {Colour::green, "green"}};
constexpr std::span<const EnumName<Colour>> enum_names(Colour) { return colour_names; }
enum class Unnamed { one };

struct Params {
    int count = 3;
    Colour colour = Colour::green;
};

template <class Visitor, FieldsOf<Params> P>
void describe(Visitor& visit, P& p) {
    visit.field("count", p.count, Range{0, 10}, "how many");
    visit.field("colour", p.colour, "which");
}

namespace {

struct Lister {
    std::vector<std::string> lines;
    void field(std::string_view name, const int& value, Range range, std::string_view) {
        lines.push_back(std::string(name) + "=" + std::to_string(value) +
                        "<=" + std::to_string(static_cast<int>(range.max)));
    }
    template <NamedEnum E>
    void field(std::string_view name, const E& value, std::string_view) {
        lines.push_back(std::string(name) + "=" + std::string(name_of(value)));
    }
};

struct Setter {
    void field(std::string_view, int& value, Range, std::string_view) { value = 7; }
    void field(std::string_view, Colour& value, std::string_view) { value = Colour::red; }
};

TEST(Fields, OneDeclarationServesReadersOfConstAndWriters) {
    Params params;
    Setter setter;
    describe(setter, params);
    EXPECT_EQ(params.count, 7);
    const Params& fixed = params;
    Lister lister;
    describe(lister, fixed);
    EXPECT_EQ(lister.lines, (std::vector<std::string>{"count=7<=10", "colour=red"}));
}

TEST(Fields, EnumsAreNamedByTheirTable) {
    EXPECT_EQ(name_of(Colour::green), "green");
    EXPECT_EQ(name_of(static_cast<Colour>(99)), "?");
    static_assert(NamedEnum<Colour>);
    static_assert(!NamedEnum<Unnamed>);
    static_assert(!NamedEnum<int>);
}

TEST(Fields, ARangeIsUnboundedByDefault) {
    EXPECT_LT(Range{}.min, -1e308);
    EXPECT_GT(Range{}.max, 1e308);
}

TEST(Index, FacesOfATetLookOutward) {
    // Corners of the tet (origin, x, y, z): the face opposite a corner must not see it.
    const int at[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int corner = 0; corner < 4; ++corner) {
        const int* a = at[tet_face_corners[corner][0]];
        const int* b = at[tet_face_corners[corner][1]];
        const int* c = at[tet_face_corners[corner][2]];
        const int* d = at[corner];
        const auto minor = [&](int i, int j) { return (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]); };
        const int side = (d[0] - a[0]) * minor(1, 2) + (d[1] - a[1]) * minor(2, 0) + (d[2] - a[2]) * minor(0, 1);
        EXPECT_LT(side, 0) << corner;
    }
}

TEST(Index, OppositeEdgesOfATetAddUpToFive) {
    for (int edge = 0; edge < 6; ++edge) {
        const int* here = tet_edge_corners[edge];
        const int* there = tet_edge_corners[5 - edge];
        EXPECT_EQ((1 << here[0]) | (1 << here[1]) | (1 << there[0]) | (1 << there[1]), 15);
    }
}

}

}
