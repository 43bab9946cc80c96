#pragma once

#include <string>
#include <vector>

#include "abflat/flatten.h"
#include "abflat/unwrap.h"

namespace abflat {

/// A picture in CSS pixels, to be put beside others by svgFile.
struct Drawing {
  double width = 0, height = 0;
  std::string body;  ///< SVG elements inside (0, 0)-(width, height)
};

struct LayoutDrawingOptions {
  double size = 380;              ///< of the square that the layout is fitted into
  std::string title;              ///< above it, such as "t = 1"
  bool marksNonDelaunay = false;  ///< interior edges, by an exact in-circle test
};

/// A layout: edges thin, boundary thick, flipped triangles filled, crossings of the boundary
/// circled; below it the distortions and whether it is valid.
Drawing drawLayout(const FlattenResult& flat, const LayoutDrawingOptions& options);

/// The same frame with a sentence in place of a layout that does not exist.
Drawing drawReason(const std::string& reason, const LayoutDrawingOptions& options);

/// The mesh itself, shaded, from where most of it shows its outside.
Drawing drawSurface(const PolygonMesh& mesh, const LayoutDrawingOptions& options);

/// The non-zeros of the system matrix (8) at the solution for a mesh that is a disk, with its
/// blocks: Hessian, triangles, vertices, wheels, active bounds. Errors: those of flatten.
Result<Drawing> drawKktMatrix(const PolygonMesh& mesh, double t, Formulation formulation);

/// Values at 1, 2, 3, ... Those that are not above 0 have no place on a logarithmic axis: they are
/// drawn at its lower end.
struct Curve {
  std::vector<double> y;
};

struct PlotOptions {
  std::string title, xLabel;
  double width = 460, height = 340;
};

/// Curves over a linear horizontal and a logarithmic vertical axis; colours follow their order.
Drawing drawLogPlot(const std::vector<Curve>& curves, const PlotOptions& options);

/// Names of curves beside samples of their lines, one below the other.
Drawing drawLegend(const std::vector<std::string>& names, double width);

/// A whole SVG file: a heading and the drawings, at most `columns` in a row.
std::string svgFile(const std::string& heading, const std::vector<Drawing>& drawings,
                    std::size_t columns);

/// The largest atlas that is drawn in pixels.
constexpr int kMostPictureTexels = 16384;

/// An atlas to paint on, as a PNG file of a pixel per texel: charts in pale colours, edges thin,
/// outlines thick; transparent elsewhere. Tiles lie side by side. `mesh` is what was unwrapped.
/// Errors: InvalidOption when a side would be above kMostPictureTexels.
Result<std::string> atlasPng(const PolygonMesh& mesh, const UnwrapResult& result);

/// The same as an SVG file, each chart a group. With `millimetres` for a unit of the mesh the
/// picture has the size at which charts are as large as their surface; with 0 a pixel per texel.
std::string atlasSvg(const PolygonMesh& mesh, const UnwrapResult& result, double millimetres = 0);

/// The atlas as a PNG file with each face in a colour for its area in uv, divided by its area in
/// 3D, where 1 is the whole atlas's: 1/2 and below blue, 1 white, 2 and above red, without area
/// grey; outlines as of atlasPng. Errors: as of atlasPng.
Result<std::string> heatMapPng(const PolygonMesh& mesh, const UnwrapResult& result);

}  // namespace abflat
