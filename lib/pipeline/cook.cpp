// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/cook.h"

#include <algorithm>

#include "pipeline/compare.h"
#include "pipeline/input_digests.h"
#include "pipeline/version.h"
#include "store/sha256.h"

namespace crumple::pipeline {

namespace {

double peak_of(const std::vector<StageRun>& runs) {
    double peak = 0;
    for (const StageRun& run : runs) peak = std::max(peak, run.usage.peak_memory_mb);
    return peak;
}

// Stage by stage, so that the report holds what ran before something stopped it.
Workspace run_stages(const Recipe& recipe, const CookRequest& request, unsigned jobs, const Observer& observer,
                     std::vector<StageRun>& runs) {
    Workspace work;
    work.sources = request.sources;
    for (std::size_t i = 0; i < stage_table().size(); ++i) {
        runs.push_back(run_stage(stage_table()[i], recipe.params[i], work, jobs, observer));
    }
    return work;
}

// Another number of threads than the first time, so that work is cut differently.
unsigned other_jobs(unsigned jobs) { return jobs == 1 ? 3 : 1; }

void check_determinism(const Recipe& recipe, const CookRequest& request, const std::vector<std::byte>& image,
                       CookReport& report) {
    std::vector<StageRun> runs;
    const unsigned jobs = other_jobs(request.jobs);
    const Workspace again = run_stages(recipe, request, jobs, {}, runs);
    const std::vector<std::byte> other = work_image(again, request.contents);
    if (other != image) {
        const CompareReport difference = compare_images(image, "first cook", other, "second cook");
        throw Error(ErrorKind::difference, "cooked twice, " + std::to_string(request.jobs) + " and " +
                                               std::to_string(jobs) + " threads: the results differ, first in " +
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
        const Workspace work = run_stages(recipe, request, request.jobs, observer, report.stages);
        report.inputs = cook_record(work).inputs;
        image = work_image(work, request.contents);
    }
    report.output.bytes = image.size();
    report.output.sha256 = store::to_hex(store::sha256(image));
    if (request.checks_determinism) check_determinism(recipe, request, image, report);
    report.usage = meter.read();
    report.usage.peak_memory_mb = std::max(report.usage.peak_memory_mb, peak_of(report.stages));
    if (request.may_finish) request.may_finish(report.usage.peak_memory_mb);
    report.output.is_unchanged = !write_if_changed(request.output, image);
}

}
