// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "study/scene.h"

namespace crumple::study {
namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
    throw Error(ErrorKind::usage, path + ": " + why);
}

void check_handle(const SceneHandle& h, const std::string& path) {
    if (h.times_s.empty()) refuse(path + ".times_s", "has no key");
    if (!std::is_sorted(h.times_s.begin(), h.times_s.end(), std::less_equal<>())) {
        refuse(path + ".times_s", "does not ascend");
    }
    for (const auto& [name, values] : {std::pair{".shift_m", &h.shift_m}, std::pair{".turn_deg", &h.turn_deg}}) {
        if (!values->empty() && values->size() != h.times_s.size()) {
            refuse(path + name, "has " + std::to_string(values->size()) + " values for " +
                                    std::to_string(h.times_s.size()) + " keys");
        }
    }
}

void check_obstacle(const SceneObstacle& o, const std::string& path) {
    if (o.shape == solver::ObstacleShape::plane && o.axis == Vec3{}) refuse(path + ".axis", "a plane needs a normal");
    if (o.shape == solver::ObstacleShape::capsule && !(o.radius_m > 0)) {
        refuse(path + ".radius_m", "a capsule needs a radius");
    }
    if (o.shape == solver::ObstacleShape::box && !(o.axis.x > 0 && o.axis.y > 0 && o.axis.z > 0)) {
        refuse(path + ".axis", "a box needs half of its three edges");
    }
}

}

void check_params(const Scene& s) {
    if (s.frames_per_s > s.steps_per_s) refuse("frames_per_s", "there are more frames than steps");
    if (s.seconds * s.frames_per_s > 1e5 || s.seconds * s.steps_per_s > 1e7) refuse("seconds", "too long");
    for (std::size_t i = 0; i < s.obstacles.size(); ++i) {
        check_obstacle(s.obstacles[i], "obstacles[" + std::to_string(i) + "]");
    }
    for (std::size_t i = 0; i < s.handles.size(); ++i) {
        check_handle(s.handles[i], "handles[" + std::to_string(i) + "]");
    }
}

}
