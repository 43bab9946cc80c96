#pragma once

#include <string>

#include "batch/manifest.h"
#include "batch/task.h"

namespace abflat::cli {

/// Whether a line says all that a run would find out: it is of the same content, options and
/// version, its files are as they were written, and the limits of `command` would not change it.
/// The task has its hashes.
bool isSettled(const ManifestLine& line, const Task& task, const BatchCommand& command);

/// Removes files that are in the line of an earlier result, and neither part of the new one nor in
/// another line.
void removeOldFiles(const ManifestLines& lines, const ManifestLine& now, const std::string& out);

}  // namespace abflat::cli
