#pragma once

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

/// A value, or the status that says why there is none (then `value` is default constructed).
template <class T>
struct [[nodiscard]] Result {
  Status status;
  T value{};

  Result() = default;
  Result(T v) : value(std::move(v)) {}
  Result(Status s) : status(std::move(s)) {}
  bool ok() const { return status.ok(); }
};

}  // namespace abflat
