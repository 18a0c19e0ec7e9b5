// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/prescan.h"

#include <string>
#include <utility>

#include "importer/import_checks.h"
#include "importer/temp_folder.h"

namespace crumple::formats {
namespace {

using test::bad_input_of;
using test::contains;
using test::TempFolder;

struct Part {
    std::string from, to;
};

// A painted tetrahedron, vertex 1 locked, with one part of the text changed; what is changed must be there.
std::string tetrahedron(const Part& part = {}) {
    std::string text =
        "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<!-- a comment <p> -->\n"
        "<COLLADA version=\"1.4.1\"><asset><unit name=\"m\" meter=\"1\"/><up_axis>Y_UP</up_axis></asset>\n"
        "<library_geometries><geometry id=\"g\"><mesh>\n"
        "<source id=\"p\"><float_array id=\"pa\" count=\"12\">0 0 0 1 0 0 0 1 0 0 0 1</float_array>"
        "<technique_common><accessor source=\"#pa\" count=\"4\" stride=\"3\"><param name=\"X\" type=\"float\"/>"
        "<param name=\"Y\" type=\"float\"/><param name=\"Z\" type=\"float\"/></accessor></technique_common></source>\n"
        "<source id=\"c\"><float_array id=\"ca\" count=\"16\">1 1 1 1 0 1 1 1 1 1 1 1 1 1 1 1</float_array>"
        "<technique_common><accessor source=\"#ca\" count=\"4\" stride=\"4\"><param name=\"R\" type=\"float\"/>"
        "<param name=\"G\" type=\"float\"/><param name=\"B\" type=\"float\"/><param name=\"A\" type=\"float\"/>"
        "</accessor></technique_common></source>\n"
        "<vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices>\n"
        "<triangles count=\"4\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/>"
        "<input semantic=\"COLOR\" source=\"#c\" offset=\"1\"/>\n"
        "<p>0 0 2 2 1 1  0 0 1 1 3 3  1 1 2 2 3 3  0 0 3 3 2 2</p></triangles>\n"
        "</mesh></geometry></library_geometries>\n"
        "<library_visual_scenes><visual_scene id=\"s\"><node id=\"n\"><instance_geometry url=\"#g\"/></node>"
        "</visual_scene></library_visual_scenes><scene><instance_visual_scene url=\"#s\"/></scene></COLLADA>\n";
    const std::size_t at = text.find(part.from);
    if (at == std::string::npos) throw std::logic_error("nothing to change: " + part.from);
    return text.replace(at, part.from.size(), part.to);
}

std::string message(const std::string& text, Purpose purpose = Purpose::shell) {
    return bad_input_of([&] { (void)prescan_dae(text, purpose); });
}

TEST(PrescanDae, AGoodFileIsReadWithItsLock) {
    EXPECT_EQ(message(tetrahedron()), "");
    const TempFolder folder;
    const auto result = test::import_shell(folder.write("a.dae", tetrahedron()));
    EXPECT_EQ(result.report.vertices, 4u);
    EXPECT_EQ(result.asset.locked_positions, (std::vector<Vec3>{{1, 0, 0}}));
}

TEST(PrescanDae, WhatIsNoXmlIsRefusedWithItsLine) {
    for (const char* text : {"", "hello", "<!-- only -->", "<?xml?>"}) EXPECT_NE(message(text), "") << text;
    for (const char* text :
         {"<a>\n<b></a>", "<a>\n<b>", "<a\nb></a>", "<a\nb=c></a>", "<a\nb=\"c></a>", "<a>\n<!-- <</a>"})
        EXPECT_TRUE(contains(message(text), "line 2: the XML is damaged")) << message(text);
    EXPECT_TRUE(contains(message("<a/>\n<b/>"), "line 2: a second root"));
    std::string deep;
    for (int i = 0; i < 100'000; ++i) deep += "<a>";
    EXPECT_TRUE(contains(message(deep), "cut short"));
    for (int i = 0; i < 100'000; ++i) deep += "</a>";
    EXPECT_TRUE(contains(message(deep), "deep"));
    EXPECT_EQ(message("<!DOCTYPE a [<!ENTITY b \"]>\">]><a c='>'><![CDATA[<x>]]><?d >?></a >"), "");
}

TEST(PrescanDae, ArraysHoldWhatTheyAnnounce) {
    const std::string array = "<float_array id=\"ca\" count=\"16\">1 1";
    const auto change = [&](const std::string& to) { return message(tetrahedron({array, to})); };
    EXPECT_TRUE(contains(change("<float_array id=\"ca\" count=\"16\">1 1 1"),
                         "line 6: <float_array> 'ca' announces 16 numbers and holds 17"));
    EXPECT_TRUE(contains(change("<float_array id=\"ca\" count=\"16\">1"), "holds 15"));
    EXPECT_TRUE(contains(change("<float_array id=\"ca\">1 1"), "announces 0"));
    EXPECT_TRUE(contains(change("<float_array id=\"ca\" count=\"-1\">1 1"), "no size"));
    EXPECT_TRUE(contains(change("<float_array id=\"ca\" count=\"18446744073709551615\">1 1"), "no size"));
    EXPECT_TRUE(contains(change("<float_array id=\"ca\" count=\"16\">x 1"), "holds 'x' as number 1"));
    EXPECT_TRUE(contains(change("<float_array id=\"ca\" count=\"16\">&a; 1"), "holds '&a;'"));
    EXPECT_EQ(change("<float_array id=\"ca\" count=\"16\">nan 1,5"), "");
    EXPECT_EQ(change("<float_array id=\"ca\" count=\"16\">-1e-50 +1.00000000000000000000001e3"), "");
    EXPECT_TRUE(contains(change("<float_array id=\"ca\" count=\"16\">99999999999999999999 1"), "makes something else"));
    EXPECT_EQ(message(tetrahedron({array, "<float_array id=\"ca\" count=\"16\">1"}), Purpose::visual), "");
}

TEST(PrescanDae, AccessorsStayWithinTheirArrays) {
    const auto change = [&](const std::string& to) {
        return message(tetrahedron({"source=\"#ca\" count=\"4\" stride=\"4\"", to}));
    };
    EXPECT_TRUE(contains(change("source=\"#ca\" count=\"4\" offset=\"1\" stride=\"4\""), "beyond its array of 16"));
    EXPECT_TRUE(contains(change("source=\"#ca\" count=\"5\" stride=\"4\""), "beyond its array"));
    EXPECT_TRUE(contains(change("source=\"#ca\" count=\"4000000000\" stride=\"4000000000\""), "beyond its array"));
    EXPECT_TRUE(contains(change("source=\"#ca\" count=\"4\" stride=\"3\""), "a stride of 3 under 4 parameters"));
    EXPECT_TRUE(contains(change("source=\"#ca\" count=\"4\" stride=\"0\""), "a stride of 0"));
    EXPECT_TRUE(contains(change("source=\"#ca\" count=\"4\""), "a stride of 1"));
    EXPECT_TRUE(contains(change("source=\"#x\" count=\"4\" stride=\"4\""), "'#x', which is no <float_array>"));
    EXPECT_TRUE(contains(message(tetrahedron({"source=\"#c\"", "source=\"#v\""})), "'#v', which is no <source>"));
}

TEST(PrescanDae, IndicesAreWholeNumbersOfWhatIsThere) {
    const auto change = [&](const std::string& index) {
        return message(tetrahedron({"<p>0 0 2 2", "<p>0 0 " + index + " 2"}));
    };
    for (const char* word : {"x", "-1", "1.5", "inf", "1e38", "&lol;", "0x1", "99999999999"})
        EXPECT_TRUE(contains(change(word), "line 9: <p> holds '" + std::string(word) + "' as number 3")) << word;
    for (const char* word : {"4", "4294967295"})
        EXPECT_TRUE(contains(change(word), "holds " + std::string(word) + " as number 3, where 4 elements")) << word;
    EXPECT_TRUE(contains(change(""), "holds 23 indices, 2 a corner, where <triangles> announces 12 corners"));
    EXPECT_TRUE(contains(message(tetrahedron({"<triangles count=\"4\">", "<triangles count=\"0\">"})), "0 corners"));
    EXPECT_TRUE(contains(message(tetrahedron({"offset=\"1\"", "offset=\"4000000000\""})), "offset of more than"));
}

TEST(PrescanDae, PolygonsHaveAsManyCornersAsTheirListSays) {
    const auto polygons = [](const std::string& counts) {
        std::string text =
            tetrahedron({"<triangles count=\"4\">", "<polylist count=\"4\"><vcount>" + counts + "</vcount>"});
        return text.replace(text.find("</triangles>"), 12, "</polylist>");
    };
    EXPECT_EQ(message(polygons("3 3 3 3")), "");
    EXPECT_TRUE(contains(message(polygons("3 3 3")), "announces 4 polygons, and its <vcount> holds 3"));
    EXPECT_TRUE(contains(message(polygons("3 3 3 4")), "announces 13 corners"));
    EXPECT_TRUE(contains(message(polygons("3 3 3 x")), "<vcount> holds 'x'"));
    std::string free = tetrahedron({"<triangles count=\"4\">", "<polygons count=\"1\">"});
    free.replace(free.find("</triangles>"), 12, "</polygons>");
    EXPECT_EQ(message(free), "");
    EXPECT_TRUE(contains(message(free.replace(free.find("<p>0"), 4, "<p>")), "whole corners"));
}

TEST(PrescanDae, TransformsAndUnitAreFinite) {
    const auto node = [](const std::string& transform) {
        return message(tetrahedron({"<node id=\"n\">", "<node id=\"n\">" + transform}));
    };
    EXPECT_EQ(node("<scale>1 2 3</scale><matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</matrix>"), "");
    EXPECT_TRUE(contains(node("<translate>1 2</translate>"), "<translate> holds 2 numbers, not 3"));
    EXPECT_TRUE(contains(node("<scale>1 nan 3</scale>"), "not finite"));
    EXPECT_TRUE(contains(node("<rotate>1 0 0 x</rotate>"), "holds 'x'"));
    for (const char* meter : {"0", "-1", "nan", "inf", "0,01", "", "1 2", "m"})
        EXPECT_TRUE(contains(message(tetrahedron({"meter=\"1\"", "meter=\"" + std::string(meter) + "\""})), "<unit>"))
            << meter;
    EXPECT_EQ(message(tetrahedron({" meter=\"1\"", ""})), "");
}

// Ten nodes each ten times in the next: 10^levels instances of a few hundred bytes.
std::string laughing(int levels) {
    std::string nodes = "<library_nodes><node id=\"L0\"><instance_geometry url=\"#g\"/></node>";
    for (int level = 1; level <= levels; ++level) {
        nodes += "<node id=\"L" + std::to_string(level) + "\">";
        for (int i = 0; i < 10; ++i) nodes += "<instance_node url=\"#L" + std::to_string(level - 1) + "\"/>";
        nodes += "</node>";
    }
    std::string text = tetrahedron({"<library_visual_scenes>", nodes + "</library_nodes><library_visual_scenes>"});
    const std::string drawn = "<instance_geometry url=\"#g\"/>";
    return text.replace(text.rfind(drawn), drawn.size(), "<instance_node url=\"#L" + std::to_string(levels) + "\"/>");
}

TEST(PrescanDae, InstancesAreCountedBeforeTheyAreMade) {
    EXPECT_EQ(message(laughing(3)), "");
    EXPECT_TRUE(contains(message(laughing(8)), "come to more than 1000000 nodes"));
    EXPECT_TRUE(contains(message(laughing(1000)), "come to more than"));
    EXPECT_TRUE(contains(message(tetrahedron({"<instance_geometry url=\"#g\"/>", "<instance_node url=\"#n\"/>"})),
                         "<node> 'n' is drawn within itself"));
    // assimp finds a node by its name too.
    EXPECT_TRUE(contains(message(tetrahedron({"<node id=\"n\"><instance_geometry url=\"#g\"/>",
                                              "<node name=\"n\"><instance_node url=\"#n\"/>"})),
                         "within itself"));
}

}
}
