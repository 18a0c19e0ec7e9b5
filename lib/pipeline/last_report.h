// SPDX-License-Identifier: GPL-3.0-or-later
// The report of a cook in a process of its own, as far as it had come when that process was ended.
#pragma once
#include "pipeline/cook.h"
#include "sandbox/shared_text.h"

namespace crumple::pipeline {

// To be made before the fork. The cook keeps its report here (CookRequest::keep_report), its parent reads it.
class LastReport {
public:
    void keep(const CookReport& report);

    // What it cost is counted since this was made.
    [[nodiscard]] CookReport read() const;

private:
    UsageMeter meter_;
    sandbox::SharedText text_;
};

}
