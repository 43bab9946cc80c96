// Makes one system call of a program fail, or interrupts the program there. Loaded with LD_PRELOAD.
//   ABFLAT_FAULT_LOG   file that gets the name of each call, a line each
//   ABFLAT_FAULT_AT    which call, counted from 0 over all that are watched
//   ABFLAT_FAULT       what happens there: an errno by its number, "short" (of a read or write only
//                      one byte), "always N" (this call and all of its kind fail with errno N), or
//                      "signal N" (before the call)
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/syscall.h>
#include <sys/types.h>
#include <unistd.h>

enum { kNone = 0, kShort = -1 };

static int log_file = -1, next_call = 0, at = -1;
static const char *fault = "", *always_kind = NULL;

__attribute__((constructor)) static void begin(void) {
  const char *path = getenv("ABFLAT_FAULT_LOG"), *number = getenv("ABFLAT_FAULT_AT");
  if (path) log_file = (int)syscall(SYS_openat, AT_FDCWD, path, O_WRONLY | O_APPEND | O_CREAT, 0666);
  if (number) at = atoi(number);
  if (getenv("ABFLAT_FAULT")) fault = getenv("ABFLAT_FAULT");
}

/// The errno that the call is to fail with, kShort, or kNone.
static int fault_of(const char *kind) {
  if (log_file >= 0) {
    syscall(SYS_write, log_file, kind, strlen(kind));
    syscall(SYS_write, log_file, "\n", 1);
  }
  if (always_kind && strcmp(always_kind, kind) == 0) return atoi(fault + strlen("always "));
  if (next_call++ != at) return kNone;
  if (strcmp(fault, "short") == 0) return kShort;
  if (strncmp(fault, "signal ", 7) == 0) {
    kill(getpid(), atoi(fault + 7));
    return kNone;
  }
  if (strncmp(fault, "always ", 7) == 0) {
    always_kind = kind;
    return atoi(fault + 7);
  }
  return atoi(fault);
}

#define REAL(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

#define WATCH(name, parameters, arguments)                 \
  int name parameters {                                    \
    const int error = fault_of(#name);                     \
    if (error > 0) return errno = error, -1;               \
    return REAL(name) arguments;                           \
  }

WATCH(fsync, (int file), (file))
WATCH(fchmod, (int file, mode_t mode), (file, mode))
WATCH(fchown, (int file, uid_t user, gid_t group), (file, user, group))
WATCH(rename, (const char *from, const char *to), (from, to))
WATCH(link, (const char *from, const char *to), (from, to))
WATCH(unlink, (const char *path), (path))

/// A file is closed even where that fails.
int close(int file) {
  const int error = fault_of("close");
  const int result = REAL(close)(file);
  return error > 0 ? (errno = error, -1) : result;
}

ssize_t read(int file, void *bytes, size_t size) {
  const int error = fault_of("read");
  if (error > 0) return errno = error, -1;
  return REAL(read)(file, bytes, error == kShort && size > 0 ? 1 : size);
}

ssize_t write(int file, const void *bytes, size_t size) {
  const int error = fault_of("write");
  if (error > 0) return errno = error, -1;
  return REAL(write)(file, bytes, error == kShort && size > 0 ? 1 : size);
}

#define WATCH_OPEN(name)                                       \
  int name(const char *path, int flags, ...) {                 \
    va_list rest;                                              \
    va_start(rest, flags);                                     \
    const mode_t mode = flags & O_CREAT ? va_arg(rest, mode_t) : 0; \
    va_end(rest);                                              \
    const int error = fault_of("open");                        \
    if (error > 0) return errno = error, -1;                   \
    return REAL(name)(path, flags, mode);                      \
  }

WATCH_OPEN(open)
WATCH_OPEN(open64)
