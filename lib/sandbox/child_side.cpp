// SPDX-License-Identifier: GPL-3.0-or-later
#include "sandbox/child_side.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <exception>
#include <new>
#include <string>

#include "core/error.h"
#include "sandbox/process_memory.h"

namespace crumple::sandbox {

namespace {

void end_with_parent([[maybe_unused]] int parent_pid) {
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent_pid) _exit(1);  // it went before we asked
#endif
}

// Handlers of the parent (a cancelled cook, say) have no business here.
void take_default_signals() {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL, SIGXFSZ}) {
        // The sanitizers' own handlers report and exit, which is what their builds are for.
        if (!has_sanitizer || signal == SIGINT || signal == SIGTERM || signal == SIGHUP) std::signal(signal, SIG_DFL);
    }
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
}

void silence() {
    const int null_fd = open("/dev/null", O_RDWR);
    if (null_fd < 0) {
        for (int fd = 0; fd < 3; ++fd) close(fd);
        return;
    }
    for (int fd = 0; fd < 3; ++fd) {
        if (fd != null_fd) dup2(null_fd, fd);
    }
    if (null_fd > 2) close(null_fd);
}

void set_limit(decltype(RLIMIT_CORE) what, std::size_t bytes) {
    rlimit limit{};
    if (getrlimit(what, &limit) != 0) return;
    limit.rlim_cur = std::min<rlim_t>(bytes, limit.rlim_max);
    setrlimit(what, &limit);
}

bool write_all(int fd, const void* data, std::size_t size) {
    const char* next = static_cast<const char*>(data);
    while (size > 0) {
        const ssize_t written = write(fd, next, std::min(size, std::size_t{1} << 20));
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        next += written;
        size -= static_cast<std::size_t>(written);
    }
    return true;
}

[[noreturn]] void answer(int fd, Ending ending, ErrorKind kind, const void* data, std::size_t size) {
    FrameHeader header;
    header.ending = static_cast<std::uint32_t>(ending);
    header.error_kind = static_cast<std::uint32_t>(kind);
    header.size = size;
    const bool written = write_all(fd, &header, sizeof header) && write_all(fd, data, size);
    _exit(written ? 0 : 1);
}

[[noreturn]] void refuse(int fd, ErrorKind kind, const char* message) {
    answer(fd, Ending::refused, kind, message, std::char_traits<char>::length(message));
}

}

void be_the_child(int pipe_fd, int parent_pid, const std::function<std::vector<std::byte>()>& function,
                  const Limits& limits) noexcept {
    end_with_parent(parent_pid);
    take_default_signals();
    silence();
    set_limit(RLIMIT_CORE, 0);
    if (!has_sanitizer) {
        // The fork shares our mappings, and they count: the limit is on what comes on top.
        const std::size_t in_use = memory_of(getpid()).address_space;
        if (limits.memory_bytes < RLIM_INFINITY - in_use) set_limit(RLIMIT_AS, in_use + limits.memory_bytes);
    }
    try {
        const std::vector<std::byte> bytes = function();
        answer(pipe_fd, Ending::ok, {}, bytes.data(), bytes.size());
    } catch (const Error& error) {
        refuse(pipe_fd, error.kind(), error.what());
    } catch (const std::bad_alloc&) {
        answer(pipe_fd, Ending::out_of_memory, {}, nullptr, 0);
    } catch (const std::exception& error) {
        refuse(pipe_fd, ErrorKind::bad_input, error.what());
    } catch (...) {
        refuse(pipe_fd, ErrorKind::bad_input, "the reader stopped with an unknown exception");
    }
}

}
