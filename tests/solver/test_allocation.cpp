// SPDX-License-Identifier: MIT
// A step takes no memory: this file counts every request of its program.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>
#ifdef _WIN32
#include <malloc.h>
#endif

#include "solver/body.h"
#include "solver/instance.h"

// A sanitizer has its own operator new and wants to see all of it.
#if defined(__SANITIZE_ADDRESS__)
#define CRUMPLE_COUNTS_MEMORY 0
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define CRUMPLE_COUNTS_MEMORY 0
#endif
#endif
#ifndef CRUMPLE_COUNTS_MEMORY
#define CRUMPLE_COUNTS_MEMORY 1
#endif

namespace {

std::atomic<bool> is_counting = false;
std::atomic<int> requests = 0;

#if CRUMPLE_COUNTS_MEMORY
void* counted(std::size_t size, std::size_t alignment) {
    if (is_counting) ++requests;
    size = std::max((size + alignment - 1) / alignment * alignment, alignment);
#ifdef _WIN32
    void* const memory = _aligned_malloc(size, alignment);
#else
    void* const memory = std::aligned_alloc(alignment, size);
#endif
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
}

// Not inline, or GCC takes `free` for the wrong partner of the `new` that it sees.
__attribute__((noinline)) void give_back(void* memory) {
#ifdef _WIN32
    _aligned_free(memory);
#else
    std::free(memory);
#endif
}

#endif

}

#if CRUMPLE_COUNTS_MEMORY
void* operator new(std::size_t size) { return counted(size, alignof(std::max_align_t)); }
void* operator new[](std::size_t size) { return counted(size, alignof(std::max_align_t)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
    return counted(size, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
    return counted(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept { give_back(memory); }
void operator delete[](void* memory) noexcept { give_back(memory); }
void operator delete(void* memory, std::size_t) noexcept { give_back(memory); }
void operator delete[](void* memory, std::size_t) noexcept { give_back(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { give_back(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { give_back(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { give_back(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { give_back(memory); }
#endif

namespace crumple::solver::test {
namespace {

Material crushed() {
    Material m = elastic_material(1e6);
    m.yield_pa = 1e4;
    m.creep_per_s = 100;
    m.alpha_per_s = 20;
    m.beta_s = 0.002;
    return m;
}

}

static_assert(noexcept(step(std::declval<const Model&>(), std::declval<State&>(), std::declval<Workspace&>(),
                            std::declval<const StepInput&>())));
static_assert(noexcept(step_instance(std::declval<const Model&>(), std::declval<State&>(), std::declval<Workspace&>(),
                                     std::declval<const InstanceInput&>())));

// Flight, a hit, contact, plastic flow, inverted tets, rest, sleep, waking: for every treatment and plasticity.
TEST(Allocation, AStepTakesNoMemory) {
    if (!CRUMPLE_COUNTS_MEMORY) GTEST_SKIP() << "memory is the sanitizer's";
    for (const Treatment treatment : {Treatment::reflect, Treatment::smooth}) {
        for (const Plasticity plasticity : {Plasticity::additive, Plasticity::multiplicative, Plasticity::off}) {
            Settings settings;
            settings.treatment = treatment;
            settings.plasticity = plasticity;
            Body body(grid_body({4, 2, 2}, {0.2f, 0.2f, 0.2f}, crushed(), [](Vec3f p) { return p.x > 0.7f; }),
                      settings);
            std::vector<Constraint> room(2 * body.node_count());
            Obstacle obstacles[2];
            obstacles[0].axis = {1, 0, 0};
            obstacles[0].position = {-0.1, 0, 0};
            obstacles[1].shape = ObstacleShape::capsule;
            obstacles[1].radius = 0.1;
            obstacles[1].position = {0.2, -0.3, 0.2};
            const Hit hit{{0, 0.2, 0.2}, {4, 1, 0}};
            Wind wind;
            wind.velocity = {1, 2, 3};
            InstanceInput input;
            input.gravity = {0, -1, 0};
            input.carrier.velocity = {-5, 0, 0};
            input.obstacles = obstacles;
            input.wind = &wind;
            input.room = room;
            bool has_slept = false;
            requests = 0;
            is_counting = true;
            for (int i = 0; i < 500; ++i) {
                input.hits = {&hit, i % 450 == 3 ? 1u : 0u};
                if (i == 20) input.carrier.velocity = {};
                if (i == 30) input.wind = nullptr;
                if (i == 60) input.is_carrier_free = false;
                if (i == 100) input.obstacles = {};
                if (i == 40) set_velocity(body.state, 0, {300, 0, 0});
                has_slept =
                    has_slept || step_instance(body.model, body.state, body.workspace, input, body.settings).is_asleep;
            }
            is_counting = false;
            EXPECT_EQ(requests, 0);
            EXPECT_TRUE(has_slept);
            EXPECT_TRUE(body.is_finite());
        }
    }
}

}
