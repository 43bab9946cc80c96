#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace abflat {

/// In pixels from the upper left corner of the picture.
struct PixelPoint {
  double x = 0, y = 0;
};

/// Red, green, blue, each from 0 to 1.
using Rgb = std::array<float, 3>;

/// Inks of lines, and how opaque they are.
struct BandInks {
  Rgb ink = {};  ///< of thin and thick lines
  float thinOpacity = 1, thickOpacity = 1;
  Rgb mark = {};
};

/// Some rows of a picture: areas, and lines of three kinds above them. Nothing is drawn outside.
class Band {
 public:
  Band(int width, int firstRow, int rows);

  /// Adds the exact share of each pixel that a simple polygon covers: neighbours that share an edge
  /// cover it without a gap.
  void fill(const std::vector<PixelPoint>& polygon, const Rgb& colour);

  enum class Line : std::uint8_t { Thin, Thick, Mark };
  /// With round ends. Lines of one kind form a single shape: they are no darker where they meet.
  void draw(Line kind, const PixelPoint& from, const PixelPoint& to, double width);

  /// Areas at the bottom, then thin and thick lines, then marks; transparent elsewhere.
  std::vector<std::uint8_t> rgba(const BandInks& inks) const;

 private:
  void addEdge(PixelPoint from, PixelPoint to);

  int width_, firstRow_, rows_;
  std::vector<std::array<float, 4>> areas_;  ///< colours times shares, and shares
  std::array<std::vector<float>, 3> lines_;  ///< shares by kind
  /// For the current polygon: what each column adds to the cover of those on its right.
  std::vector<double> steps_;
  int left_ = 0, top_ = 0, bottom_ = 0;
  std::size_t stride_ = 0;
};

}  // namespace abflat
