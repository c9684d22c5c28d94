# Settings that all targets have in common.

# The language, the warnings, and arithmetic that gives the same bits everywhere.
function(girth_configure target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  target_compile_options(
    ${target}
    PRIVATE -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Wconversion
            -Wno-sign-conversion
            # GCC 12 and 13 see overlaps in "literal" + std::string that are not there (GCC bug 105651).
            $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> $<$<BOOL:${GIRTH_WERROR}>:-Werror>)
  if(NOT EMSCRIPTEN)
    # A function that other libraries could replace would never be inlined into its own one.
    target_compile_options(${target} PRIVATE -fno-semantic-interposition)
  endif()
endfunction()

# Takes what is for other systems out of a list of sources: *_posix.cpp on Windows, *_windows.cpp elsewhere.
macro(girth_leave_other_systems sources)
  if(WIN32)
    list(FILTER ${sources} EXCLUDE REGEX "_posix\\.cpp$")
  else()
    list(FILTER ${sources} EXCLUDE REGEX "_windows\\.cpp$")
  endif()
endmacro()

# Precompiles the standard library's headers for a target, and others that are named; only while Girth itself is
# developed. Each source still includes what it uses: Emscripten compiles it without them, and clang-tidy reads it so.
function(girth_precompile target)
  if(NOT GIRTH_PRECOMPILE_HEADERS)
    return()
  endif()
  target_precompile_headers(
    ${target} PRIVATE <algorithm> <array> <atomic> <cmath> <cstddef> <cstdint> <functional> <limits>
                      <memory> <optional> <span> <string> <string_view> <thread> <utility> <variant>
                      <vector> ${ARGN})
  # Without -fpch-preprocess ccache cannot see what a precompiled header was made of. GCC 12 forgets that a precompiled
  # header is a system header, and sees overlaps in its strings that are not there (GCC bug 105651 again), and vectors
  # that free what they never had.
  target_compile_options(
    ${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess -Wno-array-bounds -Wno-stringop-overflow
                      -Wno-stringop-overread -Wno-free-nonheap-object>)
endfunction()

# Compiles some sources of a target at a time, which share what they include; only while Girth itself is developed. A
# source that is large, or compiled with options of its own, stays alone. So few at a time that a changed source costs
# seconds; names in anonymous namespaces must differ between them.
function(girth_unity target)
  if(GIRTH_UNITY_BUILD)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 6)
    # GCC takes a source that is included for a header, whose types must not be made of a source's own ones.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  endif()
endfunction()

# Visibility and name of a shared library: before 1.0.0 each minor version has an interface of its own.
function(girth_visibility target)
  if(PROJECT_VERSION_MAJOR EQUAL 0)
    set(interface "${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}")
  else()
    set(interface "${PROJECT_VERSION_MAJOR}")
  endif()
  set_target_properties(
    ${target} PROPERTIES VERSION "${PROJECT_VERSION}" SOVERSION "${interface}" DEFINE_SYMBOL ""
                         CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  target_compile_definitions(${target} PRIVATE GIRTH_BUILDING)
  get_target_property(type ${target} TYPE)
  if(type STREQUAL "SHARED_LIBRARY")
    target_compile_definitions(${target} INTERFACE GIRTH_SHARED)
    if(NOT APPLE AND NOT GIRTH_SANITIZERS)
      target_link_options(${target} PRIVATE LINKER:--no-undefined)
    endif()
  endif()
endfunction()

# A library of the project: `girth_library(core SOURCES ... [PUBLIC core ...] [PRIVATE target ...])`
# makes girth_core, alias girth::core; PUBLIC names other libraries of the project. Static or, with
# BUILD_SHARED_LIBS, shared; both are made of the same objects, which show what GIRTH_EXPORT marks
# (girth/export.h). Under Emscripten they are static, and there is a second one for modules with threads, girth_core_threads,
# alias girth::core_threads, which alone has the sources that ONLY_THREADED (a regular expression) finds.
function(girth_library name)
  cmake_parse_arguments(arg "" "ONLY_THREADED" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  set(suffixes "none")
  if(EMSCRIPTEN)
    # Everything is compiled twice, for modules with threads and without: objects with atomics keep what is thrown in
    # thread-local variables, and modules without threads would not find it.
    list(APPEND suffixes "_threads")
  endif()
  foreach(suffix IN LISTS suffixes)
    string(REPLACE "none" "" suffix "${suffix}")
    set(target girth_${name}${suffix})
    set(sources ${arg_SOURCES})
    if(EMSCRIPTEN AND NOT suffix AND arg_ONLY_THREADED)
      list(FILTER sources EXCLUDE REGEX "${arg_ONLY_THREADED}")
    endif()
    if(EMSCRIPTEN)
      add_library(${target} STATIC ${sources})
    else()
      add_library(${target} ${sources})
      girth_visibility(${target})
    endif()
    if(NOT PROJECT_IS_TOP_LEVEL)
      set_target_properties(${target} PROPERTIES EXCLUDE_FROM_ALL ON)
    endif()
    add_library(girth::${name}${suffix} ALIAS ${target})
    girth_configure(${target})
    girth_precompile(${target})
    girth_unity(${target})
    target_include_directories(
      ${target} PUBLIC "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/cpp/include>"
                       "$<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>"
                       "$<INSTALL_INTERFACE:include>"
                PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}")
    foreach(library IN LISTS arg_PUBLIC)
      target_link_libraries(${target} PUBLIC girth_${library}${suffix})
    endforeach()
    foreach(library IN LISTS arg_PRIVATE)
      target_link_libraries(${target} PRIVATE "$<BUILD_INTERFACE:${library}>")
    endforeach()
    if(EMSCRIPTEN)
      target_compile_options(${target} PUBLIC -fwasm-exceptions -msimd128)
      # Built as far as the modules need it.
      set_target_properties(${target} PROPERTIES EXCLUDE_FROM_ALL ON)
    endif()
    if(suffix STREQUAL "_threads")
      target_compile_options(${target} PUBLIC -pthread)
    endif()
    set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  endforeach()
endfunction()
