#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "abflat/atlas_size.h"
#include "abflat/generated/mesh_summary.h"
#include "abflat/status.h"
#include "base/json_writer.h"

namespace abflat {

/// Counts of an input that could not be read are unknown, but reports still have their keys.
class NullWriter {
 public:
  explicit NullWriter(JsonWriter& json) : json_(json) {}
  template <class T>
  void field(const char* name, const T&) {
    json_.null(name);
  }

 private:
  JsonWriter& json_;
};

/// Writes as JSON what visitFields() visits. Three things are written by hand: options, where words
/// stand for numbers; the input, of which reports have only a part; and a Status.
class FieldWriter {
 public:
  template <class T>
  void field(const char* name, const T& value) {
    if constexpr (std::is_enum_v<T>) {
      json_.field(name, nameOf(value));
    } else if constexpr (kIsPlain<T>) {
      json_.field(name, value);
    } else {
      json_.object(name);
      visitFields(value, *this);
      json_.end();
    }
  }
  template <class T>
  void field(const char* name, const std::optional<T>& value) {
    if (value)
      field(name, *value);
    else
      json_.null(name);
  }
  template <class T>
  void field(const char* name, const std::vector<T>& list) {
    if constexpr (std::is_class_v<T> && !kIsPlain<T> && !kIsPair<T>) {
      json_.array(name);
      for (const T& element : list) field(nullptr, element);
      json_.end();
    } else {
      json_.field(name, list);
    }
  }

  /// The fields that follow go inside, until end().
  void begin(const char* name) { json_.object(name); }
  void end() { json_.end(); }

  template <class Values>
  void options(const char* name, const Values& options) {
    json_.object(name);
    forEachOption(options, [&](const char* key, const auto& value) { option(key, value); });
    json_.end();
  }
  /// The input part of a report.
  template <class Report>
  void inputSummary(const char* name, const Report& report) {
    json_.object(name);
    json_.field("path", report.path);
    if (isKnown(report.error.code)) {
      visitInputSummary(report.input, *this);
    } else {
      NullWriter nulls(json_);
      visitInputSummary(report.input, nulls);
    }
    json_.end();
  }
  void verdict(const char* name, const Status& status);
  /// Writes nothing if there is no error.
  void reportError(const char* name, const Status& error);

  std::string take() { return json_.take(); }

 private:
  template <class T>
  static constexpr bool kIsPlain = std::is_arithmetic_v<T> || std::is_same_v<T, std::string>;
  template <class T>
  static constexpr bool kIsPair = std::is_same_v<T, std::array<std::uint32_t, 2>>;

  template <class T>
  void option(const char* name, const T& value) {
    json_.field(name, value);
  }
  void option(const char* name, const AtlasSize& size) {
    if (size.isSquare()) return json_.field(name, size.width);
    json_.array(name);
    json_.field(nullptr, size.width);
    json_.field(nullptr, size.height);
    json_.end();
  }

  static bool isKnown(StatusCode error);

  JsonWriter json_;
};

}  // namespace abflat
