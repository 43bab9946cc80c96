/* The library for C, and for languages that call C. Everything else here is for C++. */
#ifndef ABFLAT_ABFLAT_H
#define ABFLAT_ABFLAT_H

#include <stddef.h>
#include <stdint.h>

#include "abflat/export.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct abflat_options abflat_options;
typedef struct abflat_result abflat_result;

/* Triangles in the caller's memory, which is only read, and only until the function returns.
   Nothing needs to be aligned. */
typedef struct abflat_mesh {
  const void* positions;    /* x, y, z of each vertex, finite */
  int positions_are_floats; /* 0: they are doubles */
  size_t position_stride;   /* bytes from one vertex to the next; 0: they follow each other */
  size_t vertex_count;
  const void* triangles;  /* 3 vertices each, counted from 0, counter-clockwise seen from outside */
  size_t index_size;      /* bytes of a vertex's number: 2 (unsigned), 4 or 8; 0: 4 */
  size_t triangle_stride; /* bytes from one triangle to the next; 0: they follow each other */
  size_t triangle_count;
  const void* texcoords; /* u, v of each vertex, NaN if it has none; abflat_unwrap ignores them */
  int texcoords_are_floats;
  size_t texcoord_stride;
} abflat_mesh;

/* Receives the name of the stage and a rough share from 0 to 1. Called often, from the thread that
   called abflat_unwrap, abflat_pack or abflat_verify; 0 cancels. */
typedef int (*abflat_progress)(const char* stage, double share, void* user);

ABFLAT_API const char* abflat_version(void);

/* "Ok" for 0; the codes and their names are those of docs/cpp.md, in that order. */
ABFLAT_API const char* abflat_status_name(int status);

/* With the defaults; NULL if there is no memory. */
ABFLAT_API abflat_options* abflat_new_options(void);
ABFLAT_API void abflat_free_options(abflat_options* options);

/* Sets an option of unwrap, of pack, or of both, by its name in JSON ("maxStretch") or on the
   command line ("--max-stretch") to a value as on the command line: "1.04", "auto", "true",
   "quarter", "2048x1024"; "seams" takes a list of sources, such as "auto,sharp=60". Returns a
   status; InvalidOption changes nothing. */
ABFLAT_API int abflat_set_option(abflat_options* options, const char* name, const char* value);

/* The same for a rule of abflat_verify, which may have the name of an option: "padding", "8";
   "maxStretch", "1.1"; "allowStacked", "true". */
ABFLAT_API int abflat_set_rule(abflat_options* options, const char* name, const char* value);

/* One sentence about the last call of abflat_set_option or abflat_set_rule; empty if its status
   was 0. */
ABFLAT_API const char* abflat_option_message(const abflat_options* options);

/* Cuts a mesh into charts, flattens and packs them. `options` and `progress` may be NULL. Returns a
   status. `result` receives what the functions below read, also where the status is not 0; it is
   NULL if there is no memory for it. A result that is not valid has status 0, see
   abflat_is_valid. */
ABFLAT_API int abflat_unwrap(const abflat_mesh* mesh, const abflat_options* options,
                             abflat_progress progress, void* user, abflat_result** result);

/* The same for packing the layout that the mesh has: its uv islands keep their shapes. */
ABFLAT_API int abflat_pack(const abflat_mesh* mesh, const abflat_options* options,
                           abflat_progress progress, void* user, abflat_result** result);

/* The same for saying what the layout that the mesh has does not keep to: the findings are in the
   report. Of the arrays below it has abflat_charts and abflat_faults. */
ABFLAT_API int abflat_verify(const abflat_mesh* mesh, const abflat_options* options,
                             abflat_progress progress, void* user, abflat_result** result);
ABFLAT_API void abflat_free_result(abflat_result* result);

/* One sentence that names the place and what to do; empty if the status is 0. */
ABFLAT_API const char* abflat_message(const abflat_result* result);

/* Whether no triangle is flipped and nothing overlaps, by exact arithmetic; after abflat_pack,
   whether no two islands overlap that lay apart; after abflat_verify, whether nothing was found. */
ABFLAT_API int abflat_is_valid(const abflat_result* result);

/* JSON text; its keys are those of docs/report.md. */
ABFLAT_API const char* abflat_report(const abflat_result* result);

/* Arrays of a result, which owns them. Vertices are in the order of the input; one on a seam comes
   once for each of its texcoords. `count` is the number of vertices or triangles; it may be NULL.
 */
ABFLAT_API const uint32_t* abflat_vertices(const abflat_result* result,
                                           size_t* count); /* of the input */
ABFLAT_API const double* abflat_uv(const abflat_result* result,
                                   size_t* count); /* u, v of each vertex */
/* 3 vertices each, in the order of the input. */
ABFLAT_API const uint32_t* abflat_triangles(const abflat_result* result, size_t* count);
ABFLAT_API const uint32_t* abflat_charts(const abflat_result* result,
                                         size_t* count); /* or islands, of each triangle */
/* What is wrong with each triangle in uv, after abflat_verify: a sum of 1 (overlaps), 2 (runs
   clockwise), 4 (has no area) and 8 (is not within one tile). */
ABFLAT_API const uint8_t* abflat_faults(const abflat_result* result, size_t* count);

#ifdef __cplusplus
}
#endif

#endif
