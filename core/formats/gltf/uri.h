#pragma once

#include <string>
#include <string_view>

#include "abflat/status.h"

namespace abflat::gltf {

/// "data:...": the URI itself holds the bytes.
bool isDataUri(std::string_view uri);

/// "https://...", or any other scheme, so not a file beside this one.
bool hasScheme(std::string_view uri);

/// Bytes of a data URI. Errors: ParseError, worded to follow the name of the place.
Result<std::string> dataOf(std::string_view uri);

/// Encodes the bytes as "application/octet-stream".
std::string dataUri(std::string_view bytes);

/// A relative URI as a path: %XX is decoded.
std::string pathOfUri(std::string_view uri);

/// The inverse.
std::string uriOfPath(std::string_view path);

}  // namespace abflat::gltf
