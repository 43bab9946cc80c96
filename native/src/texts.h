#pragma once

#include <string>

#include "abflat/flatten.h"
#include "abflat/inspect.h"

namespace abflat::cli {

/// A few lines about a result, for people.
std::string resultText(const Report& report, const std::string& inputName,
                       const std::string& outputName);

/// What keeps a result from being valid and what may help, one sentence without a full stop.
std::string invalidText(const ChartReport& chart);

/// Aligned table of what a mesh is.
std::string inspectText(const MeshSummary& summary, const std::string& name);

}  // namespace abflat::cli
