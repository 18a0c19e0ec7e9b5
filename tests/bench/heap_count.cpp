// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/heap_count.h"

#include <malloc.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>

namespace crumple::bench {
namespace {

// Relaxed and without read-modify-write: the benchmarks that ask run on one thread.
std::atomic<std::size_t> in_use = 0;
std::atomic<std::size_t> peak = 0;

void* counted(void* memory) {
    if (memory == nullptr) throw std::bad_alloc();
    const std::size_t now = in_use.load(std::memory_order_relaxed) + malloc_usable_size(memory);
    in_use.store(now, std::memory_order_relaxed);
    if (now > peak.load(std::memory_order_relaxed)) peak.store(now, std::memory_order_relaxed);
    return memory;
}

void release(void* memory) {
    if (memory == nullptr) return;
    in_use.store(in_use.load(std::memory_order_relaxed) - malloc_usable_size(memory), std::memory_order_relaxed);
    std::free(memory);
}

}

std::size_t heap_in_use() { return in_use; }
std::size_t heap_peak() { return peak; }
void reset_heap_peak() { peak = in_use.load(); }

void* counted_new(std::size_t size) { return counted(std::malloc(std::max<std::size_t>(size, 1))); }
void* counted_new(std::size_t size, std::align_val_t alignment) {
    void* memory = nullptr;
    return posix_memalign(&memory, static_cast<std::size_t>(alignment), size) == 0 ? counted(memory) : counted(nullptr);
}
void counted_delete(void* memory) { release(memory); }

}

void* operator new(std::size_t size) { return crumple::bench::counted_new(size); }
void* operator new[](std::size_t size) { return crumple::bench::counted_new(size); }
void* operator new(std::size_t size, std::align_val_t alignment) {
    return crumple::bench::counted_new(size, alignment);
}
void operator delete(void* memory) noexcept { crumple::bench::counted_delete(memory); }
void operator delete[](void* memory) noexcept { crumple::bench::counted_delete(memory); }
void operator delete(void* memory, std::size_t) noexcept { crumple::bench::counted_delete(memory); }
void operator delete[](void* memory, std::size_t) noexcept { crumple::bench::counted_delete(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { crumple::bench::counted_delete(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { crumple::bench::counted_delete(memory); }
