#include "abflat/bake.h"
#include "commands/commands.h"
#include "commands/mesh_run.h"
#include "files/paths.h"
#include "terminal/texts.h"

namespace abflat::cli {
namespace {

/// The layout of the file, which stays.
struct BakeResult {
  std::vector<double> uv;
  std::vector<std::uint32_t> cornerUv, triangleCorners;
  BakeReport report;
};

std::size_t unmappedFaces(const PolygonMesh& mesh) {
  std::size_t out = 0;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    bool isMapped = !mesh.faceTexcoords.empty();
    for (std::size_t c = mesh.faceOffsets[f]; isMapped && c < mesh.faceOffsets[f + 1]; ++c)
      isMapped = mesh.faceTexcoords[c] != kNoTexcoord;
    out += !isMapped;
  }
  return out;
}

struct BakeJob {
  using Command = BakeCommand;
  using Outcome = BakeResult;
  using Report = BakeReport;

  static constexpr Repeated kRepeated = Repeated::Stay;
  static constexpr bool kBakes = true;
  static constexpr bool kMakesLayout = false;

  static GltfReadOptions gltf(const BakeCommand& command) { return {*command.texcoord, false}; }
  static bool keepsTexcoords(const BakeCommand&) { return true; }

  static void addNotes(const std::vector<std::string>& notes, BakeReport& report) {
    report.notes.insert(report.notes.begin(), notes.begin(), notes.end());
  }

  static Result<BakeResult> compute(const BakeCommand& command, const PolygonMesh& mesh,
                                    const ProgressCallback&) {
    BakeResult out;
    const std::string set = "TEXCOORD_" + std::to_string(*command.texcoord);
    out.report.unmapped = unmappedFaces(mesh);
    if (out.report.unmapped == mesh.faceCount())
      return Status{StatusCode::NoTexcoords, inputName(command.input) + ": no face has " + set +
                                                 ". Name the set of the new layout with "
                                                 "--texcoord, or use unwrap --bake"};
    if (out.report.unmapped > 0)
      out.report.notes.push_back(std::to_string(out.report.unmapped) + " of " +
                                 std::to_string(mesh.faceCount()) + " faces have no " + set +
                                 ", so they show the corner of the new images");
    out.uv = mesh.texcoords;
    out.cornerUv = mesh.faceTexcoords;
    out.triangleCorners = triangleCornersOf(mesh);
    out.report.input = inspect(mesh);
    out.report.options = command.options;
    out.report.texcoord = *command.texcoord;
    out.report.valid = true;
    return out;
  }

  static std::optional<BakeOptionValues> baking(const BakeCommand& command) {
    return command.options;
  }
  static NewLayout newLayout(const BakeResult& result, const std::vector<std::uint32_t>& turned) {
    return {result.uv, result.cornerUv, turned, result.report.options.padding, 0};
  }
  static void setBaking(const BakingReport& baking, BakeReport& report) { report.baking = baking; }

  static const std::vector<std::uint32_t>& triangleCorners(const PolygonMesh&,
                                                           const BakeResult& result) {
    return result.triangleCorners;
  }

  static std::vector<std::uint32_t> turnFaces(InputFile&, BakeResult&) { return {}; }
  static std::vector<ExtraFile<BakeResult>> extraFiles(const BakeCommand&) { return {}; }

  static std::string json(const BakeReport& report) { return bakeReportJson(report); }
  static std::string summary(const BakeReport& report, const std::string& input,
                             const std::string& output) {
    return bakeText(report, input, output);
  }
  static std::string problem(const BakeReport&) { return {}; }
};

}  // namespace

int runBake(const BakeCommand& command) { return MeshRun<BakeJob>(command).run(); }

}  // namespace abflat::cli
