// Checks that must hold of everything that a reader gives back, whatever the bytes were.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "girth/io/read_mesh.h"

namespace girth::fuzz {

std::span<const std::byte> bytesOf(const std::uint8_t* data, std::size_t size);

/// Files beside the model: all names that end in ".bin" are there.
std::optional<std::vector<std::byte>> resource(std::string_view name);

/// Ends the program where the condition does not hold.
void demand(bool condition, const std::string& rule);

/// Ends the program where an error is not one that a user can read: coded, short, with a remedy.
void check(const Error& error);

/// Ends the program where a rule of readModel is broken. Always 0, which libFuzzer wants to hear.
int check(const Result<io::ReadModel>& model);

/// Checks the result of readMesh.
int check(const Result<io::LoadedMesh>& loaded);

}  // namespace girth::fuzz
