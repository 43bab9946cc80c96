#include "arguments/options.h"
#include "arguments/subcommands.h"

namespace abflat::cli {

CLI::App* addInspect(CLI::App& app, InspectCommand& c) {
  CLI::App* sub =
      app.add_subcommand("inspect", "Describe a mesh and say why flatten would refuse it");
  sub->group("Commands");
  addInput(*sub, c.input);
  sub->add_flag("--json", c.json, "print JSON instead of a table");
  addAllowOutside(*sub, c.allowsOutside);
  setUsage(*sub, "abflat inspect IN [OPTIONS]");
  sub->footer("The exit code is 0 for every mesh that can be read, disk or not.\n");
  return sub;
}

}  // namespace abflat::cli
