#include "arguments/baking.h"
#include "arguments/options.h"
#include "arguments/pictures.h"
#include "arguments/subcommands.h"
#include "files/paths.h"

namespace abflat::cli {

CLI::App* addPack(CLI::App& app, PackCommand& c) {
  CLI::App* sub = app.add_subcommand(
      "pack", "Pack the layout that a mesh has: its uv islands keep their shapes");
  sub->group("Commands");
  addInput(*sub, c.input);
  addOutput(*sub, c.output);
  addMovedTo(*sub, c.movedTo);
  addLayoutPicture(*sub, c.layout);
  addOptions(*sub, c.options);
  addBaking(*sub, c.baking);
  addTexcoordSet(*sub, c.texcoord);
  addReadTexcoord(*sub, c.gltf.texcoord,
                  "glTF set with the layout to pack: TEXCOORD_0 to TEXCOORD_7; one above 0 is also "
                  "written unless --texcoord names another");
  addAllowOutside(*sub, c.allowsOutside);
  addReport(*sub, c.report);
  addQuiet(*sub, c.quiet);
  sub->footer(exitCodeHelp());
  setUsage(*sub, "abflat pack IN -o OUT [OPTIONS]");
  return sub;
}

void checkTogether(const PackCommand& c) {
  const std::pair<const char*, const std::string&> others[] = {{"--report", c.report},
                                                               {"--layout", c.layout}};
  for (const auto& [option, path] : others) {
    if (path.empty()) continue;
    if (isSameTarget(path, c.output)) refuse(option, "is the same file as --output");
    if (replaces(path, c.input)) refuse(option, "would replace the input");
  }
  if (!c.report.empty() && !c.layout.empty() && isSameTarget(c.report, c.layout))
    refuse("--layout", "is the same file as --report");
  checkUdim(c.options);
  checkBaking(c.baking, c.output, c.options.udim);
  checkPicture("--layout", c.layout, c.options.resolution);
}

}  // namespace abflat::cli
