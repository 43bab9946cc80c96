/* Unwraps a cube, prints where its corners lie in the atlas, and packs that with more padding. */
#include <stdio.h>
#include <string.h>

#include "abflat/abflat.h"

static const float corners[8][4] = {/* x, y, z, and something else of each vertex */
                                    {0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}, {1, 1, 0, 1},
                                    {0, 0, 1, 1}, {1, 0, 1, 1}, {0, 1, 1, 1}, {1, 1, 1, 1}};
static const uint32_t faces[12][3] = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6},
                                      {0, 1, 5}, {0, 5, 4}, {2, 6, 7}, {2, 7, 3},
                                      {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};

static int progress(const char* stage, double share, void* user) {
  (void)stage;
  (void)share;
  ++*(int*)user;
  return 1; /* 0 would cancel */
}

/* Packs the charts of a result once more, as any layout can be. */
static int pack_again(const abflat_result* unwrapped, const abflat_options* options) {
  float at[36][4]; /* room for all corners of the faces */
  abflat_mesh mesh = {.positions = at, .positions_are_floats = 1, .position_stride = sizeof at[0]};
  const uint32_t* vertices = abflat_vertices(unwrapped, &mesh.vertex_count);
  for (size_t i = 0; i < mesh.vertex_count; ++i) memcpy(at[i], corners[vertices[i]], sizeof at[i]);
  mesh.triangles = abflat_triangles(unwrapped, &mesh.triangle_count);
  mesh.texcoords = abflat_uv(unwrapped, NULL);
  abflat_result* packed = NULL;
  int status = abflat_pack(&mesh, options, NULL, NULL, &packed);
  if (status == 0) printf("packed again: %s\n", abflat_is_valid(packed) ? "valid" : "not valid");
  abflat_free_result(packed);
  return status;
}

int main(void) {
  abflat_mesh mesh = {.positions = corners,
                      .positions_are_floats = 1,
                      .position_stride = sizeof corners[0],
                      .vertex_count = 8,
                      .triangles = faces,
                      .triangle_count = 12};
  abflat_options* options = abflat_new_options();
  abflat_result* result = NULL;
  int calls = 0;
  if (options == NULL) return 1;
  if (abflat_set_option(options, "padding", "8") != 0) {
    fprintf(stderr, "%s\n", abflat_option_message(options));
    return 1;
  }
  int status = abflat_unwrap(&mesh, options, progress, &calls, &result);
  if (status != 0) {
    fprintf(stderr, "%s: %s\n", abflat_status_name(status),
            result ? abflat_message(result) : "no memory");
  } else {
    size_t count = 0;
    const double* uv = abflat_uv(result, &count);
    const uint32_t* vertices = abflat_vertices(result, NULL);
    printf("abflat %s: %s\n", abflat_version(), abflat_is_valid(result) ? "valid" : "not valid");
    for (size_t i = 0; i < count; ++i)
      printf("corner %u: %.3f %.3f\n", (unsigned)vertices[i], uv[2 * i], uv[2 * i + 1]);
    status = abflat_set_option(options, "padding", "16");
    if (status == 0) status = pack_again(result, options);
  }
  abflat_free_result(result);
  abflat_free_options(options);
  return status != 0 || calls == 0;
}
