// SPDX-License-Identifier: MIT
// An open file of the system, closed at the end of its scope.
#pragma once
#include <unistd.h>

#include <utility>

namespace crumple {

class FileDescriptor {
public:
    explicit FileDescriptor(int id = -1) : id_(id) {}
    ~FileDescriptor() { close(); }
    FileDescriptor(FileDescriptor&& other) noexcept : id_(std::exchange(other.id_, -1)) {}
    FileDescriptor& operator=(FileDescriptor&& other) noexcept {
        std::swap(id_, other.id_);
        return *this;
    }

    [[nodiscard]] int id() const { return id_; }  // -1: none
    // False when the system reports a late write error.
    bool close() { return id_ < 0 || ::close(std::exchange(id_, -1)) == 0; }

private:
    int id_;
};

}
