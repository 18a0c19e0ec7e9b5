// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/roles.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "core/counted.h"
#include "geometry/bvh.h"
#include "geometry/measures.h"
#include "geometry/winding_number.h"

namespace crumple::importer {

namespace {

// Triangle centres asked whether they lie inside another component. They agree unless the two overlap.
constexpr std::size_t sample_count = 16;

std::vector<std::vector<Triangle>> triangles_by_component(const Shell& shell, std::size_t count) {
    std::vector<std::vector<Triangle>> result(count);
    for (std::size_t t = 0; t < shell.triangles.size(); ++t) result[shell.component[t]].push_back(shell.triangles[t]);
    return result;
}

class UniqueNames {
public:
    std::string take(const std::string& wanted) {
        std::string name = wanted;
        // Thousands of pieces may want one name: each goes on where the last one left off.
        for (int& number = last_.try_emplace(wanted, 1).first->second; !taken_.insert(name).second;)
            name = wanted + "." + std::to_string(++number);
        return name;
    }

private:
    std::map<std::string, int> last_;
    std::set<std::string> taken_;
};

void name_components(const Surface& surface, const Components& components, Shell& shell) {
    UniqueNames names;
    for (const ComponentFacts& facts : components.facts) {
        Component component;
        component.name = names.take(surface.objects[facts.object].name);
        component.material = surface.parts[facts.part].material;
        component.is_closed = facts.is_closed;
        component.is_inward = facts.signed_volume < 0;
        component.volume = std::fabs(facts.signed_volume);
        shell.components.push_back(std::move(component));
    }
}

class Nesting {
public:
    explicit Nesting(const Shell& shell)
        : shell_(shell), triangles_(triangles_by_component(shell, shell.components.size())) {
        for (const auto& own : triangles_) {
            Box box;
            for (const Triangle& t : own) {
                for (const Index v : t) box.add(shell.positions[v]);
            }
            boxes_.push_back(box);
        }
        trees_.resize(triangles_.size());
        tree_of_boxes_ = Bvh(boxes_);
    }

    // The closed component of least volume that holds most samples of c; of equal ones the earlier.
    Index parent_of(Index c) {
        Index best = none;
        tree_of_boxes_.containing(boxes_[c].low, [&](Index other) {
            const Component& candidate = shell_.components[other];
            const bool is_larger = candidate.is_closed && candidate.volume > shell_.components[c].volume;
            if (other == c || !is_larger || !holds_box(boxes_[other], boxes_[c])) return false;
            const double best_volume = best == none ? candidate.volume : shell_.components[best].volume;
            if (candidate.volume > best_volume || (candidate.volume == best_volume && other > best)) return false;
            if (holds(other, c)) best = other;
            return false;
        });
        return best;
    }

private:
    static bool holds_box(const Box& outer, const Box& inner) {
        for (int axis = 0; axis < 3; ++axis) {
            if (inner.low[axis] < outer.low[axis] || inner.high[axis] > outer.high[axis]) return false;
        }
        return true;
    }
    bool holds(Index outer, Index inner) {
        if (!trees_[outer]) trees_[outer].emplace(shell_.positions, triangles_[outer]);
        const auto& own = triangles_[inner];
        const std::size_t step = std::max<std::size_t>(1, own.size() / sample_count);
        std::size_t asked = 0;
        std::size_t inside = 0;
        for (std::size_t t = 0; t < own.size(); t += step) {
            const Vec3 centre =
                (shell_.positions[own[t][0]] + shell_.positions[own[t][1]] + shell_.positions[own[t][2]]) / 3.0;
            ++asked;
            inside += std::fabs(trees_[outer]->at(centre)) > 0.5;
        }
        return 2 * inside > asked;
    }

    const Shell& shell_;
    std::vector<std::vector<Triangle>> triangles_;
    std::vector<Box> boxes_;
    Bvh tree_of_boxes_;
    std::vector<std::optional<WindingNumber>> trees_;  // built when first asked
};

struct Decision {
    Role role = Role::solid;
    std::string reason;
};

// The recipe's word, if it has one: for the component itself, else for its object, mesh or material.
std::optional<Decision> by_recipe(const Surface& surface, const Component& component, const ComponentFacts& facts,
                                  bool is_cavity, const Params& params, std::set<std::string>& used) {
    const Part& part = surface.parts[facts.part];
    const std::string* keys[] = {&component.name, &surface.objects[facts.object].name, &part.mesh, &part.material};
    const char* kinds[] = {"component", "object", "mesh", "material"};
    for (int i = 0; i < 4; ++i) {
        const auto found = params.roles.find(*keys[i]);
        if (found == params.roles.end()) continue;
        used.insert(found->first);
        // "body: solid" means the body, not the cabin modelled in the same object.
        if (i > 0 && is_cavity) continue;
        return Decision{found->second, std::string("recipe: ") + kinds[i] + " '" + found->first + "'"};
    }
    return std::nullopt;
}

// By triangle, so a component that shares locked vertices with its neighbour is judged by its own.
std::vector<std::uint8_t> fully_locked(const Shell& shell) {
    std::vector<std::uint8_t> result(shell.components.size(), 1);
    for (std::size_t t = 0; t < shell.triangles.size(); ++t) {
        for (const Index v : shell.triangles[t]) result[shell.component[t]] &= shell.locked[v];
    }
    return result;
}

// A part painted all over inside another one is an engine block: nothing of it can deform. Painted all over and inside
// nothing, it is more likely a default colour (LOCK_NEARLY_ALL says so) and stays as it was.
bool is_rigid_by_paint(const Component& component, const Decision& decision, bool is_fully_locked) {
    return is_fully_locked && component.is_closed && component.parent != none && decision.role == Role::solid;
}

Decision by_winding(const Shell& shell, const Component& component) {
    if (!component.is_closed) return {Role::solid, "not closed: taken as solid"};
    const std::string inside =
        component.parent == none ? "" : " inside '" + shell.components[component.parent].name + "'";
    if (!component.is_inward) return {Role::solid, "winding: closed and wound outwards" + inside};
    if (component.parent == none) return {Role::solid, "winding: closed and wound inwards, but inside nothing; turned"};
    if (shell.components[component.parent].role == Role::cavity) {
        return {Role::solid, "winding: closed and wound inwards, but in the cavity" + inside.substr(7) + "; turned"};
    }
    return {Role::cavity, "winding: closed and wound inwards" + inside};
}

// Outer components first, so that a parent's role is known.
std::vector<Index> by_falling_volume(const Shell& shell) {
    std::vector<Index> order(shell.components.size());
    for (Index c = 0; c < order.size(); ++c) order[c] = c;
    std::stable_sort(order.begin(), order.end(),
                     [&](Index a, Index b) { return shell.components[a].volume > shell.components[b].volume; });
    return order;
}

Vec3 first_corner(const Shell& shell, Index c) {
    const auto found = std::find(shell.component.begin(), shell.component.end(), c);
    return shell.positions[shell.triangles[static_cast<std::size_t>(found - shell.component.begin())][0]];
}

void report_nesting(const Shell& shell, std::vector<Finding>& findings) {
    Finding nested{"SHELL_NESTED", Severity::info, "", 0, {}};
    Finding inverted{"SHELL_INVERTED", Severity::warning, "", 0, {}};
    const auto add = [&](Finding& finding, Index c) {
        ++finding.count;
        if (wants_place(finding)) finding.places.push_back({first_corner(shell, c), none, shell.components[c].name});
    };
    for (Index c = 0; c < shell.components.size(); ++c) {
        const Component& component = shell.components[c];
        if (component.parent != none) add(nested, c);
        if (component.is_inward && component.is_closed && component.role != Role::cavity) add(inverted, c);
    }
    if (nested.count > 0) {
        nested.message = counted(nested.count, "component lies", "components lie") +
                         " inside another; the report says what each is taken for";
        findings.push_back(nested);
    }
    if (inverted.count > 0) {
        inverted.message = counted(inverted.count, "closed component was wound inwards though no cavity, and was",
                                   "closed components were wound inwards though no cavities, and were") +
                           " turned";
        findings.push_back(inverted);
    }
}

void report_unknown_names(const Shell& shell, const Params& params, const std::set<std::string>& used,
                          std::vector<Finding>& findings) {
    for (const auto& [name, role] : params.roles) {
        if (used.contains(name)) continue;
        std::string known;
        for (std::size_t c = 0; c < std::min<std::size_t>(shell.components.size(), max_places); ++c) {
            known += (c == 0 ? "'" : ", '") + shell.components[c].name + "'";
        }
        findings.push_back(
            {"ROLE_UNKNOWN",
             Severity::warning,
             "the recipe gives '" + name + "' a role, but nothing of the shell has that name; it has " + known,
             1,
             {}});
    }
}

void turn_by_role(Shell& shell) {
    for (std::size_t t = 0; t < shell.triangles.size(); ++t) {
        const Component& component = shell.components[shell.component[t]];
        const bool wants_inward = component.role == Role::cavity;
        if (component.is_closed && component.is_inward != wants_inward)
            std::swap(shell.triangles[t][1], shell.triangles[t][2]);
    }
}

}

std::vector<Finding> assign_roles(const Surface& surface, const Components& components, const Params& params,
                                  Shell& shell) {
    name_components(surface, components, shell);
    Nesting nesting(shell);
    const std::vector<std::uint8_t> is_fully_locked = fully_locked(shell);
    std::set<std::string> used;
    for (const Index c : by_falling_volume(shell)) {
        Component& component = shell.components[c];
        component.parent = nesting.parent_of(c);
        Decision decision = by_winding(shell, component);
        const bool is_cavity = decision.role == Role::cavity;
        if (is_rigid_by_paint(component, decision, is_fully_locked[c] != 0)) {
            decision = {Role::rigid,
                        "paint: every vertex is locked, inside '" + shell.components[component.parent].name + "'"};
        }
        if (auto wanted = by_recipe(surface, component, components.facts[c], is_cavity, params, used))
            decision = *wanted;
        component.role = decision.role;
        component.role_reason = decision.reason;
    }
    std::vector<Finding> findings;
    report_nesting(shell, findings);
    report_unknown_names(shell, params, used, findings);
    turn_by_role(shell);
    return findings;
}

}
