#include "io/ply_header.h"

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <utility>

#include "base/number_text.h"
#include "io/parse_error.h"
#include "io/text_lines.h"

namespace abflat {
namespace {

struct TypeName {
  std::string_view name;
  PlyType type;
};

/// Where a type has two names, the first one is written.
constexpr std::array<TypeName, 16> kTypeNames = {{
    {"char", PlyType::Int8},
    {"uchar", PlyType::Uint8},
    {"short", PlyType::Int16},
    {"ushort", PlyType::Uint16},
    {"int", PlyType::Int32},
    {"uint", PlyType::Uint32},
    {"float", PlyType::Float32},
    {"double", PlyType::Float64},
    {"int8", PlyType::Int8},
    {"uint8", PlyType::Uint8},
    {"int16", PlyType::Int16},
    {"uint16", PlyType::Uint16},
    {"int32", PlyType::Int32},
    {"uint32", PlyType::Uint32},
    {"float32", PlyType::Float32},
    {"float64", PlyType::Float64},
}};

bool parseType(std::string_view word, PlyType& type) {
  for (const TypeName& known : kTypeNames)
    if (known.name == word) {
      type = known.type;
      return true;
    }
  return false;
}

class HeaderReader {
 public:
  HeaderReader(std::string_view bytes, std::string_view fileName)
      : bytes_(bytes), rest_(bytes), fileName_(fileName) {}

  Result<PlyHeader> run() {
    if (bytes_.empty())
      return Status{StatusCode::ParseError, std::string(fileName_) + ": the file is empty"};
    header_.lineEnd = lineEnd(bytes_.substr(0, lineSize(bytes_)));
    std::string_view words;
    nextLine(words);
    if (const std::string_view word = takeWord(words); word != "ply" || !takeWord(words).empty())
      return here("not a PLY file: it begins with " + quoted(word));
    bool hasFormat = false;
    while (nextLine(words)) {
      const std::string_view keyword = takeWord(words);
      if (keyword == "end_header") return hasFormat ? finished() : here("the header has no format");
      Status s;
      if (keyword == "format") {
        s = format(words);
        hasFormat = true;
      } else if (keyword == "element") {
        s = element(words);
      } else if (keyword == "property") {
        s = property(words);
      } else if (keyword != "comment" && keyword != "obj_info" && !keyword.empty()) {
        s = here(quoted(keyword) +
                 " is not format, comment, obj_info, element, property or "
                 "end_header");
      }
      if (!s.ok()) return s;
    }
    return here("the header has no end_header. Is the file truncated?");
  }

 private:
  Status here(const std::string& sentence) const {
    return parseError(fileName_, header_.lines, sentence);
  }

  bool nextLine(std::string_view& words) {
    const std::string_view line = headerLine(rest_, header_.lineEnd);
    if (line.empty()) return false;
    rest_.remove_prefix(line.size());
    ++header_.lines;
    words = line.substr(0, line.find_first_of("\r\n"));
    return true;
  }

  Status format(std::string_view words) {
    const std::string_view name = takeWord(words), version = takeWord(words);
    if (name == "ascii")
      header_.encoding = PlyEncoding::Text;
    else if (name == "binary_little_endian")
      header_.encoding = PlyEncoding::LittleEndian;
    else if (name == "binary_big_endian")
      header_.encoding = PlyEncoding::BigEndian;
    else
      return here(quoted(name) + " is not ascii, binary_little_endian or binary_big_endian");
    if (version != "1.0") return here("PLY version " + quoted(version) + " is not supported");
    return {};
  }

  Status element(std::string_view words) {
    PlyElement e;
    e.name = takeWord(words);
    const std::string_view word = takeWord(words);
    std::int64_t count = 0;
    if (e.name.empty() || !parseInteger(word, count) || count < 0 || !takeWord(words).empty())
      return here("expected 'element NAME COUNT'");
    e.count = static_cast<std::uint64_t>(count);
    if (!elementNames_.insert(e.name).second) return here("duplicate element " + quoted(e.name));
    propertyNames_.clear();
    header_.elements.push_back(std::move(e));
    return {};
  }

  Status property(std::string_view words) {
    if (header_.elements.empty()) return here("this property comes before any element");
    PlyElement& e = header_.elements.back();
    PlyProperty p;
    std::string_view type = takeWord(words);
    if (type == "list") {
      p.isList = true;
      const std::string_view count = takeWord(words);
      if (!parseType(count, p.countType)) return here(quoted(count) + " is not a PLY type");
      type = takeWord(words);
    }
    if (!parseType(type, p.type)) return here(quoted(type) + " is not a PLY type");
    p.name = takeWord(words);
    if (p.name.empty() || !takeWord(words).empty())
      return here("expected 'property TYPE NAME' or 'property list TYPE TYPE NAME'");
    if (!propertyNames_.insert(p.name).second)
      return here("duplicate property " + quoted(p.name) + " of element " + quoted(e.name));
    e.hasLists = e.hasLists || p.isList;
    e.leastBytes += sizeOf(p.isList ? p.countType : p.type);
    e.properties.push_back(p);
    return {};
  }

  Result<PlyHeader> finished() {
    header_.text = bytes_.substr(0, bytes_.size() - rest_.size());
    for (std::size_t i = 0; i < header_.elements.size(); ++i) {
      if (header_.elements[i].name == "vertex") header_.vertex = i;
      if (header_.elements[i].name == "face") header_.face = i;
    }
    if (Status s = findVertices(); !s.ok()) return s;
    if (Status s = findFaces(); !s.ok()) return s;
    return std::move(header_);
  }

  Status findVertices() {
    if (header_.vertex == kNoIndex) return here("the header has no element 'vertex'");
    const PlyElement& e = header_.elements[header_.vertex];
    for (const auto& [name, index] : {std::pair<const char*, std::size_t*>{"x", &header_.x},
                                      {"y", &header_.y},
                                      {"z", &header_.z}}) {
      *index = e.find(name);
      if (*index == kNoIndex || e.properties[*index].isList)
        return here(std::string("element 'vertex' has no scalar property '") + name + "'");
    }
    if (e.count > 0xffffffff) return here("more than 4294967295 vertices are not supported");
    const std::array<std::size_t, 3> normal = {e.find("nx"), e.find("ny"), e.find("nz")};
    const auto isNumber = [&](std::size_t p) { return p != kNoIndex && !e.properties[p].isList; };
    if (std::all_of(normal.begin(), normal.end(), isNumber)) header_.normal = normal;
    for (const auto& [u, v] : kPlyTexcoordNames) {
      const std::size_t first = e.find(u), second = e.find(v);
      if (header_.u != kNoIndex || first == kNoIndex || second == kNoIndex) continue;
      if (e.properties[first].isList || e.properties[second].isList) continue;
      header_.u = first;
      header_.v = second;
    }
    return {};
  }

  Status findFaces() {
    for (std::size_t i = 0; i < header_.elements.size(); ++i)
      if (header_.elements[i].name == "tristrips" && header_.elements[i].count > 0) {
        if (header_.face != kNoIndex)
          return here("the header has both 'face' and 'tristrips'. Save the mesh with one of them");
        header_.face = i;
        header_.hasStrips = true;
      }
    if (header_.face == kNoIndex) return {};
    const PlyElement& e = header_.elements[header_.face];
    for (const char* name : {"vertex_indices", "vertex_index"})
      if (header_.corners == kNoIndex) header_.corners = e.find(name);
    if (header_.corners == kNoIndex || !e.properties[header_.corners].isList)
      return here("element '" + std::string(e.name) +
                  "' has no list property 'vertex_indices' or 'vertex_index'");
    if (header_.hasStrips) return {};
    for (std::size_t p = e.properties.size(); p-- > 0;)
      if (isCornerTexcoords(e.properties[p])) header_.cornerTexcoords = p;
    if (header_.cornerTexcoords != kNoIndex) header_.u = header_.v = kNoIndex;
    return {};
  }

  std::string_view bytes_, rest_, fileName_;
  PlyHeader header_;
  std::set<std::string_view> elementNames_, propertyNames_;  ///< the latter: of the last element
};

}  // namespace

std::string_view nameOf(PlyType type) { return kTypeNames[static_cast<std::size_t>(type)].name; }

std::size_t PlyElement::find(std::string_view property) const {
  for (std::size_t i = 0; i < properties.size(); ++i)
    if (properties[i].name == property) return i;
  return kNoIndex;
}

std::string_view headerLine(std::string_view rest, std::string_view lineEnd) {
  const std::size_t end = rest.find(lineEnd == "\r" ? '\r' : '\n');
  return rest.substr(0, end == std::string_view::npos ? rest.size() : end + 1);
}

Result<PlyHeader> readPlyHeader(std::string_view bytes, std::string_view fileName) {
  return HeaderReader(bytes, fileName).run();
}

}  // namespace abflat
