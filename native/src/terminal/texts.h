#pragma once

#include <string>

#include "abflat/bake.h"
#include "abflat/flatten.h"
#include "abflat/inspect.h"
#include "abflat/pack_layout.h"
#include "abflat/unwrap.h"

namespace abflat::cli {

/// A few readable lines about a result.
std::string resultText(const Report& report, const std::string& inputName,
                       const std::string& outputName);

/// The same for an atlas.
std::string unwrapText(const UnwrapReport& report, const std::string& inputName,
                       const std::string& outputName);

/// The same for a layout that has been packed again.
std::string packText(const PackReport& report, const std::string& inputName,
                     const std::string& outputName);

/// The same for textures in another layout.
std::string bakeText(const BakeReport& report, const std::string& inputName,
                     const std::string& outputName);

/// An aligned table of a mesh's properties.
std::string inspectText(const MeshSummary& summary, const std::string& name,
                        const std::vector<std::string>& notes);

}  // namespace abflat::cli
