#pragma once

#include <string>

namespace abflat::cli {

/// What matters most of a report of unwrap, flatten, pack, bake or verify, as a JSON object in one
/// line; empty if the text is no report.
std::string reportSummary(const std::string& report);

/// What verify has found first, in a sentence; empty if the summary has no findings.
std::string firstFinding(const std::string& summary);

}  // namespace abflat::cli
