// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace crumple::bench {

// CPU seconds this process has used: unlike the wall clock it does not count what others do meanwhile.
[[nodiscard]] double cpu_seconds();

}
