// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/source_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "core/error.h"

namespace crumple::importer {

std::string read_file(const std::string& path) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
    if (!file) throw Error(ErrorKind::file, std::string("cannot be opened: ") + std::strerror(errno));
    std::string bytes;
    constexpr std::size_t chunk = std::size_t{1} << 20;
    for (;;) {
        const std::size_t have = bytes.size();
        bytes.resize(have + chunk);
        const std::size_t read = std::fread(bytes.data() + have, 1, chunk, file.get());
        bytes.resize(have + read);
        if (read < chunk) break;
    }
    if (std::ferror(file.get())) throw Error(ErrorKind::file, std::string("cannot be read: ") + std::strerror(errno));
    return bytes;
}

}
