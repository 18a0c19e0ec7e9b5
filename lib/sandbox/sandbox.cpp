// SPDX-License-Identifier: GPL-3.0-or-later
#include "sandbox/sandbox.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <optional>
#include <string>
#include <utility>

#include "core/error.h"
#include "core/file_descriptor.h"
#include "sandbox/child_side.h"
#include "sandbox/process_memory.h"

namespace crumple::sandbox {

namespace {

using Clock = std::chrono::steady_clock;

// How often the resident memory is looked at where an address-space limit is not possible.
constexpr int watch_ms = 10;
constexpr int max_wait_ms = 1000;

[[noreturn]] void cannot_start(const char* what) {
    throw Error(ErrorKind::internal,
                std::string("cannot start a child process: ") + what + ": " + std::strerror(errno));
}

struct Pipe {
    FileDescriptor read_end;
    FileDescriptor write_end;
};

// Where our own stdin, stdout or stderr are closed, a new descriptor may be 0, 1 or 2: the child will put /dev/null
// there.
FileDescriptor above_standard_streams(FileDescriptor fd) {
    if (fd.id() > 2) return fd;
    FileDescriptor moved(fcntl(fd.id(), F_DUPFD_CLOEXEC, 3));
    if (moved.id() < 0) cannot_start("fcntl");
    return moved;
}

Pipe open_pipe() {
    int fds[2];
    if (pipe(fds) != 0) cannot_start("pipe");
    Pipe result{FileDescriptor(fds[0]), FileDescriptor(fds[1])};
    for (const int fd : fds) fcntl(fd, F_SETFD, FD_CLOEXEC);
    result.read_end = above_standard_streams(std::move(result.read_end));
    result.write_end = above_standard_streams(std::move(result.write_end));
    return result;
}

// Owns a running child: it is gone, and no zombie, when this is.
class Child {
public:
    explicit Child(pid_t pid) : pid_(pid) {}
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    ~Child() {
        if (pid_ <= 0) return;
        kill(pid_, SIGKILL);
        (void)wait_status();
    }

    // Nothing where somebody else reaps our children (SIGCHLD ignored).
    std::optional<int> wait_status() {
        int status = 0;
        pid_t waited = -1;
        do {
            waited = waitpid(pid_, &status, 0);
        } while (waited < 0 && errno == EINTR);
        pid_ = -1;
        return waited < 0 ? std::nullopt : std::optional<int>(status);
    }

    [[nodiscard]] std::uint64_t resident_bytes() const { return memory_of(pid_).resident; }

private:
    pid_t pid_;
};

Outcome ended(Ending ending, std::string message) {
    Outcome outcome;
    outcome.ending = ending;
    outcome.message = std::move(message);
    return outcome;
}

Outcome out_of_time(const Limits& limits) {
    char text[64];
    std::snprintf(text, sizeof text, "not done within %g s", limits.time_s);
    return ended(Ending::out_of_time, text);
}

std::string mebibytes(std::uint64_t bytes) { return std::to_string(bytes >> 20) + " MiB of memory"; }

Outcome out_of_memory(const Limits& limits) {
    return ended(Ending::out_of_memory, "more than " + mebibytes(limits.memory_bytes));
}

// What the system lets a child take beyond what we use.
std::uint64_t room_for_a_child() {
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_max == RLIM_INFINITY) return RLIM_INFINITY;
    const std::uint64_t in_use = memory_of(getpid()).address_space;
    return limit.rlim_max > in_use ? limit.rlim_max - in_use : 0;
}

Outcome starved(std::uint64_t room) {
    return ended(Ending::starved,
                 "it takes more than the " + mebibytes(room) + " that the system leaves for it; raise ulimit -v");
}

Outcome no_memory_left(const Limits& limits) {
    const std::uint64_t room = room_for_a_child();
    return room < limits.memory_bytes ? starved(room) : out_of_memory(limits);
}

const char* signal_name(int signal) {
    switch (signal) {
        case SIGSEGV:
            return "SIGSEGV";
        case SIGBUS:
            return "SIGBUS";
        case SIGABRT:
            return "SIGABRT";
        case SIGFPE:
            return "SIGFPE";
        case SIGILL:
            return "SIGILL";
        case SIGKILL:
            return "SIGKILL";
        case SIGTERM:
            return "SIGTERM";
        case SIGXCPU:
            return "SIGXCPU";
        default:
            return nullptr;
    }
}

Outcome died(std::optional<int> status) {
    // With less, not even a stack can grow, and a crash says nothing of the file.
    constexpr std::uint64_t least_room = std::uint64_t{16} << 20;
    if (const std::uint64_t room = room_for_a_child(); room < least_room) return starved(room);
    if (!status) return ended(Ending::crashed, "ended without an answer");
    if (WIFEXITED(*status)) {
        return ended(Ending::crashed, "ended with status " + std::to_string(WEXITSTATUS(*status)) + " and no answer");
    }
    const int signal = WTERMSIG(*status);
    const char* name = signal_name(signal);
    return ended(Ending::crashed, name ? name : "signal " + std::to_string(signal));
}

enum class Progress { more, closed, time_is_up, memory_is_up };

// Waits until the pipe has something to read, is closed, or a limit is met.
Progress wait_for_more(int fd, const Child& child, const Limits& limits, Clock::time_point start) {
    for (;;) {
        const double left_s = limits.time_s - std::chrono::duration<double>(Clock::now() - start).count();
        if (left_s <= 0) return Progress::time_is_up;
        if (has_sanitizer && child.resident_bytes() > limits.memory_bytes) return Progress::memory_is_up;
        const double longest_ms = has_sanitizer ? watch_ms : max_wait_ms;
        pollfd ready{fd, POLLIN, 0};
        const int count = poll(&ready, 1, static_cast<int>(std::min(longest_ms, left_s * 1000)) + 1);
        if (count > 0) return Progress::more;  // data or hang-up: read tells which
        if (count < 0 && errno != EINTR) return Progress::closed;
    }
}

// Reads up to size bytes; fewer when the child closes the pipe. Memory grows with what came, not with what was
// announced.
Progress read_exactly(int fd, std::size_t size, std::vector<std::byte>& bytes, const Child& child, const Limits& limits,
                      Clock::time_point start) {
    constexpr std::size_t chunk = std::size_t{1} << 20;
    std::size_t have = 0;
    bytes.clear();
    while (have < size) {
        const Progress progress = wait_for_more(fd, child, limits, start);
        if (progress != Progress::more) return progress;
        if (bytes.size() == have) bytes.resize(std::min(size, std::max(have * 2, chunk)));
        const ssize_t count = read(fd, bytes.data() + have, bytes.size() - have);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return Progress::closed;
        have += static_cast<std::size_t>(count);
    }
    return Progress::more;
}

// The ending a limit has, nothing while all is well.
std::optional<Outcome> stopped(Progress progress, const Limits& limits) {
    if (progress == Progress::time_is_up) return out_of_time(limits);
    if (progress == Progress::memory_is_up) return out_of_memory(limits);
    return std::nullopt;
}

// What a child says may be anything.
ErrorKind kind_of(const FrameHeader& header) {
    constexpr auto last = static_cast<std::uint32_t>(ErrorKind::difference);
    return header.error_kind <= last ? static_cast<ErrorKind>(header.error_kind) : ErrorKind::bad_input;
}

Outcome receive(int fd, Child& child, const Limits& limits) {
    const auto start = Clock::now();
    std::vector<std::byte> bytes;
    Progress progress = read_exactly(fd, sizeof(FrameHeader), bytes, child, limits, start);
    if (auto limit = stopped(progress, limits)) return *limit;
    if (progress == Progress::closed) return died(child.wait_status());

    FrameHeader header;
    std::memcpy(&header, bytes.data(), sizeof header);
    if (header.magic != FrameHeader::frame_magic) return ended(Ending::crashed, "answered in an unknown form");
    if (header.size > limits.answer_bytes) {
        return ended(Ending::out_of_memory,
                     "an answer of " + std::to_string(header.size) + " bytes, more than the limit");
    }
    progress = read_exactly(fd, static_cast<std::size_t>(header.size), bytes, child, limits, start);
    if (auto limit = stopped(progress, limits)) return *limit;
    if (progress == Progress::closed) return died(child.wait_status());

    const auto ending = static_cast<Ending>(header.ending);
    if (ending == Ending::out_of_memory) return no_memory_left(limits);
    Outcome outcome;
    outcome.ending = ending == Ending::ok ? Ending::ok : Ending::refused;
    outcome.kind = kind_of(header);
    if (outcome.ending == Ending::ok) {
        outcome.answer = std::move(bytes);
    } else {
        outcome.message.assign(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    }
    return outcome;
}

}

Outcome run_in_child(const std::function<std::vector<std::byte>()>& function, const Limits& limits) {
    Pipe pipe = open_pipe();
    const pid_t parent = getpid();
    const pid_t pid = fork();
    if (pid < 0) cannot_start("fork");
    if (pid == 0) {
        pipe.read_end.close();
        be_the_child(pipe.write_end.id(), parent, function, limits);
    }
    Child child(pid);
    pipe.write_end.close();
    return receive(pipe.read_end.id(), child, limits);
}

}
