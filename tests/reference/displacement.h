// SPDX-License-Identifier: GPL-3.0-or-later
// How far a part of a body has moved.
#pragma once
#include "bundle/bundle.h"
#include "reference/reference.h"
#include "solver/body.h"

namespace crumple::test {

// Mean over the nodes of which is_part(node) holds; position(node): where it is now.
template <class IsPart, class Position>
Vec3 mean_displacement(const Bundle& bundle, IsPart&& is_part, Position&& position) {
    Vec3 sum;
    double count = 0;
    for (std::size_t i = 0; i < bundle.rest_positions.size(); ++i) {
        if (!is_part(i)) continue;
        sum += position(i) - widen(bundle.rest_positions[i]);
        ++count;
    }
    return sum / count;
}

template <class IsPart>
Vec3 mean_displacement(const reference::Body& body, IsPart&& is_part) {
    return mean_displacement(*body.bundle, is_part, [&](std::size_t i) { return body.positions[i]; });
}

template <class IsPart>
Vec3 mean_displacement(const solver::test::Body& body, IsPart&& is_part) {
    return mean_displacement(body.bundle, is_part, [&](std::size_t i) { return widen(body.x(i)); });
}

}
