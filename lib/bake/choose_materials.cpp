// SPDX-License-Identifier: GPL-3.0-or-later
#include "bake/choose_materials.h"

#include <algorithm>

namespace crumple::bake {
namespace {

// REQUIRES: check_params(params).
std::uint16_t find_material(const std::vector<Material>& materials, const std::string& name) {
    const auto found =
        std::find_if(materials.begin(), materials.end(), [&](const Material& m) { return m.name == name; });
    return static_cast<std::uint16_t>(found - materials.begin());
}

std::uint16_t choose(const Component& component, const Params& params) {
    if (const auto it = params.material_by_component.find(component.name); it != params.material_by_component.end()) {
        return find_material(params.materials, it->second);
    }
    if (const auto it = params.material_by_source.find(component.material); it != params.material_by_source.end()) {
        return find_material(params.materials, it->second);
    }
    const auto it = params.material_by_role.find(std::string(name_of(component.role)));
    return it == params.material_by_role.end() ? std::uint16_t{0} : find_material(params.materials, it->second);
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
