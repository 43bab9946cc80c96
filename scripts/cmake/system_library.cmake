# abflat_system_library(NAME HEADER LIBRARY PACKAGE)
#
# Finds HEADER and LIBRARY on the system and makes them the target abflat_NAME. For native builds: a
# cross compiler has libraries of its own.
function(abflat_system_library NAME HEADER LIBRARY PACKAGE)
  find_path(ABFLAT_${NAME}_INCLUDE ${HEADER} PATHS /opt/homebrew/include)
  find_library(ABFLAT_${NAME}_LIBRARY ${LIBRARY} PATHS /opt/homebrew/lib)
  if(NOT ABFLAT_${NAME}_INCLUDE OR NOT ABFLAT_${NAME}_LIBRARY)
    message(FATAL_ERROR "Cannot find ${HEADER} and the library ${LIBRARY}. Install them "
      "(Debian/Ubuntu: apt-get install ${PACKAGE}), or pass -DABFLAT_${NAME}_INCLUDE=<folder of ${HEADER}> "
      "and -DABFLAT_${NAME}_LIBRARY=<file of the library>.")
  endif()
  add_library(abflat_${NAME} INTERFACE)
  target_link_libraries(abflat_${NAME} INTERFACE ${ABFLAT_${NAME}_LIBRARY})
  # The compiler looks into /usr/include anyway, and in the right order.
  if(NOT ABFLAT_${NAME}_INCLUDE STREQUAL "/usr/include")
    target_include_directories(abflat_${NAME} SYSTEM INTERFACE ${ABFLAT_${NAME}_INCLUDE})
  endif()
endfunction()
