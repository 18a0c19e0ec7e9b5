// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/memory_files.h"

#include <assimp/MemoryIOWrapper.h>

namespace crumple::importer {

const std::string_view* MemoryFiles::find(std::string_view name) const {
    auto found = files_.find(name);
    if (found == files_.end()) found = files_.find(name.substr(name.rfind('/') + 1));
    return found == files_.end() ? nullptr : &found->second;
}

Assimp::IOStream* MemoryFiles::Open(const char* name, const char* mode) {
    const std::string_view* bytes = find(name);
    if (!bytes || std::string_view(mode).find('w') != std::string_view::npos) return nullptr;
    return new Assimp::MemoryIOStream(reinterpret_cast<const std::uint8_t*>(bytes->data()), bytes->size());
}

void MemoryFiles::Close(Assimp::IOStream* stream) { delete stream; }

}
