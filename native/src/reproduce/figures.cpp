#include "reproduce/figures.h"

#include <sstream>

#include "abflat/draw.h"
#include "abflat/flatten.h"
#include "files/out_of_memory.h"

namespace abflat::cli {
namespace {

constexpr std::size_t kMaxMatrixFaces = 6000;
constexpr double kSmallPanel = 300;
/// With more faces a picture would take megabytes.
constexpr std::size_t kMaxSurfaceFaces = 12000;

std::string boundTitle(double t) {
  if (t == kAutoT) return "t = auto";
  std::ostringstream out;
  out << "t = " << t;
  if (t == 2) out << " (free boundary)";
  if (t == 1) out << " (convex)";
  return out.str();
}

Drawing layoutAt(Experiment& e, double t, double size) {
  LayoutDrawingOptions options;
  options.size = size;
  options.title = boundTitle(t);
  const Result<FlattenResult>& flat = e.flattened(t);
  return flat.ok() ? drawLayout(flat.value(), options) : drawReason(flat.status().message, options);
}

/// The mesh itself as the first panel.
std::vector<Drawing> startPanels(const Experiment& e, double size) {
  if (e.summary().faces > kMaxSurfaceFaces) return {};
  LayoutDrawingOptions options;
  options.size = size;
  options.title = "original";
  return {drawSurface(e.mesh(), options)};
}

Figure figure(const Experiment& e, int number, const std::string& what,
              const std::vector<Drawing>& drawings) {
  const std::string heading = e.model().name + ": " + what;
  return {number, "figure-" + std::to_string(number) + "-" + e.model().fileStem + ".svg",
          e.model().name, svgFile(heading, drawings, drawings.size())};
}

Figure boundaries(Experiment& e) {
  constexpr double kPanel = 360;
  std::vector<Drawing> panels = startPanels(e, kPanel);
  for (const double t : {2.0, 1.0, kAutoT}) panels.push_back(layoutAt(e, t, kPanel));
  return figure(e, 2, "free, convex and automatic boundary", panels);
}

Figure boundaryControl(Experiment& e) {
  std::vector<Drawing> panels = startPanels(e, kSmallPanel);
  for (const double t : {2.0, 1.05, 1.0, 0.98, 0.968})
    panels.push_back(layoutAt(e, t, kSmallPanel));
  return figure(e, 8, "effect of the boundary control coefficient t", panels);
}

bool isDelaunay(const FlattenResult& flat) {
  const auto& delaunay = flat.report.charts.front().delaunay;
  return delaunay.has_value() && delaunay->violated == 0;
}

/// The convex layout with its non-Delaunay edges marked, and the layout under condition (9).
Figure delaunayLayouts(Experiment& e) {
  LayoutDrawingOptions drawing;
  drawing.size = 380;
  std::vector<Drawing> panels = startPanels(e, drawing.size);
  drawing.marksNonDelaunay = true;
  for (const bool delaunay : {false, true}) {
    FlattenOptions options;
    options.t = 1;
    options.delaunay = delaunay;
    drawing.title = delaunay ? "t = 1, Delaunay" : boundTitle(1);
    const Result<FlattenResult> flat = delaunay ? e.flattenedWith(options) : e.flattened(1);
    if (delaunay && flat.ok() && !isDelaunay(flat.value()))
      drawing.title = "t = 1, no Delaunay layout found";
    panels.push_back(flat.ok() ? drawLayout(flat.value(), drawing)
                               : drawReason(flat.status().message, drawing));
  }
  return figure(e, 6, "Delaunay layout", panels);
}

/// Returns an empty string, or why there is no picture of the matrix.
std::string whyNoMatrix(const Experiment& e) {
  const std::size_t faces = e.summary().triangles;
  if (faces <= kMaxMatrixFaces) return "";
  return "left out: with " + std::to_string(faces) +
         " faces, a dot would stand for hundreds of rows; the limit is " +
         std::to_string(kMaxMatrixFaces);
}

Result<Figure> systemMatrix(const Experiment& e) {
  std::vector<Drawing> panels;
  for (const Formulation form : {Formulation::Log, Formulation::Product}) {
    Result<Drawing> panel =
        orOutOfMemory(e.model().name, [&] { return drawKktMatrix(e.mesh(), 1, form); });
    if (!panel.ok()) return panel.status();
    panels.push_back(std::move(panel.value()));
  }
  return figure(e, 4, "system matrix (8) at t = 1", panels);
}

}  // namespace

std::string figureHeading(int number) {
  switch (number) {
    case 2:
      return "Figure 2: free, convex and automatic boundary";
    case 4:
      return "Figure 4: the system matrix";
    case 6:
      return "Figure 6: Delaunay layouts";
    case 8:
      return "Figure 8: the boundary control coefficient t";
  }
  return "Figure " + std::to_string(number);
}

FigureSet makeFigures(Experiment& e) {
  FigureSet out;
  if (!e.status().ok()) return out;
  out.figures.push_back(boundaries(e));
  std::string reason = whyNoMatrix(e);
  if (reason.empty()) {
    Result<Figure> matrix = systemMatrix(e);
    reason = matrix.status().message;
    if (matrix.ok()) out.figures.push_back(std::move(matrix.value()));
  }
  if (!reason.empty())
    out.remarks.push_back(figureHeading(4) + " of " + e.model().name + ": " + reason);
  out.figures.push_back(delaunayLayouts(e));
  out.figures.push_back(boundaryControl(e));
  return out;
}

}  // namespace abflat::cli
