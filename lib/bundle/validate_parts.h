// SPDX-License-Identifier: MIT
// What the files of validate() share: a list of what is wrong, one finding a code with the first few offenders.
#pragma once
#include <string_view>
#include <vector>

#include "bundle/bundle.h"
#include "core/finding.h"

namespace crumple {

// The position of what has none.
constexpr Vec3f no_place = narrow(nowhere);

class Complaints {
public:
    // The message is that of the first offender of its code.
    void add(const char* code, const char* message, Index element = none, Vec3f position = no_place,
             std::string_view name = {});
    [[nodiscard]] bool empty() const { return findings_.empty(); }
    [[nodiscard]] std::vector<Finding> take() { return std::move(findings_); }

private:
    std::vector<Finding> findings_;
};

// Each REQUIRES that the checks before it passed without complaint; that is what makes its own reads safe.
void check_sizes(const Bundle& bundle, Complaints& complaints);
void check_indices(const Bundle& bundle, Complaints& complaints);
void check_numbers(const Bundle& bundle, Complaints& complaints);
// From here on in any order.
void check_node_order(const Bundle& bundle, Complaints& complaints);
void check_locks(const Bundle& bundle, Complaints& complaints);
void check_tet_geometry(const Bundle& bundle, Complaints& complaints);
void check_tet_order(const Bundle& bundle, Complaints& complaints);
void check_faces(const Bundle& bundle, Complaints& complaints);
void check_masses(const Bundle& bundle, Complaints& complaints);
void check_matrix(const Bundle& bundle, Complaints& complaints);
void check_edges(const Bundle& bundle, Complaints& complaints);
void check_visuals(const Bundle& bundle, Complaints& complaints);
void check_sensors(const Bundle& bundle, Complaints& complaints);
void check_names(const Bundle& bundle, Complaints& complaints);

}
