#pragma once

#include <cstdint>
#include <string>

namespace abflat::cli {

/// The peak memory in MB that a mesh will need, judged by its format and size, rather too much than
/// too little.
double predictedMemory(const std::string& path, std::uintmax_t bytes);

/// Memory in MB that is free now, also by the limits of a container; 0 if the system does not tell.
double freeMemory();

}  // namespace abflat::cli
