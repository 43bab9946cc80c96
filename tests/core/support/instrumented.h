// Sanitizers make a program some fifteen times as slow.
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

/// How many cases, or of what size: fewer where that takes long and the plain build has run them
/// all.
template <class T>
constexpr T cases(T usual, T instrumented) {
  return kIsInstrumented ? instrumented : usual;
}

}  // namespace abflat::test
