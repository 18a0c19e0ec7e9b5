// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/cook.h"

#include <algorithm>
#include <string_view>

#include "pipeline/compare.h"
#include "pipeline/input_digests.h"
#include "pipeline/output_file.h"
#include "pipeline/version.h"
#include "store/sha256.h"

namespace crumple::pipeline {

namespace {

const StageRun& largest_of(const std::vector<StageRun>& runs) {
    return *std::max_element(runs.begin(), runs.end(), [](const StageRun& a, const StageRun& b) {
        return a.usage.peak_memory_mb < b.usage.peak_memory_mb;
    });
}

// From here to the next call the report says where it would have stopped.
void enter(CookReport& report, const CookRequest& request, std::string_view place) {
    report.stopped_in = place;
    if (request.keep_report) request.keep_report(report);
}

// Stage by stage, so that the report holds what ran before something stopped it.
Workspace run_stages(const Recipe& recipe, const CookRequest& request, unsigned jobs, const Observer& observer,
                     CookReport& report) {
    Workspace work;
    work.sources = request.sources;
    for (std::size_t i = 0; i < stage_table().size(); ++i) {
        enter(report, request, stage_table()[i].name);
        report.stages.push_back(run_stage(stage_table()[i], recipe.params[i], work, jobs, observer));
        report.inputs = cook_record(work).inputs;
    }
    return work;
}

// Another number of threads than the first time, so that work is cut differently.
unsigned other_jobs(unsigned jobs) { return jobs == 1 ? 3 : 1; }

void check_determinism(const Recipe& recipe, const CookRequest& request, const std::vector<std::byte>& image,
                       CookReport& report) {
    enter(report, request, "check_determinism");
    CookRequest again_request = request;
    again_request.keep_report = {};
    CookReport again_report;
    const unsigned jobs = other_jobs(request.jobs);
    const Workspace again = run_stages(recipe, again_request, jobs, {}, again_report);
    const std::vector<std::byte> other = work_image(again, request.contents);
    if (other != image) {
        const CompareReport difference = compare_images(image, "first cook", other, "second cook");
        throw Error(ErrorKind::difference, "cooked twice, with --jobs " + std::to_string(request.jobs) + " and " +
                                               std::to_string(jobs) + ": the results differ, first in " +
                                               difference.first);
    }
    report.determinism_jobs = jobs;
}

}

void cook(const Recipe& recipe, const CookRequest& request, CookReport& report, const Observer& observer) {
    const UsageMeter meter;
    report.tool_version = tool_version();
    report.params.text = canonical_json(recipe);
    report.jobs = request.jobs;
    std::vector<std::byte> image;
    {
        const Workspace work = run_stages(recipe, request, request.jobs, observer, report);
        image = work_image(work, request.contents);
    }
    report.output.bytes = image.size();
    report.output.sha256 = store::to_hex(store::sha256(image));
    if (request.checks_determinism) check_determinism(recipe, request, image, report);
    report.usage = meter.read();
    const StageRun& largest = largest_of(report.stages);
    report.usage.peak_memory_mb = std::max(report.usage.peak_memory_mb, largest.usage.peak_memory_mb);
    enter(report, request, "write");
    if (request.may_finish) request.may_finish(report.usage.peak_memory_mb, largest.name);
    if (report.stages.back().is_rejected()) {
        report.output.is_rejected = true;
        report.stopped_in = report.stages.back().name;
        reject(report.stages.back().findings, request.output, image);
    }
    report.output.is_unchanged = holds(request.output, image);
    report.stopped_in.clear();
    if (request.before_output) request.before_output(report);
    report.stopped_in = "write";
    accept(request.output, image);
    report.stopped_in.clear();
}

}
