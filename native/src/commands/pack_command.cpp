#include "abflat/pack_layout.h"
#include "commands/commands.h"
#include "commands/layout_picture.h"
#include "commands/mesh_run.h"
#include "files/paths.h"
#include "terminal/texts.h"

namespace abflat::cli {
namespace {

/// The layout as pictures take it: islands are charts.
UnwrapResult drawn(const PolygonMesh& mesh, const PackLayoutResult& result) {
  UnwrapResult out;
  out.uv = result.uv;
  out.cornerUv = result.cornerUv;
  out.chartOfFace = result.islandOfFace;
  out.report.charts.resize(result.report.islands);
  out.report.atlas.width = result.report.width;
  out.report.atlas.height = result.report.height;
  out.report.atlas.tiles = result.report.tiles;
  for (std::uint32_t f = 0; f < mesh.faceCount(); ++f)
    if (result.islandOfFace[f] == kNoIsland) out.report.repair.collapsedFaces.push_back(f);
  return out;
}

struct PackJob {
  using Command = PackCommand;
  using Outcome = PackLayoutResult;
  using Report = PackReport;

  static constexpr Repeated kRepeated = Repeated::Stay;
  static constexpr bool kBakes = true;
  static constexpr bool kMakesLayout = true;

  static const GltfReadOptions& gltf(const PackCommand& command) { return command.gltf; }
  /// The first set may be that of textures, which fit only as it is.
  static bool keepsTexcoords(const PackCommand& command) { return command.gltf.texcoord > 0; }

  static void addNotes(const std::vector<std::string>& notes, PackReport& report) {
    report.notes.insert(report.notes.begin(), notes.begin(), notes.end());
  }

  static Result<PackLayoutResult> compute(const PackCommand& command, const PolygonMesh& mesh,
                                          ProgressCallback progress) {
    PackLayoutOptions options;
    static_cast<PackOptionValues&>(options) = command.options;
    options.precision = precisionOf(writtenFormat(command.output));
    options.progress = std::move(progress);
    return placed(inputName(command.input), [&] { return packLayout(mesh, options); });
  }

  static const std::vector<std::uint32_t>& triangleCorners(const PolygonMesh&,
                                                           const PackLayoutResult& result) {
    return result.triangleCorners;
  }

  static std::vector<std::uint32_t> turnFaces(InputFile&, PackLayoutResult&) { return {}; }

  static std::optional<BakeOptionValues> baking(const PackCommand& command) {
    return bakeOptions(command);
  }
  static NewLayout newLayout(const PackLayoutResult& result,
                             const std::vector<std::uint32_t>& turned) {
    return {result.uv,
            result.cornerUv,
            turned,
            result.report.padding,
            {result.report.width, result.report.height}};
  }
  static void setBaking(const BakingReport& baking, PackReport& report) { report.baking = baking; }

  static std::vector<ExtraFile<PackLayoutResult>> extraFiles(const PackCommand& command) {
    if (command.layout.empty()) return {};
    return {{command.layout,
             [path = command.layout](const PolygonMesh& mesh, const PackLayoutResult& result) {
               return layoutPicture(path, 0, mesh, drawn(mesh, result));
             }}};
  }

  static std::string json(const PackReport& report) { return packReportJson(report); }
  static std::string summary(const PackReport& report, const std::string& input,
                             const std::string& output) {
    return packText(report, input, output);
  }
  static std::string problem(const PackReport& report) { return report.notes.back(); }
};

}  // namespace

int runPack(const PackCommand& command) { return MeshRun<PackJob>(command).run(); }

}  // namespace abflat::cli
