// SPDX-License-Identifier: GPL-3.0-or-later
// What a file is when it is not what its name says: what editors, mail and version control make of files.
#pragma once
#include <string>

#include "formats/format.h"

namespace crumple::formats {

// Takes a byte order mark away. Throws Error(bad_input) for a pointer of Git LFS, and for text in UTF-16 or with lines
// that end in a carriage return alone, which assimp reads as something else.
void undisguise(std::string& bytes, FormatId format);

}
