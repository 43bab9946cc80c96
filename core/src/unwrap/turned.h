#pragma once

#include <string>

#include "abflat/unwrap.h"
#include "base/listener.h"
#include "mesh/input_mesh.h"

namespace abflat {

/// What to do about neighbours that run in opposite directions; empty if there are none.
std::string orientationNote(const RepairReport& repair, bool isOriented);

using UnwrapMesh = Result<UnwrapResult> (*)(const InputMesh&, const UnwrapOptions&,
                                            const Listener&);

/// Turns faces of a copy, if necessary, and unwraps that. The result refers to the mesh itself.
Result<UnwrapResult> unwrapTurned(const InputMesh& mesh, const UnwrapOptions& options,
                                  const Listener& listener, UnwrapMesh unwrapAsItIs);

}  // namespace abflat
