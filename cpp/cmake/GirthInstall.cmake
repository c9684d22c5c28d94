# `cmake --install`: headers, libraries, the command, and the package that find_package(girth) finds.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package "${CMAKE_INSTALL_LIBDIR}/cmake/girth")
install(TARGETS girth_core girth_io girth_study EXPORT girthTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY cpp/include/girth DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(FILES "${PROJECT_BINARY_DIR}/include/girth/version_numbers.h"
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/girth)
install(EXPORT girthTargets NAMESPACE girth:: DESTINATION ${package})
configure_package_config_file(cpp/cmake/girthConfig.cmake.in girthConfig.cmake
                              INSTALL_DESTINATION ${package})
write_basic_package_version_file(girthConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/girthConfig.cmake"
              "${CMAKE_CURRENT_BINARY_DIR}/girthConfigVersion.cmake" DESTINATION ${package})
