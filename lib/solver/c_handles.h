// SPDX-License-Identifier: MIT
// What is behind the opaque handles of crumple.h.
#pragma once
#include "bundle/blob.h"
#include "solver/c_memory.h"
#include "solver/instance.h"
#include "solver/sensor.h"
#include "solver/skin.h"

struct crumple_model {
    crumple_allocator allocator;
    crumple::Blob blob{};
    crumple::solver::CArray<crumple::Material> materials{};
    crumple::solver::CArray<std::byte> memory{};
    crumple::solver::Model model{};
};

struct crumple_workspace {
    crumple_allocator allocator;
    const crumple_model* model = nullptr;
    crumple::solver::CArray<std::byte> memory{};
    crumple::solver::Workspace workspace{};
    crumple::solver::CArray<crumple::solver::Constraint> room{};
};

struct crumple_instance {
    crumple_allocator allocator;
    const crumple_model* model = nullptr;
    crumple::solver::Settings settings{};
    crumple::solver::CArray<std::byte> memory{};
    crumple::solver::State state{};
    crumple::solver::CArray<crumple::solver::SensorMemory> sensors{};
};
