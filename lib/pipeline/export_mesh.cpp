// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/export_mesh.h"

#include "bundle/blob.h"
#include "bundle/validate.h"
#include "core/error.h"
#include "geometry/measures.h"
#include "store/export_msh.h"
#include "store/export_obj.h"
#include "store/export_vtu.h"

namespace crumple::pipeline {

namespace {

Bundle bundle_of_work(const TetMesh& mesh, const Asset* asset) {
    Bundle bundle;
    for (const Vec3 p : mesh.positions) bundle.rest_positions.push_back(narrow(p));
    bundle.tets = mesh.tets;
    if (asset) bundle.locked = asset->shell.locked;
    bundle.locked.resize(mesh.positions.size(), 0);
    for (const auto& [a, b, c, d] : mesh.tets) {
        const auto& p = mesh.positions;
        bundle.volume.push_back(static_cast<float>(signed_volume(p[a], p[b], p[c], p[d])));
    }
    bundle.region = mesh.region;
    bundle.region.resize(mesh.tets.size(), 0);
    if (!asset || mesh.region.empty()) {
        bundle.regions = {"tets"};
    } else {
        for (const Component& component : asset->shell.components) bundle.regions.push_back(component.name);
    }
    return bundle;
}

std::string export_shell(const Shell& shell) {
    std::vector<Vec3f> positions;
    for (const Vec3 p : shell.positions) positions.push_back(narrow(p));
    return store::export_surface_obj(positions, shell.locked, shell.triangles);
}

std::string export_blob(const Bundle& bundle) {
    if (!validate(bundle).empty()) throw Error(ErrorKind::bad_input, "the bundle is not valid; see crumple check");
    const std::vector<std::byte> blob = write_blob(bundle);
    return {reinterpret_cast<const char*>(blob.data()), blob.size()};
}

}

Bundle visible_bundle(const Workspace& workspace) {
    if (workspace.bundle) return *workspace.bundle;
    if (workspace.tets) return bundle_of_work(*workspace.tets, workspace.asset ? &*workspace.asset : nullptr);
    throw Error(ErrorKind::usage, "there are no tets yet; run crumple delaunay first, or look at the shell with --obj");
}

std::string export_work(const Workspace& workspace, ExportFormat format) {
    if (format == ExportFormat::blob && !workspace.bundle)
        throw Error(ErrorKind::usage, "there is no bundle yet; run crumple bake first");
    const bool has_tets = workspace.bundle || workspace.tets;
    if (!has_tets && workspace.asset && format == ExportFormat::obj) return export_shell(workspace.asset->shell);
    return export_mesh(visible_bundle(workspace), format);
}

std::string export_mesh(const Bundle& bundle, ExportFormat format) {
    switch (format) {
        case ExportFormat::vtu:
            return store::export_vtu(bundle);
        case ExportFormat::msh:
            return store::export_msh(bundle);
        case ExportFormat::obj:
            return store::export_obj(bundle);
        case ExportFormat::blob:
            return export_blob(bundle);
    }
    return {};
}

}
