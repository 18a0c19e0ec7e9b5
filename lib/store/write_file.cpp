// SPDX-License-Identifier: MIT
#include "store/write_file.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

#include "core/error.h"
#include "core/file_descriptor.h"

namespace crumple::store {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& why) {
    if (path.empty()) throw Error(ErrorKind::file, "the path of a file to write is empty");
    throw Error(ErrorKind::file, path.string() + ": cannot be written: " + why);
}

std::string reason(int error) {
    if (error == ENOSPC || error == EDQUOT) return "the disk is full";
    if (error == EFBIG) return "it would exceed the size limit for files";
    return std::strerror(error);
}

// Where the bytes will really go. A dangling link counts as the file it points to.
fs::path follow_links(const std::string& path) {
    fs::path target = path;
    for (int step = 0; step < 40; ++step) {
        std::error_code error;
        if (!fs::is_symlink(fs::symlink_status(target, error))) return target;
        const fs::path next = fs::read_symlink(target, error);
        if (error) fail(path, error.message());
        target = next.is_absolute() ? next : target.parent_path() / next;
    }
    fail(path, "too many links");
}

fs::path folder_of(const fs::path& target) { return target.has_parent_path() ? target.parent_path() : fs::path("."); }

// A rename would replace a file that nobody may write; who protects a file does not expect that.
void check_may_replace(const fs::path& path, const fs::path& target, const fs::file_status& status) {
    constexpr fs::perms any_write = fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
    if ((status.permissions() & any_write) == fs::perms::none)
        fail(path, "it is there already and read-only; make it writable (chmod u+w) or remove it");
    if (::faccessat(AT_FDCWD, target.c_str(), W_OK, AT_EACCESS) != 0)
        fail(path, "it is there already and belongs to others: " + reason(errno));
}

fs::path checked_target(const std::string& path) {
    const fs::path target = follow_links(path);
    std::error_code error;
    const fs::file_status status = fs::status(target, error);
    if (error && status.type() == fs::file_type::none) fail(path, error.message());
    if (path.empty() || !target.has_filename()) fail(path, "it names no file");
    if (fs::is_directory(status)) fail(path, "it is a folder");
    if (fs::exists(status) && !fs::is_regular_file(status)) fail(path, "it is not a plain file");
    if (fs::exists(status)) check_may_replace(path, target, status);
    if (!fs::is_directory(folder_of(target), error))
        fail(path, "the folder " + folder_of(target).string() + " does not exist");
    return target;
}

// While it lives, a write past RLIMIT_FSIZE returns EFBIG to this thread instead of killing the process.
class SizeSignalBlock {
public:
    SizeSignalBlock() {
        ::sigemptyset(&signals_);
        ::sigaddset(&signals_, SIGXFSZ);
        ::pthread_sigmask(SIG_BLOCK, &signals_, &before_);
    }
    ~SizeSignalBlock() {
        const int error = errno;
        const timespec now{};
        while (::sigtimedwait(&signals_, nullptr, &now) == SIGXFSZ) {
        }
        ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
        errno = error;
    }
    SizeSignalBlock(const SizeSignalBlock&) = delete;
    SizeSignalBlock& operator=(const SizeSignalBlock&) = delete;

private:
    sigset_t signals_{};
    sigset_t before_{};
};

// A new file in the target's folder that is gone again unless it takes the target's place. It has no name before that
// where the system can do so (Linux, most file systems), so that a killed process leaves nothing behind.
class Temporary {
public:
    explicit Temporary(const fs::path& target) : target_(target) {
        if (::access("/proc/self/fd", X_OK) == 0) {
            file_ = FileDescriptor(::open(folder_of(target).c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, 0666));
        }
        if (file_.id() >= 0) return;
        take_name([&](const fs::path& name) {
            file_ = FileDescriptor(::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
            return file_.id() >= 0;
        });
    }
    ~Temporary() {
        if (!name_.empty()) ::unlink(name_.c_str());
    }
    Temporary(const Temporary&) = delete;
    Temporary& operator=(const Temporary&) = delete;

    [[nodiscard]] int id() const { return file_.id(); }

    void replace_target() {
        if (name_.empty()) {
            const std::string self = "/proc/self/fd/" + std::to_string(id());
            take_name([&](const fs::path& name) {
                return ::linkat(AT_FDCWD, self.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
            });
        }
        if (!file_.close() || ::rename(name_.c_str(), target_.c_str()) != 0) fail(target_, reason(errno));
        name_.clear();
    }

private:
    // Tries names until one is free.
    template <class Create>
    void take_name(Create create) {
        for (int attempt = 0; attempt < 1000; ++attempt) {
            const fs::path name = folder_of(target_) /
                                  (".crumple-" + std::to_string(::getpid()) + "-" + std::to_string(attempt) + ".tmp");
            if (create(name)) {
                name_ = name;
                return;
            }
            if (errno != EEXIST) break;
        }
        fail(target_, reason(errno));
    }

    fs::path target_;
    fs::path name_;
    FileDescriptor file_{-1};
};

bool write_all(int file, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(file, bytes.data(), std::min(bytes.size(), std::size_t{1} << 30));
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
    return true;
}

// Makes the rename itself last; file systems that cannot do it are none of our business.
void flush_folder(const fs::path& folder) {
    const FileDescriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (descriptor.id() >= 0) (void)::fsync(descriptor.id());
}

}

void check_can_write(const std::string& path) {
    const fs::path folder = folder_of(checked_target(path));
    if (::faccessat(AT_FDCWD, folder.c_str(), W_OK | X_OK, AT_EACCESS) != 0)
        fail(path, "folder " + folder.string() + ": " + reason(errno));
}

void write_file(const std::string& path, std::span<const std::byte> bytes) {
    const fs::path target = checked_target(path);
    Temporary temporary(target);
    {
        const SizeSignalBlock block;
        if (!write_all(temporary.id(), bytes) || ::fsync(temporary.id()) != 0) fail(path, reason(errno));
    }
    temporary.replace_target();
    flush_folder(folder_of(target));
}

}
