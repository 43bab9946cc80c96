#include "abflat/flatten.h"
#include "commands/commands.h"
#include "commands/mesh_run.h"
#include "files/bounds_file.h"
#include "files/pins_file.h"
#include "files/straight_file.h"
#include "terminal/texts.h"

namespace abflat::cli {
namespace {

struct FlattenJob {
  using Command = FlattenCommand;
  using Outcome = FlattenResult;
  using Report = abflat::Report;

  static constexpr Repeated kRepeated = Repeated::Join;
  static constexpr bool kBakes = false;

  static GltfReadOptions gltf(const FlattenCommand&) { return {}; }
  static bool keepsTexcoords(const FlattenCommand&) { return false; }

  static void addNotes(const std::vector<std::string>& notes, abflat::Report& report) {
    if (report.charts.empty()) return;  // there is only an error to report
    std::vector<std::string>& out = report.charts.front().fallbacks;
    out.insert(out.begin(), notes.begin(), notes.end());
  }

  static Result<FlattenResult> compute(const FlattenCommand& command, const PolygonMesh& mesh,
                                       ProgressCallback progress) {
    FlattenOptions options;
    static_cast<FlattenOptionValues&>(options) = command.options;
    if (!command.bounds.empty()) {
      Result<std::vector<VertexBound>> bounds = readBounds(command.bounds);
      if (!bounds.ok()) return bounds.status();
      options.bounds = std::move(bounds.value());
    }
    if (!command.straight.empty()) {
      Result<std::vector<StraightRun>> straight = readStraight(command.straight);
      if (!straight.ok()) return straight.status();
      options.straight = std::move(straight.value());
    }
    if (!command.pins.empty()) {
      Result<std::vector<Pin>> pins = readPins(command.pins);
      if (!pins.ok()) return pins.status();
      options.pins = std::move(pins.value());
    }
    options.progress = std::move(progress);
    Result<FlattenResult> result =
        placed(inputName(command.input), [&] { return flatten(mesh, options); });
    if (!result.ok()) return result;
    const Precision precision = precisionOf(writtenFormat(command.output));
    if (precision == Precision::Single) roundToSinglePrecision(mesh, result.value());
    if (precision == Precision::Gltf) roundForGltf(mesh, result.value());
    return result;
  }

  /// A disk is flattened as it is, with the triangles of its own faces.
  static std::vector<std::uint32_t> triangleCorners(const PolygonMesh& mesh, const FlattenResult&) {
    return triangleCornersOf(mesh);
  }

  static std::vector<std::uint32_t> turnFaces(InputFile&, FlattenResult&) { return {}; }

  static std::vector<ExtraFile<FlattenResult>> extraFiles(const FlattenCommand&) { return {}; }
  static std::string json(const Report& report) { return reportJson(report); }
  static std::string summary(const Report& report, const std::string& input,
                             const std::string& output) {
    return resultText(report, input, output);
  }
  static std::string problem(const Report& report) { return report.charts.front().problem; }
};

}  // namespace

int runFlatten(const FlattenCommand& command) { return MeshRun<FlattenJob>(command).run(); }

}  // namespace abflat::cli
