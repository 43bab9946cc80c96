#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/number_text.h"
#include "io/parse_error.h"
#include "io/ply_messages.h"
#include "io/ply_row.h"
#include "io/ply_texcoords.h"
#include "io/read_ply.h"
#include "io/settle_normals.h"
#include "io/triangle_strip.h"

namespace abflat {
namespace {

std::string numberText(double value) {
  std::array<char, kMostDoubleChars> text{};
  return {text.data(), writeDouble(text.data(), value)};
}

class BinaryReader {
 public:
  BinaryReader(const PlyHeader& header, std::string_view bytes, std::string_view fileName)
      : header_(header),
        isBigEndian_(header.encoding == PlyEncoding::BigEndian),
        begin_(bytes.data()),
        at_(begin_ + header.text.size()),
        end_(begin_ + bytes.size()),
        fileName_(fileName) {}

  Result<PolygonMesh> run() {
    mesh_.faceOffsets.push_back(0);
    for (std::size_t i = 0; i < header_.elements.size(); ++i) {
      element_ = &header_.elements[i];
      row_ = 0;
      if (element_->count == 0 || element_->properties.empty()) continue;
      // A false count must not make the reader reserve more memory than the file size warrants.
      if (room() / element_->leastBytes < element_->count) return cutOff();
      const Status s = i == header_.vertex ? vertices() : i == header_.face ? faces() : skipped();
      if (!s.ok()) return s;
    }
    // Padding is harmless; anything else means that a count is wrong.
    for (const char* c = at_; c != end_; ++c)
      if (*c != '\0' && *c != '\n' && *c != '\r' && *c != ' ')
        return Status{StatusCode::ParseError,
                      std::string(fileName_) + ": the file has " + std::to_string(room()) +
                          " bytes after the last element that its header declares"};
    finishTexcoords(header_, mesh_);
    takeVertexNormals(mesh_);
    return std::move(mesh_);
  }

 private:
  /// Of the element; never more than the remaining bytes allow.
  std::size_t rows() const { return static_cast<std::size_t>(element_->count); }
  std::size_t room() const { return static_cast<std::size_t>(end_ - at_); }

  std::string fileEnds() const {
    return std::string(fileName_) + ": the file ends at byte " + std::to_string(end_ - begin_);
  }

  Status cutOff() const {
    return {StatusCode::ParseError, fileEnds() + " before the " +
                                        rowsOf(element_->count, *element_) +
                                        " that its header declares. Is it truncated?"};
  }

  Status here(const std::string& sentence) const {
    return {StatusCode::ParseError,
            std::string(fileName_) + ": " + std::string(element_->name.substr(0, 40)) + " " +
                std::to_string(row_) + " (byte " + std::to_string(at_ - begin_) + "): " + sentence};
  }

  Status take(const PlyProperty& property, PlyField& field) {
    switch (scanField(property, at_, end_, isBigEndian_, field)) {
      case PlyScan::Ok:
        at_ = field.end;
        return {};
      case PlyScan::CutOff:
        return {StatusCode::ParseError, fileEnds() + ", within " + quoted(element_->name) + " " +
                                            std::to_string(row_) + " of " +
                                            std::to_string(element_->count) +
                                            " (numbered from 0). Is it truncated?"};
      case PlyScan::BadCount:
        break;
    }
    return here("the length of list " + quoted(property.name) + " is not a whole number");
  }

  Status skipped() {
    if (!element_->hasLists) {
      at_ += rows() * element_->leastBytes;
      return {};
    }
    PlyField field;
    for (; row_ < element_->count; ++row_)
      for (const PlyProperty& property : element_->properties)
        if (Status s = take(property, field); !s.ok()) return s;
    return {};
  }

  Status vertices() {
    mesh_.positions.reserve(3 * rows());
    if (hasUv()) mesh_.texcoords.reserve(2 * rows());
    if (hasNormal()) mesh_.normals.reserve(3 * rows());
    // All rows have the same size, so the numbers are read at fixed offsets.
    std::size_t offsets[kNumbers] = {};
    for (std::size_t d = 0; d < kNumbers; ++d)
      for (std::size_t p = 0; p < property(d) && p < element_->properties.size(); ++p)
        offsets[d] += sizeOf(element_->properties[p].type);
    for (; row_ < element_->count; ++row_) {
      const char* numbers[kNumbers];
      for (std::size_t d = 0; d < kNumbers; ++d) numbers[d] = at_ + offsets[d];
      const char* next = at_ + element_->leastBytes;
      if (element_->hasLists)
        if (Status s = scanRow(numbers, next); !s.ok()) return s;
      for (std::size_t d = 0; d < 3; ++d) {
        const double value =
            loadNumber(numbers[d], element_->properties[property(d)].type, isBigEndian_);
        if (!std::isfinite(value))
          return here(std::string("coordinate ") + "xyz"[d] + " is not finite");
        mesh_.positions.push_back(value);
      }
      for (std::size_t d = 3; hasUv() && d < 5; ++d)
        mesh_.texcoords.push_back(
            loadNumber(numbers[d], element_->properties[property(d)].type, isBigEndian_));
      for (std::size_t d = 5; hasNormal() && d < kNumbers; ++d)
        mesh_.normals.push_back(
            loadNumber(numbers[d], element_->properties[property(d)].type, isBigEndian_));
      at_ = next;
    }
    return {};
  }

  /// Numbers read per vertex: x, y, z, u, v, nx, ny, nz.
  static constexpr std::size_t kNumbers = 8;
  std::size_t property(std::size_t d) const {
    const std::size_t of[5] = {header_.x, header_.y, header_.z, header_.u, header_.v};
    return d < 5 ? of[d] : header_.normal[d - 5];
  }
  bool hasUv() const { return header_.u != kNoIndex; }
  bool hasNormal() const { return header_.normal[0] != kNoIndex; }

  /// For a vertex with lists: finds its numbers and the next row.
  Status scanRow(const char* (&numbers)[kNumbers], const char*& next) {
    const char* const row = at_;
    PlyField field;
    for (std::size_t p = 0; p < element_->properties.size(); ++p) {
      if (Status s = take(element_->properties[p], field); !s.ok()) return s;
      for (std::size_t d = 0; d < kNumbers; ++d)
        if (p == property(d)) numbers[d] = field.numbers;
    }
    next = std::exchange(at_, row);
    return {};
  }

  Status faces() {
    mesh_.faceOffsets.reserve(rows() + 1);
    const PlyType type = element_->properties[header_.corners].type;
    mesh_.faceVertices.reserve(std::min(3 * rows(), room() / sizeOf(type)));
    for (; row_ < element_->count; ++row_) {
      uv_.clear();
      for (std::size_t p = 0; p < element_->properties.size(); ++p) {
        PlyField field;
        if (Status s = take(element_->properties[p], field); !s.ok()) return s;
        if (p == header_.cornerTexcoords) cornerTexcoords(field, element_->properties[p].type);
        if (p != header_.corners) continue;
        if (Status s = header_.hasStrips ? strips(field, type) : face(field, type); !s.ok())
          return s;
        if (mesh_.faceVertices.size() > 0xffffffff) return here(kTooManyCorners);
      }
      if (header_.cornerTexcoords != kNoIndex) appendTexcoords(uv_, mesh_);
    }
    return {};
  }

  void cornerTexcoords(const PlyField& field, PlyType type) {
    const char* number = field.numbers;
    for (std::size_t k = 0; k < field.count; ++k, number += sizeOf(type))
      uv_.push_back(loadNumber(number, type, isBigEndian_));
  }

  bool isVertex(double value) const {
    const auto vertices = static_cast<double>(header_.elements[header_.vertex].count);
    // No std::floor: it is a function call on targets without an instruction for it.
    return value >= 0 && value < vertices &&
           value == static_cast<double>(static_cast<std::uint32_t>(value));
  }

  Status strips(const PlyField& field, PlyType type) {
    TriangleStrip strip(mesh_);
    const char* number = field.numbers;
    for (std::size_t k = 0; k < field.count; ++k, number += sizeOf(type)) {
      const double value = loadNumber(number, type, isBigEndian_);
      if (value == -1)
        strip.end();
      else if (isVertex(value))
        strip.add(static_cast<std::uint32_t>(value));
      else
        return here(noSuchEntry(k, numberText(value), header_.elements[header_.vertex].count));
    }
    return {};
  }

  Status face(const PlyField& field, PlyType type) {
    if (field.count < 3) return here(tooFewCorners(field.count));
    const char* number = field.numbers;
    for (std::size_t k = 0; k < field.count; ++k, number += sizeOf(type)) {
      const double value = loadNumber(number, type, isBigEndian_);
      if (!isVertex(value))
        return here(noSuchVertex(numberText(value), header_.elements[header_.vertex].count));
      mesh_.faceVertices.push_back(static_cast<std::uint32_t>(value));
    }
    mesh_.faceOffsets.push_back(static_cast<std::uint32_t>(mesh_.faceVertices.size()));
    return {};
  }

  const PlyHeader& header_;
  bool isBigEndian_;
  const char *begin_, *at_, *end_;
  std::string_view fileName_;
  const PlyElement* element_ = nullptr;
  std::uint64_t row_ = 0;
  std::vector<double> uv_;  ///< of the corners of one face
  PolygonMesh mesh_;
};

}  // namespace

Result<PolygonMesh> readPlyBinary(const PlyHeader& header, std::string_view bytes,
                                  std::string_view fileName) {
  return BinaryReader(header, bytes, fileName).run();
}

}  // namespace abflat
