#include "files/atlas_parts.h"

#include "files/read_file.h"

namespace abflat::cli {

// Paths contain anything but zero bytes.
std::string atlasPartsText(const std::vector<AtlasPart>& parts) {
  std::string out;
  for (const AtlasPart& part : parts)
    for (const std::string* path : {&part.input, &part.output, &part.movedTo})
      out.append(*path).push_back('\0');
  return out;
}

Result<std::vector<AtlasPart>> readAtlasParts(const std::string& path) {
  const Result<std::string> text = readBytes(path);
  if (!text.ok()) return text.status();
  std::vector<std::string> words;
  for (std::size_t begin = 0, end = 0; (end = text.value().find('\0', begin)) != std::string::npos;
       begin = end + 1)
    words.push_back(text.value().substr(begin, end - begin));
  if (words.empty() || words.size() % 3 != 0)
    return Status{StatusCode::ParseError, path + " is no list of the meshes of an atlas"};
  std::vector<AtlasPart> out;
  for (std::size_t i = 0; i < words.size(); i += 3)
    out.push_back({words[i], words[i + 1], words[i + 2]});
  return out;
}

}  // namespace abflat::cli
