#include "texts.h"

#include <iomanip>
#include <sstream>
#include <vector>

namespace abflat::cli {
namespace {

std::string counted(std::size_t n, const char* one, const char* many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

std::string joined(const std::vector<std::string>& parts, const char* separator) {
  std::string out;
  for (const std::string& part : parts) out += (out.empty() ? "" : separator) + part;
  return out;
}

}  // namespace

std::string resultText(const Report& report, const std::string& inputName,
                       const std::string& outputName) {
  const ChartReport& c = report.charts.front();
  std::ostringstream out;
  out << std::setprecision(3);
  out << inputName << " -> " << outputName << "\n"
      << "  " << counted(report.input.faces, "face", "faces") << ", "
      << counted(report.input.vertices, "vertex", "vertices") << ", "
      << counted(c.boundaryVertices, "boundary vertex", "boundary vertices") << "\n"
      << "  t = " << c.t << ", "
      << counted(static_cast<std::size_t>(c.iterations), "Newton step", "Newton steps")
      << ", residual " << c.constraintResidual << "\n"
      << "  distortion: angles " << c.angularDistortion << ", lengths " << c.lengthDistortion
      << ", conformal " << c.quasiConformalMean << " (at most " << c.quasiConformalMax << ")\n"
      << "  " << (report.valid ? "valid" : "not valid") << ", " << report.timings.total << " s\n";
  return out.str();
}

std::string invalidText(const ChartReport& c) {
  std::vector<std::string> reasons, hints;
  if (!c.converged) {
    std::ostringstream residual;
    residual << std::setprecision(2) << c.constraintResidual;
    reasons.push_back("the solver did not converge in " + std::to_string(c.iterations) +
                      " steps (constraint residual " + residual.str() + ")");
    if (c.t < 2) hints.push_back("a larger --t asks for less");
  }
  if (c.flippedTriangles > 0)
    reasons.push_back(counted(c.flippedTriangles, "triangle is", "triangles are") +
                      " flipped or flat");
  if (c.boundaryCrossings > 0) {
    reasons.push_back("the boundary crosses itself at " +
                      counted(c.boundaryCrossings, "place", "places"));
    if (c.t > 1 && c.converged) hints.push_back("a smaller --t, down to 1, straightens it");
  }
  const std::string hint = joined(hints, ", ");
  return joined(reasons, ", ") + (hint.empty() ? "" : "; " + hint);
}

std::string inspectText(const MeshSummary& s, const std::string& name) {
  std::ostringstream out;
  const auto row = [&](const char* label, const auto& value) {
    out << "  " << std::left << std::setw(24) << label << std::right << std::setw(10) << value
        << "\n";
  };
  out << name << "\n";
  row("vertices", s.vertices);
  row("  without faces", s.unreferencedVertices);
  row("faces", s.faces);
  row("  as triangles", s.triangles);
  row("  of zero area", s.degenerateFaces);
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
  row("disk", s.disk.ok() ? "yes" : "no");
  if (!s.disk.ok()) out << "  " << s.disk.message << "\n";
  return out.str();
}

}  // namespace abflat::cli
