# `cmake --install`: the command (component `command`), and the libraries, their headers and the
# packages that find_package(girth) and pkg-config find (component `development`), and shared libraries
# (component `libraries`). Releases are made of the same.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package "${CMAKE_INSTALL_LIBDIR}/cmake/girth")
# Installed anywhere, libraries find each other, and the command finds them.
if(APPLE)
  set(girthOrigin "@loader_path")
else()
  set(girthOrigin "$ORIGIN")
endif()
cmake_path(RELATIVE_PATH CMAKE_INSTALL_FULL_LIBDIR BASE_DIRECTORY "${CMAKE_INSTALL_FULL_BINDIR}"
           OUTPUT_VARIABLE girthFromCommand)
foreach(library IN LISTS girthLibraries)
  install(TARGETS girth_${library} EXPORT girth_${library}Targets
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT libraries
                  NAMELINK_COMPONENT development
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
  install(EXPORT girth_${library}Targets NAMESPACE girth:: DESTINATION ${package}
          COMPONENT development)
  if(BUILD_SHARED_LIBS)
    set_target_properties(girth_${library} PROPERTIES INSTALL_RPATH "${girthOrigin}")
  endif()
endforeach()
install(DIRECTORY cpp/include/girth DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development
        PATTERN io EXCLUDE PATTERN study EXCLUDE)
foreach(library IN ITEMS io study)
  if(library IN_LIST girthLibraries)
    install(DIRECTORY cpp/include/girth/${library}
            DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/girth COMPONENT development)
  endif()
endforeach()
install(FILES "${PROJECT_BINARY_DIR}/include/girth/version_numbers.h"
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/girth COMPONENT development)
configure_package_config_file(cpp/cmake/girthConfig.cmake.in girthConfig.cmake
                              INSTALL_DESTINATION ${package})
write_basic_package_version_file(girthConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/girthConfig.cmake"
              "${CMAKE_CURRENT_BINARY_DIR}/girthConfigVersion.cmake"
        DESTINATION ${package} COMPONENT development)

# girth.pc is the core, girth-io.pc and girth-study.pc the others. The libraries that static ones are to be linked with
# stand in their Libs, those of shared ones in Libs.private.
cmake_path(SET girthPcFolder NORMALIZE "/${CMAKE_INSTALL_LIBDIR}/pkgconfig")
string(REGEX REPLACE "/[^/]+" "/.." girthPcRoot "${girthPcFolder}")
# `girth_pkg_config(name library description requires needs)`
function(girth_pkg_config name library description requires needs)
  set(file "${CMAKE_CURRENT_BINARY_DIR}/${name}.pc")
  if(BUILD_SHARED_LIBS)
    set(girthPcFlags " -DGIRTH_SHARED")
    set(girthPcPrivate "${needs}")
  else()
    set(girthPcNeeds "${needs}")
  endif()
  configure_file(cpp/cmake/girth.pc.in "${file}" @ONLY)
  install(FILES "${file}" DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
endfunction()
girth_pkg_config(girth core "${PROJECT_DESCRIPTION}" "" " -pthread")
if(GIRTH_BUILD_IO)
  if(GIRTH_GLTF_CODECS)
    set(girthIoNeeds " -ldraco -lmeshoptimizer")
  endif()
  girth_pkg_config(girth-io io "Girth: reading and writing models" "girth = ${PROJECT_VERSION}"
                   "${girthIoNeeds}")
  girth_pkg_config(girth-study study "Girth: the studies of its paper"
                   "girth-io = ${PROJECT_VERSION}" "")
endif()

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
