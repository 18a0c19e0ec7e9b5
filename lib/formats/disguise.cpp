// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/disguise.h"

#include <string_view>

#include "core/error.h"

namespace crumple::formats {

namespace {

[[noreturn]] void refuse(const char* what) { throw Error(ErrorKind::bad_input, what); }

bool is_line_by_line(FormatId format) { return format == FormatId::obj || format == FormatId::off; }

}

void undisguise(std::string& bytes, FormatId format) {
    if (bytes.starts_with("version https://git-lfs.github.com/"))
        refuse("it is a pointer of Git LFS, not the file itself; fetch it with git lfs pull");
    if (bytes.starts_with("\xef\xbb\xbf")) bytes.erase(0, 3);
    if (!is_line_by_line(format)) return;
    if (bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff"))
        refuse("it is text in UTF-16; save it as UTF-8 or ASCII");
    if (bytes.find('\r') != std::string::npos && bytes.find('\n') == std::string::npos)
        refuse("its lines end in carriage returns alone; save it with line feeds");
}

}
