#include "solve/element.h"

namespace abflat {

std::array<double, 21> elementMatrix(const Element& e) {
  // Rows of B: row 2k is the unit vector k, row 2k+1 has cot at k+1 and -cot at k+2.
  std::array<std::array<double, 3>, 6> b{}, pb{};
  for (unsigned k = 0; k < 3; ++k) {
    b[2 * k][k] = 1;
    b[2 * k + 1][(k + 1) % 3] = e.cot[(k + 1) % 3];
    b[2 * k + 1][(k + 2) % 3] = -e.cot[(k + 2) % 3];
  }
  for (unsigned r = 0; r < 6; ++r) pb[r] = applyProjected(e, b[r]);
  std::array<double, 21> m;
  unsigned i = 0;
  for (unsigned r = 0; r < 6; ++r)
    for (unsigned c = 0; c <= r; ++c)
      m[i++] = b[r][0] * pb[c][0] + b[r][1] * pb[c][1] + b[r][2] * pb[c][2];
  return m;
}

}  // namespace abflat
