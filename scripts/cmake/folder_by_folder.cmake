# Has the sources of a target in one folder compiled as one: what they include is read once, which
# takes more than half of the time away. So a name without linkage may be used once in a folder.
# Unless IN_ALL_BUILDS is given, not in the native build, where single sources of the core are
# compiled again and again: it sees to it that each includes what it needs.
function(abflat_folder_by_folder target)
  if(NOT (ABFLAT_SANITIZE OR ABFLAT_COVERAGE OR EMSCRIPTEN OR "IN_ALL_BUILDS" IN_LIST ARGN))
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    if(source MATCHES "\\.cpp$")
      get_filename_component(folder ${source} ABSOLUTE)
      get_filename_component(folder ${folder} DIRECTORY)
      file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${folder})
      string(REPLACE "/" "_" folder ${folder})
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP "${folder}")
    endif()
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()
