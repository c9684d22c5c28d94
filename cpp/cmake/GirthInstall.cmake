# `cmake --install`: the command (component `command`), and the libraries, their headers and the
# package that find_package(girth) finds (component `development`). Releases are made of the same.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package "${CMAKE_INSTALL_LIBDIR}/cmake/girth")
install(TARGETS girth_core girth_io girth_study EXPORT girthTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
install(DIRECTORY cpp/include/girth DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
install(FILES "${PROJECT_BINARY_DIR}/include/girth/version_numbers.h"
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/girth COMPONENT development)
install(EXPORT girthTargets NAMESPACE girth:: DESTINATION ${package} COMPONENT development)
configure_package_config_file(cpp/cmake/girthConfig.cmake.in girthConfig.cmake
                              INSTALL_DESTINATION ${package})
write_basic_package_version_file(girthConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/girthConfig.cmake"
              "${CMAKE_CURRENT_BINARY_DIR}/girthConfigVersion.cmake"
        DESTINATION ${package} COMPONENT development)

# The licence and the change log, in both components: each of them is a Debian package.
set(girthDocuments "${CMAKE_INSTALL_DATAROOTDIR}/doc")
install(DIRECTORY cpp/examples DESTINATION ${girthDocuments}/libgirth-dev COMPONENT development)
set(girthComponents "development libgirth-dev")
if(GIRTH_BUILD_COMMAND)
  list(APPEND girthComponents "command girth")
endif()
foreach(entry IN LISTS girthComponents)
  separate_arguments(entry)
  list(GET entry 0 component)
  list(GET entry 1 name)
  install(FILES LICENSE RENAME copyright DESTINATION ${girthDocuments}/${name}
          COMPONENT ${component})
  install(FILES CHANGELOG.md DESTINATION ${girthDocuments}/${name} COMPONENT ${component})
endforeach()

if(PROJECT_IS_TOP_LEVEL)
  include(GirthRelease)
endif()
