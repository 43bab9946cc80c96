#include "gltf/decompress_meshopt.h"

#include <meshoptimizer.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gltf/json_extensions.h"
#include "gltf/meshopt_extension.h"

namespace abflat::gltf {
namespace {

enum class Coding { Attributes, Triangles, Indices };
enum class Filter { None, Octahedral, Quaternion, Exponential };

/// A view as its extension describes it.
struct Packed {
  std::size_t view = kNone;
  std::string place;
  BufferView source;
  std::size_t count = 0, stride = 0;
  Coding coding = Coding::Attributes;
  Filter filter = Filter::None;
};

Coding codingOf(const Field& mode) {
  const std::string name = mode.text();
  if (name == "TRIANGLES") return Coding::Triangles;
  if (name == "INDICES") return Coding::Indices;
  if (name != "ATTRIBUTES") mode.complain("must be ATTRIBUTES, TRIANGLES or INDICES");
  return Coding::Attributes;
}

Filter filterOf(const Field& filter) {
  const std::string name = filter.text();
  if (name == "OCTAHEDRAL") return Filter::Octahedral;
  if (name == "QUATERNION") return Filter::Quaternion;
  if (name == "EXPONENTIAL") return Filter::Exponential;
  if (name == "COLOR")
    filter.complain("is COLOR, which abflat cannot decode. Save the file without compression");
  else if (filter.isPresent() && name != "NONE")
    filter.complain("must be NONE, OCTAHEDRAL, QUATERNION or EXPONENTIAL");
  return Filter::None;
}

/// What the decoder takes for granted, and so must be checked.
bool hasFittingStride(const Packed& packed) {
  constexpr std::size_t kMost = 256;
  const std::size_t n = packed.stride;
  if (packed.coding != Coding::Attributes) return n == 2 || n == 4;
  if (packed.filter == Filter::Octahedral) return n == 4 || n == 8;
  if (packed.filter == Filter::Quaternion) return n == 8;
  return n > 0 && n % 4 == 0 && n <= kMost;
}

Packed packedOf(const Field& view, const Document& document) {
  const Field extension = meshoptExtension(view);
  Packed out;
  out.place = extension.place();
  out.source = readView(extension, document.buffers);
  out.count = extension["count"].count();
  out.stride = extension["byteStride"].count();
  out.coding = codingOf(extension["mode"]);
  out.filter = filterOf(extension["filter"]);
  if (out.coding != Coding::Attributes && out.filter != Filter::None)
    extension["filter"].complain("applies to the mode ATTRIBUTES only");
  if (!hasFittingStride(out))
    extension["byteStride"].complain("does not fit the mode and the filter");
  if (out.count == 0 || (out.coding == Coding::Triangles && out.count % 3 != 0))
    extension["count"].complain("does not fit the mode");
  const std::size_t stride = view["byteStride"].count(out.stride);
  if (stride != out.stride) extension["byteStride"].complain("differs from that of its bufferView");
  return out;
}

bool decodeInto(char* out, const Packed& packed, std::string_view bytes) {
  const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
  switch (packed.coding) {
    case Coding::Attributes:
      return meshopt_decodeVertexBuffer(out, packed.count, packed.stride, data, bytes.size()) == 0;
    case Coding::Triangles:
      return meshopt_decodeIndexBuffer(out, packed.count, packed.stride, data, bytes.size()) == 0;
    case Coding::Indices:
      return meshopt_decodeIndexSequence(out, packed.count, packed.stride, data, bytes.size()) == 0;
  }
  return false;
}

void applyFilter(char* values, const Packed& packed) {
  if (packed.filter == Filter::Octahedral)
    meshopt_decodeFilterOct(values, packed.count, packed.stride);
  if (packed.filter == Filter::Quaternion)
    meshopt_decodeFilterQuat(values, packed.count, packed.stride);
  if (packed.filter == Filter::Exponential)
    meshopt_decodeFilterExp(values, packed.count, packed.stride);
}

/// Why the decoder rejects the bytes.
std::string reason(const Packed& packed, std::string_view bytes) {
  constexpr unsigned char kVertexVersion1 = 0xa1;
  const bool isNewer = packed.coding == Coding::Attributes && !bytes.empty() &&
                       static_cast<unsigned char>(bytes[0]) == kVertexVersion1;
  return isNewer ? " has vertices in version 1 of meshopt's format, which this build cannot "
                   "decode. Save the file without compression"
                 : " has damaged compressed bytes. Export the file again";
}

/// The bytes that a compressed view stands for.
std::string decoded(const Packed& packed, const Document& document, Budget& budget,
                    Complaints& complaints) {
  const std::string_view bytes = bytesOf(packed.source, document.buffers);
  if (!budget.take(packed.count * packed.stride)) {
    complaints.add(packed.place + " decodes to far more than the " + std::to_string(document.size) +
                   " bytes of the file allow");
    return {};
  }
  std::string out(packed.count * packed.stride, '\0');
  if (decodeInto(out.data(), packed, bytes))
    applyFilter(out.data(), packed);
  else
    complaints.add(packed.place + reason(packed, bytes));
  return out;
}

}  // namespace

bool decompressViews(Document& document, DecodedViews& views, Complaints& complaints) {
  std::vector<Packed> all;
  const std::vector<Field> fields = Field(&document.json, "", complaints)["bufferViews"].items();
  for (std::size_t v = 0; v < fields.size(); ++v) {
    if (!meshoptExtension(fields[v]).isPresent()) continue;
    all.push_back(packedOf(fields[v], document));
    all.back().view = v;
  }
  for (const Packed& packed : all) {
    if (!complaints.none()) return false;
    std::string bytes = decoded(packed, document, views.budget(), complaints);
    views.put(packed.view, std::move(bytes));
  }
  for (const char* list : {"bufferViews", "buffers"})
    for (const char* name : kMeshoptExtensions) removeExtension(document.json, list, name);
  return !all.empty();
}

}  // namespace abflat::gltf
