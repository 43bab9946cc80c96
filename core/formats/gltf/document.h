#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "abflat/gltf.h"
#include "gltf/buffers.h"
#include "gltf/element_shape.h"
#include "gltf/field.h"
#include "gltf/json.h"

namespace abflat::gltf {

// Entries of the lists of a glTF file, as far as geometry needs them. Indices are within their
// lists, or kNone.

/// Values that replace some of the elements.
struct SparseElements {
  std::size_t count = 0;
  std::size_t indexView = kNone, indexOffset = 0;
  ComponentType indexType = ComponentType::Uint32;
  std::size_t valueView = kNone, valueOffset = 0;
};

struct Accessor {
  std::size_t view = kNone;  ///< kNone: all zero
  std::size_t offset = 0, count = 0;
  ElementShape shape;
  bool isNormalized = false;
  std::optional<SparseElements> sparse;
};

/// Indices of accessors by attribute name.
using Attributes = std::vector<std::pair<std::string, std::size_t>>;

/// kNone if there is none.
std::size_t accessorNamed(const Attributes& attributes, const std::string& name);

enum class Mode { Points, Lines, LineLoop, LineStrip, Triangles, TriangleStrip, TriangleFan };

struct Primitive {
  Mode mode = Mode::Triangles;
  Attributes attributes;
  std::vector<Attributes> targets;
  std::size_t indices = kNone, material = kNone;
};

using Matrix = std::array<double, 16>;  ///< by columns

struct Node {
  std::vector<std::size_t> children;
  std::size_t mesh = kNone, skin = kNone;
  Matrix local{};
};

/// A glTF file that has been parsed and checked. Views are inside their buffers, accessors inside
/// their views.
struct Document {
  std::string fileName;
  bool isBinary = false;
  Json json;
  std::size_t size = 0;              ///< in bytes, with all buffers; limits what it may ask for
  std::vector<std::string> buffers;  ///< those that no view refers to are empty
  std::string otherChunks;           ///< of a .glb, as they are in the file
  std::vector<BufferView> views;
  std::vector<Accessor> accessors;
  std::vector<std::vector<Primitive>> meshes;
  std::vector<Node> nodes;
  std::optional<std::vector<std::size_t>> roots;  ///< of the scene, if there is one
  std::vector<std::string> packings;              ///< what the file was compressed with: "Draco"
  std::vector<std::size_t> decodedViews;          ///< views whose bytes were compressed

  std::string_view viewBytes(std::size_t view) const { return bytesOf(views[view], buffers); }
};

/// "meshes[2].primitives[0]"
std::string primitivePlace(std::size_t mesh, std::size_t primitive);

Result<Document> readDocument(std::string_view bytes, const std::string& fileName,
                              const ReadResource& readResource);

}  // namespace abflat::gltf
