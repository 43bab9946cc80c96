#pragma once

// Catch2 v3 (a library) or v2 (a single header), whichever the system has. Tests include only this.
// An exception of v2 ends its test wherever it is thrown, without a handler in each assertion.
#define CATCH_CONFIG_FAST_COMPILE
#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
#else
#include <catch2/catch.hpp>
#endif
