#include "callbacks.h"

#include <emscripten/em_asm.h>
#include <emscripten/em_js.h>
#include <emscripten/emscripten.h>

#include <cstdlib>

// clang-format off
EM_JS(void, abflatReportProgress, (const char* stage, int newtonStep, double residual, double fraction), {
  Module["onProgress"](stage, newtonStep, residual, fraction);
});

// clang-format on

namespace abflat::bindings {

bool tellProgress(const Progress& progress) {
  abflatReportProgress(nameOf(progress), progress.newtonStep, progress.constraintResidual,
                       progress.fraction);
  return true;
}

void outOfMemory() {
  MAIN_THREAD_EM_ASM({ Module["onOutOfMemory"](); });
  std::abort();
}

}  // namespace abflat::bindings
