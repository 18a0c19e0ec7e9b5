// SPDX-License-Identifier: GPL-3.0-or-later
#include "bake/choose_materials.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"

namespace crumple::bake {
namespace {

using Map = std::map<std::string, std::string>;

void check_table(const std::vector<Material>& materials) {
    if (materials.empty() || materials.size() > std::numeric_limits<std::uint16_t>::max()) {
        throw Error(ErrorKind::usage, "bake.materials: the table needs 1 to 65535 materials");
    }
    for (std::size_t m = 0; m < materials.size(); ++m) {
        const std::string complaint = first_field_out_of_range(materials[m]);
        if (!complaint.empty()) throw Error(ErrorKind::usage, "bake.materials[" + std::to_string(m) + "]." + complaint);
        const auto has_same_name = [&](const Material& other) { return other.name == materials[m].name; };
        if (materials[m].name.empty() || std::count_if(materials.begin(), materials.end(), has_same_name) != 1) {
            throw Error(ErrorKind::usage, "bake.materials[" + std::to_string(m) + "].name: '" + materials[m].name +
                                              "' is empty or used twice");
        }
    }
}

std::string list_names(const std::vector<Material>& materials) {
    std::string list;
    for (const Material& material : materials) list += (list.empty() ? "" : ", ") + material.name;
    return list;
}

std::uint16_t find_material(const std::vector<Material>& materials, const std::string& name, const std::string& where) {
    const auto found =
        std::find_if(materials.begin(), materials.end(), [&](const Material& m) { return m.name == name; });
    if (found == materials.end()) {
        throw Error(ErrorKind::usage, where + " names material '" + name + "', which is not in bake.materials (" +
                                          list_names(materials) + ")");
    }
    return static_cast<std::uint16_t>(found - materials.begin());
}

// Also the entries nobody asks for must name a material of the table: a slip in a recipe should not wait for an asset.
void check_map(const Map& map, const std::string& path, const std::vector<Material>& materials) {
    for (const auto& [key, name] : map) (void)find_material(materials, name, path + "." + key);
}

void check_roles(const Map& map) {
    for (const auto& [key, name] : map) {
        const auto is_role = [&key = key](const EnumName<Role>& role) { return role.name == key; };
        if (std::none_of(std::begin(role_names), std::end(role_names), is_role)) {
            throw Error(ErrorKind::usage, "bake.material_by_role." + key + ": roles are solid, cavity and rigid");
        }
    }
}

std::uint16_t choose(const Component& component, const Params& params) {
    if (const auto it = params.material_by_component.find(component.name); it != params.material_by_component.end()) {
        return find_material(params.materials, it->second, "bake.material_by_component");
    }
    if (const auto it = params.material_by_source.find(component.material); it != params.material_by_source.end()) {
        return find_material(params.materials, it->second, "bake.material_by_source");
    }
    const auto it = params.material_by_role.find(std::string(name_of(component.role)));
    return it == params.material_by_role.end() ? std::uint16_t{0}
                                               : find_material(params.materials, it->second, "bake.material_by_role");
}

template <class Value, class Matches>
void report_unmatched(const std::map<std::string, Value>& map, const char* what, const Shell& shell, Matches matches,
                      std::vector<Finding>& findings) {
    for (const auto& [key, value] : map) {
        const auto matches_key = [&, &name = key](const Component& component) { return matches(component, name); };
        if (std::any_of(shell.components.begin(), shell.components.end(), matches_key)) continue;
        findings.push_back({"MATERIAL_UNUSED",
                            Severity::warning,
                            std::string("bake.") + what + " names '" + key + "', which the shell does not have",
                            1,
                            {}});
    }
}

float stiffness_of(const Component& component, const Params& params) {
    const auto it = params.stiffness_by_component.find(component.name);
    return it == params.stiffness_by_component.end() ? 1.0f : static_cast<float>(it->second);
}

void check_stiffness(const std::map<std::string, double>& map) {
    for (const auto& [key, factor] : map) {
        if (!(factor >= 1e-6 && factor <= 1e6)) {
            throw Error(ErrorKind::usage,
                        "bake.stiffness_by_component." + key + ": a factor lies between 1e-6 and 1e6");
        }
    }
}

}

std::vector<Material> default_materials() {
    Material engine;
    engine.name = "engine";
    engine.young_pa = 2e9;
    engine.density_kg_m3 = 3000;
    engine.yield_pa = 1e9;
    return {Material{}, engine};
}

std::vector<ComponentMaterial> choose_materials(const Shell& shell, const Params& params,
                                                std::vector<Finding>& findings) {
    check_table(params.materials);
    check_map(params.material_by_component, "bake.material_by_component", params.materials);
    check_map(params.material_by_source, "bake.material_by_source", params.materials);
    check_map(params.material_by_role, "bake.material_by_role", params.materials);
    check_roles(params.material_by_role);
    check_stiffness(params.stiffness_by_component);

    const auto by_name = [](const Component& c, const std::string& key) { return c.name == key; };
    const auto by_source = [](const Component& c, const std::string& key) { return c.material == key; };
    report_unmatched(params.material_by_component, "material_by_component", shell, by_name, findings);
    report_unmatched(params.material_by_source, "material_by_source", shell, by_source, findings);
    report_unmatched(params.stiffness_by_component, "stiffness_by_component", shell, by_name, findings);

    std::vector<ComponentMaterial> chosen;
    for (const Component& component : shell.components) {
        chosen.push_back({choose(component, params), stiffness_of(component, params)});
    }
    if (chosen.empty()) chosen.push_back({choose(Component{}, params), 1.0f});
    return chosen;
}

}
