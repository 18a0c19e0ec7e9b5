// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/workspace.h"

namespace crumple::pipeline {

bool has_group(const Workspace& workspace, Group group) {
    switch (group) {
        case Group::asset:
            return workspace.asset.has_value();
        case Group::points:
            return workspace.points.has_value();
        case Group::tets:
            return workspace.tets.has_value();
        case Group::bindings:
            return workspace.bindings.has_value();
        case Group::bundle:
            return workspace.bundle.has_value();
    }
    return false;
}

void drop_after(Workspace& workspace, Group group) {
    if (group < Group::points) workspace.points.reset();
    if (group < Group::tets) workspace.tets.reset();
    if (group < Group::bindings) workspace.bindings.reset();
    if (group < Group::bundle) workspace.bundle.reset();
}

}
