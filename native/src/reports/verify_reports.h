#pragma once

#include <string>

#include "abflat/verify.h"

namespace abflat::cli {

/// What was measured and found, in a few lines.
std::string verifyText(const VerifyReport& report, const std::string& inputName);

/// A test for each rule, as services for continuous integration show them.
std::string verifyJunit(const VerifyReport& report, const std::string& inputName);

/// SARIF 2.1.0, with a result for each finding.
std::string verifySarif(const VerifyReport& report, const std::string& inputName);

}  // namespace abflat::cli
