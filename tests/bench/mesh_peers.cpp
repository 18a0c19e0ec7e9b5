// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/mesh_peers.h"

#include <sys/resource.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "bench/tetgen_files.h"
#include "core/error.h"
#include "geometry/measures.h"
#include "mesh/neighbours.h"

namespace crumple::bench {
namespace {

double child_cpu_seconds() {
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double mean_edge(const RawShell& shell) {
    std::set<Edge> edges;
    for (const Triangle& t : shell.triangles) {
        for (int i = 0; i < 3; ++i) edges.insert({std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])});
    }
    double sum = 0;
    for (const Edge& e : edges) sum += length(shell.positions[e[1]] - shell.positions[e[0]]);
    return edges.empty() ? 0 : sum / static_cast<double>(edges.size());
}

std::string text(Vec3 p) {
    char line[96];
    std::snprintf(line, sizeof line, "%.17g %.17g %.17g", p.x, p.y, p.z);
    return line;
}

void write_smesh(const RawShell& shell, const std::filesystem::path& path) {
    std::ofstream file(path);
    file << shell.positions.size() << " 3 0 0\n";
    for (std::size_t v = 0; v < shell.positions.size(); ++v) file << v << ' ' << text(shell.positions[v]) << '\n';
    file << shell.triangles.size() << " 0\n";
    for (const auto& [a, b, c] : shell.triangles) file << "3 " << a << ' ' << b << ' ' << c << '\n';
    file << "0\n0\n";
}

void write_stl(const RawShell& shell, const std::filesystem::path& path) {
    std::ofstream file(path);
    file << "solid shell\n";
    for (const Triangle& triangle : shell.triangles) {
        file << "facet normal 0 0 0\nouter loop\n";
        for (const Index v : triangle) file << "vertex " << text(shell.positions[v]) << '\n';
        file << "endloop\nendfacet\n";
    }
    file << "endsolid shell\n";
}

void write_geo(double size, const std::filesystem::path& path) {
    std::ofstream file(path);
    file.precision(17);
    file << "Merge \"shell.stl\";\nSurface Loop(1) = {1};\nVolume(1) = {1};\nMesh.MeshSizeMax = " << size
         << ";\nMesh.MeshSizeExtendFromBoundary = 1;\n";
}

// The tets of a gmsh file, format 2.2.
TetMesh read_msh(const std::filesystem::path& path) {
    TetMesh mesh;
    std::map<long, Index> index_of;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        std::size_t count = 0;
        if (line == "$Nodes") {
            file >> count;
            for (std::size_t i = 0; file && i < count; ++i) {
                long number = 0;
                Vec3 p;
                file >> number >> p.x >> p.y >> p.z;
                index_of[number] = static_cast<Index>(mesh.positions.size());
                mesh.positions.push_back(p);
            }
        } else if (line == "$Elements") {
            file >> count;
            std::getline(file, line);
            for (std::size_t i = 0; i < count && std::getline(file, line); ++i) {
                std::istringstream words(line);
                long number = 0, type = 0, tags = 0;
                words >> number >> type >> tags;
                constexpr long tet_type = 4;
                if (type != tet_type) continue;
                for (long tag = 0; tag < tags; ++tag) words >> number;
                Tet tet{};
                for (Index& v : tet) {
                    words >> number;
                    v = index_of.at(number);
                }
                mesh.tets.push_back(tet);
            }
        }
    }
    return mesh;
}

bool make_usable(TetMesh& mesh) {
    for (Tet& tet : mesh.tets) {
        for (const Index v : tet) {
            if (v >= mesh.positions.size()) return false;
        }
        const auto& [a, b, c, d] = tet;
        const double volume = signed_volume(mesh.positions[a], mesh.positions[b], mesh.positions[c], mesh.positions[d]);
        if (volume < 0) std::swap(tet[0], tet[1]);
    }
    try {
        mesh.neighbours = neighbours_of(mesh.tets);
    } catch (const Error&) {
        return false;  // three tets on one face
    }
    return !mesh.tets.empty();
}

}

RawShell read_raw_shell(const std::filesystem::path& path) {
    RawShell shell;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string kind;
        words >> kind;
        if (kind == "v") {
            Vec3 p;
            words >> p.x >> p.y >> p.z;
            shell.positions.push_back(p);
        } else if (kind == "f") {
            Triangle triangle{};
            for (Index& v : triangle) {
                words >> kind;  // "7", "7/3" or "7/3/1", from 1
                v = static_cast<Index>(std::stoul(kind)) - 1;
            }
            shell.triangles.push_back(triangle);
        }
    }
    return shell;
}

std::optional<PeerMesh> run_peer(const std::string& peer, const RawShell& shell, const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    const double size = mean_edge(shell);
    std::string command;
    if (peer == "tetgen") {
        write_smesh(shell, folder / "shell.smesh");
        command = "tetgen -pYq1.4CVO2/7 shell.smesh";
    } else {
        write_stl(shell, folder / "shell.stl");
        write_geo(size, folder / "shell.geo");
        command = "gmsh -3 shell.geo -algo ";
        command += peer == "hxt" ? "hxt -optimize_netgen" : "del3d";
        command += " -format msh22 -o out.msh";
    }
    const double before = child_cpu_seconds();
    const std::string quoted = "'" + folder.string() + "'";
    const int status = std::system(("cd " + quoted + " && timeout 600 " + command + " >" + peer + ".log 2>&1").c_str());
    if (status != 0) return std::nullopt;
    PeerMesh result;
    result.cpu_s = child_cpu_seconds() - before;
    result.mesh = peer == "tetgen" ? read_tetgen(folder, "shell", 0) : read_msh(folder / "out.msh");
    if (!make_usable(result.mesh)) return std::nullopt;
    return result;
}

}
