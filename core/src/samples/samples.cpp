#include "abflat/samples.h"

#include "samples/generators.h"

namespace abflat {

const std::vector<Sample>& samples() {
  static const std::vector<Sample> all{
      {"hemisphere", "Half sphere", makeHemisphere},
      {"wavy-strip", "Wavy strip", makeWavyStrip},
      {"head", "Head", makeHead},
      {"alpha-band", "Alpha-shaped band", makeAlphaBand},
      {"three-balls", "Square with three balls", makeThreeBalls},
  };
  return all;
}

}  // namespace abflat
