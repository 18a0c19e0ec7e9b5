// SPDX-License-Identifier: GPL-3.0-or-later
// One line of `--progress json`.
#pragma once
#include <string>

#include "pipeline/usage.h"

namespace crumple::pipeline {

enum class ProgressEvent { begin, step, end };
inline constexpr EnumName<ProgressEvent> progress_event_names[] = {
    {ProgressEvent::begin, "begin"}, {ProgressEvent::step, "step"}, {ProgressEvent::end, "end"}};
constexpr std::span<const EnumName<ProgressEvent>> enum_names(ProgressEvent) { return progress_event_names; }

struct ProgressLine {
    ProgressEvent event = ProgressEvent::begin;
    std::string stage;
    std::string step;
    double fraction = 0;
    Usage usage;
};

template <class Visitor, FieldsOf<ProgressLine> L>
void describe(Visitor& visit, L& l) {
    visit.field("event", l.event, "a stage began, came a step further, or ended");
    visit.field("stage", l.stage, "which");
    visit.field("step", l.step, "what it is at; empty at begin and end");
    visit.field("fraction", l.fraction, "of the stage, 0 to 1");
    visit.field("usage", l.usage, "what the stage cost; zeros before its end");
}

}
