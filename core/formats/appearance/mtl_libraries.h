#pragma once

#include <string>
#include <vector>

#include "abflat/obj_maps.h"

namespace abflat {

/// Reads the material files that an OBJ names. The words after `mtllib` are a single file name if
/// there is such a file, otherwise one name per word. Some programs repeat a line for each object.
class MtlLibraries {
 public:
  MtlLibraries(const ReadResource& readResource, std::vector<std::string>& notes)
      : readResource_(readResource), notes_(notes) {}

  void addAll(const std::vector<std::string>& lines);
  std::vector<MtlFile> takeFound() { return std::move(found_); }

 private:
  void add(const std::string& line);
  Status read(const std::string& name);

  const ReadResource& readResource_;
  std::vector<std::string>& notes_;
  std::vector<MtlFile> found_;
};

}  // namespace abflat
