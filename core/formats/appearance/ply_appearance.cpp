#include "appearance/images.h"
#include "appearance/ply_columns.h"
#include "appearance/readers.h"
#include "base/number_text.h"
#include "io/ply_value.h"
#include "io/text_lines.h"

namespace abflat {
namespace {

/// The numeric properties of vertices with these names; empty if one is missing.
std::vector<std::size_t> propertiesNamed(const PlyElement& vertex,
                                         std::initializer_list<std::string_view> names) {
  std::vector<std::size_t> out;
  for (const std::string_view name : names) {
    const std::size_t p = vertex.find(name);
    if (p == kNoIndex || vertex.properties[p].isList) return {};
    out.push_back(p);
  }
  return out;
}

/// Integers are fractions of the largest value of their type, other numbers are taken as they are.
double scaleOf(PlyType type) {
  return type == PlyType::Float32 || type == PlyType::Float64 ? 1 : 1 / largestWhole(type);
}

void readColors(const PlyHeader& header, std::string_view bytes, Appearance& out) {
  const PlyElement& vertex = header.elements[header.vertex];
  std::vector<std::size_t> properties = propertiesNamed(vertex, {"red", "green", "blue"});
  if (properties.empty())
    properties = propertiesNamed(vertex, {"diffuse_red", "diffuse_green", "diffuse_blue"});
  if (properties.empty()) properties = propertiesNamed(vertex, {"r", "g", "b"});
  if (properties.empty()) return;
  for (const std::size_t alpha : propertiesNamed(vertex, {"alpha"})) properties.push_back(alpha);
  const std::vector<double> values = plyColumns(header, bytes, properties);
  const std::size_t size = properties.size();
  out.colors.reserve(4 * (values.size() / size));
  for (std::size_t i = 0; i < values.size(); i += size)
    for (std::size_t d = 0; d < 4; ++d)
      out.colors.push_back(d < size ? scaleOf(vertex.properties[properties[d]].type) * values[i + d]
                                    : 1);
}

/// "comment TextureFile NAME", as MeshLab and photogrammetry tools write it; applies to the whole
/// mesh if there is only one.
void readTexture(const PlyHeader& header, const ReadResource& readResource, Appearance& out) {
  std::string name;
  std::string_view rest = header.text;
  while (!rest.empty()) {
    std::string_view line = headerLine(rest, header.lineEnd);
    rest.remove_prefix(line.size());
    if (takeWord(line) != "comment" || takeWord(line) != "TextureFile") continue;
    if (!name.empty()) return;
    name = restOfLine(line);
  }
  if (!name.empty())
    out.materials.emplace_back().image =
        Images(readResource, ImageTypes::OfGltf, out.images, out.notes).numberOf("", name);
}

}  // namespace

void readPlyAppearance(std::string_view bytes, const ReadResource& readResource, Appearance& out) {
  const Result<PlyHeader> header = readPlyHeader(bytes, {});
  if (!header.ok()) return;  // the mesh was not read from these bytes
  readColors(header.value(), bytes, out);
  readTexture(header.value(), readResource, out);
}

}  // namespace abflat
