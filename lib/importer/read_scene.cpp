// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/read_scene.h"

#include <assimp/commonMetaData.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <new>

#include "core/error.h"
#include "formats/disguise.h"
#include "formats/prescan.h"
#include "formats/printable.h"
#include "importer/file_space.h"
#include "importer/input_files.h"
#include "importer/memory_files.h"
#include "importer/restore.h"
#include "importer/source_file.h"

namespace crumple::importer {

namespace {

[[noreturn]] void refuse(const std::string& what) { throw Error(ErrorKind::bad_input, what); }

constexpr const char* no_faces = "it has no faces; a surface is needed";

bool counts_triangles(formats::FormatId format) {
    return format == formats::FormatId::obj || format == formats::FormatId::ply || format == formats::FormatId::off ||
           format == formats::FormatId::gltf;
}

// Formats are empty in many words.
bool tells_of_nothing(const std::string& text) {
    for (const char* words : {"file is too small", "mNumMeshes is 0", "contains no faces", "has no faces",
                              "contains no vertices", "no valid vertices", "no valid faces", "There are no facets",
                              "Unable to extract mesh data", "No root node"}) {
        if (text.find(words) != std::string::npos) return true;
    }
    return false;
}

// assimp's own words, without the path some of them carry.
std::string reason(const Assimp::Importer& importer, const std::string& path) {
    std::string text = importer.GetErrorString();
    if (text.find("bad_alloc") != std::string::npos) throw std::bad_alloc();
    if (tells_of_nothing(text)) return no_faces;
    if (text.find("but the limit is 32767") != std::string::npos)
        return "a face has more than 32767 corners; split it, or triangulate before exporting";
    for (std::size_t at = text.find(path); at != std::string::npos; at = text.find(path))
        text.replace(at, path.size(), "the file");
    return "it cannot be read: it is damaged, cut short, or of a version that is not known; export it again, or in "
           "another format" +
           (text.empty() ? "" : " (the reader says: " + text + ")");
}

std::string generator_of(const aiScene& scene) {
    aiString generator;
    return scene.mMetaData && scene.mMetaData->Get(AI_METADATA_SOURCE_GENERATOR, generator) ? generator.C_Str() : "";
}

void check_importer(const aiScene& scene, const formats::Format& format) {
    aiString used;
    const bool says = scene.mMetaData && scene.mMetaData->Get(AI_METADATA_SOURCE_FORMAT, used);
    if (!says || std::string_view(used.C_Str()) == format.assimp_name) return;
    refuse("the content is no " + std::string(format.name) + ": it was recognized as " + used.C_Str());
}

// The bytes of a file and of those that belong to it, found good.
struct Source {
    std::string bytes;
    formats::Prescan scan;
    std::vector<std::string> buffers;  // as scan.buffers
};

std::string read_buffer(const std::string& path, const formats::ExternalBuffer& buffer) {
    std::string bytes;
    const std::string name = "its buffer " + formats::in_quotes(buffer.uri);
    const std::string where = path_of_uri(path, buffer.uri);
    try {
        bytes = read_file(where);
    } catch (const Error& error) {
        refuse(name + " " + error.what() + "; keep the files together, or export .glb");
    }
    if (bytes.size() < buffer.size) {
        refuse(name + " has " + std::to_string(bytes.size()) + " bytes where the file announces " +
               std::to_string(buffer.size) + "; it is damaged, cut short or of another export");
    }
    return bytes;
}

Source look_at(const std::string& path, const formats::Format& format, formats::Purpose purpose) {
    Source source;
    source.bytes = read_file(path);
    if (source.bytes.empty()) refuse("the file is empty");
    formats::undisguise(source.bytes, format.id);
    source.scan = formats::prescan(source.bytes, format.id, purpose);
    // A visual mesh of glTF may be points: they move with the shell too.
    const bool needs_faces = purpose == formats::Purpose::shell || format.id != formats::FormatId::gltf;
    if (needs_faces && counts_triangles(format.id) && source.scan.expected_triangles == 0) refuse(no_faces);
    for (const formats::ExternalBuffer& buffer : source.scan.buffers)
        source.buffers.push_back(read_buffer(path, buffer));
    return source;
}

// assimp takes a file's name for what it is: a binary glTF by the name of .gltf it would not read.
std::string name_for_assimp(const std::string& path, const formats::Format& format, std::string_view bytes) {
    if (format.id != formats::FormatId::gltf) return path;
    return bytes.starts_with("glTF") ? "scene.glb" : "scene.gltf";
}

// assimp leaves out triangles of vertices that are not there, and a glTF file has no other that it does not deliver.
void check_triangles(std::uint64_t lost, std::uint64_t expected) {
    if (lost == 0) return;
    refuse(std::to_string(lost) + " of its " + std::to_string(expected) +
           " triangles refer to vertices that are not there; the file is damaged, export it again");
}

[[noreturn]] void refuse_unread(const std::string& why, const Source& source, const formats::Format& format) {
    const std::uint64_t expected = source.scan.expected_triangles;
    if (why == no_faces && format.id == formats::FormatId::gltf) check_triangles(expected, expected);
    refuse(why);
}

// The importer is never destroyed: some destructors crash after a good load, and this process ends anyway.
// JoinIdenticalVertices would lose locks (it ignores colours), SortByPType would reorder vertices.
const aiScene& read_with_assimp(const std::string& path, const Source& source, const formats::Format& format) {
    auto* files = new MemoryFiles;
    const std::string& bytes = source.scan.surface_only.empty() ? source.bytes : source.scan.surface_only;
    const std::string name = name_for_assimp(path, format, bytes);
    files->add(name, bytes);
    for (std::size_t i = 0; i < source.buffers.size(); ++i) files->add(source.scan.buffers[i].name, source.buffers[i]);
    auto* importer = new Assimp::Importer;
    importer->SetIOHandler(files);
    const aiScene* scene = importer->ReadFile(name, aiProcess_Triangulate | aiProcess_ValidateDataStructure);
    if (!scene) refuse_unread(reason(*importer, name), source, format);
    check_importer(*scene, format);
    if ((scene->mFlags & AI_SCENE_FLAGS_INCOMPLETE) || !scene->mRootNode || scene->mNumMeshes == 0) {
        refuse(
            "the reader found no mesh in it; export what is selected or visible as polygons, or in another format (a "
            "damaged mesh is left out too)");
    }
    return *scene;
}

void copy_faces(const aiMesh& from, SceneMesh& to) {
    to.triangles.reserve(from.mNumFaces);
    for (unsigned f = 0; f < from.mNumFaces; ++f) {
        const aiFace& face = from.mFaces[f];
        if (face.mNumIndices == 3) {
            to.triangles.push_back({face.mIndices[0], face.mIndices[1], face.mIndices[2]});
        } else if (face.mNumIndices < 3) {
            ++to.points_and_lines;
        } else {
            ++to.unreadable_polygons;
        }
    }
}

std::vector<std::vector<Color>> copy_colors(const aiMesh& mesh) {
    std::vector<std::vector<Color>> sets(mesh.GetNumColorChannels());
    for (unsigned set = 0; set < sets.size(); ++set) {
        sets[set].resize(mesh.mNumVertices);
        for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
            const aiColor4D& c = mesh.mColors[set][v];
            sets[set][v] = {c.r, c.g, c.b, c.a};
        }
    }
    return sets;
}

SceneMesh copy_mesh(const aiScene& scene, const aiMesh& from, formats::Purpose purpose) {
    SceneMesh mesh;
    mesh.name = from.mName.C_Str();
    if (from.mMaterialIndex < scene.mNumMaterials)
        mesh.material = scene.mMaterials[from.mMaterialIndex]->GetName().C_Str();
    mesh.positions.resize(from.mNumVertices);
    for (unsigned v = 0; v < from.mNumVertices; ++v) {
        const aiVector3D& p = from.mVertices[v];
        mesh.positions[v] = {p.x, p.y, p.z};
    }
    copy_faces(from, mesh);
    if (purpose == formats::Purpose::shell) mesh.colors = copy_colors(from);
    return mesh;
}

// Some programs hide a colour a face in STL's spare bits, and a default one in its header: nobody's paint.
void forget_colors(Scene& scene) {
    for (SceneMesh& mesh : scene.meshes) mesh.colors.clear();
}

formats::Affine copy_transform(const aiMatrix4x4& m, const char* node) {
    if (m.d1 != 0 || m.d2 != 0 || m.d3 != 0 || m.d4 != 1)
        refuse(std::string("the transform of node '") + node + "' is not affine");
    return {m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4};
}

// Parents before children, children in file order. A list instead of recursion: the file decides how deep it goes.
void copy_nodes(const aiNode& root, std::vector<SceneNode>& nodes) {
    struct Pending {
        const aiNode* node;
        Index parent;
    };
    std::vector<Pending> pending{{&root, none}};
    while (!pending.empty()) {
        const Pending next = pending.back();
        pending.pop_back();
        SceneNode node;
        node.name = next.node->mName.C_Str();
        node.parent = next.parent;
        node.transform = copy_transform(next.node->mTransformation, next.node->mName.C_Str());
        node.meshes.assign(next.node->mMeshes, next.node->mMeshes + next.node->mNumMeshes);
        const auto index = static_cast<Index>(nodes.size());
        nodes.push_back(std::move(node));
        for (unsigned i = next.node->mNumChildren; i-- > 0;) pending.push_back({next.node->mChildren[i], index});
    }
}

}

Scene read_scene(const std::string& path, const formats::Format& format, formats::Purpose purpose) {
    Source source = look_at(path, format, purpose);
    const aiScene& from = read_with_assimp(path, source, format);

    Scene scene;
    scene.generator = generator_of(from);
    scene.expected_triangles = source.scan.expected_triangles;
    scene.unread = source.scan.unread;
    scene.extensions = source.scan.extensions;
    for (unsigned m = 0; m < from.mNumMeshes; ++m) scene.meshes.push_back(copy_mesh(from, *from.mMeshes[m], purpose));
    copy_nodes(*from.mRootNode, scene.nodes);
    if (format.id == formats::FormatId::gltf) check_triangles(scene.lost_triangles(), scene.expected_triangles);
    if (format.id == formats::FormatId::stl) forget_colors(scene);
    read_file_space(from, format.id, scene);
    restore(std::move(source.scan), scene);
    return scene;
}

void look_at_bytes(const std::string& path, const formats::Format& format, formats::Purpose purpose) {
    (void)look_at(path, format, purpose);
}

}
