#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "arguments/arguments.h"

namespace abflat::cli {

/// Options for textures that follow the layout that a command makes.
void addBaking(CLI::App& app, Baking& baking);

/// Throws CLI::ValidationError if the output cannot hold their images.
void checkBaking(const Baking& baking, const std::string& output, bool hasTiles);

/// Throws CLI::ValidationError if an output is no glTF, which alone holds new images.
void checkHoldsImages(const std::string& output);

}  // namespace abflat::cli
