#include <cmath>
#include <iomanip>
#include <sstream>

#include "reports/verify_reports.h"
#include "terminal/terminal.h"

namespace abflat::cli {
namespace {

std::string numbered(std::size_t n, const char* one, const char* many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

/// Three digits, and never fewer than a whole number has.
std::string brief(double x) {
  std::ostringstream out;
  if (std::abs(x) >= 100)
    out << std::fixed << std::setprecision(0) << x;
  else
    out << std::setprecision(3) << x;
  return out.str();
}

std::string tilesLine(const VerifyReport& report) {
  constexpr std::size_t kMost = 8;
  std::string out = report.tiles.size() == 1 ? "tile" : "tiles";
  for (std::size_t i = 0; i < report.tiles.size() && i < kMost; ++i)
    out += " " + std::to_string(report.tiles[i]);
  return report.tiles.size() > kMost ? out + " and more" : out;
}

/// Islands of one density differ by what rounding does.
std::string differText(const VerifyReport& report) {
  if (report.islands < 2) return "";
  if (report.texelDensityRatio < 1.005) return "; the same in all islands";
  return "; islands differ " + brief(report.texelDensityRatio) + " times";
}

}  // namespace

std::string verifyText(const VerifyReport& report, const std::string& inputName) {
  std::ostringstream out;
  out << std::setprecision(3);
  const AtlasSize& size = report.options.resolution;
  out << printable(inputName) << "\n  " << numbered(report.islands, "island", "islands");
  if (report.mirrored > 0) out << ", " << report.mirrored << " mirrored";
  if (!report.tiles.empty()) out << ", in " << tilesLine(report);
  out << " of " << atlasSizeText(size) << " texels, " << brief(100 * report.utilization)
      << " % used\n"
      << "  faces: " << report.facesOverlapping << " overlapping, " << report.facesFlipped
      << " flipped, " << report.facesEmpty << " without area, " << report.facesOutside
      << " outside, " << report.unmapped << " without texcoords\n"
      << "  texels: ";
  if (!std::isnan(report.distanceIslands))
    out << brief(report.distanceIslands) << " between islands, ";
  out << brief(report.distanceEdge) << " to the edge, " << brief(report.narrowest)
      << " across the narrowest island\n";
  if (!std::isnan(report.texelDensityMean))
    out << "  texel density: " << brief(report.texelDensityMean) << " texels per unit, from "
        << brief(report.texelDensityMin) << " to " << brief(report.texelDensityMax)
        << differText(report) << "\n";
  if (!std::isnan(report.symmetricDirichlet))
    out << "  stretch: " << std::setprecision(4) << report.symmetricDirichlet << ", "
        << report.worstStretch << " of the worst island; angles: " << report.quasiConformalMean
        << ", " << report.quasiConformalMax << " of the worst face\n"
        << std::setprecision(3);
  for (const std::string& note : report.notes) out << "  " << printable(note) << "\n";
  for (const VerifyFinding& found : report.findings)
    out << "  " << nameOf(found.rule) << ": " << printable(sentence(found.message)) << "\n";
  out << "  "
      << (report.valid ? "valid"
                       : "not valid: " + numbered(report.findings.size(), "finding", "findings"))
      << ", " << report.timings.total << " s\n";
  return out.str();
}

}  // namespace abflat::cli
