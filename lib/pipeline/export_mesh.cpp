// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/export_mesh.h"

#include "core/error.h"
#include "store/export_msh.h"
#include "store/export_obj.h"
#include "store/export_vtu.h"

namespace crumple::pipeline {

namespace {

Bundle bundle_of_work(const TetMesh& mesh, const Asset* asset) {
    Bundle bundle;
    for (const Vec3 p : mesh.positions) {
        bundle.rest_positions.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
    }
    bundle.tets = mesh.tets;
    bundle.mass.resize(mesh.positions.size(), 0);
    if (asset) bundle.locked = asset->shell.locked;
    bundle.locked.resize(mesh.positions.size(), 0);
    bundle.volume.resize(mesh.tets.size(), 0);
    bundle.stiffness_scale.resize(mesh.tets.size(), 1);
    bundle.material.resize(mesh.tets.size(), 0);
    bundle.region = mesh.region;
    bundle.region.resize(mesh.tets.size(), 0);
    if (!asset || mesh.region.empty()) {
        bundle.regions = {"tets"};
    } else {
        for (const Component& component : asset->shell.components) bundle.regions.push_back(component.name);
    }
    return bundle;
}

}

Bundle visible_bundle(const Workspace& workspace) {
    if (workspace.bundle) return *workspace.bundle;
    if (workspace.tets) return bundle_of_work(*workspace.tets, workspace.asset ? &*workspace.asset : nullptr);
    throw Error(ErrorKind::bad_input, "there is no mesh yet; run crumple delaunay first");
}

std::string export_mesh(const Bundle& bundle, ExportFormat format) {
    switch (format) {
        case ExportFormat::vtu:
            return store::export_vtu(bundle);
        case ExportFormat::msh:
            return store::export_msh(bundle);
        case ExportFormat::obj:
            return store::export_obj(bundle);
    }
    return {};
}

}
