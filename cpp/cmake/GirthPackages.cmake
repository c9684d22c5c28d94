# The packages that the project is built with. A missing one is named with its Debian package.

# A package with a CMake config of its own: `girth_find_package(GTest libgtest-dev GIRTH_BUILD_TESTS)`,
# where the last names the option that does without it, if there is one.
macro(girth_find_package name debianPackage)
  find_package(${name} QUIET)
  if(NOT ${name}_FOUND)
    set(girthWithout "")
    if(${ARGC} GREATER 2)
      set(girthWithout " To build without it: -D${ARGV2}=OFF.")
    endif()
    message(FATAL_ERROR "${name} is missing. On Debian and Ubuntu: apt-get install ${debianPackage}."
                        "${girthWithout}")
  endif()
endmacro()

# Libraries that unpack compressed glTF. In WebAssembly the page does that.
if(GIRTH_GLTF_CODECS)
  girth_find_package(draco libdraco-dev GIRTH_GLTF_CODECS)
  girth_find_package(meshoptimizer libmeshoptimizer-dev GIRTH_GLTF_CODECS)
endif()

# girth_single_headers: libraries that are headers only. They are linked into a folder of the build
# tree, because a cross compiler must not see the rest of /usr/include.
function(girth_add_single_headers)
  set(folder "${CMAKE_CURRENT_BINARY_DIR}/single_headers")
  file(MAKE_DIRECTORY "${folder}")
  set(entries "Eigen/Core libeigen3-dev" "Spectra/SymEigsSolver.h libspectra-dev")
  if(GIRTH_BUILD_IO)
    list(APPEND entries "nlohmann/json.hpp nlohmann-json3-dev" "tiny_gltf.h libtinygltf-dev")
  endif()
  foreach(entry IN LISTS entries)
    separate_arguments(entry)
    list(GET entry 0 header)
    list(GET entry 1 debianPackage)
    string(MAKE_C_IDENTIFIER "GIRTH_${header}_FOLDER" variable)
    # The emsdk toolchain re-roots searches into its own system root.
    find_path(${variable} "${header}" PATHS /usr/include /usr/local/include
              PATH_SUFFIXES eigen3 NO_CMAKE_FIND_ROOT_PATH)
    mark_as_advanced(${variable})
    if(NOT ${variable})
      message(FATAL_ERROR "The header ${header} is missing. On Debian and Ubuntu: apt-get install "
                          "${debianPackage}. Elsewhere: -D${variable}=<the folder it lies in>.")
    endif()
    string(REGEX REPLACE "/.*" "" top "${header}")
    file(CREATE_LINK "${${variable}}/${top}" "${folder}/${top}" SYMBOLIC)
  endforeach()
  add_library(girth_single_headers INTERFACE)
  target_include_directories(girth_single_headers SYSTEM INTERFACE "${folder}")
endfunction()

girth_add_single_headers()
