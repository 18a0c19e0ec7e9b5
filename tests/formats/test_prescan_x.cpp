// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/prescan.h"

#include <string>

#include "importer/import_checks.h"
#include "importer/temp_folder.h"

namespace crumple::formats {
namespace {

using test::bad_input_of;
using test::contains;
using test::TempFolder;

struct Tetrahedron {
    std::string vertices = "4;\n0;0;0;,\n1;0;0;,\n0;1;0;,\n0;0;1;;\n";
    std::string faces = "4;\n3;0,2,1;,\n3;0,1,3;,\n3;1,2,3;,\n3;0,3,2;;\n";
    std::string colors = "4;\n0;1;1;1;1;;,\n1;0;1;1;1;;,\n2;1;1;1;1;;,\n3;1;1;1;1;;;\n";
    std::string end = "}\n}\n";
};

std::string text_of(const Tetrahedron& t) {
    return "xof 0303txt 0032\n# a comment {\n// another {\n"
           "template MeshVertexColors {\n <1630B821-7842-11cf-8F52-0040333594A3>\n DWORD n;\n}\n"
           "Mesh \"a{\" {\n" +
           t.vertices + t.faces + "MeshVertexColors {\n" + t.colors + t.end;
}

std::string message(const Tetrahedron& t, Purpose purpose = Purpose::shell) {
    return bad_input_of([&] { (void)prescan_x(text_of(t), purpose); });
}

TEST(PrescanX, AGoodFileIsReadWithItsLock) {
    EXPECT_EQ(message({}), "");
    std::string text = text_of({});
    text.replace(text.find("\"a{\""), 4, "a");
    const TempFolder folder;
    const auto result = test::import_shell(folder.write("a.x", text));
    EXPECT_EQ(result.report.vertices, 4u);
    EXPECT_EQ(result.asset.locked_positions, (std::vector<Vec3>{{1, 0, 0}}));
}

TEST(PrescanX, EachVertexHasOneColour) {
    const auto colors = [](const std::string& text, Purpose purpose = Purpose::shell) {
        Tetrahedron t;
        t.colors = text;
        return message(t, purpose);
    };
    const std::string twice = "4;\n0;1;1;1;1;;,\n0;0;1;1;1;;,\n2;1;1;1;1;;,\n3;1;1;1;1;;;\n";
    EXPECT_TRUE(contains(colors(twice), "line 22: MeshVertexColors gives vertex 0 a second colour"));
    EXPECT_EQ(colors(twice, Purpose::visual), "");
    EXPECT_TRUE(contains(colors("4;\n9;1;1;1;1;;\n"), "names vertex 9 of 4"));
    EXPECT_TRUE(contains(colors("4;\n-1;1;1;1;1;;\n"), "'-1' stands where the index"));
    EXPECT_TRUE(contains(colors("4000000000;\n0;1;1;1;1;;\n"), "announces 4000000000 colours for 4 vertices"));
    EXPECT_TRUE(contains(colors("4;\n0;1;1;1;1;;\n"), "'}' stands where"));
    EXPECT_TRUE(contains(colors("4;\n0;1;1;\n"), "a number is missing"));
    EXPECT_TRUE(contains(colors("4;\n0;-1.#IND00;1;1;1;;\n"), "'-1.#IND00' stands where a number"));
    EXPECT_TRUE(contains(colors("4;\n0;99999999999999999999;1;1;1;;\n"), "makes something else of '9999"));
}

TEST(PrescanX, MeshesHoldWhatTheyAnnounce) {
    Tetrahedron t;
    t.faces = "1;\n3;0,2,4;;\n";
    EXPECT_TRUE(contains(message(t), "a face names vertex 4 of 4"));
    t.faces = "5;\n3;0,2,1;;\n";
    EXPECT_TRUE(contains(message(t), "'MeshVertexColors' stands where a face's number of corners should"));
    t = {};
    t.vertices = "5;\n0;0;0;,\n1;0;0;,\n0;1;0;,\n0;0;1;;\n";
    EXPECT_NE(message(t), "");
    t = {};
    t.end = "}\n";
    EXPECT_TRUE(contains(message(t), "the file ends within what begins in line 8"));
    t.end = "}\n}\n}\n";
    EXPECT_TRUE(contains(message(t), "a brace closes nothing"));
}

TEST(PrescanX, NamesMayBeTypesElsewhere) {
    const std::string header = "xof 0303txt 0032\n";
    const std::string mesh = text_of({}).substr(text_of({}).find("Mesh \"a{\""));
    const auto message_of = [&](const std::string& body) {
        return bad_input_of([&] { (void)prescan_x(header + body, Purpose::shell); });
    };
    EXPECT_EQ(message_of("Frame Mesh {\nFrame MeshVertexColors { }\n{ Mesh }\n" + mesh + "}\n"), "");
    std::string damaged = mesh;
    damaged.replace(damaged.find("0,2,1"), 5, "0,2,4");
    EXPECT_TRUE(contains(message_of("Frame Mesh {\n" + damaged + "}\n"), "a face names vertex 4 of 4"));
    EXPECT_TRUE(contains(message_of("Frame a { Mesh Frame {\n1;\n}\n}\n"), "a number is missing"));
    EXPECT_EQ(message_of("Frame a { SomeData { 1; Mesh; }\n}\n"), "");
}

TEST(PrescanX, CutShortAnywhereIsRefused) {
    const std::string whole = text_of({});
    for (std::size_t size = whole.find("Mesh \"a{\"") + 12; size + 3 < whole.size(); size += 5)
        EXPECT_NE(bad_input_of([&] { (void)prescan_x(whole.substr(0, size), Purpose::shell); }), "") << size;
}

TEST(PrescanX, WhatIsNotTextIsLeftToTheReader) {
    EXPECT_EQ(bad_input_of([&] { (void)prescan_x("xof 0303bin 0032}}}}", Purpose::shell); }), "");
    EXPECT_EQ(bad_input_of([&] { (void)prescan_x("hello", Purpose::shell); }), "");
}

}
}
