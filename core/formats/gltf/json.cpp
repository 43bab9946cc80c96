#include "gltf/json.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace abflat::gltf {
namespace {

/// Builds a value while its text is read.
class JsonBuilder final : public nlohmann::json_sax<nlohmann::json> {
 public:
  bool null() override { return put({}); }
  bool boolean(bool value) override { return put(value); }
  bool number_integer(std::int64_t value) override { return put(value); }
  bool number_unsigned(std::uint64_t value) override { return put(value); }
  bool number_float(double value, const std::string&) override { return put(value); }
  bool string(std::string& text) override { return put(std::move(text)); }
  bool binary(nlohmann::json::binary_t&) override { return false; }  // not in texts
  bool start_object(std::size_t) override { return open(Json::object()); }
  bool start_array(std::size_t) override { return open(Json::array()); }
  bool key(std::string& text) override {
    member_ = &(*open_.back())[text];
    return true;
  }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception&) override {
    return false;
  }

  Json take() { return std::move(root_); }

 private:
  Json& place() {
    if (open_.empty()) return root_;
    return open_.back()->isObject() ? *member_ : open_.back()->items().emplace_back();
  }
  bool put(Json value) {
    place() = std::move(value);
    return true;
  }
  bool open(Json value) {
    Json& here = place();
    here = std::move(value);
    open_.push_back(&here);
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  Json root_;
  std::vector<Json*> open_;  ///< only the last one grows, so none of them moves
  Json* member_ = nullptr;   ///< of the last one, if that is an object
};

std::string scalarText(const nlohmann::json& value) {
  return value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

class JsonWriter {
 public:
  explicit JsonWriter(bool isIndented) : isIndented_(isIndented) {}

  void write(const Json& json) {
    if (json.isArray())
      writeList(json.items(), '[', ']', [&](const Json& item) { write(item); });
    else if (json.isObject())
      writeList(json.members(), '{', '}', [&](const Json::Member& member) {
        out_ += scalarText(member.key) + (isIndented_ ? ": " : ":");
        write(member.value);
      });
    else
      out_ += textOf(json);
  }

  std::string take() { return std::move(out_); }

 private:
  static std::string textOf(const Json& json) {
    if (const std::string* text = json.text()) return scalarText(*text);
    if (const bool* flag = json.flag()) return *flag ? "true" : "false";
    return json.isNumber() ? json.numberText() : "null";
  }

  template <class List, class Write>
  void writeList(const List& list, char first, char last, const Write& writeEntry) {
    out_ += first;
    ++level_;
    bool isFirst = true;
    for (const auto& entry : list) {
      if (!isFirst) out_ += ',';
      isFirst = false;
      newLine();
      writeEntry(entry);
    }
    --level_;
    if (!isFirst) newLine();
    out_ += last;
  }

  void newLine() {
    if (isIndented_) out_.append(1, '\n').append(2 * level_, ' ');
  }

  bool isIndented_;
  std::size_t level_ = 0;
  std::string out_;
};

}  // namespace

Json::Json() = default;
// Copied first and then moved: when the copy constructor of a variant throws, libstdc++ destroys
// what it has not made.
Json::Json(const Json& other) {
  std::visit([&](const auto& value) { value_ = std::decay_t<decltype(value)>(value); },
             other.value_);
}
Json::Json(Json&& other) noexcept = default;
Json& Json::operator=(const Json& other) { return *this = Json(other); }
Json& Json::operator=(Json&& other) noexcept = default;
Json::~Json() = default;
Json::Json(const char* text) : value_(std::string(text)) {}
Json::Json(std::string text) : value_(std::move(text)) {}

Json Json::array() {
  Json out;
  out.value_ = Items();
  return out;
}

Json Json::object() {
  Json out;
  out.value_ = Members();
  return out;
}

std::optional<double> Json::number() const {
  if (const auto* x = std::get_if<double>(&value_)) return *x;
  if (const auto* x = std::get_if<std::int64_t>(&value_)) return static_cast<double>(*x);
  if (const auto* x = std::get_if<std::uint64_t>(&value_)) return static_cast<double>(*x);
  return {};
}

std::optional<std::uint64_t> Json::wholeNumber() const {
  if (const auto* x = std::get_if<std::uint64_t>(&value_)) return *x;
  return {};
}

std::string Json::numberText() const {
  if (const auto* x = std::get_if<std::int64_t>(&value_)) return std::to_string(*x);
  if (const auto* x = std::get_if<std::uint64_t>(&value_)) return std::to_string(*x);
  return scalarText(*number());
}

const Json::Items& Json::items() const {
  static const Items kNoItems;
  const auto* items = std::get_if<Items>(&value_);
  return items ? *items : kNoItems;
}

Json::Items& Json::items() {
  if (!isArray()) value_ = Items();
  return std::get<Items>(value_);
}

const Json::Members& Json::members() const {
  static const Members kNoMembers;
  const auto* members = std::get_if<Members>(&value_);
  return members ? *members : kNoMembers;
}

const Json* Json::find(std::string_view key) const {
  for (const Member& member : members())
    if (member.key == key) return &member.value;
  return nullptr;
}

Json* Json::find(std::string_view key) {
  return const_cast<Json*>(static_cast<const Json&>(*this).find(key));
}

Json& Json::operator[](std::string_view key) {
  if (Json* const found = find(key)) return *found;
  if (!isObject()) value_ = Members();
  return std::get<Members>(value_).emplace_back(Member{std::string(key), {}}).value;
}

void Json::erase(std::string_view key) {
  auto* const members = std::get_if<Members>(&value_);
  if (!members) return;
  const auto isIt = [&](const Member& member) { return member.key == key; };
  members->erase(std::remove_if(members->begin(), members->end(), isIt), members->end());
}

std::string Json::dump(bool isIndented) const {
  JsonWriter writer(isIndented);
  writer.write(*this);
  return writer.take();
}

std::optional<Json> parsedJson(std::string_view text) {
  JsonBuilder builder;
  if (!nlohmann::json::sax_parse(text, &builder)) return {};
  return builder.take();
}

}  // namespace abflat::gltf
