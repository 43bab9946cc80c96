#include "base/shortest_digits.h"

// Emscripten's library has no std::to_chars for doubles, but a JavaScript function gives the same
// digits.
#ifdef __EMSCRIPTEN__
#include <emscripten/em_js.h>
#include <emscripten/emscripten.h>

// clang-format off
EM_JS(int, abflatWriteShortest, (char* out, double value), {
  const text = value.toExponential();
  const heap = HEAPU8;
  for (let i = 0; i < text.length; ++i) heap[(out >>> 0) + i] = text.charCodeAt(i);
  return text.length;
});
// clang-format on
#else
#include <charconv>
#endif

namespace abflat {

char* writeShortest(char* out, double value) {
#ifdef __EMSCRIPTEN__
  return out + abflatWriteShortest(out, value);
#else
  return std::to_chars(out, out + kMostShortestChars, value, std::chars_format::scientific).ptr;
#endif
}

}  // namespace abflat
