#pragma once

#include <optional>
#include <string>
#include <utility>

#include "abflat/generated/status_code.h"

namespace abflat {

/// Outcome of a call. `message` is empty when ok; otherwise it is one sentence that names the place
/// and what to do.
struct [[nodiscard]] Status {
  StatusCode code = StatusCode::Ok;
  std::string message;

  bool ok() const { return code == StatusCode::Ok; }
};

/// A value, or the status that says why there is none.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : value_(std::move(value)) {}
  /// `status` is not ok.
  Result(Status status) : status_(std::move(status)) {}

  bool ok() const { return value_.has_value(); }
  const Status& status() const& { return status_; }
  Status status() && { return std::move(status_); }
  /// Throws std::bad_optional_access if there is none.
  const T& value() const& { return value_.value(); }
  T& value() & { return value_.value(); }
  T value() && { return std::move(value_).value(); }

 private:
  Status status_;
  std::optional<T> value_;
};

}  // namespace abflat
