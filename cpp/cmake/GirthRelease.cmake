# `cpack` in the build tree makes what a release consists of: girth-VERSION-Linux-x86_64.tar.gz with
# everything, and where dpkg is, the Debian packages girth (the command) and libgirth-dev (the
# static libraries and their headers).
set(CPACK_PACKAGE_NAME girth)
set(CPACK_PACKAGE_VENDOR "The Girth authors")
set(CPACK_PACKAGE_CONTACT "The Girth authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_PACKAGE_FILE_NAME
    "girth-${PROJECT_VERSION}-${CMAKE_SYSTEM_NAME}-${CMAKE_SYSTEM_PROCESSOR}")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_STRIP_FILES ON)
set(CPACK_GENERATOR TGZ)
set(CPACK_COMPONENTS_ALL development)
if(GIRTH_BUILD_COMMAND)
  list(APPEND CPACK_COMPONENTS_ALL command)
endif()
if(BUILD_SHARED_LIBS)
  list(APPEND CPACK_COMPONENTS_ALL libraries)
endif()

find_program(GIRTH_DPKG_SHLIBDEPS dpkg-shlibdeps)
mark_as_advanced(GIRTH_DPKG_SHLIBDEPS)
if(GIRTH_DPKG_SHLIBDEPS AND NOT BUILD_SHARED_LIBS)
  list(APPEND CPACK_GENERATOR DEB)
endif()
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMMAND_PACKAGE_NAME girth)
set(CPACK_DEBIAN_COMMAND_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_COMMAND_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_COMMAND_DESCRIPTION
    "The command: the exact girth of triangle meshes, and the loops that measure it.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libgirth-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
# The libraries are static; what they need is linked by the program that uses them.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libdraco-dev, libmeshoptimizer-dev")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION
    "Static libraries and headers of girth::core, girth::io and girth::study.")
include(CPack)
