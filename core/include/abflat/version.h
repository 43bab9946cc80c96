#pragma once

/// The version of the library, as in semantic versioning. The build reads it from here.
#define ABFLAT_VERSION "0.1.0"
