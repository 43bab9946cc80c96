#include "callbacks.h"

#include <emscripten/em_asm.h>
#include <emscripten/em_js.h>
#include <emscripten/emscripten.h>

#include <cstdlib>

// clang-format off
EM_JS(int, abflatReportProgress, (const char* stage, int newtonStep, double residual, double fraction), {
  return Module["onProgress"](stage, newtonStep, residual, fraction);
});

// clang-format on

namespace abflat::bindings {

bool tellProgress(const Progress& progress) {
  return abflatReportProgress(nameOf(progress), progress.newtonStep, progress.constraintResidual,
                              progress.fraction) != 0;
}

void outOfMemory() {
  MAIN_THREAD_EM_ASM({ Module["onOutOfMemory"](); });
  std::abort();
}

}  // namespace abflat::bindings
