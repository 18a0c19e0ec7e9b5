// SPDX-License-Identifier: GPL-3.0-or-later
// All that assimp may open: bytes that were read and looked at before. It asks for whatever a file names - material
// libraries, textures, pipes - and gets nothing else, so what decides the result is what input_files lists.
#pragma once
#include <assimp/IOSystem.hpp>
#include <map>
#include <string>
#include <string_view>

namespace crumple::importer {

class MemoryFiles final : public Assimp::IOSystem {
public:
    // The bytes must outlive this.
    void add(std::string name, std::string_view bytes) { files_[std::move(name)] = bytes; }

    bool Exists(const char* name) const override { return find(name) != nullptr; }
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char* name, const char* mode) override;
    void Close(Assimp::IOStream* stream) override;

private:
    // By its whole name, or by what follows the last slash: assimp puts the folder of the main file before the others'.
    [[nodiscard]] const std::string_view* find(std::string_view name) const;

    std::map<std::string, std::string_view, std::less<>> files_;
};

}
