// SPDX-License-Identifier: MIT
#include "store/read_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "core/error.h"
#include "core/file_descriptor.h"

namespace crumple::store {
namespace {

[[noreturn]] void fail(const std::string& path, const std::string& why) {
    if (path.empty()) throw Error(ErrorKind::file, "the path of a file to read is empty");
    throw Error(ErrorKind::file, path + ": cannot be read: " + why);
}

}

std::vector<std::byte> read_file(const std::string& path) {
    // Not blocking: opening a pipe nobody writes to would otherwise wait for ever.
    const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (file.id() < 0) fail(path, std::strerror(errno));
    struct stat status {};
    if (::fstat(file.id(), &status) != 0) fail(path, std::strerror(errno));
    if (S_ISDIR(status.st_mode)) fail(path, "it is a folder");
    if (!S_ISREG(status.st_mode)) fail(path, "it is not a plain file");
    std::vector<std::byte> bytes(static_cast<std::size_t>(status.st_size));
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t count = ::read(file.id(), bytes.data() + done, bytes.size() - done);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) fail(path, std::strerror(errno));
        if (count == 0) break;  // it shrank while we read
        done += static_cast<std::size_t>(count);
    }
    bytes.resize(done);
    return bytes;
}

}
