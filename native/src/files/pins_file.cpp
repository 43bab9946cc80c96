#include "files/pins_file.h"

#include "files/rows_file.h"

namespace abflat::cli {

Result<std::vector<Pin>> readPins(const std::string& path) {
  const auto read = [](std::istream& in, Pin& pin) {
    if (!readIndex(in, pin.vertex) || !(in >> pin.uv[0] >> pin.uv[1])) return false;
    return (in >> std::ws).eof() || readIndex(in, pin.face);
  };
  return readRows<Pin>(
      path, "a vertex number, u, v and optionally a face number, such as '17 0.5 1'", read);
}

}  // namespace abflat::cli
