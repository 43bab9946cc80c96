#include "files/rules_file.h"

#include <nlohmann/json.hpp>

#include "abflat/option_text.h"
#include "files/paths.h"
#include "files/read_file.h"

namespace abflat::cli {
namespace {

using nlohmann::json;

int indexOf(const VerifyOptionValues& options, const std::string& name) {
  const OptionInfos infos = optionInfos(options);
  for (int i = 0; i < infos.count; ++i)
    if (name == infos[i].name) return i;
  return -1;
}

/// The first key that names no option; empty if there is none.
std::string wrongRule(const json& rules, const VerifyOptionValues& options) {
  for (const auto& [key, value] : rules.items())
    if (key != "$schema" && indexOf(options, key) < 0) return key;
  return {};
}

Status mustBe(const std::string& name, const std::string& rule, const std::string& wanted) {
  return {StatusCode::InvalidOption, name + ": \"" + rule + "\" must be " + wanted};
}

/// As on the command line: 2048, "none", true, or a width and a height as [2048, 1024].
std::string valueText(const json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_array() && value.size() == 2) return value[0].dump() + "x" + value[1].dump();
  return value.dump();
}

/// Sets one option. Returns what is wrong with its value; empty if nothing.
std::string setRule(VerifyOptionValues& options, int index, const std::string& text) {
  double number = 0;
  bool isWord = false;
  if (readOption(options, index, text, number, isWord) && setOption(options, index, number, isWord))
    return {};
  const OptionInfo& info = optionInfos(options)[index];
  return (info.isSwitch ? "true or false" : "a number " + std::string(info.range)) + ", not " +
         text;
}

}  // namespace

Status readRules(const std::string& path, const std::vector<bool>& isGiven,
                 VerifyOptionValues& options) {
  const std::string name = inputName(path);
  const Result<std::string> bytes = readBytes(path);
  if (!bytes.ok()) return bytes.status();
  const json rules = json::parse(bytes.value(), nullptr, false, true);
  if (!rules.is_object())
    return {StatusCode::ParseError,
            name + " is no JSON object. Write rules such as {\"padding\": 8, \"maxStretch\": 1.1}"};
  const std::string key = wrongRule(rules, options);
  if (!key.empty())
    return {StatusCode::InvalidOption,
            name + ": there is no rule \"" + key + "\". See abflat verify --help for their names"};
  for (int i = 0; i < optionInfos(options).count; ++i) {
    const std::string rule = optionInfos(options)[i].name;
    if (!rules.contains(rule) || isGiven[static_cast<std::size_t>(i)]) continue;
    const std::string wanted = setRule(options, i, valueText(rules[rule]));
    if (!wanted.empty()) return mustBe(name, rule, wanted);
  }
  return {};
}

}  // namespace abflat::cli
