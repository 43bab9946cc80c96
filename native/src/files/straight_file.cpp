#include "files/straight_file.h"

#include "files/rows_file.h"

namespace abflat::cli {

Result<std::vector<StraightRun>> readStraight(const std::string& path) {
  const auto read = [](std::istream& in, StraightRun& run) {
    return readIndex(in, run.from) && readIndex(in, run.to);
  };
  return readRows<StraightRun>(path, "two boundary vertices, such as '17 42'", read);
}

}  // namespace abflat::cli
