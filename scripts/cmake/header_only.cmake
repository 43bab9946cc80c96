# abflat_header_only(NAME ENTRY PACKAGE [PATH_SUFFIXES ...])
#
# Finds the header or folder ENTRY on the system and makes it the target abflat_NAME. Only that
# entry is linked into the build folder: adding all of /usr/include would hide the C library of a
# cross compiler such as emcc.
function(abflat_header_only NAME ENTRY PACKAGE)
  cmake_parse_arguments(ARG "" "" "PATH_SUFFIXES" ${ARGN})
  find_path(ABFLAT_${NAME}_ROOT ${ENTRY} PATH_SUFFIXES ${ARG_PATH_SUFFIXES}
    PATHS /usr/include /usr/local/include /opt/homebrew/include NO_CMAKE_FIND_ROOT_PATH)
  if(NOT ABFLAT_${NAME}_ROOT)
    message(FATAL_ERROR "Cannot find ${ENTRY}. Install it (Debian/Ubuntu: apt-get install ${PACKAGE}), "
      "or pass -DABFLAT_${NAME}_ROOT=<folder that contains it>.")
  endif()
  set(FOLDER ${CMAKE_BINARY_DIR}/third_party/${NAME})
  file(MAKE_DIRECTORY ${FOLDER})
  file(CREATE_LINK ${ABFLAT_${NAME}_ROOT}/${ENTRY} ${FOLDER}/${ENTRY} COPY_ON_ERROR SYMBOLIC)
  add_library(abflat_${NAME} INTERFACE)
  target_include_directories(abflat_${NAME} SYSTEM INTERFACE ${FOLDER})
endfunction()
