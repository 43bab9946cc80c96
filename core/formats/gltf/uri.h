#pragma once

#include <string>
#include <string_view>

#include "abflat/status.h"

namespace abflat::gltf {

/// "data:...": the bytes are in the URI itself.
bool isDataUri(std::string_view uri);

/// "https://...", or any other scheme: nothing beside the file.
bool hasScheme(std::string_view uri);

/// Bytes of a data URI. Errors: ParseError, worded to follow the name of the place.
Result<std::string> dataOf(std::string_view uri);

/// "application/octet-stream" with these bytes.
std::string dataUri(std::string_view bytes);

/// A relative URI as path: without %XX.
std::string pathOfUri(std::string_view uri);

/// The other way.
std::string uriOfPath(std::string_view path);

}  // namespace abflat::gltf
