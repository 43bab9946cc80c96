#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "abflat/flatten.h"
#include "abflat/option_text.h"
#include "abflat/unwrap.h"

namespace abflat::cli {

/// The part of a help text that lists the exit codes.
std::string exitCodeHelp();

/// Breaks a description into lines so that it fits beside the option names.
std::string wrapped(const std::string& text);

/// Shows required options in the usage line, and footers unchanged.
void setUsage(CLI::App& app, const std::string& usage);

CLI::Validator notEmpty();
/// `range` in words, for the error message.
CLI::Validator numberCheck(const std::string& range, bool (*isValid)(double));

void addInput(CLI::App& app, std::string& input);
void addOutput(CLI::App& app, std::string& output);
/// Where the output will lie; other programs than batch do not need it.
void addMovedTo(CLI::App& app, std::string& path);
/// `where`: words that describe their uv.
void addPins(CLI::App& app, std::string& pins, const std::string& where);
/// None means auto.
void addTexcoordSet(CLI::App& app, std::optional<std::size_t>& set);
/// The number of a set, from 0 to 7; `others`: what else the text may be, for the error message.
std::size_t texcoordSet(const char* option, const std::string& text, const char* others);
/// `help`: what is read from that set.
void addReadTexcoord(CLI::App& app, std::size_t& set, const std::string& help);
void addOwnTexels(CLI::App& app, bool& ownTexels);
/// Whether files that the mesh refers to may be anywhere.
void addAllowOutside(CLI::App& app, bool& allowsOutside);
void addReport(CLI::App& app, std::string& report);
void addQuiet(CLI::App& app, bool& quiet);

/// Whether a switch is off by default; one that is on has a flag to turn it off.
inline bool isOff(const OptionInfo& info) { return std::string_view(info.defaultText) == "false"; }

/// Adds an option of the schema, which provides its flag, range, default and help.
template <class Values>
CLI::Option* addOption(CLI::App& app, Values& values, int index) {
  const OptionInfo& info = optionInfos(values)[index];
  if (info.isSwitch) {
    return app.add_flag_callback(
        info.flag, [&values, index, on = isOff(info)] { setOption(values, index, on); },
        wrapped(info.help));
  }
  const auto set = [&values, index](const std::string& text) {
    const OptionInfo& option = optionInfos(values)[index];
    const std::string wanted =
        (option.isChoice ? "one of " : "a number ") + std::string(option.range);
    bool isWord = false;
    double value = 0;
    if (!readOption(values, index, text, value, isWord))
      throw CLI::ValidationError(option.flag, "'" + text + "' is not " + wanted);
    if (!setOption(values, index, value, isWord))
      throw CLI::ValidationError(option.flag, "must be " + wanted + ", not " + text);
  };
  return app.add_option_function<std::string>(info.flag, set, wrapped(info.help))
      ->default_str(info.defaultText)
      ->type_name(info.isChoice ? "WORD" : "NUMBER");
}

template <class Values>
void addOptions(CLI::App& app, Values& values) {
  for (int i = 0; i < optionInfos(values).count; ++i) addOption(app, values, i);
}

/// Throws CLI::ValidationError if tiles are asked for without saying how large charts are.
template <class Values>
void checkUdim(const Values& values) {
  if (values.udim && values.texelDensity == kAutoTexelDensity)
    throw CLI::ValidationError("--udim", "needs a numeric --texel-density");
}

/// Rejects a file name that clashes with another one.
void refuse(const char* option, const std::string& what);

/// Whether writing `target` would lose what is read from `source`.
bool replaces(const std::string& target, const std::string& source);

}  // namespace abflat::cli
