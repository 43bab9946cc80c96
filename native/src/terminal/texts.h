#pragma once

#include <string>

#include "abflat/flatten.h"
#include "abflat/inspect.h"
#include "abflat/unwrap.h"

namespace abflat::cli {

/// A few lines about a result, for people.
std::string resultText(const Report& report, const std::string& inputName,
                       const std::string& outputName);

/// The same for an atlas.
std::string unwrapText(const UnwrapReport& report, const std::string& inputName,
                       const std::string& outputName);

/// Aligned table of what a mesh is.
std::string inspectText(const MeshSummary& summary, const std::string& name,
                        const std::vector<std::string>& notes);

}  // namespace abflat::cli
