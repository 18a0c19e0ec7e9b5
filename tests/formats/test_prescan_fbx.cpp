// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/prescan.h"

#include <fstream>
#include <iterator>
#include <string>

#include "importer/import_checks.h"
#include "importer/temp_folder.h"

namespace crumple::formats {
namespace {

using test::bad_input_of;
using test::contains;
using test::TempFolder;

// A tetrahedron with a colour layer.
struct Tetrahedron {
    std::string unit = "1";
    std::string vertices = "*12 { a: 0,0,0,1,0,0,0,1,0,0,0,1 }";
    std::string polygons = "*12 {\n a: 0,2,-2,0,1,-4,\n1,2,-4,0,3,-3 }";
    std::string mapping = "ByVertice";
    std::string reference = "Direct";
    std::string colors = "*16 {\n a: 1,1,1,1,0,1,1,1,1,1,1,1,1,1,1,1\n}";
    std::string more;  // in the colour layer
    std::string layer = "0";
};

std::string text_of(const Tetrahedron& t) {
    return "; FBX 7.4.0 project file\n"
           "FBXHeaderExtension:  {\n FBXHeaderVersion: 1003\n FBXVersion: 7400\n Creator: \"a \"\n}\n"
           "GlobalSettings:  {\n Version: 1000\n Properties70:  {\n"
           "  P: \"UnitScaleFactor\", \"double\", \"Number\", \"\"," +
           t.unit +
           "\n }\n}\n"
           "Objects:  {\n Geometry: 1000001, \"Geometry::{a;b\", \"Mesh\" {\n  Vertices: " +
           t.vertices + "\n  PolygonVertexIndex: " + t.polygons +
           "\n  LayerElementColor: 0 {\n   Version: 101\n   Name: \"paint\"\n   MappingInformationType: \"" +
           t.mapping + "\"\n   ReferenceInformationType: \"" + t.reference + "\"\n   Colors: " + t.colors + "\n" +
           t.more +
           "  }\n  Layer: 0 {\n   Version: 100\n"
           "   LayerElement:  {\n    Type: \"LayerElementColor\"\n    TypedIndex: " +
           t.layer +
           "\n   }\n  }\n }\n Model: 1000003, \"Model::m\", \"Mesh\" {\n  Version: 232\n }\n}\n"
           "Connections:  {\n C: \"OO\", 1000003, 0\n C: \"OO\", 1000001, 1000003\n}\n";
}

std::string message(const std::string& bytes, Purpose purpose = Purpose::shell) {
    return bad_input_of([&] { (void)prescan_fbx(bytes, purpose); });
}
std::string message(const Tetrahedron& t, Purpose purpose = Purpose::shell) { return message(text_of(t), purpose); }

std::string fixture(const std::string& name) {
    std::ifstream file(std::string(CRUMPLE_FIXTURES) + "/" + name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

// The name of a node begins with the byte of its length, a text value with four.
std::string replaced(std::string bytes, const std::string& after, const std::string& from, const std::string& to) {
    const std::size_t at = bytes.find(from, bytes.find(after));
    if (at == std::string::npos) throw std::logic_error("nothing to change: " + from);
    return bytes.replace(at, from.size(), to);
}

TEST(PrescanFbx, AGoodFileIsReadWithItsLock) {
    EXPECT_EQ(message(Tetrahedron{}), "");
    const TempFolder folder;
    const auto result = test::import_shell(folder.write("a.fbx", text_of({})));
    EXPECT_EQ(result.report.vertices, 4u);
    EXPECT_EQ(result.report.locked, 1u);
}

TEST(PrescanFbx, TextThatIsNoTreeIsRefusedWithItsLine) {
    EXPECT_EQ(message("; nothing\n"), "");
    EXPECT_TRUE(contains(message("hello\n"), "line 1: 'hello' stands where a name and a colon should"));
    EXPECT_TRUE(contains(message("A: {\n B: 1\n"), "line 3: the file ends within 'A', which begins in line 1"));
    EXPECT_TRUE(contains(message("A: 1\n}\n"), "line 2: a brace closes nothing"));
    EXPECT_TRUE(contains(message("A: \"b\n"), "within quotes"));
    std::string deep;
    for (int i = 0; i < 100'000; ++i) deep += "A: {";
    EXPECT_TRUE(contains(message(deep), "deep"));
    const std::string whole = text_of({});
    EXPECT_TRUE(contains(message(whole.substr(0, whole.size() / 2)), "the file ends within"));
}

TEST(PrescanFbx, ColoursThatAreNotReadAreNamed) {
    for (const char* mapping : {"ByVertex", "AllSame", "ByEdge", "Foo", ""}) {
        Tetrahedron t;
        t.mapping = mapping;
        const std::string text = message(t);
        EXPECT_TRUE(contains(text, "the colour layer 'paint'")) << text;
        EXPECT_TRUE(contains(text, "mapped '" + std::string(mapping) + "'")) << text;
        EXPECT_EQ(message(t, Purpose::visual), "");
    }
    Tetrahedron t;
    t.reference = "Index";
    EXPECT_TRUE(contains(message(t), "LayerElementColor is referred to by 'Index'"));
    t = {};
    t.layer = "1";
    EXPECT_TRUE(contains(message(t), "no Layer of the mesh names it"));
    t.colors = "*0 {\n a: \n}";
    EXPECT_EQ(message(t), "");
}

TEST(PrescanFbx, ColoursOfFacesAreCounted) {
    Tetrahedron t;
    t.mapping = "ByPolygon";
    EXPECT_EQ(prescan_fbx(text_of(t), Purpose::shell).unread.colored_faces, 4u);
    const TempFolder folder;
    const auto result = test::import_shell(folder.write("a.fbx", text_of(t)));
    EXPECT_TRUE(test::has(result.report, "COLOR_ON_FACES"));
    EXPECT_EQ(result.report.locked, 0u);
}

TEST(PrescanFbx, ColoursAreAsManyAsTheyMustBe) {
    Tetrahedron t;
    t.colors = "*12 {\n a: 1,1,1,1,0,1,1,1,1,1,1,1\n}";
    EXPECT_TRUE(contains(message(t), "'paint' holds 3 colours mapped ByVertice, where the mesh has 4 vertices"));
    t.mapping = "ByPolygonVertex";
    EXPECT_TRUE(contains(message(t), "3 colours mapped ByPolygonVertex, where the mesh has 12 corners"));
    t.reference = "IndexToDirect";
    t.more = "ColorIndex: *12 {\n a: 0,1,2,0,1,2,0,1,2,0,1,2\n}\n";
    EXPECT_EQ(message(t), "");
    t.more = "ColorIndex: *12 {\n a: 0,1,2,0,1,2,0,1,2,0,1,-1\n}\n";
    EXPECT_TRUE(contains(message(t), "ColorIndex chooses colour -1, where 3 colours are there"));
    t.more = "ColorIndex: *11 {\n a: 0,1,2,0,1,2,0,1,2,0,1\n}\n";
    EXPECT_TRUE(contains(message(t), "holds 11 colours"));
    for (const auto& [colors, words] :
         {std::pair{"*16 {\n a: 1,1,1,1\n}", "announces 16 numbers and holds 4"},
          std::pair{"*4 {\n a: 1,x,1,1\n}", "Colors holds 'x' as number 2"},
          std::pair{"*4 {\n a: 99999999999999999999,1,1,1\n}", "of which the reader makes something else"},
          std::pair{"*5 {\n a: 1,1,1,1,1\n}", "no multiple of 4"}, std::pair{"*y {\n a: 1\n}", "announces '*y'"}}) {
        t.colors = colors;
        EXPECT_TRUE(contains(message(t), words)) << colors;
    }
}

TEST(PrescanFbx, PolygonsEndAndNameVerticesThatAreThere) {
    for (const auto& [polygons, words] :
         {std::pair{"*3 { a: 0,1,-6 }", "PolygonVertexIndex names vertex 5 as number 3, where 4 vertices are there"},
          std::pair{"*3 { a: 99999,1,-3 }", "names vertex 99999 as number 1"},
          std::pair{"*3 { a: 0,1,-2147483648 }", "names vertex 2147483647"},
          std::pair{"*3 { a: 0,1,2 }", "does not end its last polygon"},
          std::pair{"*3 { a: 0,nan,-3 }", "names vertex"}}) {
        Tetrahedron t;
        t.polygons = polygons;
        for (const Purpose purpose : {Purpose::shell, Purpose::visual})
            EXPECT_TRUE(contains(message(t, purpose), words)) << message(t, purpose);
    }
    Tetrahedron t;
    t.vertices = "*11 { a: 0,0,0,1,0,0,0,1,0,0,0 }";
    EXPECT_TRUE(contains(message(t), "Vertices holds 11 numbers, which is no multiple of 3"));
}

TEST(PrescanFbx, TheUnitIsALength) {
    for (const char* unit : {"0", "-1", "nan", "inf", "x", "\"1\""}) {
        Tetrahedron t;
        t.unit = unit;
        EXPECT_TRUE(contains(message(t), "UnitScaleFactor is ")) << unit;
    }
}

TEST(PrescanFbx, BinaryFilesAreLookedAtToo) {
    const std::string name = "blender.byte_corner.fbx";
    const std::string whole = fixture(name);
    ASSERT_FALSE(whole.empty());
    EXPECT_EQ(message(whole), "");
    const std::string layer("\x11LayerElementColor", 18);
    EXPECT_TRUE(contains(message(replaced(whole, layer, "ByPolygonVertex", "ByPolygonVertax")),
                         "the colour layer 'locks' (LayerElementColor) is mapped 'ByPolygonVertax'"));
    EXPECT_TRUE(contains(message(replaced(whole, layer, "IndexToDirect", "IndexToIndex!")), "'IndexToIndex!'"));
    // A number of the array's header: another count than that of the numbers in it.
    std::string shorter = whole;
    const std::size_t count = shorter.find("PolygonVertexIndex") + std::string("PolygonVertexIndexi").size();
    --shorter[count];
    EXPECT_TRUE(contains(message(shorter), "PolygonVertexIndex is no array of the numbers it announces"));
    shorter[count + 3] = 0x7f;
    EXPECT_TRUE(contains(message(shorter), "no array of the numbers it announces"));
}

TEST(PrescanFbx, BinaryFilesCutShortAnywhereAreRefused) {
    const std::string whole = fixture("blender.byte_corner.fbx");
    const std::size_t end = whole.rfind("Takes");
    for (std::size_t size = 30; size < end; size += 97) EXPECT_NE(message(whole.substr(0, size)), "") << size;
}

}
}
