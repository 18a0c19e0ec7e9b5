// SPDX-License-Identifier: GPL-3.0-or-later
// One line of `--progress json`. stderr then holds nothing else.
#pragma once
#include <string>

#include "pipeline/usage.h"

namespace crumple::pipeline {

enum class ProgressEvent { begin, step, end, error };
inline constexpr EnumName<ProgressEvent> progress_event_names[] = {{ProgressEvent::begin, "begin"},
                                                                   {ProgressEvent::step, "step"},
                                                                   {ProgressEvent::end, "end"},
                                                                   {ProgressEvent::error, "error"}};
constexpr std::span<const EnumName<ProgressEvent>> enum_names(ProgressEvent) { return progress_event_names; }

struct ProgressLine {
    ProgressEvent event = ProgressEvent::begin;
    std::string stage;
    std::string step;
    double fraction = 0;
    Usage usage;
    std::string message;
};

template <class Visitor, FieldsOf<ProgressLine> L>
void describe(Visitor& visit, L& l) {
    visit.field("event", l.event, "a stage began, came a step further or ended; or an error, which is the last line");
    visit.field("stage", l.stage, "which; empty for an error");
    visit.field("step", l.step, "what it is at; empty at begin and end");
    visit.field("fraction", l.fraction, "of the stage, 0 to 1");
    visit.field("usage", l.usage, "what the stage cost up to here; zeros when it begins");
    visit.field("message", l.message, "what went wrong, empty without error");
}

}
