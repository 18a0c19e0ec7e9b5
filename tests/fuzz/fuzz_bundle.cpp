// SPDX-License-Identifier: MIT
// The bundle reader against bytes from anywhere. The first byte chooses how the rest is used:
//   0: the rest is a file
//   1: the rest is a file that gets a valid seal, so that HDF5 sees it
//   2: the rest are edits (offset, value) of a good file, sealed again
//   3: the rest are edits of the words of a good bundle in memory
// A file without findings must hold exactly what a good one holds, read twice alike.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <span>

#include "bundle/small_bundle.h"
#include "bundle/validate.h"
#include "store/bundle_file.h"
#include "store/check_file.h"
#include "store/seal.h"

namespace {

using namespace crumple;

std::vector<std::byte> sealed(std::vector<std::byte> file) {
    if (file.size() < store::seal_size) file.resize(store::seal_size);
    store::write_seal(file);
    return file;
}

const std::vector<std::byte>& good_file() {
    static const std::vector<std::byte> file = store::to_image(test::small_bundle());
    return file;
}

void check(const std::vector<std::byte>& file) {
    const store::CheckedFile checked = store::check_file(file, "fuzz");
    if (!checked.findings.empty() || !checked.bundle) return;
    // What check passes can be used: written and read again it is the same.
    const store::FileReader again(store::to_image(*checked.bundle), "again");
    if (!validate(store::read_bundle(again)).empty()) std::abort();
}

std::vector<std::byte> edited_file(std::span<const std::byte> edits) {
    std::vector<std::byte> file = good_file();
    for (; edits.size() >= 4; edits = edits.subspan(4)) {
        std::uint32_t word = 0;
        std::memcpy(&word, edits.data(), 4);
        file[(word >> 8) % file.size()] = edits[0];
    }
    return sealed(std::move(file));
}

template <class T>
void edit(std::vector<T>& values, std::uint32_t place, std::uint32_t value) {
    const auto bytes = std::as_writable_bytes(std::span(values));
    if (bytes.size() < 4) return;
    std::memcpy(bytes.data() + place % (bytes.size() / 4) * 4, &value, 4);
}

// Each edit: which array, which word of it, its new value.
void check_edited_bundle(std::span<const std::byte> edits) {
    Bundle b = test::small_bundle();
    for (; edits.size() >= 7; edits = edits.subspan(7)) {
        std::uint16_t place = 0;
        std::uint32_t value = 0;
        std::memcpy(&place, edits.data() + 1, 2);
        std::memcpy(&value, edits.data() + 3, 4);
        switch (std::to_integer<int>(edits[0]) % 20) {
            case 0:
                edit(b.rest_positions, place, value);
                break;
            case 1:
                edit(b.mass, place, value);
                break;
            case 2:
                edit(b.locked, place, value);
                break;
            case 3:
                edit(b.node_to_mesh, place, value);
                break;
            case 4:
                edit(b.mesh_to_node, place, value);
                break;
            case 5:
                edit(b.tets, place, value);
                break;
            case 6:
                edit(b.inverse_rest, place, value);
                break;
            case 7:
                edit(b.material, place, value);
                break;
            case 8:
                edit(b.row_start, place, value);
                break;
            case 9:
                edit(b.column, place, value);
                break;
            case 10:
                edit(b.diagonal, place, value);
                break;
            case 11:
                edit(b.element_slots, place, value);
                break;
            case 12:
                edit(b.edges, place, value);
                break;
            case 13:
                edit(b.edge_slots, place, value);
                break;
            case 14:
                edit(b.edge_start, place, value);
                break;
            case 15:
                edit(b.edge_tet, place, value);
                break;
            case 16:
                edit(b.visuals[0].tet_start, place, value);
                break;
            case 17:
                edit(b.visuals[0].vertices_by_tet, place, value);
                break;
            case 18:
                b.solver_tet_count = value;
                break;
            default:
                b.tets.resize(value % 64);
                break;
        }
    }
    if (validate(b).empty()) check(store::to_image(b));
}

}

// HDF5 1.10.8 forgets memory when it refuses broken metadata.
extern "C" const char* __lsan_default_suppressions() { return "leak:libhdf5\n"; }

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const auto rest = std::as_bytes(std::span(data + 1, size - 1));
    const std::vector<std::byte> file(rest.begin(), rest.end());
    switch (data[0] % 4) {
        case 0:
            check(file);
            break;
        case 1:
            check(sealed(file));
            break;
        case 2:
            check(edited_file(rest));
            break;
        default:
            check_edited_bundle(rest);
            break;
    }
    return 0;
}
