// SPDX-License-Identifier: MIT
// crumple.h, most of it through use_c_interface.c, which is strict C99.
#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <new>
#include <thread>
#include <vector>

#include "bundle/aligned_bytes.h"
#include "bundle/blob.h"
#include "bundle/hash64.h"
#include "bundle/small_bundle.h"
#include "core/random.h"
#include "solver/instance.h"
#include "solver/use_c_interface.h"

namespace crumple::solver::test {
namespace {

using crumple::test::AlignedBytes;

Bundle tower() {
    Bundle bundle = crumple::test::small_bundle(4);
    bundle.materials[0].young_pa = 1e6;
    bundle.materials[0].yield_pa = 1e3;
    return bundle;
}

AlignedBytes memory_for(std::size_t size) { return AlignedBytes(std::vector<std::byte>(size)); }

// Counts what was taken and not given back; says no to one request.
struct CountingHeap {
    int refused = -1;
    int requests = 0;
    long held = 0;

    crumple_allocator allocator() { return {allocate, release, this}; }
    static void* allocate(void* user, std::size_t bytes, std::size_t alignment) {
        auto& heap = *static_cast<CountingHeap*>(user);
        if (heap.requests++ == heap.refused) return nullptr;
        heap.held += static_cast<long>(bytes);
        return ::operator new (bytes, std::align_val_t{alignment});
    }
    static void release(void* user, void* memory, std::size_t bytes) {
        static_cast<CountingHeap*>(user)->held -= static_cast<long>(bytes);
        ::operator delete (memory, std::align_val_t{64});
    }
};

struct Used {
    std::vector<float> positions;
    used_c_interface result{};
};

Used use(const crumple_allocator* allocator, const crumple_jobs* jobs = nullptr) {
    const Bundle bundle = tower();
    const AlignedBytes blob(write_blob(bundle));
    Used used;
    used.positions.resize(4 * bundle.rest_positions.size());
    used.result.positions = used.positions.data();
    use_c_interface(blob.get().data(), blob.get().size(), allocator, jobs, &used.result);
    return used;
}

// Two threads, each through half of the pieces.
void run_on_two(void*, std::size_t count, void (*task)(void*, std::size_t), void* context) {
    std::thread other([&] {
        for (std::size_t i = count; i-- > count / 2;) task(context, i);
    });
    for (std::size_t i = 0; i < count / 2; ++i) task(context, i);
    other.join();
}

}

TEST(CProgram, InC99CrushesABody) {
    const Used used = use(nullptr);
    EXPECT_EQ(used.result.failure, nullptr) << used.result.failure;
    EXPECT_GT(used.result.contacts, 0u);
    EXPECT_EQ(used.result.was_triggered, 1);
    EXPECT_EQ(used.result.last.warnings & CRUMPLE_NOT_FINITE, 0u);
    EXPECT_GT(used.result.last.iterations, 0u);
    EXPECT_EQ(crumple_c_version(), static_cast<uint32_t>(CRUMPLE_C_VERSION));
}

TEST(CProgram, GetsTheBitsOfTheCppInterface) {
    const Used used = use(nullptr);
    const Bundle bundle = tower();
    const BundleView view = view_of(bundle);
    const AlignedBytes model_memory = memory_for(model_bytes(view));
    const Model model = build_model(view, model_memory.get());
    const AlignedBytes state_memory = memory_for(state_bytes(model, Plasticity::additive));
    const AlignedBytes workspace_memory = memory_for(workspace_bytes(model));
    State state = make_state(model, Plasticity::additive, state_memory.get());
    Workspace workspace = make_workspace(model, workspace_memory.get());
    std::vector<Constraint> room(2 * model.node_count);
    Obstacle hammer;
    hammer.axis = {0, -1, 0};
    hammer.velocity = {0, -1, 0};
    InstanceInput input;
    input.room = room;
    for (int i = 0; i < USED_STEPS; ++i) {
        if (i % (USED_STEPS / 2) == 0) hammer.position.y = 3.9;
        input.obstacles = {&hammer, 1};
        step_instance(model, state, workspace, input);
        hammer.position.y -= static_cast<double>(input.dt);
    }
    EXPECT_EQ(std::memcmp(used.positions.data(), state.positions.data(), used.positions.size() * sizeof(float)), 0);
}

TEST(CProgram, ThreadsOfTheCallerChangeNoBit) {
    const crumple_jobs jobs{run_on_two, nullptr};
    const Used alone = use(nullptr);
    const Used together = use(nullptr, &jobs);
    EXPECT_EQ(together.result.failure, nullptr);
    EXPECT_EQ(std::memcmp(alone.positions.data(), together.positions.data(), 4 * alone.positions.size()), 0);
}

TEST(CProgram, TakesAllMemoryFromTheCallerAndGivesItBack) {
    CountingHeap heap;
    const crumple_allocator allocator = heap.allocator();
    EXPECT_EQ(use(&allocator).result.failure, nullptr);
    EXPECT_EQ(heap.held, 0);
    const int requests = heap.requests;
    EXPECT_GE(requests, 6);
    for (int refused = 0; refused < requests; ++refused) {
        CountingHeap poor;
        poor.refused = refused;
        const crumple_allocator from_poor = poor.allocator();
        EXPECT_NE(use(&from_poor).result.failure, nullptr) << refused;
        EXPECT_EQ(poor.held, 0) << refused;
    }
}

TEST(CProgram, TakesNoMemoryInAStep) {
    const AlignedBytes blob(write_blob(tower()));
    CountingHeap heap;
    const crumple_allocator allocator = heap.allocator();
    crumple_model* model = nullptr;
    crumple_workspace* workspace = nullptr;
    crumple_instance* instance = nullptr;
    ASSERT_EQ(crumple_model_create(blob.get().data(), blob.get().size(), &allocator, &model, nullptr), CRUMPLE_OK);
    ASSERT_EQ(crumple_workspace_create(model, &allocator, &workspace), CRUMPLE_OK);
    ASSERT_EQ(crumple_instance_create(model, nullptr, &allocator, &instance), CRUMPLE_OK);
    const int requests = heap.requests;
    const crumple_input input = crumple_default_input();
    for (int i = 0; i < 5; ++i) EXPECT_EQ(crumple_step(instance, workspace, &input, nullptr, nullptr), CRUMPLE_OK);
    EXPECT_EQ(heap.requests, requests);
    crumple_instance_destroy(instance);
    crumple_workspace_destroy(workspace);
    crumple_model_destroy(model);
}

// An instance that has made a few steps, and what it saved.
struct Saved {
    explicit Saved(const Bundle& bundle = tower(), std::uint32_t plasticity = CRUMPLE_ADDITIVE)
        : blob(write_blob(bundle)) {
        crumple_settings settings = crumple_default_settings();
        settings.plasticity = plasticity;
        EXPECT_EQ(crumple_model_create(blob.get().data(), blob.get().size(), nullptr, &model, nullptr), CRUMPLE_OK);
        EXPECT_EQ(crumple_workspace_create(model, nullptr, &workspace), CRUMPLE_OK);
        EXPECT_EQ(crumple_instance_create(model, &settings, nullptr, &instance), CRUMPLE_OK);
        for (int i = 0; i < 3; ++i) step();
        bytes = save();
    }
    Saved(const Saved&) = delete;
    Saved& operator=(const Saved&) = delete;
    ~Saved() {
        crumple_instance_destroy(instance);
        crumple_workspace_destroy(workspace);
        crumple_model_destroy(model);
    }
    crumple_report step(const crumple_input& input = crumple_default_input()) {
        crumple_report report;
        EXPECT_EQ(crumple_step(instance, workspace, &input, nullptr, &report), CRUMPLE_OK);
        return report;
    }
    [[nodiscard]] std::vector<std::byte> save() const {
        std::vector<std::byte> saved(crumple_state_size(instance));
        EXPECT_EQ(crumple_save(instance, saved.data(), saved.size()), CRUMPLE_OK);
        return saved;
    }
    crumple_status restore(const std::vector<std::byte>& from) {
        return crumple_restore(instance, from.data(), from.size());
    }

    AlignedBytes blob;
    crumple_model* model = nullptr;
    crumple_workspace* workspace = nullptr;
    crumple_instance* instance = nullptr;
    std::vector<std::byte> bytes;
};

TEST(CProgram, IsToldWhatEachLockPushesWith) {
    Saved body;
    const crumple_info info = crumple_model_info(body.model);
    const std::uint8_t* locked = crumple_locked(body.model);
    std::vector<crumple_vec3f> reactions(info.nodes, {7, 7, 7});
    crumple_input input = crumple_default_input();
    input.is_carrier_free = 0;
    input.reactions = reactions.data();
    input.may_sleep = 0;
    crumple_report report{};
    for (int i = 0; i < 600; ++i) report = body.step(input);
    Vec3 sum{};
    for (std::size_t n = 0; n < info.nodes; ++n) {
        const crumple_vec3f r = reactions[n];
        if (!locked[n]) {
            EXPECT_EQ(r.x * r.x + r.y * r.y + r.z * r.z, 0) << n;
        }
        sum += {r.x, r.y, r.z};
    }
    double weight = 0;
    for (const float mass : tower().mass) weight += 9.81 * static_cast<double>(mass);
    EXPECT_NEAR(sum.x, 0, 1e-3 * weight);
    EXPECT_NEAR(sum.y, weight, 1e-3 * weight);
    EXPECT_NEAR(sum.z, 0, 1e-3 * weight);
    EXPECT_NEAR(report.force.y, 0, 1e-3 * weight) << "gravity is the engine's own";
}

TEST(CProgram, IsRefusedASaveWithAnyBitChanged) {
    Saved saved;
    saved.step();
    const std::vector<std::byte> before = saved.save();
    Rng rng(7);
    for (int trial = 0; trial < 2000; ++trial) {
        std::vector<std::byte> bytes = saved.bytes;
        const std::uint32_t bit = rng.next_below(static_cast<std::uint32_t>(8 * bytes.size()));
        bytes[bit / 8] ^= static_cast<std::byte>(1u << bit % 8);
        EXPECT_EQ(saved.restore(bytes), CRUMPLE_BAD_ARGUMENT) << bit;
    }
    EXPECT_EQ(saved.save(), before) << "refused bytes change nothing";
    EXPECT_EQ(saved.restore(saved.bytes), CRUMPLE_OK);
    EXPECT_EQ(saved.save(), saved.bytes);
}

TEST(CProgram, IsRefusedTheSaveOfAnotherBlobOrPlasticity) {
    Bundle softer = tower();
    softer.materials[0].young_pa *= 0.5;
    Saved saved, of_softer(softer), of_other(tower(), CRUMPLE_PLASTICITY_OFF), of_same;
    ASSERT_EQ(saved.bytes.size(), of_softer.bytes.size());
    ASSERT_EQ(saved.bytes.size(), of_other.bytes.size());
    EXPECT_EQ(saved.restore(of_softer.bytes), CRUMPLE_BAD_ARGUMENT);
    EXPECT_EQ(saved.restore(of_other.bytes), CRUMPLE_BAD_ARGUMENT);
    EXPECT_EQ(saved.restore(of_same.bytes), CRUMPLE_OK);
}

TEST(CProgram, RestoresWhateverItSaved) {
    Saved saved;
    for (const float speed : {1e6f, 1e12f, 1e18f}) {
        EXPECT_EQ(crumple_set_velocity(saved.instance, 3, {speed, -speed, speed}), CRUMPLE_OK);
        for (int i = 0; i < 4; ++i) {
            saved.step();
            EXPECT_EQ(saved.restore(saved.save()), CRUMPLE_OK) << speed;
        }
    }
}

// Bytes with the right checksum, the last eight, around anything: refused, or stepped without harm (sanitizers watch).
TEST(CProgram, MayRestoreBytesFromAnywhere) {
    Saved saved;
    Rng rng(5);
    int refused = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        std::vector<std::byte> bytes = saved.bytes;
        const std::size_t size = bytes.size() - 8;
        for (int change = 0; change < 4; ++change) {
            bytes[rng.next_below(static_cast<std::uint32_t>(size))] = static_cast<std::byte>(rng.next_u32());
        }
        const std::uint64_t hash = hash64(std::span(bytes).first(size));
        std::memcpy(&bytes[size], &hash, sizeof hash);
        refused += saved.restore(bytes) == CRUMPLE_OK ? 0 : 1;
        saved.step();
    }
    EXPECT_GT(refused, 20);
    EXPECT_LT(refused, 1000);
    EXPECT_EQ(saved.restore(saved.bytes), CRUMPLE_OK);
}

TEST(CProgram, IsToldWhatIsWrongWithABlob) {
    const AlignedBytes blob(write_blob(tower()));
    crumple_model* model = nullptr;
    const char* problem = nullptr;
    blob.get()[777] ^= std::byte{1};
    EXPECT_EQ(crumple_model_create(blob.get().data(), blob.get().size(), nullptr, &model, &problem), CRUMPLE_BAD_BLOB);
    EXPECT_EQ(model, nullptr);
    EXPECT_STREQ(problem, "is damaged: it has another checksum");
    char message[20];
    EXPECT_EQ(crumple_check_blob(blob.get().data(), blob.get().size(), message, sizeof message), CRUMPLE_BAD_BLOB);
    EXPECT_STREQ(message, "the blob is damaged");
    blob.get()[777] ^= std::byte{1};
    EXPECT_EQ(crumple_check_blob(blob.get().data(), blob.get().size(), message, sizeof message), CRUMPLE_OK);
    EXPECT_STREQ(message, "");
}

TEST(CProgram, IsRefusedWhatMakesNoSense) {
    const AlignedBytes blob(write_blob(tower()));
    crumple_model* model = nullptr;
    crumple_model* other = nullptr;
    EXPECT_EQ(crumple_model_create(nullptr, 100, nullptr, &model, nullptr), CRUMPLE_BAD_ARGUMENT);
    EXPECT_EQ(crumple_model_create(blob.get().data(), 100, nullptr, nullptr, nullptr), CRUMPLE_BAD_ARGUMENT);
    ASSERT_EQ(crumple_model_create(blob.get().data(), blob.get().size(), nullptr, &model, nullptr), CRUMPLE_OK);
    ASSERT_EQ(crumple_model_create(blob.get().data(), blob.get().size(), nullptr, &other, nullptr), CRUMPLE_OK);
    crumple_workspace* workspace = nullptr;
    crumple_workspace* of_other = nullptr;
    crumple_instance* instance = nullptr;
    crumple_settings settings = crumple_default_settings();
    settings.rotation = 17;
    EXPECT_EQ(crumple_instance_create(model, &settings, nullptr, &instance), CRUMPLE_BAD_ARGUMENT);
    EXPECT_EQ(crumple_instance_create(nullptr, nullptr, nullptr, &instance), CRUMPLE_BAD_ARGUMENT);
    settings = crumple_default_settings();
    settings.max_iterations = 0;
    settings.tolerance = std::numeric_limits<double>::quiet_NaN();
    ASSERT_EQ(crumple_instance_create(model, &settings, nullptr, &instance), CRUMPLE_OK) << "taken as the nearest";
    ASSERT_EQ(crumple_workspace_create(model, nullptr, &workspace), CRUMPLE_OK);
    ASSERT_EQ(crumple_workspace_create(other, nullptr, &of_other), CRUMPLE_OK);

    crumple_input input = crumple_default_input();
    EXPECT_EQ(crumple_step(instance, workspace, nullptr, nullptr, nullptr), CRUMPLE_BAD_ARGUMENT);
    EXPECT_EQ(crumple_step(instance, of_other, &input, nullptr, nullptr), CRUMPLE_BAD_ARGUMENT);
    crumple_obstacle thing{};
    thing.shape = 9;
    input.obstacles = &thing;
    input.obstacle_count = 1;
    EXPECT_EQ(crumple_step(instance, workspace, &input, nullptr, nullptr), CRUMPLE_BAD_ARGUMENT);
    for (const auto count :
         {&crumple_input::obstacle_count, &crumple_input::hit_count, &crumple_input::constraint_count}) {
        input = crumple_default_input();
        input.*count = 5;  // of a null
        EXPECT_EQ(crumple_step(instance, workspace, &input, nullptr, nullptr), CRUMPLE_BAD_ARGUMENT);
    }
    input = crumple_default_input();
    input.carrier.orientation.w = std::numeric_limits<float>::quiet_NaN();
    crumple_report report;
    EXPECT_EQ(crumple_step(instance, workspace, &input, nullptr, &report), CRUMPLE_OK);
    EXPECT_EQ(report.warnings, static_cast<uint32_t>(CRUMPLE_BAD_INPUT));
    EXPECT_EQ(report.force.x, 0);

    EXPECT_EQ(crumple_set_velocity(instance, 1u << 30, {}), CRUMPLE_BAD_ARGUMENT);
    for (const float speed : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 1e30f}) {
        EXPECT_EQ(crumple_set_velocity(instance, 0, {0, speed, 0}), CRUMPLE_BAD_ARGUMENT);
        EXPECT_EQ(crumple_velocities(instance)[1], 0);
    }
    EXPECT_EQ(crumple_save(instance, &report, 3), CRUMPLE_BAD_ARGUMENT);
    EXPECT_EQ(crumple_find_visual(model, "none such"), UINT32_MAX);
    EXPECT_EQ(crumple_visual_name(model, 5), nullptr);
    EXPECT_EQ(crumple_is_asleep(nullptr), 0);
    crumple_instance_destroy(nullptr);
    crumple_instance_destroy(instance);
    crumple_workspace_destroy(workspace);
    crumple_workspace_destroy(of_other);
    crumple_model_destroy(model);
    crumple_model_destroy(other);
}

}
