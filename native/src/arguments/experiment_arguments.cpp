#include <sstream>

#include "arguments/options.h"
#include "arguments/subcommands.h"
#include "files/file_format.h"

namespace abflat::cli {
namespace {

/// Parses "2,1.05,auto" as values of a flattening option.
std::vector<double> parseList(const std::string& option, const std::string& text) {
  const OptionInfos infos = optionInfos(FlattenOptionValues{});
  int index = 0;
  while (infos[index].flag != option) ++index;
  std::vector<double> out;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');) {
    FlattenOptionValues values;
    bool isWord = false;
    double value = 0;
    if (!readOption(values, index, word, value, isWord) || !setOption(values, index, value, isWord))
      throw CLI::ValidationError(option, "'" + word + "' is not a number " + infos[index].range);
    out.push_back(value);
  }
  if (out.empty()) throw CLI::ValidationError(option, "the list is empty");
  return out;
}

}  // namespace

CLI::App* addSweep(CLI::App& app, SweepCommand& c) {
  CLI::App* sub = app.add_subcommand(
      "sweep", "Flatten a mesh with several values of t and balance, and compare the distortion");
  sub->group("Commands");
  addInput(*sub, c.input);
  const CLI::Option* t =
      sub->add_option_function<std::string>(
             "--t", [&c](const std::string& text) { c.t = parseList("--t", text); },
             wrapped("values of t, separated by commas: numbers above 0, or auto (default with "
                     "--balance: auto)"))
          ->default_str("2,1.05,1,0.968")
          ->type_name("LIST");
  sub->add_option_function<std::string>(
         "--balance",
         [&c, t](const std::string& text) {
           c.balance = parseList("--balance", text);
           if (t->count() == 0) c.t = {kAutoT};
         },
         wrapped("balances between angles and lengths, separated by commas: numbers from 0 to 1; "
                 "every t is combined with every balance"))
      ->default_str("0")
      ->type_name("LIST");
  sub->add_option("--csv", c.csv,
                  wrapped("CSV file to write instead of a table; - writes to standard output"))
      ->check(notEmpty())
      ->type_name("FILE");
  addAllowOutside(*sub, c.allowsOutside);
  setUsage(*sub, "abflat sweep IN [OPTIONS]");
  sub->footer("If a t is impossible for the mesh, or gives no valid layout, its row says so.\n\n" +
              exitCodeHelp());
  return sub;
}

void checkTogether(const SweepCommand& c) {
  if (replaces(c.csv, c.input)) refuse("--csv", "would replace the input");
}

CLI::App* addCompare(CLI::App& app, CompareCommand& c) {
  CLI::App* sub = app.add_subcommand(
      "compare", "Compare layouts by abflat, MIPS, Tutte, mean value, harmonic and LSCM");
  sub->group("Commands");
  addInput(*sub, c.input);
  sub->add_option(
         "--json", c.json,
         wrapped("JSON file for all measures, instead of a table; - writes to standard output"))
      ->check(notEmpty())
      ->type_name("FILE");
  addAllowOutside(*sub, c.allowsOutside);
  setUsage(*sub, "abflat compare IN [OPTIONS]");
  sub->footer(
      "If a method gives no valid layout, its row says so and the exit code is still 0.\n\n" +
      exitCodeHelp());
  return sub;
}

void checkTogether(const CompareCommand& c) {
  if (replaces(c.json, c.input)) refuse("--json", "would replace the input");
}

CLI::App* addReproduce(CLI::App& app, ReproduceCommand& c) {
  CLI::App* sub = app.add_subcommand(
      "reproduce", "Repeat the experiments of the paper: tables, convergence, figures");
  sub->group("Commands");
  sub->add_option("--meshes", c.meshes,
                  wrapped(std::string("folder of ") + kCoreTitles +
                          " files to use as well as the generated models"))
      ->check(notEmpty())
      ->type_name("DIR");
  sub->add_option("-o,--out", c.out, wrapped("folder to write to; created if missing"))
      ->required()
      ->check(notEmpty())
      ->type_name("DIR");
  sub->add_option_function<std::string>(
         "--only",
         [&c](const std::string& part) {
           c.wantsTables = part == "tables";
           c.wantsConvergence = part == "convergence";
           c.wantsFigures = part == "figures";
         },
         wrapped("only one part: tables, convergence or figures"))
      ->check(CLI::IsMember({"tables", "convergence", "figures"}))
      ->type_name("PART");
  const OptionInfos infos = optionInfos(c.options);
  for (int i = 0; i < infos.count; ++i)
    if (infos[i].name == std::string("precondition")) addOption(*sub, c.options, i);
  sub->add_flag("-q,--quiet", c.quiet, "print only errors: no progress");
  setUsage(*sub, "abflat reproduce [--meshes DIR] --out DIR [OPTIONS]");
  sub->footer(
      "If a mesh cannot be read or is not a disk, its row says so. DIR/index.html shows all "
      "results.\n\n" +
      exitCodeHelp());
  return sub;
}

}  // namespace abflat::cli
