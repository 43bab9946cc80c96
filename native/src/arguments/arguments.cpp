#include "arguments/arguments.h"

#include <iostream>
#include <utility>

#include "abflat/generated/status_code.h"
#include "abflat/version.h"
#include "arguments/options.h"
#include "arguments/subcommands.h"
#include "terminal/terminal.h"

namespace abflat::cli {
namespace {

/// The first word that looks like an option but is not one.
std::string unknownOption(const CLI::App& command) {
  for (const std::string& word : command.remaining())
    if (word.size() > 1 && word[0] == '-') return word;
  return {};
}

/// What is wrong with the words.
std::string problemOf(const CLI::App& app, const CLI::Error& error) {
  const auto named = app.get_subcommands();
  std::string what = error.what();
  if (named.empty() && !app.remaining().empty())
    what = "there is no command '" + app.remaining().front() +
           "'. Use unwrap, flatten, pack, bake, verify, batch, inspect, sample, sweep, compare or "
           "reproduce";
  else if (named.empty())
    what =
        "no command given. Use unwrap, flatten, pack, bake, verify, batch, inspect, sample, sweep, "
        "compare or reproduce";
  else if (const std::string option = unknownOption(*named.front()); !option.empty())
    what = "there is no option '" + option + "'. If that is a file, write ./" + option;
  else if (error.get_name() == "ArgumentMismatch")
    what = what.substr(0, what.find(':')) + " takes exactly one value";
  return what;
}

std::string usageError(const CLI::App& app, const CLI::Error& error) {
  const auto named = app.get_subcommands();
  const std::string command = named.empty() ? "" : " " + named.front()->get_name();
  return "abflat: " + sentence(problemOf(app, error)) + "\nRun 'abflat" + command +
         " --help' for usage.\n";
}

constexpr const char* kFooter =
    "Run 'abflat COMMAND --help' for the options of a command.\n\n"
    "Examples:\n"
    "  abflat unwrap character.obj -o character-uv.obj\n"
    "  abflat flatten head.obj -o head-uv.obj\n"
    "  abflat flatten head.obj -o head-uv.obj --t 2 --report head.json\n"
    "  abflat pack robot.glb -o robot-packed.glb\n"
    "  abflat bake robot.glb -o robot-baked.glb --texcoord 1\n"
    "  abflat verify robot.glb --padding 8 --resolution 2048\n"
    "  abflat batch meshes --out unwrapped\n"
    "  abflat inspect head.obj\n"
    "  abflat sample head -o head.obj\n\n";

/// All commands, as the words set them.
class Parser {
 public:
  /// `run`: see addBatch.
  explicit Parser(const std::string& run) {
    app_.set_version_flag("--version", "abflat " ABFLAT_VERSION, "print the version");
    app_.require_subcommand(1);
    setUsage(app_, "abflat COMMAND ...");
    app_.footer(kFooter + exitCodeHelp());
    unwrapApp_ = addUnwrap(app_, unwrap_);
    atlasApp_ = addAtlas(app_, atlas_);
    flattenApp_ = addFlatten(app_, flatten_);
    packApp_ = addPack(app_, pack_);
    bakeApp_ = addBake(app_, bake_);
    verifyApp_ = addVerify(app_, verify_);
    batchApp_ = addBatch(app_, batch_, run);
    inspectApp_ = addInspect(app_, inspect_);
    sampleApp_ = addSample(app_, sample_);
    sweepApp_ = addSweep(app_, sweep_);
    compareApp_ = addCompare(app_, compare_);
    reproduceApp_ = addReproduce(app_, reproduce_);
  }

  CLI::App& app() { return app_; }

  /// Throws CLI::ParseError.
  Command parse(int argc, const char* const* argv) {
    app_.parse(argc, argv);
    if (verifyApp_->parsed()) noteGiven(*verifyApp_, verify_);
    if (unwrapApp_->parsed()) return checked(unwrap_);
    if (atlasApp_->parsed()) return checked(atlas_);
    if (flattenApp_->parsed()) return checked(flatten_);
    if (packApp_->parsed()) return checked(pack_);
    if (bakeApp_->parsed()) return checked(bake_);
    if (verifyApp_->parsed()) return checked(verify_);
    if (batchApp_->parsed()) return checked(batch_);
    if (inspectApp_->parsed()) return inspect_;
    if (sampleApp_->parsed()) return sample_;
    if (sweepApp_->parsed()) return checked(sweep_);
    if (compareApp_->parsed()) return checked(compare_);
    if (reproduceApp_->parsed()) return reproduce_;
    return Finished{static_cast<int>(ExitCode::Usage)};
  }

 private:
  template <class Each>
  static Command checked(const Each& command) {
    checkTogether(command);
    return command;
  }

  CLI::App app_{"Unwraps 3D meshes: cuts them into charts and flattens these by their angles.",
                "abflat"};
  UnwrapCommand unwrap_;
  AtlasCommand atlas_;
  FlattenCommand flatten_;
  PackCommand pack_;
  BakeCommand bake_;
  VerifyCommand verify_;
  BatchCommand batch_;
  InspectCommand inspect_;
  SampleCommand sample_;
  SweepCommand sweep_;
  CompareCommand compare_;
  ReproduceCommand reproduce_;
  const CLI::App *unwrapApp_, *atlasApp_, *flattenApp_, *packApp_, *bakeApp_, *verifyApp_,
      *batchApp_, *inspectApp_, *sampleApp_, *sweepApp_, *compareApp_, *reproduceApp_;
};

/// The command that batch is to run, as far as the words tell.
std::string commandToRun(const std::vector<std::string>& words) {
  const std::string flag = "--run", joined = flag + "=";
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i].compare(0, joined.size(), joined) == 0) return words[i].substr(joined.size());
    if (words[i] == flag && i + 1 < words.size()) return words[i + 1];
  }
  return BatchCommand().run;
}

}  // namespace

Command parseArguments(int argc, const char* const* argv) {
  Parser parser(commandToRun({argv, argv + argc}));
  try {
    return parser.parse(argc, argv);
  } catch (const CLI::Success& request) {
    const int code = parser.app().exit(request);
    return Finished{std::cout.flush() ? code : static_cast<int>(ExitCode::CannotWrite)};
  } catch (const CLI::ParseError& error) {
    std::cerr << usageError(parser.app(), error);
    return Finished{static_cast<int>(ExitCode::Usage)};
  }
}

Result<Command> parseWords(const std::vector<std::string>& words) {
  std::vector<const char*> all = {"abflat"};
  for (const std::string& word : words) all.push_back(word.c_str());
  Parser parser(commandToRun(words));
  try {
    return parser.parse(static_cast<int>(all.size()), all.data());
  } catch (const CLI::Error& error) {
    return Status{StatusCode::InvalidOption, problemOf(parser.app(), error)};
  }
}

std::vector<std::string> filesReadBy(const Command& command) {
  std::vector<std::string> all;
  if (const auto* unwrap = std::get_if<UnwrapCommand>(&command))
    all = {unwrap->seamFile, unwrap->keep.file, unwrap->pins};
  else if (const auto* flatten = std::get_if<FlattenCommand>(&command))
    all = {flatten->bounds, flatten->straight, flatten->pins};
  else if (const auto* verify = std::get_if<VerifyCommand>(&command))
    all = {verify->rules};
  std::vector<std::string> out;
  for (std::string& path : all)
    if (!path.empty()) out.push_back(std::move(path));
  return out;
}

}  // namespace abflat::cli
