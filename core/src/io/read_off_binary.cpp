#include "io/read_off_binary.h"

#include <cmath>
#include <string>

#include "base/counted.h"
#include "io/ply_value.h"

namespace abflat {
namespace {

struct OffVariant {
  bool isBigEndian = true;
  bool hasColors = true;  ///< each face ends in a colour, which may be empty
};

/// Reads one variant.
class OffBinaryReader {
 public:
  OffBinaryReader(const OffBinaryHeader& header, OffVariant variant, std::string_view bytes,
                  std::string_view fileName)
      : header_(header), variant_(variant), bytes_(bytes), fileName_(fileName), at_(header.size) {}

  /// Whether the counts of vertices and faces fit the size of the file.
  bool hasCounts() {
    std::int64_t vertices = 0, faces = 0, edges = 0;
    if (!take(vertices) || !take(faces) || !take(edges)) return false;
    vertices_ = static_cast<std::uint32_t>(vertices);
    faces_ = static_cast<std::uint32_t>(faces);
    constexpr std::size_t kLeastFace = 4 * kNumber;
    return vertices_ <= room() / (kNumber * header_.vertexNumbers) &&
           faces_ <= (room() - vertices_ * kNumber * header_.vertexNumbers) / kLeastFace;
  }

  Status noCounts() const {
    const std::string place = std::string(fileName_) + ": ";
    if (bytes_.size() < header_.size + 3 * kNumber)
      return {StatusCode::ParseError, place + "the file ends before the vertex and face counts"};
    return {StatusCode::ParseError,
            place + "the header declares " + counted(vertices_, "vertex", "vertices") + " and " +
                counted(faces_, "face", "faces") + ", more than fit in the " +
                std::to_string(bytes_.size()) + " bytes of the file. Is it truncated?"};
  }

  Result<PolygonMesh> run() {
    mesh_.positions.reserve(3 * vertices_);
    mesh_.faceOffsets.reserve(faces_ + 1);
    mesh_.faceOffsets.push_back(0);
    for (row_ = 0; row_ < vertices_; ++row_)
      if (Status s = readVertex(); !s.ok()) return s;
    for (row_ = 0; row_ < faces_; ++row_)
      if (Status s = readFace(); !s.ok()) return s;
    for (const char c : bytes_.substr(at_))
      if (c != '\0' && c != '\n' && c != '\r' && c != ' ')
        return Status{StatusCode::ParseError, std::string(fileName_) + ": the file has " +
                                                  counted(room(), "byte", "bytes") +
                                                  " after the last face that its header declares"};
    return std::move(mesh_);
  }

 private:
  static constexpr std::size_t kNumber = 4;  ///< bytes of every number

  std::size_t room() const { return bytes_.size() - at_; }

  bool take(std::int64_t& value) {
    if (room() < kNumber) return false;
    value = loadedFrom<std::int32_t, std::uint32_t>(bytes_.data() + at_, variant_.isBigEndian);
    at_ += kNumber;
    return true;
  }

  Status here(const char* what, const std::string& sentence) const {
    return {StatusCode::ParseError, std::string(fileName_) + ": " + what + " " +
                                        std::to_string(row_) + " (byte " + std::to_string(at_) +
                                        "): " + sentence};
  }

  Status cutOff() const {
    return {StatusCode::ParseError, std::string(fileName_) + ": the file ends at byte " +
                                        std::to_string(bytes_.size()) + ", within face " +
                                        std::to_string(row_) + " of " + std::to_string(faces_) +
                                        " (numbered from 0). Is it truncated?"};
  }

  Status readVertex() {
    for (std::size_t d = 0; d < 3; ++d) {
      const auto x = static_cast<double>(loadedFrom<float, std::uint32_t>(
          bytes_.data() + at_ + d * kNumber, variant_.isBigEndian));
      if (!std::isfinite(x))
        return here("vertex", std::string("coordinate ") + "xyz"[d] + " is not finite");
      mesh_.positions.push_back(x);
    }
    at_ += kNumber * header_.vertexNumbers;
    return {};
  }

  Status readFace() {
    std::int64_t count = 0, number = 0;
    if (!take(count)) return cutOff();
    if (count < 3)
      return here("face", "it has " + std::to_string(count) + " corners; at least 3 are needed");
    if (static_cast<std::size_t>(count) > room() / kNumber) return cutOff();
    for (std::int64_t k = 0; k < count; ++k) {
      take(number);
      if (number < 0 || static_cast<std::size_t>(number) >= vertices_)
        return here("face", "it refers to vertex " + std::to_string(number) +
                                ", but the file has " + std::to_string(vertices_) +
                                " vertices (indices start at 0)");
      mesh_.faceVertices.push_back(static_cast<std::uint32_t>(number));
    }
    mesh_.faceOffsets.push_back(static_cast<std::uint32_t>(mesh_.faceVertices.size()));
    return variant_.hasColors ? skipColor() : Status();
  }

  Status skipColor() {
    constexpr std::int64_t kMost = 4;
    std::int64_t count = 0;
    if (!take(count)) return cutOff();
    if (count < 0 || count > kMost)
      return here("face",
                  "its colour has " + std::to_string(count) + " components; at most 4 are allowed");
    if (static_cast<std::size_t>(count) > room() / kNumber) return cutOff();
    at_ += kNumber * static_cast<std::size_t>(count);
    return {};
  }

  const OffBinaryHeader& header_;
  const OffVariant variant_;
  std::string_view bytes_, fileName_;
  std::size_t at_;  ///< byte
  std::size_t vertices_ = 0, faces_ = 0, row_ = 0;
  PolygonMesh mesh_;
};

}  // namespace

Result<PolygonMesh> readOffBinary(const OffBinaryHeader& header, std::string_view bytes,
                                  std::string_view fileName) {
  Status problem;  // of the first variant that the counts allow
  for (const OffVariant variant :
       {OffVariant{true, true}, {true, false}, {false, true}, {false, false}}) {
    OffBinaryReader reader(header, variant, bytes, fileName);
    if (!reader.hasCounts()) continue;
    Result<PolygonMesh> mesh = reader.run();
    if (mesh.ok()) return mesh;
    if (problem.ok()) problem = mesh.status();
  }
  if (!problem.ok()) return problem;
  OffBinaryReader reader(header, {}, bytes, fileName);
  reader.hasCounts();
  return reader.noCounts();
}

}  // namespace abflat
