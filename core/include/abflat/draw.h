#pragma once

#include <string>
#include <vector>

#include "abflat/export.h"
#include "abflat/flatten.h"
#include "abflat/unwrap.h"
#include "abflat/verify.h"

namespace abflat {

/// A picture, sized in CSS pixels; svgFile puts several side by side.
struct Drawing {
  double width = 0, height = 0;
  std::string body;  ///< SVG elements inside (0, 0)-(width, height)
};

struct LayoutDrawingOptions {
  double size = 380;              ///< side of the square that the layout is fitted into
  std::string title;              ///< shown above the layout, such as "t = 1"
  bool marksNonDelaunay = false;  ///< marks interior edges, by an exact in-circle test
};

/// Draws a layout: edges thin, boundary thick, flipped triangles filled, crossings of the boundary
/// circled. The distortions and whether it is valid are given below it.
ABFLAT_API Drawing drawLayout(const FlattenResult& flat, const LayoutDrawingOptions& options);

/// The same frame, with a sentence in place of a layout that does not exist.
ABFLAT_API Drawing drawReason(const std::string& reason, const LayoutDrawingOptions& options);

/// Draws the mesh itself, shaded, from the side that shows most of its outside.
ABFLAT_API Drawing drawSurface(const PolygonMesh& mesh, const LayoutDrawingOptions& options);

/// The non-zeros of the system matrix (8) at the solution for a mesh that is a disk, with its
/// blocks: Hessian, triangles, vertices, wheels, active bounds. Errors: those of flatten.
ABFLAT_API Result<Drawing> drawKktMatrix(const PolygonMesh& mesh, double t,
                                         Formulation formulation);

/// Values at 1, 2, 3, ... Values that are not above 0 do not fit a logarithmic axis and are drawn
/// at its lower end.
struct Curve {
  std::vector<double> y;
};

struct PlotOptions {
  std::string title, xLabel;
  double width = 460, height = 340;
};

/// Curves over a linear horizontal and a logarithmic vertical axis; colours follow their order.
ABFLAT_API Drawing drawLogPlot(const std::vector<Curve>& curves, const PlotOptions& options);

/// Names of curves beside samples of their lines, one below the other.
ABFLAT_API Drawing drawLegend(const std::vector<std::string>& names, double width);

/// A whole SVG file: a heading and the drawings, at most `columns` in a row.
ABFLAT_API std::string svgFile(const std::string& heading, const std::vector<Drawing>& drawings,
                               std::size_t columns);

/// The largest atlas that is drawn in pixels.
constexpr int kMostPictureTexels = 16384;

/// The atlas as a template to paint on: a PNG file with one pixel per texel, charts in pale
/// colours, edges thin, outlines thick, transparent elsewhere. Tiles lie side by side. `mesh` is
/// the mesh that was unwrapped. Errors: InvalidOption when a side would be above
/// kMostPictureTexels.
ABFLAT_API Result<std::string> atlasPng(const PolygonMesh& mesh, const UnwrapResult& result);

/// The same as an SVG file, with a group for each chart. `millimetres` is the length of one mesh
/// unit: the picture gets the size at which charts are as large as their surface. With 0, a texel
/// is a pixel.
ABFLAT_API std::string atlasSvg(const PolygonMesh& mesh, const UnwrapResult& result,
                                double millimetres = 0);

/// The atlas as a PNG file, with each face coloured by its area in uv divided by its area in 3D,
/// relative to the whole atlas: 1/2 and below blue, 1 white, 2 and above red, faces without area
/// grey. Outlines and errors as in atlasPng.
ABFLAT_API Result<std::string> heatMapPng(const PolygonMesh& mesh, const UnwrapResult& result);

/// The layout that was verified as a PNG file with a pixel per texel, or smaller. Faces that
/// overlap are vermilion, flipped ones blue, those outside of their tile yellow, and islands with
/// another fault purple; faults too small to be seen have a ring. It shows the first tile and all
/// that lies outside of it.
ABFLAT_API Result<std::string> verifyPng(const PolygonMesh& mesh, const VerifyResult& result);

}  // namespace abflat
