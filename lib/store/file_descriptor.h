// SPDX-License-Identifier: MIT
// An open file of the system, closed at the end of its scope.
#pragma once
#include <unistd.h>

#include <utility>

namespace crumple::store {

class FileDescriptor {
public:
    explicit FileDescriptor(int id) : id_(id) {}
    ~FileDescriptor() { close(); }
    FileDescriptor(const FileDescriptor&) = delete;
    FileDescriptor& operator=(const FileDescriptor&) = delete;

    [[nodiscard]] int id() const { return id_; }
    // False when the system reports a late write error.
    bool close() { return id_ < 0 || ::close(std::exchange(id_, -1)) == 0; }

private:
    int id_;
};

}
