// Digits to doubles. Nearly all numbers of files have at most 19 digits and a small power of ten,
// which two doubles resolve. The rest need a table of powers: natively fast_float's, in a browser
// the one that JavaScript has already.

#include <cmath>
#include <cstdint>
#include <limits>

#include "base/number_text.h"

#ifdef __EMSCRIPTEN__
#include <emscripten/em_js.h>
#include <emscripten/emscripten.h>

// clang-format off
EM_JS(double, abflatParseNumber, (const char* begin, const char* end), {
  let text = String();
  const heap = HEAPU8;
  for (let i = begin >>> 0; i < end >>> 0; ++i) text += String.fromCharCode(heap[i]);
  return Number(text);
});
// clang-format on
#else
#include <fast_float/fast_float.h>
#endif

namespace abflat {
namespace {

constexpr int kMostDigits = 19;  // that 64 bits hold whatever they are
constexpr double kPowers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                              1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                              1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
constexpr std::uint64_t kMostExact = std::uint64_t{1} << 53;
constexpr int kMostPower = 22;  // larger powers of ten are not doubles

bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// A number without its sign: digits * 10^power, unless it has more digits than that.
struct Scanned {
  const char* end = nullptr;
  std::uint64_t digits = 0;
  int power = 0;
  int count = 0;  ///< of digits, from the first that is not zero
  bool hasDigits = false;

  bool isShort() const { return count <= kMostDigits && std::abs(power) <= kMostPower; }
};

void takeDigits(Scanned& s, const char* end) {
  const char* const begin = s.end;
  for (; s.end < end && isDigit(*s.end); ++s.end) {
    if (s.count > 0 || *s.end != '0') ++s.count;
    if (s.count <= kMostDigits) s.digits = 10 * s.digits + static_cast<std::uint64_t>(*s.end - '0');
  }
  s.hasDigits = s.hasDigits || s.end > begin;
}

/// An exponent that is not complete is none.
void takeExponent(Scanned& s, const char* end) {
  if (s.end == end || (*s.end != 'e' && *s.end != 'E')) return;
  const char* at = s.end + 1;
  const bool isNegative = at < end && *at == '-';
  if (at < end && (*at == '-' || *at == '+')) ++at;
  if (at == end || !isDigit(*at)) return;
  constexpr int kHuge = 100000;
  int exponent = 0;
  for (; at < end && isDigit(*at); ++at)
    if (exponent < kHuge) exponent = 10 * exponent + (*at - '0');
  s.power += isNegative ? -exponent : exponent;
  s.end = at;
}

Scanned scanUnsigned(const char* begin, const char* end) {
  Scanned out;
  out.end = begin;
  takeDigits(out, end);
  if (out.end < end && *out.end == '.') {
    const char* const point = out.end++;
    takeDigits(out, end);
    out.power = static_cast<int>(point + 1 - out.end);
  }
  if (out.hasDigits) takeExponent(out, end);
  return out;
}

/// a * b as a sum of two doubles (Dekker 1971).
struct ExactProduct {
  double high, low;

  ExactProduct(double a, double b) : high(a * b) {
    constexpr double kSplit = 134217729;  // 2^27 + 1
    const auto upper = [](double x) { return kSplit * x - (kSplit * x - x); };
    const double a1 = upper(a), a2 = a - a1, b1 = upper(b), b2 = b - b1;
    low = a2 * b2 - (high - a1 * b1 - a2 * b1 - a1 * b2);
  }
};

/// Rounds digits * 10^power correctly, unless it lies so close to the middle of two doubles that
/// more than two doubles are needed to tell.
bool roundShort(const Scanned& s, double& value) {
  const double power = kPowers[std::abs(s.power)];
  if (s.digits <= kMostExact) {
    const auto digits = static_cast<double>(s.digits);
    value = s.power < 0 ? digits / power : digits * power;
    return true;
  }
  // Within 2^11 of the digits, which may be beyond 2^63.
  const auto high = static_cast<double>(s.digits >> 11 << 11);
  const auto low = static_cast<double>(s.digits & 2047);
  double first, rest, error;
  if (s.power < 0) {
    first = high / power;
    const ExactProduct back(first, power);
    rest = (high - back.high - back.low + low) / power;
    error = std::abs(rest);
  } else {
    const ExactProduct product(high, power);
    const double small = low * power;
    first = product.high;
    rest = product.low + small;
    error = std::abs(product.low) + small;
  }
  constexpr double kRounding = 0x1p-50;
  value = first + (rest - kRounding * error);
  return value == first + (rest + kRounding * error);
}

double roundLong(const char* begin, const char* end) {
#ifdef __EMSCRIPTEN__
  return abflatParseNumber(begin, end);
#else
  double out = 0;
  fast_float::from_chars(begin, end, out);  // beyond the range of doubles 0 or infinity
  return out;
#endif
}

/// The end of `word`, whose letters may be of either case, or nullptr.
const char* skipWord(const char* at, const char* end, const char* word) {
  for (; *word != '\0'; ++word, ++at)
    if (at == end || (*at | 0x20) != *word) return nullptr;
  return at;
}

/// "nan(ind)" is how some programs write it.
const char* skipPayload(const char* at, const char* end) {
  if (at == end || *at != '(') return at;
  for (const char* c = at + 1; c < end; ++c) {
    if (*c == ')') return c + 1;
    const bool isPart = isDigit(*c) || *c == '_' || ((*c | 0x20) >= 'a' && (*c | 0x20) <= 'z');
    if (!isPart) break;
  }
  return at;
}

const char* scanSpecial(const char* begin, const char* end, double& value) {
  if (const char* const nan = skipWord(begin, end, "nan")) {
    value = std::numeric_limits<double>::quiet_NaN();
    return skipPayload(nan, end);
  }
  const char* const inf = skipWord(begin, end, "inf");
  if (inf == nullptr) return nullptr;
  value = std::numeric_limits<double>::infinity();
  const char* const infinity = skipWord(inf, end, "inity");
  return infinity ? infinity : inf;
}

}  // namespace

const char* scanDouble(const char* begin, const char* end, double& value) {
  const bool isNegative = begin < end && *begin == '-';
  const char* const first = isNegative ? begin + 1 : begin;
  const Scanned number = scanUnsigned(first, end);
  const char* out = number.end;
  if (!number.hasDigits)
    out = scanSpecial(first, end, value);
  else if (!number.isShort() || !roundShort(number, value))
    value = roundLong(first, number.end);
  if (out && isNegative) value = -value;
  return out;
}

}  // namespace abflat
