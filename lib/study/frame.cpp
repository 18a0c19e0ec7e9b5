// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/frame.h"

#include <algorithm>
#include <cmath>

#include "solver/check_input.h"
#include "solver/measure.h"

namespace crumple::study {

namespace {

void read_tets(const Player& player, Frame& f) {
    f.plastic_strain.assign(player.bundle().tets.size(), 0);
    for (std::size_t t = 0; t < player.model().tet_count; ++t) {
        f.inverted += determinant(deformation_gradient(player.model(), player.state(), t)) <= 0;
        f.plastic_strain[t] = plastic_strain(player.model(), player.state(), t);
    }
}

SensorFrame place_reading(const solver::SensorReading& reading, const solver::CarrierMotion& motion) {
    SensorFrame s;
    s.orientation = solver::to_quaternion(to_matrix(motion.orientation) * to_matrix(reading.orientation));
    s.origin = solver::Frame(motion).point_to_world(reading.origin);
    s.deformation = reading.deformation;
    s.plastic_strain = reading.plastic_strain;
    s.acceleration = length(reading.acceleration);
    return s;
}

bool is_finite(const SensorFrame& s) {
    const solver::Quaternion q = s.orientation;
    const double sum = static_cast<double>(q.x + q.y + q.z + q.w) + static_cast<double>(s.deformation) +
                       static_cast<double>(s.plastic_strain) + static_cast<double>(s.acceleration);
    return std::isfinite(sum) && solver::is_usable(narrow(s.origin));
}

}

Frame take_frame(Player& player, double time_s, double since_s) {
    Frame f;
    f.time_s = time_s;
    const solver::CarrierMotion motion = player.motion();
    const solver::Frame world(motion);
    for (std::size_t n = 0; n < player.model().node_count; ++n) {
        f.nodes.push_back(narrow(world.point_to_world(position(player.state(), n))));
    }
    for (const BundleVisual& visual : player.bundle().visuals) {
        f.vertices.push_back(player.skinned(visual));
        for (Vec3f& p : f.vertices.back()) p = narrow(world.point_to_world(p));
    }
    read_tets(player, f);
    for (std::size_t i = 0; i < player.bundle().sensors.size(); ++i) {
        f.sensors.push_back(place_reading(player.read_sensor(i, static_cast<float>(since_s)), motion));
    }
    f.kinetic_j = kinetic_energy(player.model(), player.state());
    f.elastic_j = elastic_energy(player.model(), player.state(), solver::EnergyRotation::of_state);
    f.iterations = player.report().step.iterations;
    f.contacts = static_cast<std::uint32_t>(player.report().contacts);
    f.is_asleep = player.report().is_asleep;
    return f;
}

bool is_finite(const Frame& f) {
    const auto are_places = [](const std::vector<Vec3f>& places) {
        return std::all_of(places.begin(), places.end(), [](Vec3f p) { return solver::is_usable(p); });
    };
    return are_places(f.nodes) && std::all_of(f.vertices.begin(), f.vertices.end(), are_places) &&
           std::all_of(f.plastic_strain.begin(), f.plastic_strain.end(), [](float x) { return std::isfinite(x); }) &&
           std::all_of(f.sensors.begin(), f.sensors.end(), [](const SensorFrame& s) { return is_finite(s); }) &&
           std::isfinite(f.kinetic_j) && std::isfinite(f.elastic_j);
}

}
