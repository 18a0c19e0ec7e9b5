// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/guarded.h"

#include <exception>
#include <new>
#include <string>

#include "pipeline/exit_codes.h"

namespace crumple::cli {

int run_guarded(const Console& console, const std::function<int()>& work) {
    try {
        return work();
    } catch (const Error& error) {
        console.error(error.what());
        return pipeline::exit_code_of(error.kind());
    } catch (const std::bad_alloc&) {
        console.error("out of memory");
        return pipeline::exit_code_of(ErrorKind::budget);
    } catch (const std::exception& error) {
        console.error(std::string("internal: ") + error.what());
        return pipeline::exit_internal;
    }
}

}
