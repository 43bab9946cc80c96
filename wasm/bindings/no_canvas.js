// The runtime of threads can hand calls for canvases to the main thread. Nothing here has a canvas,
// so what would serve them is left out.
mergeInto(LibraryManager.library, {
  emscripten_set_canvas_element_size__deps: [],
  // biome-ignore lint/complexity/useArrowFunction: Emscripten drops arrow functions in silence
  emscripten_set_canvas_element_size: function () {
    return -1;
  },
  emscripten_webgl_create_context__deps: [],
  // biome-ignore lint/complexity/useArrowFunction: Emscripten drops arrow functions in silence
  emscripten_webgl_create_context: function () {
    return 0;
  },
});
