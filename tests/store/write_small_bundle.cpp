// SPDX-License-Identifier: MIT
// Writes a small bundle in every form into a folder, for readers that are not ours.
#include <filesystem>
#include <iostream>

#include "bundle/small_bundle.h"
#include "core/error.h"
#include "store/bundle_file.h"
#include "store/export_msh.h"
#include "store/export_obj.h"
#include "store/export_vtu.h"
#include "store/write_file.h"

int main(int argc, char** argv) try {
    if (argc != 2) return 1;
    using namespace crumple;
    const std::filesystem::path folder = argv[1];
    std::filesystem::create_directories(folder);
    const auto write = [&](const char* name, std::span<const std::byte> bytes) {
        store::write_file((folder / name).string(), bytes);
    };
    const auto write_text = [&](const char* name, const std::string& text) {
        write(name, std::as_bytes(std::span(text)));
    };
    const Bundle bundle = test::small_bundle(40);
    write("small.hdf", store::to_image(bundle));
    write("contiguous.hdf", store::to_image(bundle, store::Layout::contiguous));
    write_text("small.vtu", store::export_vtu(bundle));
    write_text("small.msh", store::export_msh(bundle));
    write_text("small.obj", store::export_obj(bundle));
} catch (const crumple::Error& error) {
    std::cerr << error.what() << '\n';
    return 1;
}
