#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "abflat/status.h"
#include "gltf/json.h"

namespace abflat::gltf {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

/// Keeps the first complaint about a file.
class Complaints {
 public:
  explicit Complaints(std::string fileName) : fileName_(std::move(fileName)) {}

  void add(const std::string& sentence) {
    fail({StatusCode::ParseError, fileName_ + ": " + sentence});
  }
  void fail(Status status) {
    if (status_.ok()) status_ = std::move(status);
  }
  bool none() const { return status_.ok(); }
  const Status& status() const { return status_; }

 private:
  std::string fileName_;
  Status status_;
};

/// A value of the document, present or not, and where it is: "meshes[2].primitives[0]". Anything
/// that violates the specification causes a complaint and is read as if it were absent.
class Field {
 public:
  Field(const Json* value, std::string place, Complaints& complaints)
      : value_(value), place_(std::move(place)), complaints_(&complaints) {}

  bool isPresent() const { return value_ != nullptr; }
  const std::string& place() const { return place_; }
  void complain(const std::string& sentence) const { complaints_->add(place_ + " " + sentence); }

  /// Member of an object.
  Field operator[](const std::string& key) const;
  std::vector<std::pair<std::string, Field>> members() const;
  /// Elements of an array.
  std::vector<Field> items() const;

  /// A whole number, 0 or more. Absent: `fallback`.
  std::size_t count(std::size_t fallback) const;
  /// The same for a required value.
  std::size_t count() const;
  /// Index into a list of `size` entries that is called `list`. Absent: kNone.
  std::size_t index(std::size_t size, const char* list) const;
  /// The same for a required value.
  std::size_t requiredIndex(std::size_t size, const char* list) const;
  double number(double fallback) const;  ///< a finite number; absent: `fallback`
  bool flag() const;                     ///< absent: false
  std::string text() const;              ///< absent: empty
  /// As many finite numbers as `out` has; `out` is unchanged if there are none.
  void numbers(double* out, std::size_t size) const;

 private:
  const Json* value_;
  std::string place_;
  Complaints* complaints_;
};

}  // namespace abflat::gltf
