#include "arguments.h"

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>

#include "abflat/draw.h"
#include "abflat/generated/status_code.h"
#include "mesh_format.h"
#include "paths.h"

namespace abflat::cli {
namespace {

std::string exitCodeHelp() {
  std::ostringstream out;
  out << "Exit codes:\n";
  for (int code = 0; code < kExitCodeCount; ++code)
    out << "  " << code << "  " << exitCodeText(static_cast<ExitCode>(code)) << "\n";
  return out.str();
}

std::string sampleHelp() {
  std::ostringstream out;
  out << "Samples:\n";
  for (const Sample& sample : samples())
    out << "  " << std::left << std::setw(14) << sample.name << sample.title << "\n";
  return out.str();
}

/// Breaks a description so that it fits beside the option names.
std::string wrapped(const std::string& text) {
  constexpr std::size_t kWidth = 50;
  std::istringstream words(text);
  std::string out, word;
  for (std::size_t column = 0; words >> word; column += word.size() + 1) {
    const bool isFull = column > 0 && column + word.size() > kWidth;
    if (isFull) column = 0;
    out += (out.empty() ? "" : isFull ? "\n" : " ") + word;
  }
  return out;
}

/// Shows required options in the usage line and footers as they are.
class HelpFormatter : public CLI::Formatter {
 public:
  explicit HelpFormatter(std::string usage) : usage_(std::move(usage)) {
    label("REQUIRED", "(required)");
    label("Positionals", "Arguments");
    column_width(29);
  }
  std::string make_usage(const CLI::App*, std::string) const override {
    return "Usage: " + usage_ + "\n";
  }
  std::string make_footer(const CLI::App* app) const override { return app->get_footer(); }

 private:
  std::string usage_;
};

void setUsage(CLI::App& app, const std::string& usage) {
  app.formatter(std::make_shared<HelpFormatter>(usage));
  app.set_help_flag("-h,--help", "print this help");
}

bool isNumber(const std::string& text, double& value) {
  char* end = nullptr;
  value = std::strtod(text.c_str(), &end);
  return !text.empty() && *end == '\0';
}

/// A number, with or without one of the option's units: "3G".
template <class Values>
bool isNumberOfOption(const Values& values, int index, const std::string& text, double& value) {
  if (isNumber(text, value)) return true;
  const double unit = text.empty() ? 0 : unitSize(values, index, text.back());
  if (unit == 0 || !isNumber(text.substr(0, text.size() - 1), value)) return false;
  value *= unit;
  return true;
}

CLI::Validator numberCheck(const std::string& range, bool (*isValid)(double)) {
  return CLI::Validator(
      [=](const std::string& text) -> std::string {
        double value = 0;
        if (!isNumber(text, value)) return "'" + text + "' is not a number";
        return isValid(value) ? "" : "must be a number " + range + ", not " + text;
      },
      "");
}

CLI::Validator notEmpty() {
  return CLI::Validator(
      [](const std::string& text) -> std::string {
        return text.empty() ? "the name is empty" : "";
      },
      "");
}

CLI::Validator sampleName() {
  return CLI::Validator(
      [](const std::string& text) -> std::string {
        std::string known;
        for (const Sample& sample : samples()) {
          if (sample.name == text) return "";
          known += (known.empty() ? "" : ", ") + std::string(sample.name);
        }
        return "there is no sample '" + text + "'; known are " + known;
      },
      "");
}

/// A name that promises another format would mislead who reads the file next.
CLI::Validator resultName() {
  return CLI::Validator(
      [](const std::string& text) -> std::string {
        if (isWritableName(text)) return "";
        return "results are written as OBJ or PLY: give a name that ends in .obj or .ply, not " +
               endingOf(text);
      },
      "");
}

/// `endings` are those that `text` may have, in words.
CLI::Validator pictureName(const std::vector<std::string>& endings, const std::string& inWords) {
  return CLI::Validator(
      [=](const std::string& text) -> std::string {
        const std::string ending = endingOf(text);
        for (const std::string& known : endings)
          if (ending == known) return "";
        return "give a name that ends in " + inWords + ", not '" + text + "'";
      },
      "");
}

void addInput(CLI::App& app, std::string& input) {
  app.add_option("IN", input, "mesh to read: OBJ, PLY, STL or OFF; - for standard input")
      ->required()
      ->check(notEmpty())
      ->type_name("");
}

void addOutput(CLI::App& app, std::string& output) {
  app.add_option("-o,--output", output,
                 wrapped("file to write, OBJ or PLY by its ending; - for OBJ on standard output"))
      ->required()
      ->check(notEmpty())
      ->check(resultName())
      ->type_name("OUT");
}

/// Whether a switch is off unless given; one that is on has a flag to turn it off.
bool isOff(const OptionInfo& info) { return std::string_view(info.defaultText) == "false"; }

/// An option of the schema: its flag, range, default and help come from there.
template <class Values>
void addOption(CLI::App& app, Values& values, int index) {
  const OptionInfo& info = optionInfos(values)[index];
  if (info.isSwitch) {
    app.add_flag_callback(
        info.flag, [&values, index, on = isOff(info)] { setOption(values, index, on); },
        wrapped(info.help));
    return;
  }
  const auto set = [&values, index](const std::string& text) {
    const OptionInfo& option = optionInfos(values)[index];
    const std::string wanted =
        (option.isChoice ? "one of " : "a number ") + std::string(option.range);
    bool isWord = false;
    double value = wordValue(values, index, text, isWord);
    if (!isWord && (option.isChoice || !isNumberOfOption(values, index, text, value)))
      throw CLI::ValidationError(option.flag, "'" + text + "' is not " + wanted);
    if (!setOption(values, index, value, isWord))
      throw CLI::ValidationError(option.flag, "must be " + wanted + ", not " + text);
  };
  app.add_option_function<std::string>(info.flag, set, wrapped(info.help))
      ->default_str(info.defaultText)
      ->type_name(info.isChoice ? "WORD" : "NUMBER");
}

template <class Values>
void addOptions(CLI::App& app, Values& values) {
  for (int i = 0; i < optionInfos(values).count; ++i) addOption(app, values, i);
}

void addReport(CLI::App& app, std::string& report) {
  app.add_option("--report", report,
                 wrapped("JSON file for what was done and how well; - for standard output"))
      ->check(notEmpty())
      ->type_name("FILE");
}

void addQuiet(CLI::App& app, bool& quiet) {
  app.add_flag("-q,--quiet", quiet, "no progress and no summary; errors are still printed");
}

CLI::App* addFlatten(CLI::App& app, FlattenCommand& c) {
  CLI::App* sub = app.add_subcommand(
      "flatten", "Flatten a mesh that is a disk and write it with its uv layout");
  sub->group("Commands");
  addInput(*sub, c.input);
  addOutput(*sub, c.output);
  addOptions(*sub, c.options);
  sub->add_option(
         "--bounds", c.bounds,
         wrapped("text file with bounds for single boundary vertices, in place of the "
                 "common t: a line 'VERTEX T' each, vertices counted from 0; - for standard input"))
      ->check(notEmpty())
      ->type_name("FILE");
  addReport(*sub, c.report);
  addQuiet(*sub, c.quiet);
  sub->footer(exitCodeHelp());
  setUsage(*sub, "abflat flatten IN -o OUT [OPTIONS]");
  return sub;
}

/// "auto,file=PATH": what is not the name of a file is for the core to understand.
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
  if (!seams.ok()) throw CLI::ValidationError("--seams", seams.status.message);
  c.seams = std::move(seams.value);
}

void addPictures(CLI::App& app, UnwrapCommand& c) {
  app.add_option("--layout", c.layout,
                 wrapped("picture of the atlas with charts in colours and all edges, SVG or PNG by "
                         "its ending; PNG has a pixel per texel"))
      ->check(notEmpty())
      ->check(pictureName({".svg", ".png"}, ".svg or .png"))
      ->type_name("FILE");
  app.add_option("--scale", c.scale,
                 wrapped("millimetres for a unit of the mesh: the SVG of --layout gets the size at "
                         "which charts are as large as their surface"))
      ->check(numberCheck("above 0", [](double mm) { return mm > 0 && mm < 1e9; }))
      ->type_name("MM");
  app.add_option("--heat-map", c.heatMap,
                 wrapped("PNG picture of the atlas by area distortion: blue shrunk, white as the "
                         "whole, red enlarged, to 1/2 and 2"))
      ->check(notEmpty())
      ->check(pictureName({".png"}, ".png"))
      ->type_name("FILE");
}

CLI::App* addUnwrap(CLI::App& app, UnwrapCommand& c) {
  CLI::App* sub = app.add_subcommand(
      "unwrap", "Cut any mesh into charts, flatten them and write it with a packed uv atlas");
  sub->group("Commands");
  addInput(*sub, c.input);
  addOutput(*sub, c.output);
  sub->add_option_function<std::string>(
         "--seams", [&c](const std::string& text) { setSeams(text, c); },
         wrapped("where to cut, separated by commas: auto = so that no chart is stretched too much "
                 "or overlaps; uv = between the islands that the mesh has; material = between "
                 "materials; sharp=DEGREES = edges that bend by more; file=PATH = edges in a text "
                 "file, a line 'VERTEX VERTEX' each, counted from 0; none = only what makes charts "
                 "disks, which is always done"))
      ->default_str("auto")
      ->type_name("LIST");
  sub->add_option("--write-seams", c.writeSeams,
                  wrapped("text file for the edges that were cut, as --seams file=PATH takes them; "
                          "- for standard output"))
      ->check(notEmpty())
      ->type_name("FILE");
  addPictures(*sub, c);
  addOptions(*sub, c.options);
  addReport(*sub, c.report);
  addQuiet(*sub, c.quiet);
  sub->footer(exitCodeHelp());
  setUsage(*sub, "abflat unwrap IN -o OUT [OPTIONS]");
  return sub;
}

CLI::App* addInspect(CLI::App& app, InspectCommand& c) {
  CLI::App* sub =
      app.add_subcommand("inspect", "Say what a mesh is, and what keeps it from being flattened");
  sub->group("Commands");
  addInput(*sub, c.input);
  sub->add_flag("--json", c.json, "print JSON instead of a table");
  setUsage(*sub, "abflat inspect IN [--json]");
  sub->footer("The exit code is 0 for every mesh that can be read, disk or not.\n");
  return sub;
}

CLI::App* addSample(CLI::App& app, SampleCommand& c) {
  CLI::App* sub = app.add_subcommand("sample", "Write a generated mesh to try things on");
  sub->group("Commands");
  sub->add_option("NAME", c.name, "one of the samples below")
      ->required()
      ->check(sampleName())
      ->type_name("");
  addOutput(*sub, c.output);
  std::ostringstream range;
  range << "from " << kMinSampleDetail << " to " << kMaxSampleDetail;
  sub->add_option("--detail", c.detail, "multiplies the number of faces, " + range.str())
      ->check(numberCheck(range.str(),
                          [](double d) { return d >= kMinSampleDetail && d <= kMaxSampleDetail; }))
      ->capture_default_str()
      ->type_name("NUMBER");
  sub->footer(sampleHelp());
  setUsage(*sub, "abflat sample NAME -o OUT [--detail NUMBER]");
  return sub;
}

/// "2,1.05,auto" as values of t.
std::vector<double> parseBounds(const std::string& text) {
  constexpr int kIndexOfT = 0;
  std::vector<double> out;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');) {
    FlattenOptionValues values;
    bool isWord = false;
    double t = wordValue(values, kIndexOfT, word, isWord);
    if ((!isWord && !isNumber(word, t)) || !setOption(values, kIndexOfT, t, isWord))
      throw CLI::ValidationError(
          "--t", "'" + word + "' is not a number " + optionInfos(values)[kIndexOfT].range);
    out.push_back(t);
  }
  if (out.empty()) throw CLI::ValidationError("--t", "the list is empty");
  return out;
}

CLI::App* addSweep(CLI::App& app, SweepCommand& c) {
  CLI::App* sub = app.add_subcommand("sweep", "Compare the distortion of a mesh for several t");
  sub->group("Commands");
  addInput(*sub, c.input);
  sub->add_option_function<std::string>(
         "--t", [&c](const std::string& text) { c.t = parseBounds(text); },
         wrapped("values of t separated by commas, each a number above 0, or auto"))
      ->default_str("2,1.05,1,0.968")
      ->type_name("LIST");
  sub->add_option("--csv", c.csv,
                  wrapped("CSV file to write instead of printing a table; - for standard output"))
      ->check(notEmpty())
      ->type_name("FILE");
  setUsage(*sub, "abflat sweep IN [--t LIST] [--csv FILE]");
  sub->footer(
      "A t that is not possible for the mesh, or gives no valid layout, is a row that says "
      "so.\n\n" +
      exitCodeHelp());
  return sub;
}

CLI::App* addCompare(CLI::App& app, CompareCommand& c) {
  CLI::App* sub = app.add_subcommand(
      "compare", "Compare the layouts of a mesh by abflat, Tutte, mean value, harmonic and LSCM");
  sub->group("Commands");
  addInput(*sub, c.input);
  sub->add_option("--json", c.json,
                  wrapped("JSON file to write instead of printing a table, with all measures; - "
                          "for standard output"))
      ->check(notEmpty())
      ->type_name("FILE");
  setUsage(*sub, "abflat compare IN [--json FILE]");
  sub->footer(
      "A method that gives no valid layout is a row that says so; the exit code is 0 all the "
      "same.\n\n" +
      exitCodeHelp());
  return sub;
}

CLI::App* addReproduce(CLI::App& app, ReproduceCommand& c) {
  CLI::App* sub = app.add_subcommand(
      "reproduce", "Repeat the experiments of the paper: tables, convergence, figures");
  sub->group("Commands");
  sub->add_option(
         "--meshes", c.meshes,
         wrapped("folder whose OBJ, PLY, STL and OFF files are used beside the generated models"))
      ->check(notEmpty())
      ->type_name("DIR");
  sub->add_option("-o,--out", c.out, wrapped("folder to write to; made when it is missing"))
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
         wrapped("one part of it: tables, convergence or figures"))
      ->check(CLI::IsMember({"tables", "convergence", "figures"}))
      ->type_name("PART");
  const OptionInfos infos = optionInfos(c.options);
  for (int i = 0; i < infos.count; ++i)
    if (infos[i].name == std::string("precondition")) addOption(*sub, c.options, i);
  sub->add_flag("-q,--quiet", c.quiet, "no progress; errors are still printed");
  setUsage(*sub, "abflat reproduce [--meshes DIR] --out DIR [OPTIONS]");
  sub->footer(
      "A mesh that cannot be read or is no disk is a row that says so. DIR/index.html shows all "
      "results.\n\n" +
      exitCodeHelp());
  return sub;
}

std::string usageError(const CLI::App& app, const CLI::Error& error) {
  const auto named = app.get_subcommands();
  std::string what = error.what();
  if (named.empty() && !app.remaining().empty())
    what = "there is no command '" + app.remaining().front() +
           "'; known are unwrap, flatten, inspect, sample, sweep, compare, reproduce";
  else if (named.empty())
    what = "name a command: unwrap, flatten, inspect, sample, sweep, compare or reproduce";
  else if (error.get_name() == "ArgumentMismatch")
    what = what.substr(0, what.find(':')) + " takes exactly one value";
  const std::string command = named.empty() ? "" : " " + named.front()->get_name();
  return "abflat: " + what + "\nabflat" + command + " --help says how.\n";
}

void refuse(const char* option, const std::string& what) {
  throw CLI::ValidationError(option, what + "; give it a name of its own");
}

/// Whether writing `target` would lose what is read from `source`.
bool replaces(const std::string& target, const std::string& source) {
  return !target.empty() && !source.empty() && target != kStandardStream &&
         isSameTarget(target, source);
}

/// What the options cannot say one by one. A mesh may be replaced by its own result.
void checkTogether(const FlattenCommand& c) {
  if (!c.report.empty() && isSameTarget(c.report, c.output))
    refuse("--report", "is the same file as --output");
  if (replaces(c.report, c.input)) refuse("--report", "would replace the input");
  if (replaces(c.report, c.bounds)) refuse("--report", "would replace the file of --bounds");
  if (replaces(c.output, c.bounds)) refuse("--output", "would replace the file of --bounds");
  if (c.input == kStandardStream && c.bounds == kStandardStream)
    throw CLI::ValidationError("--bounds", "standard input is the mesh already; name a file");
}

void checkPictures(const UnwrapCommand& c) {
  const bool isSvg = endingOf(c.layout) == ".svg";
  if (c.scale > 0 && !isSvg)
    throw CLI::ValidationError("--scale", "is for an SVG; add --layout FILE.svg");
  const char* picture = !c.heatMap.empty()            ? "--heat-map"
                        : !c.layout.empty() && !isSvg ? "--layout"
                                                      : nullptr;
  if (picture != nullptr && c.options.resolution > kMostPictureTexels)
    throw CLI::ValidationError(
        picture, "a PNG has at most " + std::to_string(kMostPictureTexels) +
                     " pixels along a side; lower --resolution, or write the layout as .svg");
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
    const bool isMesh = target == targets.begin();  // which may be replaced by its own result
    if (!isMesh && replaces(target->path, c.input))
      refuse(target->option, "would replace the input");
    // Edges that were read may be replaced by those that were cut.
    if (&target->path != &c.writeSeams && replaces(target->path, c.seamFile))
      refuse(target->option, "would replace the file of --seams");
  }
  checkPictures(c);
  if (c.input == kStandardStream && c.seamFile == kStandardStream)
    throw CLI::ValidationError("--seams", "standard input is the mesh already; name a file");
}

void checkTogether(const SweepCommand& c) {
  if (replaces(c.csv, c.input)) refuse("--csv", "would replace the input");
}

void checkTogether(const CompareCommand& c) {
  if (replaces(c.json, c.input)) refuse("--json", "would replace the input");
}

}  // namespace

Command parseArguments(int argc, const char* const* argv) {
  CLI::App app(
      "Unwraps 3D meshes: cuts them into charts and flattens these by their angles, with a convex "
      "or free boundary.",
      "abflat");
  app.set_version_flag("--version", "abflat " ABFLAT_VERSION, "print the version");
  app.require_subcommand(1);
  setUsage(app, "abflat COMMAND ...");
  app.footer(
      "abflat COMMAND --help says more about a command.\n\n"
      "Examples:\n"
      "  abflat unwrap character.obj -o character-uv.obj\n"
      "  abflat flatten head.obj -o head-uv.obj\n"
      "  abflat flatten head.obj -o head-uv.obj --t 2 --report head.json\n"
      "  abflat inspect head.obj\n"
      "  abflat sample head -o head.obj\n\n" +
      exitCodeHelp());
  UnwrapCommand unwrap;
  FlattenCommand flatten;
  InspectCommand inspect;
  SampleCommand sample;
  SweepCommand sweep;
  CompareCommand compare;
  ReproduceCommand reproduce;
  const CLI::App* unwrapApp = addUnwrap(app, unwrap);
  const CLI::App* flattenApp = addFlatten(app, flatten);
  const CLI::App* inspectApp = addInspect(app, inspect);
  const CLI::App* sampleApp = addSample(app, sample);
  const CLI::App* sweepApp = addSweep(app, sweep);
  const CLI::App* compareApp = addCompare(app, compare);
  const CLI::App* reproduceApp = addReproduce(app, reproduce);
  try {
    app.parse(argc, argv);
    if (unwrapApp->parsed()) checkTogether(unwrap);
    if (flattenApp->parsed()) checkTogether(flatten);
    if (sweepApp->parsed()) checkTogether(sweep);
    if (compareApp->parsed()) checkTogether(compare);
  } catch (const CLI::Success& request) {
    return Finished{app.exit(request)};
  } catch (const CLI::ParseError& error) {
    std::cerr << usageError(app, error);
    return Finished{static_cast<int>(ExitCode::Usage)};
  }
  if (unwrapApp->parsed()) return unwrap;
  if (flattenApp->parsed()) return flatten;
  if (inspectApp->parsed()) return inspect;
  if (sampleApp->parsed()) return sample;
  if (sweepApp->parsed()) return sweep;
  if (compareApp->parsed()) return compare;
  if (reproduceApp->parsed()) return reproduce;
  return Finished{static_cast<int>(ExitCode::Usage)};
}

}  // namespace abflat::cli
