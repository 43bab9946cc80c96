#include "arguments/baking.h"
#include "arguments/options.h"
#include "arguments/subcommands.h"
#include "files/paths.h"

namespace abflat::cli {

CLI::App* addBake(CLI::App& app, BakeCommand& c) {
  CLI::App* sub = app.add_subcommand(
      "bake", "Have the textures of a glTF follow the layout in another of its texcoord sets");
  sub->group("Commands");
  addInput(*sub, c.input);
  addOutput(*sub, c.output);
  addMovedTo(*sub, c.movedTo);
  sub->add_option_function<std::string>(
         "--texcoord",
         [&c](const std::string& text) { c.texcoord = texcoordSet("--texcoord", text, ""); },
         wrapped("glTF set with the new layout: TEXCOORD_0 to TEXCOORD_7; each material says which "
                 "sets its textures are at now"))
      ->default_str("1")
      ->type_name("NUMBER");
  addOptions(*sub, c.options);
  addAllowOutside(*sub, c.allowsOutside);
  addReport(*sub, c.report);
  addQuiet(*sub, c.quiet);
  sub->footer(exitCodeHelp());
  setUsage(*sub, "abflat bake IN -o OUT [OPTIONS]");
  return sub;
}

void checkTogether(const BakeCommand& c) {
  checkHoldsImages(c.output);
  if (c.report.empty()) return;
  if (isSameTarget(c.report, c.output)) refuse("--report", "is the same file as --output");
  if (replaces(c.report, c.input)) refuse("--report", "would replace the input");
}

}  // namespace abflat::cli
