#include "appearance/vertex_colors.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "appearance/color.h"

namespace abflat {

void makeLinear(std::vector<double>& colors) {
  double most = 0;
  for (const double x : colors)
    if (std::isfinite(x)) most = std::max(most, x);
  const double scale = most > 1 ? 1.0 / 255 : 1;
  for (std::size_t i = 0; i < colors.size(); ++i) {
    const double x = std::isfinite(colors[i]) ? scale * colors[i] : 1;
    colors[i] = i % 4 == 3 ? std::clamp(x, 0.0, 1.0) : linearOfSrgb(x);
  }
}

}  // namespace abflat
