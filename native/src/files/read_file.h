#pragma once

#include <string>

#include "abflat/status.h"

namespace abflat::cli {

/// All bytes of a file, or of standard input if `path` is "-". Pipes and terminals work as well,
/// but not devices, which may never end. Errors: UnreadableFile; the message names the file.
Result<std::string> readBytes(const std::string& path);

/// Reads an ordinary file without waiting for anything, and no more bytes than the file's size.
/// `path` must not contain symbolic links. Returns an empty string, or why it failed.
std::string readOrdinaryFile(const std::string& path, std::string& bytes);

}  // namespace abflat::cli
