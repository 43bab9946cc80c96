#pragma once

namespace abflat::cli {

/// Large arrays come and go. If their memory went back to the system each time, its pages would be
/// cleared each time as well: a twentieth of all work on large meshes.
void keepFreedMemory();

/// Lets the heap lie in huge pages where Linux gives them to those who ask: large meshes take a
/// seventh less time. The C library asks only if told so before a program begins, so it begins
/// again, once. Users who set GLIBC_TUNABLES or load an allocator of their own are left alone.
void beginWithHugePages(char** arguments);

}  // namespace abflat::cli
