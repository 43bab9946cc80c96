#include "appearance/mtl_libraries.h"

#include <set>
#include <string_view>

#include "appearance/images.h"
#include "base/number_text.h"

namespace abflat {

void MtlLibraries::addAll(const std::vector<std::string>& lines) {
  std::set<std::string_view> known;
  for (const std::string& line : lines)
    if (known.insert(line).second) add(line);
}

void MtlLibraries::add(const std::string& line) {
  constexpr const char* kNamesOnly = " keep only their names: ";
  const Status whole = read(line);
  if (whole.ok()) return;
  std::vector<std::string> missing;
  std::string_view words = line;
  bool hasAny = false;
  for (std::string_view word = takeWord(words); !word.empty(); word = takeWord(words)) {
    const Status s = read(std::string(word));
    hasAny = hasAny || s.ok();
    if (!s.ok())
      missing.push_back("the materials in " + std::string(word) + kNamesOnly + s.message);
  }
  if (!hasAny) missing = {"the materials in " + line + kNamesOnly + whole.message};
  notes_.insert(notes_.end(), missing.begin(), missing.end());
}

Status MtlLibraries::read(const std::string& name) {
  Result<std::string> text = readResource_(name);
  if (!text.ok()) return text.status();
  found_.push_back({std::move(text).value(), folderOf(name)});
  return {};
}

}  // namespace abflat
