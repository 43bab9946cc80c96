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
  if (!value_->is_object()) {
    complain("is not an object");
    return {nullptr, place, *complaints_};
  }
  const auto found = value_->find(key);
  return {found == value_->end() ? nullptr : &*found, place, *complaints_};
}

std::vector<std::pair<std::string, Field>> Field::members() const {
  std::vector<std::pair<std::string, Field>> out;
  if (!value_) return out;
  if (!value_->is_object()) {
    complain("is not an object");
    return out;
  }
  for (const auto& member : value_->items())
    out.emplace_back(member.key(),
                     Field(&member.value(), place_ + "." + member.key(), *complaints_));
  return out;
}

std::vector<Field> Field::items() const {
  std::vector<Field> out;
  if (!value_) return out;
  if (!value_->is_array()) {
    complain("is not an array");
    return out;
  }
  out.reserve(value_->size());
  for (std::size_t i = 0; i < value_->size(); ++i)
    out.emplace_back(&(*value_)[i], place_ + "[" + std::to_string(i) + "]", *complaints_);
  return out;
}

std::size_t Field::count(std::size_t fallback) const {
  if (!value_) return fallback;
  const double value = value_->is_number() ? value_->get<double>() : -1;
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

bool Field::flag() const {
  if (!value_) return false;
  if (!value_->is_boolean()) complain("must be true or false");
  return value_->is_boolean() && value_->get<bool>();
}

std::string Field::text() const {
  if (!value_) return {};
  if (value_->is_string()) return value_->get<std::string>();
  complain("is not a string");
  return {};
}

void Field::numbers(double* out, std::size_t size) const {
  if (!value_) return;
  bool isValid = value_->is_array() && value_->size() == size;
  for (std::size_t i = 0; isValid && i < size; ++i) isValid = (*value_)[i].is_number();
  if (!isValid) return complain("is not an array of " + std::to_string(size) + " numbers");
  for (std::size_t i = 0; i < size; ++i) out[i] = (*value_)[i].get<double>();
}

}  // namespace abflat::gltf
