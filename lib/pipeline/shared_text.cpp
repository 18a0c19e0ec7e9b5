// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/shared_text.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <new>

#include "core/error.h"

namespace crumple::pipeline {

namespace {

constexpr std::uint64_t nothing = ~std::uint64_t{0};

bool write_at(int file, const char* bytes, std::uint64_t count, std::uint64_t offset) {
    while (count > 0) {
        const ssize_t done = ::pwrite(file, bytes, count, static_cast<off_t>(offset));
        if (done < 0 && errno == EINTR) continue;
        if (done <= 0) return false;
        bytes += done;
        count -= static_cast<std::uint64_t>(done);
        offset += static_cast<std::uint64_t>(done);
    }
    return true;
}

bool read_at(int file, char* bytes, std::uint64_t count, std::uint64_t offset) {
    while (count > 0) {
        const ssize_t done = ::pread(file, bytes, count, static_cast<off_t>(offset));
        if (done < 0 && errno == EINTR) continue;
        if (done <= 0) return false;
        bytes += done;
        count -= static_cast<std::uint64_t>(done);
        offset += static_cast<std::uint64_t>(done);
    }
    return true;
}

}

SharedText::SharedText() : file_(::memfd_create("crumple", MFD_CLOEXEC)) {
    void* page = ::mmap(nullptr, sizeof *begin_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (file_ < 0 || page == MAP_FAILED) {
        if (file_ >= 0) ::close(file_);
        throw Error(ErrorKind::internal, "no memory to share with a child process");
    }
    begin_ = new (page) std::atomic<std::uint64_t>(nothing);
}

SharedText::~SharedText() {
    ::munmap(begin_, sizeof *begin_);
    ::close(file_);
}

void SharedText::write(std::string_view text) {
    const std::uint64_t size = text.size();
    const bool is_whole = write_at(file_, reinterpret_cast<const char*>(&size), sizeof size, end_) &&
                          write_at(file_, text.data(), size, end_ + sizeof size);
    if (!is_whole) return;
    begin_->store(end_);
    end_ += sizeof size + size;
}

std::string SharedText::read() const {
    const std::uint64_t begin = begin_->load();
    std::uint64_t size = 0;
    if (begin == nothing || !read_at(file_, reinterpret_cast<char*>(&size), sizeof size, begin)) return {};
    std::string text(size, '\0');
    return read_at(file_, text.data(), size, begin + sizeof size) ? text : std::string();
}

}
