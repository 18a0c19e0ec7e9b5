// SPDX-License-Identifier: MIT
// A copy of bytes on a 64-byte boundary, exactly as long, so that sanitizers see a read behind its end.
#pragma once
#include <algorithm>
#include <cstddef>
#include <memory>
#include <new>
#include <span>

namespace crumple::test {

class AlignedBytes {
public:
    explicit AlignedBytes(std::span<const std::byte> bytes)
        : memory_(static_cast<std::byte*>(::operator new[](bytes.size(), std::align_val_t{64}))), size_(bytes.size()) {
        std::copy(bytes.begin(), bytes.end(), memory_.get());
    }
    [[nodiscard]] std::span<std::byte> get() const { return {memory_.get(), size_}; }

private:
    struct Delete {
        void operator()(std::byte* bytes) const { ::operator delete[](bytes, std::align_val_t{64}); }
    };
    std::unique_ptr<std::byte[], Delete> memory_;
    std::size_t size_;
};

}
