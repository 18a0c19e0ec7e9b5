// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace crumple::bench {

// CPU seconds this process, or the calling thread, has used: unlike the wall clock they do not count what others do
// meanwhile.
[[nodiscard]] double cpu_seconds();
[[nodiscard]] double thread_cpu_seconds();

}
