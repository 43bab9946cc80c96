#pragma once

#include <string>

#include "abflat/status.h"

namespace abflat::cli {

/// All bytes of a file, or of standard input when `path` is "-"; pipes and terminals too, but no
/// devices, which may have no end. Errors: UnreadableFile; the message names the file.
Result<std::string> readBytes(const std::string& path);

/// Reads an ordinary file: nothing is waited for, and no more is read than the size that the file
/// has. `path` has no symbolic links. Empty, or why it failed.
std::string readOrdinaryFile(const std::string& path, std::string& bytes);

}  // namespace abflat::cli
