#include "gltf/field.h"

#include <cmath>

namespace abflat::gltf {
namespace {

/// Numbers up to this are exact in every JSON reader.
constexpr double kMostCount = 9007199254740992.0;

}  // namespace

Field Field::operator[](const std::string& key) const {
  const std::string place = place_.empty() ? key : place_ + "." + key;
  if (!value_) return {nullptr, place, *complaints_};
  if (!value_->isObject()) {
    complain("is not an object");
    return {nullptr, place, *complaints_};
  }
  return {value_->find(key), place, *complaints_};
}

std::vector<std::pair<std::string, Field>> Field::members() const {
  std::vector<std::pair<std::string, Field>> out;
  if (!value_) return out;
  if (!value_->isObject()) {
    complain("is not an object");
    return out;
  }
  for (const auto& [key, value] : value_->members())
    out.emplace_back(key, Field(&value, place_ + "." + key, *complaints_));
  return out;
}

std::vector<Field> Field::items() const {
  std::vector<Field> out;
  if (!value_) return out;
  if (!value_->isArray()) {
    complain("is not an array");
    return out;
  }
  out.reserve(value_->items().size());
  for (std::size_t i = 0; i < value_->items().size(); ++i)
    out.emplace_back(&(*value_)[i], place_ + "[" + std::to_string(i) + "]", *complaints_);
  return out;
}

std::size_t Field::count(std::size_t fallback) const {
  if (!value_) return fallback;
  const double value = value_->number().value_or(-1);
  if (value >= 0 && value < kMostCount && value == std::floor(value))
    return static_cast<std::size_t>(value);
  complain("is not a non-negative integer");
  return fallback;
}

std::size_t Field::count() const {
  if (!value_) complain("is missing");
  return count(0);
}

std::size_t Field::index(std::size_t size, const char* list) const {
  const std::size_t out = count(kNone);
  if (out == kNone || out < size) return out;
  complain("is " + std::to_string(out) + ", but there are only " + std::to_string(size) + " " +
           list + " (indices start at 0)");
  return kNone;
}

std::size_t Field::requiredIndex(std::size_t size, const char* list) const {
  if (!value_) complain("is missing");
  return index(size, list);
}

double Field::number(double fallback) const {
  if (!value_) return fallback;
  if (const std::optional<double> value = value_->number()) return *value;
  complain("is not a number");
  return fallback;
}

bool Field::flag() const {
  if (!value_) return false;
  if (!value_->flag()) complain("must be true or false");
  return value_->flag() && *value_->flag();
}

std::string Field::text() const {
  if (!value_) return {};
  if (value_->text()) return *value_->text();
  complain("is not a string");
  return {};
}

void Field::numbers(double* out, std::size_t size) const {
  if (!value_) return;
  bool isValid = value_->isArray() && value_->items().size() == size;
  for (std::size_t i = 0; isValid && i < size; ++i) isValid = (*value_)[i].isNumber();
  if (!isValid) return complain("is not an array of " + std::to_string(size) + " numbers");
  for (std::size_t i = 0; i < size; ++i) out[i] = *(*value_)[i].number();
}

}  // namespace abflat::gltf
