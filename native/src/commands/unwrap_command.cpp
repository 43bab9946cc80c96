#include "abflat/draw.h"
#include "abflat/orient.h"
#include "abflat/peak_memory.h"
#include "abflat/unwrap.h"
#include "commands/commands.h"
#include "commands/layout_picture.h"
#include "commands/mesh_run.h"
#include "files/paths.h"
#include "files/pins_file.h"
#include "files/seam_file.h"
#include "terminal/texts.h"

namespace abflat::cli {
namespace {

struct UnwrapJob {
  using Command = UnwrapCommand;
  using Outcome = UnwrapResult;
  using Report = UnwrapReport;

  static constexpr Repeated kRepeated = Repeated::Stay;  // the core joins them and reports it
  static constexpr bool kBakes = true;
  static constexpr bool kMakesLayout = true;

  static const GltfReadOptions& gltf(const UnwrapCommand& command) { return command.gltf; }
  static bool keepsTexcoords(const UnwrapCommand& command) { return command.keep.hasUv; }

  static void addNotes(const std::vector<std::string>& notes, UnwrapReport& report) {
    report.notes.insert(report.notes.begin(), notes.begin(), notes.end());
  }

  static Result<UnwrapResult> compute(const UnwrapCommand& command, const PolygonMesh& mesh,
                                      ProgressCallback progress) {
    UnwrapOptions options;
    static_cast<UnwrapOptionValues&>(options) = command.options;
    options.seams = command.seams;
    if (!command.seamFile.empty()) {
      Result<std::vector<EdgeVertices>> edges = readSeams(command.seamFile);
      if (!edges.ok()) return edges.status();
      options.seams.edges = std::move(edges.value());
    }
    Result<std::vector<std::uint32_t>> kept =
        facesToKeep(command.keep, mesh, inputName(command.input));
    if (!kept.ok()) return kept.status();
    options.reuse.fixedFaces = std::move(kept.value());
    if (!command.pins.empty()) {
      Result<std::vector<Pin>> pins = readPins(command.pins);
      if (!pins.ok()) return pins.status();
      options.pins = std::move(pins.value());
    }
    options.precision = precisionOf(writtenFormat(command.output));
    options.progress = std::move(progress);
    const double afterReading = peakMemory();
    Result<UnwrapResult> result =
        placed(inputName(command.input), [&] { return unwrap(mesh, options); });
    if (result.ok()) result.value().report.peakMemory.read = afterReading;
    return result;
  }

  static const std::vector<std::uint32_t>& triangleCorners(const PolygonMesh&,
                                                           const UnwrapResult& result) {
    return result.triangleCorners;
  }

  static std::vector<std::uint32_t> turnFaces(InputFile& input, UnwrapResult& result) {
    const std::vector<std::uint32_t>& faces = result.report.repair.turnedFaces;
    std::vector<std::uint32_t>& normals = input.look.faceNormals;
    if (!normals.empty()) normals = reordered(normals, turnedCorners(input.mesh, faces));
    abflat::turnFaces(input.mesh, result);
    return faces;
  }

  static std::optional<BakeOptionValues> baking(const UnwrapCommand& command) {
    return bakeOptions(command);
  }
  static NewLayout newLayout(const UnwrapResult& result, const std::vector<std::uint32_t>& turned) {
    const AtlasReport& atlas = result.report.atlas;
    return {result.uv, result.cornerUv, turned, atlas.padding, {atlas.width, atlas.height}};
  }
  static void setBaking(const BakingReport& baking, UnwrapReport& report) {
    report.baking = baking;
  }

  static std::vector<ExtraFile<UnwrapResult>> extraFiles(const UnwrapCommand& command) {
    std::vector<ExtraFile<UnwrapResult>> out;
    if (!command.writeSeams.empty())
      out.push_back({command.writeSeams,
                     [](const PolygonMesh&, const UnwrapResult& result) -> Result<std::string> {
                       return seamsText(result.seams);
                     }});
    if (!command.layout.empty())
      out.push_back({command.layout, [path = command.layout, scale = command.scale](
                                         const PolygonMesh& mesh, const UnwrapResult& result) {
                       return layoutPicture(path, scale, mesh, result);
                     }});
    if (!command.heatMap.empty()) out.push_back({command.heatMap, heatMapPng});
    return out;
  }

  /// Called last, since it includes the memory of writing.
  static std::string json(UnwrapReport report) {
    report.peakMemory.write = peakMemory();
    return unwrapReportJson(report);
  }
  static std::string summary(const UnwrapReport& report, const std::string& input,
                             const std::string& output) {
    return unwrapText(report, input, output);
  }

  static std::string problem(const UnwrapReport& report) {
    std::size_t count = 0;
    const UnwrapChart* first = nullptr;
    for (const UnwrapChart& chart : report.charts) {
      if (chart.valid) continue;
      if (++count == 1) first = &chart;
    }
    return std::to_string(count) + " of " + std::to_string(report.charts.size()) +
           (report.charts.size() == 1 ? " chart, " : " charts, ") + "the first containing face " +
           std::to_string(first->firstFace) + ": " + first->problem;
  }
};

}  // namespace

int runUnwrap(const UnwrapCommand& command) { return MeshRun<UnwrapJob>(command).run(); }

}  // namespace abflat::cli
