#include <sstream>

#include "arguments/baking.h"
#include "arguments/options.h"
#include "arguments/pictures.h"
#include "arguments/subcommands.h"
#include "files/paths.h"

namespace abflat::cli {
namespace {

/// Parses "auto,file=PATH". Everything but the file name is left to the core.
void setSeams(const std::string& text, UnwrapCommand& c) {
  const std::string kFile = "file=";
  std::string others;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');) {
    if (word.rfind(kFile, 0) == 0)
      c.seamFile = word.substr(kFile.size());
    else
      others += (others.empty() ? "" : ",") + word;
  }
  const bool hasFile = !c.seamFile.empty();
  Result<SeamSources> seams = parseSeams(others.empty() && hasFile ? "none" : others);
  if (!seams.ok()) throw CLI::ValidationError("--seams", seams.status().message);
  c.seams = std::move(seams.value());
}

void setKept(const std::string& text, UnwrapCommand& c) {
  Result<KeptFaces> kept = parseKept(text);
  if (!kept.ok()) throw CLI::ValidationError("--keep", kept.status().message);
  c.keep = std::move(kept.value());
}

void addPictures(CLI::App& app, UnwrapCommand& c) {
  addLayoutPicture(app, c.layout);
  app.add_option(
         "--scale", c.scale,
         wrapped("millimetres per mesh unit in the SVG of --layout, so that charts print as large "
                 "as their surface"))
      ->check(numberCheck("above 0", [](double mm) { return mm > 0 && mm < 1e9; }))
      ->type_name("MM");
  app.add_option("--heat-map", c.heatMap,
                 wrapped("PNG picture of the area distortion: blue is shrunk (1/2 and less), white "
                         "average, red "
                         "enlarged (2 and more)"))
      ->check(notEmpty())
      ->check(pictureName({".png"}, ".png"))
      ->type_name("FILE");
}

void checkPictures(const UnwrapCommand& c) {
  const bool isSvg = endingOf(c.layout) == ".svg";
  if (c.scale > 0 && !isSvg)
    throw CLI::ValidationError("--scale", "needs an SVG. Add --layout FILE.svg");
  checkPicture("--heat-map", c.heatMap, c.options.resolution);
  checkPicture("--layout", c.layout, c.options.resolution);
}

/// Standard input can be read only once.
void checkStandardInput(const UnwrapCommand& c) {
  std::string reader = c.input == kStandardStream ? "the mesh" : "";
  for (const auto& [option, path] :
       {std::pair<const char*, const std::string&>{"--seams", c.seamFile},
        {"--keep", c.keep.file},
        {"--pins", c.pins}}) {
    if (path != kStandardStream) continue;
    if (!reader.empty())
      throw CLI::ValidationError(option, "standard input is " + reader + " already. Name a file");
    reader = std::string("the file of ") + option;
  }
}

/// All options but those that name the mesh and its result.
void addUnwrapOptions(CLI::App* sub, UnwrapCommand& c) {
  sub->add_option_function<std::string>(
         "--seams", [&c](const std::string& text) { setSeams(text, c); },
         wrapped("where to cut, separated by commas: auto = where a chart would stretch too much "
                 "or overlap; hard = every edge where the shading normals or smoothing groups of "
                 "the file break; uv = around the uv islands of the mesh; material = between "
                 "materials; sharp=DEGREES = edges that bend by more; file=PATH = edges in a text "
                 "file, one 'VERTEX VERTEX' per line, numbered from 0; none = only the cuts that "
                 "every chart needs to be a disk"))
      ->default_str("auto")
      ->type_name("LIST");
  sub->add_option_function<std::string>(
         "--keep", [&c](const std::string& text) { setKept(text, c); },
         wrapped("faces whose uv islands stay exactly as they are, separated by commas; all others "
                 "are unwrapped and packed around them: uv = all faces with texcoords; "
                 "material=NAME = all faces of a material; file=PATH = the faces in a text file, "
                 "one number per line, from 0"))
      ->type_name("LIST");
  sub->add_option("--write-seams", c.writeSeams,
                  wrapped("text file for the edges that were cut, to be read by --seams file=PATH; "
                          "- writes to standard output"))
      ->check(notEmpty())
      ->type_name("FILE");
  addPins(*sub, c.pins, " in the atlas (two or more per chart)");
  addPictures(*sub, c);
  addOptions(*sub, c.options);
  addBaking(*sub, c.baking);
  addTexcoordSet(*sub, c.texcoord);
  addReadTexcoord(
      *sub, c.gltf.texcoord,
      "glTF set that --seams uv and --keep uv refer to: TEXCOORD_0 to TEXCOORD_7; --keep "
      "uv also writes it unless --texcoord names another");
  addOwnTexels(*sub, c.gltf.ownTexels);
  addAllowOutside(*sub, c.allowsOutside);
  addReport(*sub, c.report);
  addQuiet(*sub, c.quiet);
}

}  // namespace

CLI::App* addUnwrap(CLI::App& app, UnwrapCommand& c) {
  CLI::App* sub = app.add_subcommand(
      "unwrap", "Cut any mesh into charts, flatten them and pack them into an atlas");
  sub->group("Commands");
  addInput(*sub, c.input);
  addOutput(*sub, c.output);
  addMovedTo(*sub, c.movedTo);
  addUnwrapOptions(sub, c);
  sub->footer(exitCodeHelp());
  setUsage(*sub, "abflat unwrap IN -o OUT [OPTIONS]");
  return sub;
}

CLI::App* addAtlas(CLI::App& app, AtlasCommand& c) {
  CLI::App* sub = app.add_subcommand("atlas", "Unwrap several meshes into one atlas");
  sub->group("");
  sub->add_option("PARTS", c.parts, "file of batch that names the meshes")
      ->required()
      ->check(notEmpty());
  addUnwrapOptions(sub, c.unwrap);
  return sub;
}

void checkTogether(const UnwrapCommand& c) {
  struct Target {
    const char* option;
    const std::string& path;
  };
  const std::vector<Target> targets = {{"--output", c.output},
                                       {"--report", c.report},
                                       {"--write-seams", c.writeSeams},
                                       {"--layout", c.layout},
                                       {"--heat-map", c.heatMap}};
  for (auto target = targets.begin(); target != targets.end(); ++target) {
    if (target->path.empty()) continue;
    for (auto other = targets.begin(); other != target; ++other)
      if (!other->path.empty() && isSameTarget(target->path, other->path))
        refuse(target->option, std::string("is the same file as ") + other->option);
    const bool isMesh = target == targets.begin();  // a mesh may be replaced by its own result
    if (!isMesh && replaces(target->path, c.input))
      refuse(target->option, "would replace the input");
    // A file of edges that was read may be replaced by the edges that were cut.
    if (&target->path != &c.writeSeams && replaces(target->path, c.seamFile))
      refuse(target->option, "would replace the file of --seams");
    if (replaces(target->path, c.keep.file))
      refuse(target->option, "would replace the file of --keep");
    if (replaces(target->path, c.pins)) refuse(target->option, "would replace the file of --pins");
  }
  checkUdim(c.options);
  checkPictures(c);
  checkBaking(c.baking, c.output, c.options.udim);
  checkStandardInput(c);
}

void checkTogether(const AtlasCommand& c) {
  const auto refuseIf = [](bool isGiven, const char* option, const char* why) {
    if (isGiven) throw CLI::ValidationError(option, std::string(why) + ". Leave out --atlas or it");
  };
  const UnwrapCommand& unwrap = c.unwrap;
  refuseIf(unwrap.keep.any(), "--keep", "meshes that share an atlas are unwrapped whole");
  refuseIf(!unwrap.seamFile.empty(), "--seams", "a file of seams is about one mesh");
  refuseIf(!unwrap.pins.empty(), "--pins", "pins are about one mesh");
  refuseIf(unwrap.baking.isWanted, "--bake", "meshes that share an atlas are not baked");
  checkUdim(unwrap.options);
  checkPictures(unwrap);
}

}  // namespace abflat::cli
