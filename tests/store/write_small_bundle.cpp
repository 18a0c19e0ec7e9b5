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
#include "store/view_fields.h"
#include "store/write_file.h"

namespace {

// Fields of every type that a view can be given.
std::vector<std::byte> with_fields(const crumple::Bundle& bundle) {
    using namespace crumple;
    store::FileWriter file;
    store::write_bundle(file, bundle);
    std::vector<float> angles(bundle.tets.size());
    for (std::size_t t = 0; t < angles.size(); ++t) angles[t] = 0.5f * static_cast<float>(t);
    const std::vector<std::uint8_t> limits(bundle.tets.size(), 2);
    const std::vector<std::uint32_t> components(bundle.rest_positions.size(), 7);
    const std::vector<Vec3f> places{{1, 2, 3}, {4, 5, 6}};
    store::write_view_fields(file, {{{"component", components}},
                                    {{"min_dihedral_deg", angles}, {"shell_limit", limits}},
                                    {{"paint/1.position", places}}});
    return file.finish();
}

}

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
    write("fields.hdf", with_fields(bundle));
    write("contiguous.hdf", store::to_image(bundle, store::Layout::contiguous));
    write_text("small.vtu", store::export_vtu(bundle));
    write_text("small.msh", store::export_msh(bundle));
    write_text("small.obj", store::export_obj(bundle));
} catch (const crumple::Error& error) {
    std::cerr << error.what() << '\n';
    return 1;
}
