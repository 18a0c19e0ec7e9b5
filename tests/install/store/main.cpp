// SPDX-License-Identifier: MIT
// A game that loads a bundle: consumer FILE. load_bundle proves every invariant, so what comes out can be stepped.
#include <cstdio>

#include "store/bundle_file.h"

int main(int argc, char** argv) {
    if (argc != 2) return 1;
    const crumple::Bundle bundle = crumple::store::load_bundle(argv[1]);
    std::printf("%zu nodes, %zu tets\n", bundle.rest_positions.size(), bundle.tets.size());
    return bundle.tets.empty() ? 1 : 0;
}
