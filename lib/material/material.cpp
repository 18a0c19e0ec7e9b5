// SPDX-License-Identifier: MIT
#include "material/material.h"

#include <sstream>
#include <string_view>

namespace crumple {
namespace {

// Written so that a NaN counts as outside.
struct RangeCheck {
    std::string complaint;

    void field(std::string_view, const std::string&, std::string_view) {}
    void field(std::string_view name, double value, Range range, std::string_view) {
        if (!complaint.empty() || (value >= range.min && value <= range.max)) return;
        std::ostringstream text;
        text << name << " is " << value << ", allowed are " << range.min << " to " << range.max;
        complaint = text.str();
    }
};

}

std::string first_field_out_of_range(const Material& material) {
    RangeCheck check;
    describe(check, material);
    return check.complaint;
}

}
