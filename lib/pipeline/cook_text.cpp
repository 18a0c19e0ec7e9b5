// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/cook_text.h"

#include "core/counted.h"
#include "report/number_text.h"
#include "report/printable.h"
#include "report/text_view.h"

namespace crumple::pipeline {

namespace {

std::vector<std::string> row(const std::string& name, const Usage& usage, const std::vector<Finding>& findings) {
    const auto short_text = [](double number) { return report::number_text(number, 3); };
    return {name, short_text(usage.cpu_s), short_text(usage.wall_s), short_text(usage.peak_memory_mb),
            report::findings_summary(findings)};
}

}

std::string cook_text(const CookReport& report, const std::string& output, bool has_color) {
    std::vector<std::vector<std::string>> rows{{"stage", "cpu s", "wall s", "peak MB", "findings"}};
    std::vector<Finding> all;
    for (const StageRun& stage : report.stages) {
        rows.push_back(row(stage.name, stage.usage, stage.findings));
        all.insert(all.end(), stage.findings.begin(), stage.findings.end());
    }
    rows.push_back(row("all", report.usage, all));
    const std::size_t places = report.output.is_rejected ? max_places : 1;
    std::string text = report::table_text(rows) + report::findings_text(all, {has_color, 0, places});
    if (report.determinism_jobs > 0) {
        text += "cooked again with " + counted(report.determinism_jobs, "thread", "threads") + ": the same bytes\n";
    }
    if (report.output.is_rejected) return text;
    return text + report::printable(output) + ": " + report::size_text(report.output.bytes) +
           (report.output.is_unchanged ? ", unchanged\n" : "\n");
}

std::string dry_run_text(const DryRunReport& report, const std::string& output) {
    std::string text = report::printable(output) + (report.would_change ? ": would be cooked\n" : ": up to date\n");
    for (const std::string& reason : report.reasons) text += "  " + report::printable(reason) + "\n";
    return text;
}

}
