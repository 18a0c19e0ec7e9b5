// SPDX-License-Identifier: GPL-3.0-or-later
#include "sandbox/shared_text.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>

namespace crumple::sandbox {

namespace {

constexpr std::uint64_t nothing = ~std::uint64_t{0};

// Calls transfer(done) until it has moved all `count` bytes; what it returns is how many it moved.
template <class Transfer>
bool move_all(std::uint64_t count, const Transfer& transfer) {
    std::uint64_t done = 0;
    while (done < count) {
        const ssize_t moved = transfer(done);
        if (moved < 0 && errno == EINTR) continue;
        if (moved <= 0) return false;
        done += static_cast<std::uint64_t>(moved);
    }
    return true;
}

bool write_at(int file, const char* bytes, std::uint64_t count, std::uint64_t offset) {
    return move_all(count, [&](std::uint64_t done) {
        return ::pwrite(file, bytes + done, count - done, static_cast<off_t>(offset + done));
    });
}

bool read_at(int file, char* bytes, std::uint64_t count, std::uint64_t offset) {
    return move_all(count, [&](std::uint64_t done) {
        return ::pread(file, bytes + done, count - done, static_cast<off_t>(offset + done));
    });
}

}

SharedText::SharedText() : file_(::memfd_create("crumple", MFD_CLOEXEC)), begin_(nothing) {
    if (file_.id() < 0) throw Error(ErrorKind::internal, "no memory to share with a child process");
}

void SharedText::write(std::string_view text) {
    const std::uint64_t size = text.size();
    const bool is_whole = write_at(file_.id(), reinterpret_cast<const char*>(&size), sizeof size, end_) &&
                          write_at(file_.id(), text.data(), size, end_ + sizeof size);
    if (!is_whole) return;
    (*begin_).store(end_);
    end_ += sizeof size + size;
}

std::string SharedText::read() const {
    const std::uint64_t begin = (*begin_).load();
    std::uint64_t size = 0;
    if (begin == nothing || !read_at(file_.id(), reinterpret_cast<char*>(&size), sizeof size, begin)) return {};
    std::string text(size, '\0');
    return read_at(file_.id(), text.data(), size, begin + sizeof size) ? text : std::string();
}

}
