#pragma once

#include <string>
#include <vector>

#include "arguments/arguments.h"

namespace abflat::cli {

/// A mesh of a batch.
struct BatchInput {
  std::string path;                  ///< where it is read
  std::string name;                  ///< its path below the folder of results
  std::vector<GivenOption> options;  ///< for this mesh alone
  std::string atlas;                 ///< name of the one that it shares; empty: its own
  bool isListed = false;             ///< by a list, so it may be missing
};

/// A path without what would lead out of a folder: "../a/./b.obj" and "/a/b.obj" are "a/b.obj".
std::string nameBelow(const std::string& path);

bool hasSameOptions(const BatchInput& a, const BatchInput& b);

}  // namespace abflat::cli
