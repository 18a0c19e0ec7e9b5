// SPDX-License-Identifier: GPL-3.0-or-later
// Balls of very different radii, asked which of them may contain a place. A ball is entered in every cell it touches of
// a grid about as coarse as the ball, so a question looks into one cell of each grid in use.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "core/index.h"
#include "core/vec3.h"

namespace crumple::sample {

class BallGrid {
public:
    // Cells are counted from `origin`, so that places far from zero keep their digits.
    explicit BallGrid(Vec3 origin) : origin_(origin), table_(1024) {}

    // REQUIRES: radius > 0, and the distance from the origin below 2^31 radii.
    void insert(Index ball, Vec3 centre, double radius);

    // Whether test(ball) is true for any ball that may contain p. Balls that do not contain p may be asked too.
    template <class Test>
    [[nodiscard]] bool any_at(Vec3 p, const Test& test) const {
        for (const int level : levels_) {
            for (Index entry = first_in(cell_at(p, level)); entry != none; entry = entries_[entry].next) {
                if (test(entries_[entry].ball)) return true;
            }
        }
        return false;
    }

private:
    struct Cell {
        std::array<std::int32_t, 3> at{};
        std::int32_t level = 0;
        friend bool operator==(const Cell&, const Cell&) = default;
    };
    struct Slot {
        Cell cell;
        Index first = none;  // entry; none in an empty slot
    };
    struct Entry {
        Index ball;
        Index next;
    };

    [[nodiscard]] Cell cell_at(Vec3 p, int level) const;
    [[nodiscard]] std::size_t slot_of(const Cell& cell) const;  // where it is or belongs
    [[nodiscard]] Index first_in(const Cell& cell) const { return table_[slot_of(cell)].first; }
    void add(const Cell& cell, Index ball);
    void grow();

    Vec3 origin_;
    std::vector<int> levels_;  // in use; cells of level l have edge 2^l
    std::vector<Slot> table_;  // open addressing, a power of two, at most half full
    std::size_t used_slots_ = 0;
    std::vector<Entry> entries_;
};

}
