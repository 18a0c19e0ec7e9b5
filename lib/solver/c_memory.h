// SPDX-License-Identifier: MIT
// Memory from the allocator a C caller gave.
#pragma once
#include <memory>
#include <new>
#include <span>
#include <utility>

#include "solver/arena.h"
#include "solver/crumple.h"

namespace crumple::solver {

// The caller's, or the C++ heap.
[[nodiscard]] crumple_allocator allocator_or_heap(const crumple_allocator* allocator);

// An array of the caller's memory, given back at the end. Elements start as T{}.
template <class T>
class CArray {
public:
    CArray() = default;
    CArray(const CArray&) = delete;
    CArray& operator=(const CArray&) = delete;
    ~CArray() {
        std::destroy_n(data_, count_);
        if (data_) allocator_.release(allocator_.user, data_, bytes());
    }
    // False when there is no memory. Once.
    [[nodiscard]] bool allocate(const crumple_allocator& allocator, std::size_t count) {
        allocator_ = allocator;
        count_ = count;
        data_ = static_cast<T*>(allocator.allocate(allocator.user, bytes(), Arena::alignment));
        if (data_ == nullptr) count_ = 0;
        std::uninitialized_value_construct_n(data_, count_);
        return data_ != nullptr;
    }
    [[nodiscard]] std::span<T> get() const { return {data_, count_}; }

private:
    // Never 0, which an allocator may answer with null.
    [[nodiscard]] std::size_t bytes() const { return count_ * sizeof(T) + 1; }

    crumple_allocator allocator_{};
    T* data_ = nullptr;
    std::size_t count_ = 0;
};

template <class Handle>
Handle* make_handle(const crumple_allocator& allocator) {
    void* memory = allocator.allocate(allocator.user, sizeof(Handle), Arena::alignment);
    return memory == nullptr ? nullptr : new (memory) Handle{allocator};
}

template <class Handle>
void destroy_handle(Handle* handle) {
    if (handle == nullptr) return;
    const crumple_allocator allocator = handle->allocator;
    handle->~Handle();
    allocator.release(allocator.user, handle, sizeof(Handle));
}

}
