#include <algorithm>
#include <deque>
#include <utility>

#include "abflat/join_meshes.h"
#include "abflat/orient.h"
#include "abflat/peak_memory.h"
#include "abflat/unwrap.h"
#include "commands/commands.h"
#include "commands/layout_picture.h"
#include "files/atlas_parts.h"
#include "files/input_file.h"
#include "files/layout_text.h"
#include "files/out_of_memory.h"
#include "files/output_file.h"
#include "files/paths.h"
#include "terminal/terminal.h"

namespace abflat::cli {
namespace {

/// Where memory runs out, no single mesh is to blame.
constexpr const char* kAllMeshes = "the meshes of this atlas";

/// Meshes that share an atlas, from their files to those with texcoords: all of them, or none.
class AtlasRun {
 public:
  explicit AtlasRun(const AtlasCommand& command)
      : command_(command.unwrap), partsPath_(command.parts) {}

  int run() {
    const Result<UnwrapReport> report =
        orOutOfMemory(kAllMeshes, [&]() -> Result<UnwrapReport> { return unwrapAll(); });
    if (!report.ok()) return ended(report.status());
    if (report.value().valid) return static_cast<int>(ExitCode::Valid);
    complain("the layout was written, but is not valid: " + problem(report.value()));
    return static_cast<int>(ExitCode::NotValid);
  }

 private:
  static int ended(const Status& status) {
    complain(status.message);
    return exitCodeOf(status.code);
  }

  Result<UnwrapReport> unwrapAll() {
    if (Status s = readAll(); !s.ok()) return s;
    const std::vector<const PolygonMesh*> meshes = meshesOf();
    Result<PolygonMesh> joined = joinMeshes(meshes);
    if (!joined.ok()) return joined.status();
    Result<UnwrapResult> result = unwrap(joined.value(), options());
    if (!result.ok()) return result.status();
    if (Status s = writePicture(joined.value(), result.value()); !s.ok()) return s;
    joined.value() = {};
    std::vector<JoinedPart> layouts = splitLayout(result.value(), meshes);
    for (std::size_t i = 0; i < parts_.size(); ++i)
      if (Status s = writeMesh(i, layouts[i]); !s.ok()) return s;
    UnwrapReport report = std::move(result.value().report);
    if (Status s = writeReport(report); !s.ok()) return s;
    if (Status s = OutputFile::commit(written_); !s.ok()) return s;
    return report;
  }

  Status readAll() {
    Result<std::vector<AtlasPart>> parts = readAtlasParts(partsPath_);
    if (!parts.ok()) return parts.status();
    parts_ = std::move(parts.value());
    for (const AtlasPart& part : parts_) {
      Result<InputFile> input =
          readInput(part.input, {Repeated::Stay, command_.allowsOutside, command_.gltf});
      if (!input.ok()) return input.status();
      if (input.value().mesh.faceCount() == 0)
        return {StatusCode::EmptyMesh, part.input + ": the mesh has no faces"};
      inputs_.push_back(std::move(input.value()));
    }
    return {};
  }

  std::vector<const PolygonMesh*> meshesOf() const {
    std::vector<const PolygonMesh*> out;
    for (const InputFile& input : inputs_) out.push_back(&input.mesh);
    return out;
  }

  /// All texcoords are such as the coarsest of the files can hold.
  UnwrapOptions options() const {
    UnwrapOptions out;
    static_cast<UnwrapOptionValues&>(out) = command_.options;
    out.seams = command_.seams;
    for (const AtlasPart& part : parts_)
      out.precision = std::max(out.precision, precisionOf(writtenFormat(part.output)));
    return out;
  }

  OutputFile& newFile(const std::string& path) {
    written_.push_back(&files_.emplace_back(path));
    return files_.back();
  }

  Status writePicture(const PolygonMesh& joined, const UnwrapResult& result) {
    if (command_.layout.empty()) return {};
    Result<std::string> picture = layoutPicture(command_.layout, 0, joined, result);
    if (!picture.ok()) return picture.status();
    return newFile(command_.layout).write(std::move(picture.value()));
  }

  Status writeMesh(std::size_t number, JoinedPart& layout) {
    InputFile& input = inputs_[number];
    const AtlasPart& part = parts_[number];
    const bool isGltf = writtenFormat(part.output) == FileFormat::Gltf;
    if (isGltf)
      if (Status s = readLook(input); !s.ok()) return s;
    if (std::vector<std::uint32_t>& normals = input.look.faceNormals; !normals.empty())
      normals = reordered(normals, turnedCorners(input.mesh, layout.turnedFaces));
    turnFaces(input.mesh, layout);
    const std::size_t set = command_.texcoord      ? *command_.texcoord
                            : isGltf && input.gltf ? freeTexcoord(*input.gltf)
                                                   : 0;
    Result<std::string> text =
        layoutText(input, part.movedTo, set,
                   {layout.uv, layout.cornerUv, layout.triangleCorners, layout.turnedFaces});
    if (!text.ok()) return {text.status().code, part.input + ": " + text.status().message};
    return newFile(part.output).write(std::move(text.value()));
  }

  Status writeReport(UnwrapReport& report) {
    if (command_.report.empty()) return {};
    report.options = command_.options;
    report.peakMemory.write = peakMemory();
    return newFile(command_.report).write(unwrapReportJson(report));
  }

  /// Names the first chart that is not valid, by a face of its mesh.
  std::string problem(const UnwrapReport& report) const {
    const auto bad = std::find_if(report.charts.begin(), report.charts.end(),
                                  [](const UnwrapChart& chart) { return !chart.valid; });
    if (bad == report.charts.end()) return "charts overlap";
    std::size_t face = bad->firstFace, mesh = 0;
    while (face >= inputs_[mesh].mesh.faceCount()) face -= inputs_[mesh++].mesh.faceCount();
    return "the chart of face " + std::to_string(face) + " of " + parts_[mesh].input + ": " +
           bad->problem;
  }

  const UnwrapCommand& command_;
  const std::string& partsPath_;
  std::vector<AtlasPart> parts_;
  std::vector<InputFile> inputs_;
  std::deque<OutputFile> files_;
  std::vector<OutputFile*> written_;
};

}  // namespace

int runAtlas(const AtlasCommand& command) { return AtlasRun(command).run(); }

}  // namespace abflat::cli
