#include "io/ply_plan.h"

#include <algorithm>

#include "base/number_text.h"
#include "io/ply_value.h"

namespace abflat {
namespace {

/// s and t are always texcoords, because they are written anew; one name of any other pair alone
/// means something else.
bool isTexcoord(const PlyElement& vertex, std::size_t property) {
  const std::string_view ownName = vertex.properties[property].name;
  if (ownName == "s" || ownName == "t") return true;
  const auto isNumber = [&](std::string_view name) {
    const std::size_t p = vertex.find(name);
    return p != kNoIndex && !vertex.properties[p].isList;
  };
  for (const auto& pair : kPlyTexcoordNames)
    for (const std::string_view name : pair)
      if (ownName == name) return isNumber(pair[0]) && isNumber(pair[1]);
  return false;
}

/// `type`, or `wide` if `type` cannot hold the number.
PlyType roomy(PlyType type, PlyType wide, double number) {
  return number <= largestWhole(type) ? type : wide;
}

double mostCorners(const PolygonMesh& mesh) {
  std::uint32_t most = 0;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f)
    most = std::max(most, mesh.faceOffsets[f + 1] - mesh.faceOffsets[f]);
  return most;
}

void putProperty(TextWriter& out, const PlyProperty& property, const PlyTarget& target) {
  out.put("property ");
  if (property.isList) {
    out.put("list ");
    out.put(nameOf(target.countType));
    out.put(' ');
  }
  out.put(nameOf(target.type));
  out.put(' ');
  out.put(property.name);
}

/// What the triangles of strips are written as.
PlyProperty stripFaces() {
  PlyProperty out;
  out.name = "vertex_indices";
  out.isList = true;
  out.countType = PlyType::Uint8;
  out.type = PlyType::Int32;
  return out;
}

class HeaderWriter {
 public:
  HeaderWriter(TextWriter& out, const PlyHeader& header, const PlyPlan& plan,
               std::uint64_t vertexCount, std::uint64_t faceCount)
      : out_(out), header_(header), plan_(plan), vertexCount_(vertexCount), faceCount_(faceCount) {}

  void run() {
    for (std::string_view rest = header_.text; !rest.empty();) {
      const std::string_view line = headerLine(rest, header_.lineEnd);
      rest.remove_prefix(line.size());
      std::string_view words = line.substr(0, line.find_first_of("\r\n"));
      const std::string_view keyword = takeWord(words);
      if (keyword == "element")
        putElement(line, words);
      else if (keyword == "property")
        putNextProperty(line);
      else
        out_.put(line);
    }
  }

 private:
  void putElement(std::string_view line, std::string_view words) {
    const bool isFirst = element_ == kNoIndex;
    element_ = isFirst ? 0 : element_ + 1;
    property_ = 0;
    const std::string_view name = takeWord(words);
    if (element_ == header_.vertex) return putElement(name, vertexCount_);
    if (!isOfStrips()) return out_.put(line);
    putElement("face", faceCount_);
    putProperty(out_, stripFaces(), plan_.face.front());
    out_.put(header_.lineEnd);
  }

  void putElement(std::string_view name, std::uint64_t count) {
    out_.put("element ");
    out_.put(name);
    out_.put(' ');
    out_.put(static_cast<std::uint32_t>(count));
    out_.put(header_.lineEnd);
  }

  bool isOfStrips() const { return header_.hasStrips && element_ == header_.face; }

  void putNextProperty(std::string_view line) {
    if (isOfStrips()) return;
    const PlyElement& element = header_.elements[element_];
    const PlyProperty& property = element.properties[property_];
    const std::vector<PlyTarget>* targets = element_ == header_.vertex ? &plan_.vertex
                                            : element_ == header_.face ? &plan_.face
                                                                       : nullptr;
    const PlyTarget target =
        targets == nullptr ? PlyTarget{PlyTarget::Source::Copied, property.type, property.countType}
                           : (*targets)[property_];
    const bool isSame = target.type == property.type && target.countType == property.countType;
    if (target.source != PlyTarget::Source::Dropped) {
      if (isSame) {
        out_.put(line);
      } else {
        putProperty(out_, property, target);
        out_.put(header_.lineEnd);
      }
    }
    ++property_;
    if (element_ == header_.vertex && property_ == element.properties.size()) putTexcoords();
  }

  void putTexcoords() {
    for (const std::string_view name : {"s", "t"}) {
      out_.put("property ");
      out_.put(nameOf(plan_.uvType));
      out_.put(' ');
      out_.put(name);
      out_.put(header_.lineEnd);
    }
  }

  TextWriter& out_;
  const PlyHeader& header_;
  const PlyPlan& plan_;
  std::uint64_t vertexCount_, faceCount_;
  std::size_t element_ = kNoIndex, property_ = 0;
};

}  // namespace

PlyType smallestType(const std::vector<double>& numbers) {
  for (const double x : numbers)
    if (static_cast<double>(static_cast<float>(x)) != x) return PlyType::Float64;
  return PlyType::Float32;
}

PlyPlan makePlyPlan(const PlyHeader& header, const PolygonMesh& mesh,
                    const SplitVertices& vertices) {
  PlyPlan plan;
  plan.uvType = smallestType(vertices.uv);
  const PlyElement& vertex = header.elements[header.vertex];
  for (std::size_t p = 0; p < vertex.properties.size(); ++p) {
    const PlyProperty& property = vertex.properties[p];
    PlyTarget target{PlyTarget::Source::Copied, property.type, property.countType};
    if (isTexcoord(vertex, p)) {
      target.source = PlyTarget::Source::Dropped;
      plan.dropsFromVertex = true;
    }
    plan.vertex.push_back(target);
  }
  if (header.face == kNoIndex) return plan;
  const double corners = mostCorners(mesh);
  const std::size_t written = vertices.uv.size() / 2;
  const double lastVertex = static_cast<double>(written) - 1;
  const PlyElement& face = header.elements[header.face];
  for (std::size_t p = 0; p < (header.hasStrips ? 1 : face.properties.size()); ++p) {
    const PlyProperty property = header.hasStrips ? stripFaces() : face.properties[p];
    PlyTarget target{PlyTarget::Source::Copied, property.type, property.countType};
    if (header.hasStrips || p == header.corners) {
      target.source = PlyTarget::Source::Corners;
      target.type =
          roomy(roomy(property.type, PlyType::Int32, lastVertex), PlyType::Uint32, lastVertex);
    } else if (isCornerTexcoords(property)) {
      target.source = PlyTarget::Source::Texcoords;
      target.type = plan.uvType;
      target.countType = roomy(property.countType, PlyType::Int32, 2 * corners);
    }
    plan.face.push_back(target);
  }
  return plan;
}

void putPlyHeader(TextWriter& out, const PlyHeader& header, const PlyPlan& plan,
                  std::uint64_t vertexCount, std::uint64_t faceCount) {
  HeaderWriter(out, header, plan, vertexCount, faceCount).run();
}

}  // namespace abflat
