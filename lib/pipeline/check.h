// SPDX-License-Identifier: GPL-3.0-or-later
// Is a file what it was when it was written, and is what it says true: `crumple check`.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "core/finding.h"
#include "pipeline/bundle_gates.h"
#include "pipeline/exit_codes.h"
#include "pipeline/workspace.h"
#include "quality/figures.h"
#include "report/described.h"

namespace crumple::pipeline {

struct StageFindings {
    std::string stage;
    std::vector<Finding> findings;
};

template <class Visitor, FieldsOf<StageFindings> S>
void describe(Visitor& visit, S& s) {
    visit.field("stage", s.stage, "who found it, while cooking");
    visit.field("findings", s.findings, "what a person should know");
}

struct FileCheck {
    std::string path;
    int exit_code = exit_ok;
    std::string error;              // why it could not be checked to the end
    std::string digest;             // of the content, whatever the layout
    std::vector<Finding> problems;  // digests that are wrong, invariants that do not hold
    std::vector<Finding> findings;  // gates that are not met, measured on the file itself
    quality::Figures figures;
    ShellFigures shell = ShellFigures::none;
    std::vector<StageFindings> stages;  // stored when it was cooked: what needs the shell is told by these
    std::vector<StageRecord> record;
};

template <class Visitor, FieldsOf<FileCheck> C>
void describe(Visitor& visit, C& c) {
    visit.field("path", c.path, "as given");
    visit.field("exit_code", c.exit_code,
                "0: whole, true and good; 4: a quality gate is not met; 7: damaged or untrue; 2: cannot be opened; "
                "6: the system leaves too little memory to read it");
    visit.field("error", c.error, "why it could not be checked to the end");
    visit.field("digest", c.digest, "of all datasets and attributes: equal for equal content whatever the layout");
    visit.field("problems", c.problems, "digests that are wrong, invariants that do not hold");
    visit.field("findings", c.findings, "quality gates that are not met");
    visit.field("figures", c.figures, "what the gates were asked of; of a work file without bundle only the shapes");
    visit.field("shell", c.shell,
                "the figures that need the shell: measured on the file's own, or stored when it was cooked");
    visit.field("stages", c.stages, "findings stored when it was cooked");
    visit.field("record", c.record, "reports stored when it was cooked");
}

struct CheckReport {
    std::string schema = "crumple/check/2";
    int exit_code = exit_ok;
    std::vector<FileCheck> files;
};

template <class Visitor, FieldsOf<CheckReport> R>
void describe(Visitor& visit, R& r) {
    visit.field("schema", r.schema, "name and version of this form");
    visit.field("exit_code", r.exit_code, "of the whole: the first of 5 2 7 3 6 4 0 that occurred");
    visit.field("files", r.files, "in the order given");
}

// Throws Error(bad_input) for a damaged image. A problem means exit code 7, a gate that fails 4: the gates of the
// recipe it was cooked with, so that what `cook` accepted passes.
[[nodiscard]] FileCheck check_image(std::vector<std::byte> image, const std::string& name);

// In a child process with limits; never throws: what went wrong is in the answer.
[[nodiscard]] FileCheck check_file(const std::string& path);

[[nodiscard]] std::string check_text(const FileCheck& check, bool has_color, bool is_verbose);

}
