#pragma once

#include <cstdint>
#include <string>

namespace abflat::cli {

/// The faces of a mesh, judged by the format and size of its file, rather too many than too few.
double predictedFaces(const std::string& path, std::uintmax_t bytes);

/// The peak memory in MB that such a mesh will need.
double predictedMemory(double faces, std::uintmax_t bytes);

/// Memory in MB that is free now, also by the limits of a container; 0 if the system does not tell.
double freeMemory();

}  // namespace abflat::cli
