// SPDX-License-Identifier: MIT
// Cuts a block of the caller's memory into arrays, each on a cache line of its own. Over no memory it only measures.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

namespace crumple::solver {

class Arena {
public:
    static constexpr std::size_t alignment = 64;

    Arena() = default;
    explicit Arena(std::span<std::byte> memory) : base_(memory.data()) {}

    template <class T>
    [[nodiscard]] std::span<T> take(std::size_t count) {
        static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= alignment);
        const std::size_t at = used_;
        used_ += (count * sizeof(T) + alignment - 1) / alignment * alignment;
        if (base_ == nullptr) return {};
        return {reinterpret_cast<T*>(base_ + at), count};
    }
    [[nodiscard]] std::size_t used() const { return used_; }

private:
    std::byte* base_ = nullptr;
    std::size_t used_ = 0;
};

// REQUIRES of every block of memory given to the solver.
inline bool is_usable(std::span<const std::byte> memory, std::size_t bytes) {
    return memory.size() >= bytes && reinterpret_cast<std::uintptr_t>(memory.data()) % Arena::alignment == 0;
}

}
