#pragma once

#include <string>

#include "batch/manifest_line.h"
#include "batch/task.h"

namespace abflat::cli {

/// Whether a line says all that a run would find out: it is of the same content, options and
/// version, its files are as they were written, and the limits of `command` would not change it.
/// The task has its hashes.
bool isSettled(const ManifestLine& line, const Task& task, const BatchCommand& command);

/// Removes files of an earlier result that are not part of the new one.
void removeOldFiles(const ManifestLine& old, const ManifestLine& now, const std::string& out);

}  // namespace abflat::cli
