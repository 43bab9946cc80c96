# Installs the libraries that are built, their headers, and what find_package and pkg-config read.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS ${ABFLAT_INSTALLED} EXPORT abflat
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
set(MISSING)
if(NOT ABFLAT_DRAWING)
  list(APPEND MISSING PATTERN draw.h EXCLUDE)
endif()
if(NOT ABFLAT_GLTF)
  list(APPEND MISSING PATTERN gltf.h EXCLUDE PATTERN gltf_look.h EXCLUDE PATTERN appearance.h EXCLUDE)
endif()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/core/include/abflat
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} ${MISSING})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/licenses/abflat)

set(CONFIG_FOLDER ${CMAKE_INSTALL_LIBDIR}/cmake/abflat)
install(EXPORT abflat NAMESPACE abflat:: FILE abflat-targets.cmake DESTINATION ${CONFIG_FOLDER})
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/abflat-config.cmake @ONLY CONTENT
[[include(CMakeFindDependencyMacro)
if(@ABFLAT_THREADS@)
  find_dependency(Threads)
endif()
include(${CMAKE_CURRENT_LIST_DIR}/abflat-targets.cmake)
foreach(component IN LISTS abflat_FIND_COMPONENTS)
  if(TARGET abflat::${component})
    set(abflat_${component}_FOUND TRUE)
  elseif(abflat_FIND_REQUIRED_${component})
    set(abflat_FOUND FALSE)
    set(abflat_NOT_FOUND_MESSAGE "abflat was built without ${component}.")
  endif()
endforeach()
]])
write_basic_package_version_file(${PROJECT_BINARY_DIR}/abflat-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/abflat-config.cmake ${PROJECT_BINARY_DIR}/abflat-config-version.cmake
  DESTINATION ${CONFIG_FOLDER})

set(PRIVATE_LIBS)
if(ABFLAT_THREADS)
  set(PRIVATE_LIBS "${CMAKE_THREAD_LIBS_INIT}")
endif()
file(RELATIVE_PATH TO_PREFIX /p/${CMAKE_INSTALL_LIBDIR}/pkgconfig /p)  # so that the folder can move
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/abflat.pc @ONLY CONTENT
[[prefix=${pcfiledir}/@TO_PREFIX@
Name: abflat
Description: @PROJECT_DESCRIPTION@
URL: @PROJECT_HOMEPAGE_URL@
Version: @PROJECT_VERSION@
Cflags: -I${prefix}/@CMAKE_INSTALL_INCLUDEDIR@
Libs: -L${prefix}/@CMAKE_INSTALL_LIBDIR@ -labflat
Libs.private: @PRIVATE_LIBS@ -lstdc++ -lm
]])
install(FILES ${PROJECT_BINARY_DIR}/abflat.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
