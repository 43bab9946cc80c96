#pragma once

#include <optional>
#include <string>

#include "abflat/io.h"
#include "files/generated/file_format.h"

namespace abflat::cli {

/// The format that the extension of a name stands for, if any.
std::optional<FileFormat> namedFormat(const std::string& path);

/// Whether results can be written under this name: as its extension says, or without one.
bool isWritableName(const std::string& path);

/// The format that is written under a name.
FileFormat writtenFormat(const std::string& path);

/// The same format for the core; none for one that only another library knows.
std::optional<MeshFormat> coreFormat(FileFormat format);

}  // namespace abflat::cli
