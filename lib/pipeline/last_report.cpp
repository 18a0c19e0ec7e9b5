// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/last_report.h"

#include <algorithm>

#include "report/json_reader.h"
#include "report/json_writer.h"

namespace crumple::pipeline {

void LastReport::keep(const CookReport& report) {
    text_.write(report::write_json(report::Described::of(report), report::JsonStyle::compact));
}

CookReport LastReport::read() const {
    CookReport report;
    const std::string json = text_.read();
    if (!json.empty()) {
        report::read_json(json, "report", report::Described::of(report),
                          {.kind = ErrorKind::internal, .allows_null = true});
    }
    report.usage = meter_.read();
    for (const StageRun& stage : report.stages)
        report.usage.peak_memory_mb = std::max(report.usage.peak_memory_mb, stage.usage.peak_memory_mb);
    return report;
}

}
