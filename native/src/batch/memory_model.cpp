#include "batch/memory_model.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <string>
#include <utility>

#include "batch/gltf_json.h"
#include "files/file_format.h"

#if defined(__APPLE__)
#include <sys/sysctl.h>
#endif

namespace abflat::cli {
namespace {

constexpr double kMegabyte = 1024.0 * 1024.0;

/// Bytes of a file per face, where it is written tightly: positions and faces alone.
double bytesPerFace(FileFormat format) {
  switch (format) {
    case FileFormat::Obj:
      return 40;
    case FileFormat::Ply:
      return 18;  // binary
    case FileFormat::Stl:
      return 50;  // binary
    case FileFormat::Off:
      return 25;
    case FileFormat::Gltf:
      return 18;
  }
  return 18;
}

/// What an accessor counts; 0 if there is none.
double accessorCount(const nlohmann::json& gltf, const nlohmann::json& number) {
  if (!number.is_number_unsigned()) return 0;
  const nlohmann::json::json_pointer place("/accessors/" + number.dump() + "/count");
  return gltf.contains(place) && gltf[place].is_number() ? gltf[place].get<double>() : 0;
}

double primitiveCorners(const nlohmann::json& gltf, const nlohmann::json& primitive) {
  if (!primitive.is_object()) return 0;
  if (primitive.contains("indices")) return accessorCount(gltf, primitive["indices"]);
  const nlohmann::json::json_pointer positions("/attributes/POSITION");
  return primitive.contains(positions) ? accessorCount(gltf, primitive[positions]) : 0;
}

/// Triangles of its meshes, since most of a file may be images; 0 if it does not tell.
double gltfFaces(const std::string& path) {
  const nlohmann::json gltf = gltfJson(path);
  if (!gltf.is_object() || !gltf.contains("meshes")) return 0;
  double corners = 0;
  for (const nlohmann::json& mesh : gltf["meshes"])
    if (mesh.is_object() && mesh.contains("primitives"))
      for (const nlohmann::json& primitive : mesh["primitives"])
        corners += primitiveCorners(gltf, primitive);
  return corners / 3;
}

#if defined(__linux__)
/// A number in a file of the system, in bytes; none if there is no such file, or it has no number.
std::optional<double> systemNumber(const char* path) {
  std::ifstream in(path);
  double out = 0;
  if (in >> out) return out;
  return {};
}

double availableOnLinux() {
  std::ifstream in("/proc/meminfo");
  constexpr double kKilobytes = 1024;
  for (std::string line; std::getline(in, line);)
    if (line.compare(0, 13, "MemAvailable:") == 0)
      return std::strtod(line.c_str() + 13, nullptr) / kKilobytes;
  return 0;
}

/// What the limits of a container leave; as MemAvailable if there are none.
double freeInContainer(double available) {
  const std::pair<const char*, const char*> groups[] = {
      {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory.current"},
      {"/sys/fs/cgroup/memory/memory.limit_in_bytes",
       "/sys/fs/cgroup/memory/memory.usage_in_bytes"}};
  for (const auto& [most, used] : groups)
    if (const std::optional<double> limit = systemNumber(most))
      available = std::min(available, (*limit - systemNumber(used).value_or(0)) / kMegabyte);
  return std::max(available, 0.0);
}
#endif

}  // namespace

double predictedFaces(const std::string& path, std::uintmax_t bytes) {
  const FileFormat format = namedFormat(path).value_or(kUnnamedFormat);
  const double counted = format == FileFormat::Gltf ? gltfFaces(path) : 0;
  return counted > 0 ? counted : static_cast<double>(bytes) / bytesPerFace(format);
}

double predictedMemory(double faces, std::uintmax_t bytes) {
  constexpr double kProgram = 16, kPerFace = 2300;  // measured, see docs/batch.md
  constexpr double kFileCopies = 2;                 // the file, and the one that is written
  return kProgram + (kPerFace * faces + kFileCopies * static_cast<double>(bytes)) / kMegabyte;
}

double freeMemory() {
#if defined(__APPLE__)
  std::uint64_t bytes = 0;
  std::size_t size = sizeof(bytes);
  if (sysctlbyname("hw.memsize", &bytes, &size, nullptr, 0) != 0) return 0;
  return static_cast<double>(bytes) / kMegabyte;
#elif defined(__linux__)
  return freeInContainer(availableOnLinux());
#else
  return 0;
#endif
}

}  // namespace abflat::cli
