// SPDX-License-Identifier: GPL-3.0-or-later
// How well the tets keep to the artist's shell: measured again where a file still holds shell and tets, else as the
// cook stored it.
#pragma once
#include "pipeline/workspace.h"

namespace crumple::pipeline {

enum class Source { none, stored, measured };
inline constexpr EnumName<Source> source_names[] = {
    {Source::none, "none"}, {Source::stored, "stored"}, {Source::measured, "measured"}};
constexpr std::span<const EnumName<Source>> enum_names(Source) { return source_names; }

struct ShellFigures {
    Source source = Source::none;
    double volume_error = 0;
    double hausdorff_out = 0;
    double hausdorff_in = 0;
};

template <class Visitor, FieldsOf<ShellFigures> F>
void describe(Visitor& visit, F& f) {
    visit.field("source", f.source, "measured on the file's own shell, or stored when it was cooked");
    visit.field("volume_error", f.volume_error, "|volume - shell volume| / shell volume");
    visit.field("hausdorff_out", f.hausdorff_out, "farthest the tets' surface strays, share of the shell's diagonal");
    visit.field("hausdorff_in", f.hausdorff_in, "farthest the solid's surface strays from the tets', the same");
}

// The volume of a shell that is open or crosses itself needs the tets that cull threw away: it stays as stored.
[[nodiscard]] ShellFigures shell_figures(const Workspace& workspace);

}
