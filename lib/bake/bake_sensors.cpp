// SPDX-License-Identifier: GPL-3.0-or-later
#include "bake/bake_sensors.h"

#include <algorithm>
#include <cmath>

namespace crumple::bake {
namespace {

using Choice = std::vector<std::uint8_t>;  // one flag a node

Choice choose_by_box(const Bundle& bundle, const SensorParams& sensor) {
    Choice chosen(bundle.rest_positions.size(), 0);
    for (std::size_t node = 0; node < chosen.size(); ++node) {
        const Vec3 p = widen(bundle.rest_positions[node]);
        chosen[node] = sensor.box_low.x <= p.x && p.x <= sensor.box_high.x && sensor.box_low.y <= p.y &&
                       p.y <= sensor.box_high.y && sensor.box_low.z <= p.z && p.z <= sensor.box_high.z;
    }
    return chosen;
}

Choice choose_by_component(const Shell& shell, const Bundle& bundle, const SensorParams& sensor) {
    Choice chosen(bundle.rest_positions.size(), 0);
    for (std::size_t f = 0; f < shell.triangles.size(); ++f) {
        if (shell.components[shell.component[f]].name != sensor.component) continue;
        for (const Index vertex : shell.triangles[f]) {
            if (const Index node = bundle.mesh_to_node[vertex]; node != none) chosen[node] = 1;
        }
    }
    for (std::size_t t = 0; t < bundle.tets.size(); ++t) {
        if (bundle.regions[bundle.region[t]] != sensor.component) continue;
        for (const Index node : bundle.tets[t]) chosen[node] = 1;
    }
    return chosen;
}

Choice choose_by_color(const Shell& shell, const Bundle& bundle, const SensorParams& sensor) {
    Choice chosen(bundle.rest_positions.size(), 0);
    for (std::size_t vertex = 0; vertex < shell.color.size(); ++vertex) {
        const Index node = bundle.mesh_to_node[vertex];
        if (node == none) continue;
        const auto& color = shell.color[vertex];
        chosen[node] = std::fabs(color[0] - sensor.color.x) <= sensor.color_tolerance &&
                       std::fabs(color[1] - sensor.color.y) <= sensor.color_tolerance &&
                       std::fabs(color[2] - sensor.color.z) <= sensor.color_tolerance;
    }
    return chosen;
}

Choice choose_nodes(const Shell& shell, const Bundle& bundle, const SensorParams& sensor) {
    switch (sensor.by) {
        case SensorBy::box:
            return choose_by_box(bundle, sensor);
        case SensorBy::component:
            return choose_by_component(shell, bundle, sensor);
        case SensorBy::color:
            return choose_by_color(shell, bundle, sensor);
    }
    return Choice(bundle.rest_positions.size(), 0);
}

// Why nothing was chosen, with what to try.
std::string emptiness_of(const Shell& shell, const SensorParams& sensor) {
    const std::string what = "sensor '" + sensor.name + "' is left out: ";
    const auto has_name = [&](const Component& component) { return component.name == sensor.component; };
    switch (sensor.by) {
        case SensorBy::box:
            return what + "no node lies in its box; widen it";
        case SensorBy::component:
            if (std::any_of(shell.components.begin(), shell.components.end(), has_name)) break;
            return what + "the shell has no component '" + sensor.component + "'";
        case SensorBy::color:
            if (shell.color.empty()) return what + "the shell has no colours";
            return what + "no shell vertex has its colour; raise color_tolerance";
    }
    return what + "no tet uses its component";
}

BundleSensor weigh_nodes(const Bundle& bundle, const std::string& name, const Choice& chosen) {
    BundleSensor sensor{name, {}, {}, {}, {1, 0, 0, 0, 1, 0, 0, 0, 1}};
    double total = 0;
    for (Index node = 0; node < chosen.size(); ++node) {
        if (!chosen[node] || bundle.mass[node] == 0) continue;
        sensor.node.push_back(node);
        total += bundle.mass[node];
    }
    Vec3 centre;
    for (const Index node : sensor.node) {
        const double share = bundle.mass[node] / total;
        sensor.weight.push_back(static_cast<float>(share));
        centre += widen(bundle.rest_positions[node]) * share;
    }
    sensor.rest_origin = narrow(centre);
    return sensor;
}

// Nodes on one line do not say how the frame turns about it.
bool is_straight(const Bundle& bundle, const BundleSensor& sensor) {
    const Vec3 first = widen(bundle.rest_positions[sensor.node.front()]);
    Vec3 along;
    for (const Index node : sensor.node) {
        const Vec3 arm = widen(bundle.rest_positions[node]) - first;
        if (dot(arm, arm) > dot(along, along)) along = arm;
    }
    for (const Index node : sensor.node) {
        const Vec3 arm = widen(bundle.rest_positions[node]) - first;
        if (length(cross(along, arm)) > 1e-6 * dot(along, along)) return false;
    }
    return true;
}

}

std::vector<BundleSensor> bake_sensors(const Shell& shell, const Bundle& bundle, const Params& params,
                                       std::vector<Finding>& findings) {
    std::vector<BundleSensor> sensors;
    for (const SensorParams& wanted : params.sensors) {
        BundleSensor sensor = weigh_nodes(bundle, wanted.name, choose_nodes(shell, bundle, wanted));
        if (sensor.node.empty()) {
            findings.push_back({"SENSOR_EMPTY", Severity::warning, emptiness_of(shell, wanted), 1, {}});
            continue;
        }
        if (is_straight(bundle, sensor)) {
            findings.push_back({"SENSOR_STRAIGHT",
                                Severity::warning,
                                "the nodes of sensor '" + wanted.name + "' lie on one line, so its rotation is open",
                                1,
                                {{widen(sensor.rest_origin), none, wanted.name}}});
        }
        sensors.push_back(std::move(sensor));
    }
    return sensors;
}

}
