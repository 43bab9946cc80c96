#include "expect.h"

#include <cstdio>
#include <cstdlib>

namespace abflat::fuzz {

void expect(bool holds, const std::string& property) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", property.c_str());
  std::abort();
}

}  // namespace abflat::fuzz
