// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/source_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "core/error.h"

namespace crumple::importer {

namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

[[noreturn]] void fail(const std::string& what) { throw Error(ErrorKind::file, what); }

// Not blocking: opening a pipe nobody writes to would wait for ever.
File open_plain(const std::string& path) {
    const int fd = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (fd < 0) fail(std::string("cannot be opened: ") + std::strerror(errno));
    File file(fdopen(fd, "rb"), &std::fclose);
    if (!file) {
        close(fd);
        fail("cannot be opened");
    }
    struct stat status {};
    if (fstat(fd, &status) != 0) fail(std::string("cannot be read: ") + std::strerror(errno));
    if (S_ISDIR(status.st_mode)) fail("is a folder; a file was expected");
    if (!S_ISREG(status.st_mode)) fail("is a device or pipe; a file was expected");
    return file;
}

}

void check_can_open(const std::string& path) { (void)open_plain(path); }

std::string read_file(const std::string& path) {
    const File file = open_plain(path);
    std::string bytes;
    constexpr std::size_t chunk = std::size_t{1} << 20;
    for (;;) {
        const std::size_t have = bytes.size();
        bytes.resize(have + chunk);
        const std::size_t read = std::fread(bytes.data() + have, 1, chunk, file.get());
        bytes.resize(have + read);
        if (read < chunk) break;
    }
    if (std::ferror(file.get())) fail(std::string("cannot be read: ") + std::strerror(errno));
    return bytes;
}

}
