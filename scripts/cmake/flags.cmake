# abflat_flags: what all sources of this project are compiled with, and nothing of a project that
# uses it.
add_library(abflat_flags INTERFACE)
target_compile_features(abflat_flags INTERFACE cxx_std_17)
target_compile_definitions(abflat_flags INTERFACE ABFLAT_THREADS=$<BOOL:${ABFLAT_THREADS}>)
target_compile_definitions(abflat_flags INTERFACE ABFLAT_RESEARCH=$<BOOL:${ABFLAT_RESEARCH}>)
# No contraction: all platforms must round alike.
target_compile_options(abflat_flags INTERFACE -ffp-contract=off)
# Nothing is put in the place of a function of a shared library.
target_compile_options(abflat_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-fno-semantic-interposition>)
if(ABFLAT_IS_TOP_LEVEL)
  # Also where it is the compiler's own, since clang-tidy reads the commands of GCC.
  if(NOT CMAKE_CXX_STANDARD)
    set(CMAKE_CXX_STANDARD 17)
  endif()
  set(CMAKE_CXX_EXTENSIONS OFF)
  # Signs are left out because only clang counts them to -Wconversion.
  target_compile_options(abflat_flags INTERFACE
    -Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion)
  # The macros of Emscripten, and of Catch2 for clang, are not pedantic.
  target_compile_options(abflat_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wpedantic>)
endif()
if(ABFLAT_WERROR)
  target_compile_options(abflat_flags INTERFACE -Werror)
endif()
if(ABFLAT_THREADS)
  if(EMSCRIPTEN)
    # find_package would be content with the stubs of a build without threads.
    target_compile_options(abflat_flags INTERFACE -pthread)
    target_link_options(abflat_flags INTERFACE -pthread)
    target_compile_definitions(abflat_flags INTERFACE ABFLAT_MOST_THREADS=${ABFLAT_WASM_THREADS})
  else()
    set(THREADS_PREFER_PTHREAD_FLAG ON)
    find_package(Threads REQUIRED)
    target_link_libraries(abflat_flags INTERFACE Threads::Threads)
  endif()
endif()
if(EMSCRIPTEN)
  # Optimised when linked: what nothing calls, such as most of the libraries, is not loaded.
  target_compile_options(abflat_flags INTERFACE -fno-exceptions -fno-rtti -flto)
  target_link_options(abflat_flags INTERFACE -flto)
  # Browsers that know vectors know the other two.
  target_compile_options(abflat_flags INTERFACE -msimd128 -mnontrapping-fptoint -msign-ext)
endif()
if(ABFLAT_SANITIZE)
  set(SANITIZERS -fsanitize=address,undefined,float-cast-overflow -fno-sanitize-recover=all)
  # g++ reports false maybe-uninitialized values inside its own headers when they are instrumented.
  target_compile_options(abflat_flags INTERFACE
    -O1 -fno-omit-frame-pointer ${SANITIZERS} $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_compile_definitions(abflat_flags INTERFACE _GLIBCXX_ASSERTIONS)
  target_link_options(abflat_flags INTERFACE ${SANITIZERS})
  # At a fixed address a program starts in two thirds of the time, without 300,000 relocations.
  target_link_options(abflat_flags INTERFACE $<$<PLATFORM_ID:Linux>:-no-pie>)
endif()
if(ABFLAT_COVERAGE)
  set(COUNTED -O1 -fprofile-instr-generate -fcoverage-mapping)
  target_compile_options(abflat_flags INTERFACE ${COUNTED})
  target_link_options(abflat_flags INTERFACE ${COUNTED})
endif()
if(ABFLAT_FUZZ)
  # What -fsanitize=fuzzer-no-link means, but for comparisons: those are worth their time in readers only.
  target_compile_options(abflat_flags INTERFACE
    -fsanitize-coverage=inline-8bit-counters)
endif()
