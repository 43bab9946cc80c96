#include "terminal/texts.h"

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <tuple>
#include <vector>

#include "abflat/flatten.h"
#include "terminal/terminal.h"

namespace abflat::cli {
namespace {

std::string counted(std::size_t n, const char* one, const char* many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

/// What had to be repaired to see the surface in the mesh, if anything.
std::vector<std::string> repairLines(const RepairReport& r) {
  std::vector<std::string> lines;
  const auto add = [&](std::size_t n, const char* one, const char* many) {
    if (n > 0) lines.push_back(counted(n, one, many));
  };
  add(r.mergedVertices, "duplicate vertex treated as one", "duplicate vertices treated as one");
  add(r.collapsedFaces.size(), "degenerate face left out", "degenerate faces left out");
  add(r.splitFaces.size(), "face that touches itself", "faces that touch themselves");
  add(r.duplicateFaces.size(), "repeated face", "repeated faces");
  add(r.nonManifoldEdges.size(), "edge with more than two faces cut",
      "edges with more than two faces cut");
  add(r.turnedFaces.size(), "face turned to run like its neighbours",
      "faces turned to run like their neighbours");
  add(r.orientationConflicts.size(), "edge cut where the orientation changes",
      "edges cut where the orientation changes");
  return lines;
}

/// `report`: of an atlas or of packing.
template <class Report>
std::string tilesText(const Report& report) {
  return (report.tiles > 1 ? std::to_string(report.tiles) + " tiles of " : "") +
         std::to_string(report.width) + " x " + std::to_string(report.height);
}

std::string stackedText(const AtlasReport& atlas) {
  const auto charts = static_cast<std::size_t>(atlas.stackedCharts);
  return counted(charts, "chart lies on ", "charts lie on ") + std::to_string(atlas.stackedPlaces) +
         (atlas.stackedPlaces == 1 ? " other" : " others") +
         (atlas.stackedMirrored > 0 ? ", " + std::to_string(atlas.stackedMirrored) + " mirrored"
                                    : "");
}

}  // namespace

std::string resultText(const Report& report, const std::string& inputName,
                       const std::string& outputName) {
  const ChartReport& c = report.charts.front();
  std::ostringstream out;
  out << std::setprecision(3);
  out << printable(inputName) << " -> " << printable(outputName) << "\n"
      << "  " << counted(report.input.faces, "face", "faces") << ", "
      << counted(report.input.vertices, "vertex", "vertices") << ", "
      << counted(c.boundaryVertices, "boundary vertex", "boundary vertices") << "\n"
      << "  t = " << c.t
      << (c.bounds.empty() ? "" : " except at " + counted(c.bounds.size(), "vertex", "vertices"))
      << ", " << counted(static_cast<std::size_t>(c.iterations), "Newton step", "Newton steps")
      << ", residual " << c.constraintResidual << "\n"
      << "  distortion: angles " << c.angularDistortion << ", lengths " << c.lengthDistortion
      << ", conformal " << c.quasiConformalMean << " (at most " << c.quasiConformalMax << ")\n";
  if (c.refined)
    out << "  refined: energy " << std::setprecision(5) << c.refined->energyBefore << " -> "
        << c.refined->energy << std::setprecision(3) << ", "
        << counted(static_cast<std::size_t>(c.refined->steps), "step", "steps")
        << (c.refined->limit.empty() ? "" : "; " + c.refined->limit) << "\n";
  if (c.delaunay)
    out << "  Delaunay: " << c.delaunay->violated << " of "
        << counted(c.delaunay->edges, "interior edge", "interior edges") << " violated, "
        << c.delaunay->violatedBefore << " before; angular distortion was "
        << c.delaunay->angularDistortionBefore << "\n";
  for (const std::string& fallback : c.fallbacks) out << "  " << printable(fallback) << "\n";
  out << "  " << (report.valid ? "valid" : "not valid") << ", " << report.timings.total << " s\n";
  return out.str();
}

/// " (3 strips, 2 discs)"; empty if no chart has a shape with a name.
std::string shapesText(const std::vector<UnwrapChart>& charts) {
  constexpr std::tuple<ChartShape, const char*, const char*> kShapes[] = {
      {ChartShape::Rectangle, "rectangle", "rectangles"},
      {ChartShape::Strip, "strip", "strips"},
      {ChartShape::Disc, "disc", "discs"},
      {ChartShape::Ring, "ring", "rings"}};
  std::string out;
  for (const auto& [shape, one, several] : kShapes) {
    const auto count =
        std::count_if(charts.begin(), charts.end(),
                      [shape = shape](const UnwrapChart& chart) { return chart.shape == shape; });
    if (count > 0)
      out += (out.empty() ? " (" : ", ") + counted(static_cast<std::size_t>(count), one, several);
  }
  return out.empty() ? out : out + ")";
}

/// A line about the images that were baked; empty if none were.
std::string bakingText(const BakingReport& baking) {
  std::string out;
  for (const BakedMap& map : baking.maps) {
    out.append(out.empty() ? "  baked " : ", ").append(map.map).append(" ");
    out.append(std::to_string(map.width)).append(" x ").append(std::to_string(map.height));
  }
  return out.empty() ? out : out + "\n";
}

std::string unwrapText(const UnwrapReport& report, const std::string& inputName,
                       const std::string& outputName) {
  std::ostringstream out;
  out << std::setprecision(3);
  out << printable(inputName) << " -> " << printable(outputName) << "\n"
      << "  " << counted(report.input.faces, "face", "faces") << ", "
      << counted(report.input.vertices, "vertex", "vertices") << ", "
      << counted(report.input.components, "component", "components") << "\n";
  for (const std::string& line : repairLines(report.repair)) out << "  " << line << "\n";
  out << "  " << counted(report.charts.size(), "chart", "charts") << shapesText(report.charts)
      << (report.seams.symmetric ? ", symmetric" : "") << ", seam length "
      << report.seams.relativeLength << " times the square root of the area"
      << (report.seams.filledHoles == 0
              ? ""
              : ", " + counted(report.seams.filledHoles, "hole", "holes") + " filled")
      << "\n"
      << "  distortion: angles " << report.angularDistortion << ", conformal "
      << report.quasiConformalMean << ", symmetric Dirichlet " << report.symmetricDirichlet << "\n"
      << "  atlas: " << tilesText(report.atlas) << ", " << 100 * report.atlas.utilization
      << " % used, " << report.atlas.texelDensity << " texels per unit\n";
  if (report.atlas.packingCuts > 0)
    out << "  " << counted(static_cast<std::size_t>(report.atlas.packingCuts), "cut", "cuts")
        << " to pack tighter (without: " << report.atlas.uncutTexelDensity << " texels per unit)\n";
  if (report.atlas.stackedCharts > 0) out << "  " << stackedText(report.atlas) << "\n";
  if (report.baking) out << bakingText(*report.baking);
  for (const std::string& note : report.notes) out << "  " << printable(note) << "\n";
  out << "  " << (report.valid ? "valid" : "not valid") << ", " << report.timings.total << " s\n";
  return out.str();
}

namespace {

std::string packedText(const PackReport& report) {
  std::ostringstream out;
  out << std::setprecision(3) << "  atlas: " << tilesText(report) << ", "
      << 100 * report.utilizationBefore << " % used before, " << 100 * report.utilization
      << " % now; lengths in uv are " << report.scale << " times what they were, "
      << report.texelDensity << " texels per unit\n";
  return out.str();
}

/// Of a layout that stays as it is.
std::string judgedText(const PackReport& report) {
  std::ostringstream out;
  out << std::setprecision(3) << "  layout: " << tilesText(report) << ", "
      << 100 * report.utilization << " % used, " << report.texelDensity << " texels per unit\n"
      << "  faces: " << report.facesOverlapping << " overlapping, " << report.facesFlipped
      << " flipped, " << report.facesEmpty << " without area, " << report.facesOutside
      << " outside\n";
  return out.str();
}

}  // namespace

std::string packText(const PackReport& report, const std::string& inputName,
                     const std::string& outputName) {
  std::ostringstream out;
  out << std::setprecision(3);
  out << printable(inputName) << " -> " << printable(outputName) << "\n"
      << "  " << counted(report.islands, "island", "islands")
      << (report.mirrored > 0 ? ", " + std::to_string(report.mirrored) + " mirrored" : "") << "\n"
      << (report.options.keepPlaces ? judgedText(report) : packedText(report));
  if (report.baking) out << bakingText(*report.baking);
  for (const std::string& note : report.notes) out << "  " << printable(note) << "\n";
  out << "  " << (report.valid ? "valid" : "not valid") << ", " << report.timings.total << " s\n";
  return out.str();
}

std::string bakeText(const BakeReport& report, const std::string& inputName,
                     const std::string& outputName) {
  std::ostringstream out;
  out << std::setprecision(3);
  out << printable(inputName) << " -> " << printable(outputName) << "\n";
  if (report.baking) out << bakingText(*report.baking);
  for (const std::string& note : report.notes) out << "  " << printable(note) << "\n";
  out << "  " << report.timings.total << " s\n";
  return out.str();
}

std::string inspectText(const MeshSummary& s, const std::string& name,
                        const std::vector<std::string>& notes) {
  std::ostringstream out;
  const auto row = [&](const char* label, const auto& value) {
    out << "  " << std::left << std::setw(24) << label << std::right << std::setw(10) << value
        << "\n";
  };
  out << printable(name) << "\n";
  row("vertices", s.vertices);
  row("  unused", s.unreferencedVertices);
  row("faces", s.faces);
  row("  as triangles", s.triangles);
  row("  degenerate", s.degenerateFaces);
  row("components", s.components);
  row("boundary loops", s.boundaryLoops);
  row("boundary edges", s.boundaryEdges);
  row("non-manifold edges", s.nonManifoldEdges);
  row("orientation conflicts", s.orientationConflicts);
  row("Euler characteristic", s.eulerCharacteristic);
  if (s.genus < 0)
    row("genus", "undefined");
  else
    row("genus", s.genus);
  row("texcoords", s.texcoords);
  row("normals", s.normals);
  row("smoothing groups", s.smoothingGroups);
  row("materials", s.materials);
  row("disk", s.disk.ok() ? "yes" : "no");
  if (!s.disk.ok()) out << "  " << s.disk.message << "\n";
  for (const std::string& note : notes) out << "  " << printable(note) << "\n";
  return out.str();
}

}  // namespace abflat::cli
