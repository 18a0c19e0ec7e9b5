// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>

#include "bake/bake.h"
#include "core/error.h"
#include "core/names.h"

namespace crumple::bake {
namespace {

using Map = std::map<std::string, std::string>;

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
    throw Error(ErrorKind::usage, "bake." + path + why);
}

template <class Named>
std::vector<std::string> names_of(const std::vector<Named>& items) {
    std::vector<std::string> names;
    for (const Named& item : items) names.push_back(item.name);
    return names;
}

template <class Named>
void check_names(const std::vector<Named>& items, const std::string& path) {
    const std::vector<std::string> names = names_of(items);
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string at = path + "[" + std::to_string(i) + "].name: ";
        if (names[i].empty()) refuse(at, "is empty");
        const auto first = std::find(names.begin(), names.end(), names[i]) - names.begin();
        if (static_cast<std::size_t>(first) != i)
            refuse(at, "'" + names[i] + "' is the name of " + path + "[" + std::to_string(first) + "] already");
    }
}

void check_table(const std::vector<Material>& materials) {
    if (materials.empty()) refuse("materials: ", "the table is empty; it needs one material at least");
    if (materials.size() > std::numeric_limits<std::uint16_t>::max())
        refuse("materials: ", "more than 65535 materials");
    for (std::size_t m = 0; m < materials.size(); ++m) {
        const std::string complaint = first_field_out_of_range(materials[m]);
        if (!complaint.empty()) refuse("materials[" + std::to_string(m) + "].", complaint);
    }
    check_names(materials, "materials");
}

// Also the entries nobody asks for must name a material of the table: a slip in a recipe should not wait for an asset.
void check_map(const Map& map, const std::string& path, const std::vector<std::string>& materials) {
    for (const auto& [key, name] : map) {
        if (std::find(materials.begin(), materials.end(), name) != materials.end()) continue;
        refuse(path + "." + key + ": ", "'" + name + "' is not in bake.materials (" + list_names(materials) +
                                            "); nearest: '" + nearest_name(name, materials) + "'");
    }
}

void check_roles(const Map& map) {
    std::vector<std::string> roles;
    for (const auto& role : role_names) roles.emplace_back(role.name);
    for (const auto& [key, name] : map) {
        if (std::find(roles.begin(), roles.end(), key) != roles.end()) continue;
        refuse("material_by_role." + key + ": ",
               "no such role (" + list_names(roles) + "); nearest: '" + nearest_name(key, roles) + "'");
    }
}

void check_stiffness(const std::map<std::string, double>& map) {
    for (const auto& [key, factor] : map) {
        if (!(factor >= 1e-6 && factor <= 1e6))
            refuse("stiffness_by_component." + key + ": ", "a factor lies between 1e-6 and 1e6");
    }
}

}

void check_params(const Params& params) {
    check_table(params.materials);
    const std::vector<std::string> materials = names_of(params.materials);
    check_map(params.material_by_component, "material_by_component", materials);
    check_map(params.material_by_source, "material_by_source", materials);
    check_map(params.material_by_role, "material_by_role", materials);
    check_roles(params.material_by_role);
    check_stiffness(params.stiffness_by_component);
    check_names(params.sensors, "sensors");
    if (!(params.step_s >= 1e-6 && params.step_s <= 1)) refuse("step_s: ", "a step lasts 1e-6 to 1 second");
}

}
