// Sanitizers make a program about fifteen times as slow.
#pragma once

namespace abflat::test {

#ifndef __has_feature
#define __has_feature(feature) 0
#endif
#if defined(__SANITIZE_ADDRESS__) || __has_feature(address_sanitizer)
constexpr bool kIsInstrumented = true;
#else
constexpr bool kIsInstrumented = false;
#endif

/// How many cases, or of what size: fewer for instrumented builds if they take long, since the
/// plain build runs them all.
template <class T>
constexpr T cases(T usual, T instrumented) {
  return kIsInstrumented ? instrumented : usual;
}

}  // namespace abflat::test
