// SPDX-License-Identifier: GPL-3.0-or-later
// One word of memory that a process and the children it forks later both see.
#pragma once
#include <sys/mman.h>

#include <atomic>
#include <new>

#include "core/error.h"

namespace crumple::sandbox {

template <class T>
class SharedWord {
public:
    static_assert(std::atomic<T>::is_always_lock_free, "a lock would not be shared");

    // Throws Error(internal) when there is no memory for it.
    explicit SharedWord(T value) {
        void* page = mmap(nullptr, sizeof(std::atomic<T>), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
        if (page == MAP_FAILED) throw Error(ErrorKind::internal, "no memory to share with a child process");
        word_ = new (page) std::atomic<T>(value);
    }
    ~SharedWord() { munmap(word_, sizeof(std::atomic<T>)); }
    SharedWord(const SharedWord&) = delete;
    SharedWord& operator=(const SharedWord&) = delete;

    std::atomic<T>& operator*() { return *word_; }
    const std::atomic<T>& operator*() const { return *word_; }

private:
    std::atomic<T>* word_;
};

}
