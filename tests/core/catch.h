#pragma once

// Catch2 v3 (a library) or v2 (a single header), whichever the system has. Tests include only this.
#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
#else
#include <catch2/catch.hpp>
#endif
