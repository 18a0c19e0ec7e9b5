// SPDX-License-Identifier: MIT
#include "store/boundary.h"

#include <algorithm>

namespace crumple::store {
namespace {

struct Face {
    Triangle sorted;
    Triangle outward;
    std::size_t place;  // 4 tet + corner
};

std::vector<Face> list_faces(const Bundle& bundle) {
    std::vector<Face> faces;
    faces.reserve(4 * bundle.tets.size());
    for (const Tet& tet : bundle.tets) {
        for (const auto& [a, b, c] : tet_face_corners) {
            const Triangle outward{tet[static_cast<std::size_t>(a)], tet[static_cast<std::size_t>(b)],
                                   tet[static_cast<std::size_t>(c)]};
            Triangle sorted = outward;
            std::sort(sorted.begin(), sorted.end());
            faces.push_back({sorted, outward, faces.size()});
        }
    }
    return faces;
}

}

std::vector<Triangle> boundary_faces(const Bundle& bundle) {
    std::vector<Face> faces = list_faces(bundle);
    std::sort(faces.begin(), faces.end(), [](const Face& a, const Face& b) { return a.sorted < b.sorted; });
    std::vector<Face> single;
    for (std::size_t i = 0; i < faces.size();) {
        std::size_t end = i + 1;
        while (end < faces.size() && faces[end].sorted == faces[i].sorted) ++end;
        if (end == i + 1) single.push_back(faces[i]);
        i = end;
    }
    std::sort(single.begin(), single.end(), [](const Face& a, const Face& b) { return a.place < b.place; });
    std::vector<Triangle> boundary;
    for (const Face& face : single) boundary.push_back(face.outward);
    return boundary;
}

}
