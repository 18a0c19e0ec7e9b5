// SPDX-License-Identifier: GPL-3.0-or-later
#include "gates/judgement.h"

#include <cstdarg>
#include <cstdio>
#include <utility>

namespace crumple::gates {

std::string format(const char* pattern, ...) {
    char text[512];
    std::va_list arguments;
    va_start(arguments, pattern);
    std::vsnprintf(text, sizeof text, pattern, arguments);
    va_end(arguments);
    return text;
}

void Judgement::ask(const char* code, const std::string& what, double value, const Gate& gate, Wanted wanted,
                    const std::function<Told()>& tell) {
    const bool fails = is_beyond(value, gate.fail, wanted);
    if (!fails && !is_beyond(value, gate.warn, wanted)) return;
    Told told = tell();
    const double limit = fails ? gate.fail : gate.warn;
    findings.push_back(
        {code, fails ? Severity::error : Severity::warning,
         what + format(" is %.4g, %s %.4g; ", value, wanted == Wanted::high ? "below" : "above", limit) + told.remedy,
         told.count, std::move(told.places)});
}

}
