# Makes a release's files with cpack, as in a fresh build, and looks into them. The archive is left in
# FOLDER/unpacked for the test that builds against it.
cmake_minimum_required(VERSION 3.25)

# Runs a program that has to succeed; what it prints is in `output`.
macro(run)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE output ERROR_VARIABLE errors RESULT_VARIABLE code
                  OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${ARGN}: ${code}\n${output}\n${errors}")
  endif()
endmacro()

# Whether `text` contains all the words.
function(expect what text)
  foreach(word IN LISTS ARGN)
    string(FIND "${text}" "${word}" at)
    if(at EQUAL -1)
      message(FATAL_ERROR "${what}: there is no ${word} in\n${text}")
    endif()
  endforeach()
endfunction()

file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")
run("${CPACK}" --config "${BUILD}/CPackConfig.cmake" -B "${FOLDER}")

file(GLOB archives "${FOLDER}/girth-${VERSION}-*.tar.gz")
list(LENGTH archives count)
if(NOT count EQUAL 1)
  message(FATAL_ERROR "there is not one archive of version ${VERSION}: ${archives}")
endif()
cmake_path(GET archives STEM LAST_ONLY name)
string(REGEX REPLACE "\\.tar$" "" name "${name}")
file(ARCHIVE_EXTRACT INPUT "${archives}" DESTINATION "${FOLDER}/extracted")
file(RENAME "${FOLDER}/extracted/${name}" "${FOLDER}/unpacked")
set(files lib/libgirth_core.a lib/libgirth_io.a lib/libgirth_study.a lib/cmake/girth/girthConfig.cmake
          include/girth/girth.h share/doc/libgirth-dev/copyright share/doc/libgirth-dev/CHANGELOG.md
          share/doc/libgirth-dev/examples/CMakeLists.txt)
if(WITH_COMMAND)
  list(APPEND files bin/girth share/doc/girth/copyright share/doc/girth/CHANGELOG.md)
endif()
foreach(file IN LISTS files)
  if(NOT EXISTS "${FOLDER}/unpacked/${file}")
    message(FATAL_ERROR "${archives} has no ${file}")
  endif()
endforeach()
if(WITH_COMMAND)
  run("${FOLDER}/unpacked/bin/girth" --version)
  if(NOT output STREQUAL "girth ${VERSION}")
    message(FATAL_ERROR "bin/girth --version prints \"${output}\", and this is ${VERSION}")
  endif()
endif()

# The Debian packages, on systems that have them.
find_program(dpkgDeb dpkg-deb)
find_program(shlibdeps dpkg-shlibdeps)
if(NOT dpkgDeb OR NOT shlibdeps)
  return()
endif()
function(check_debian_package name dependencies)
  file(GLOB package "${FOLDER}/${name}_${VERSION}_*.deb")
  run("${dpkgDeb}" --field "${package}")
  expect("${name}" "${output}" "Package: ${name}\n" "Version: ${VERSION}\n" "Depends: "
         ${dependencies})
  run("${dpkgDeb}" --contents "${package}")
  expect("${name}" "${output}" ./usr/share/doc/${name}/copyright
         ./usr/share/doc/${name}/CHANGELOG.md ${ARGN})
endfunction()
check_debian_package(libgirth-dev "libdraco-dev;libmeshoptimizer-dev" ./usr/include/girth/girth.h
                     ./usr/lib/libgirth_core.a ./usr/lib/cmake/girth/girthConfig.cmake)
if(WITH_COMMAND)
  check_debian_package(girth "libc6;libstdc++6;libdraco;libmeshoptimizer" ./usr/bin/girth)
endif()
