#!/bin/bash
# What find_package(girth COMPONENTS ...) needs: `components.sh PREFIX FOLDER COMPILER`. The projects are configured where the
# packages that girth::io needs are not to be found, or are. Prints what is wrong and ends with 1.
set -u
prefix=$1 folder=$2 compiler=$3
. "$(dirname "$0")/expect.sh"
begin "$folder"

# `project NAME COMPONENTS TARGET`
project() {
  mkdir "$1"
  printf '%s\n' 'cmake_minimum_required(VERSION 3.25)' 'project(mine LANGUAGES CXX)' \
    'file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/mine.cpp" "int main() {}\n")' \
    "find_package(girth 1.0 REQUIRED $2)" 'add_executable(mine "${CMAKE_CURRENT_BINARY_DIR}/mine.cpp")' \
    "target_link_libraries(mine PRIVATE $3)" > "$1/CMakeLists.txt"
}
configure() {
  local name=$1
  shift
  cmake -S "$name" -B "$name/build" -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_CXX_COMPILER="$compiler" "$@"
}
without=(-DCMAKE_DISABLE_FIND_PACKAGE_draco=ON -DCMAKE_DISABLE_FIND_PACKAGE_meshoptimizer=ON
  -DCMAKE_DISABLE_FIND_PACKAGE_ZLIB=ON)

project core 'COMPONENTS core' girth::core
expect 0 '' configure core "${without[@]}"
expect 0 '' cmake --build core/build
project io 'COMPONENTS io' girth::io
if [ -f "$(find "$prefix" -name 'libgirth_io.a')" ]; then
  expect 1 'draco' configure io "${without[@]}"
else
  expect 0 '' configure io "${without[@]}"
fi
expect 0 '' configure io --fresh
expect 0 '' cmake --build io/build
project whole '' girth::study
expect 0 '' configure whole
project unknown 'COMPONENTS core viewer' girth::core
expect 1 'no component viewer here' configure unknown
expect 1 'Those that are installed: core' configure unknown
finish
