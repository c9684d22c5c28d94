#!/bin/bash
# Girth as a part of somebody else's project: `subproject.sh SOURCE FOLDER COMPILER`. The project is configured and asked what
# it would build and install; nothing is compiled. Prints what is wrong and ends with 1.
set -u
source=$1 folder=$2 compiler=$3
. "$(dirname "$0")/expect.sh"
begin "$folder"
command -v ninja > /dev/null || { echo 'skipped: Ninja is missing'; exit 77; }

# `project NAME BRING LIBRARIES`: prints what Girth has changed of the project's variables and properties.
project() {
  mkdir "$1"
  echo 'int main() {}' > "$1/mine.cpp"
  cat > "$1/CMakeLists.txt" <<END
cmake_minimum_required(VERSION 3.25)
project(mine VERSION 1.2.3.4 LANGUAGES CXX)
set(CMAKE_CXX_STANDARD 23)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "\${CMAKE_BINARY_DIR}/bin")
macro(state result)
  get_cmake_property(names VARIABLES)
  list(FILTER names EXCLUDE REGEX "^(GIRTH_|girth|names|name|value|state|before|FETCHCONTENT|fetchcontent|FetchContent|CMAKE_THREAD_LIBS|CMAKE_HAVE_LIBC|CMAKE_USE_|CMAKE_HP_|Threads_|THREADS_|_|ARG|draco_|meshoptimizer_|contentName|CMAKE_POLICY|CMAKE_TRY_COMPILE|CMAKE_CURRENT)")
  set(\${result} "")
  foreach(name IN LISTS names)
    string(APPEND \${result} "\${name}=\${\${name}}\n")
  endforeach()
  foreach(name COMPILE_OPTIONS COMPILE_DEFINITIONS INCLUDE_DIRECTORIES LINK_OPTIONS LINK_LIBRARIES TESTS)
    get_property(value DIRECTORY PROPERTY \${name})
    string(APPEND \${result} "property \${name}=\${value}\n")
  endforeach()
endmacro()
include(FetchContent)
find_package(Threads)
state(before)
$2
state(after)
file(WRITE "\${CMAKE_BINARY_DIR}/before" "\${before}")
file(WRITE "\${CMAKE_BINARY_DIR}/after" "\${after}")
add_executable(mine mine.cpp)
install(TARGETS mine)
$3
END
  expect 0 '' cmake -G Ninja -S "$1" -B "$1/build" -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=Debug "${@:4}"
  if ! diff <(sort "$1/build/before") <(sort "$1/build/after"); then
    echo "wrong: $1: variables or properties of the parent are changed"
    failed=1
  fi
  ninja -C "$1/build" -t commands all > "$1/plan" || failed=1
}
# `plans NAME yes|no WORDS`: whether the project would build something.
plans() {
  local found=no
  grep -q "$3" "$1/plan" && found=yes
  [ "$found" = "$2" ] || { echo "wrong: $1: builds $3: $found, not $2"; failed=1; }
}
fetch="FetchContent_Declare(girth SOURCE_DIR \"$source\")
FetchContent_MakeAvailable(girth)"

project unlinked "add_subdirectory(\"$source\" girth)" ''
plans unlinked no 'libgirth_'
[ "$(wc -l < unlinked/plan)" -eq 2 ] || { echo 'wrong: unlinked: builds more than the project'; failed=1; }

project core "$fetch" 'target_link_libraries(mine PRIVATE girth::core)'
plans core yes 'libgirth_core.a'
plans core no 'girth_io\|girth_study\|gtest\|cpp/cli/\|cpp/bench/\|tests/fuzz/'
grep -q -- '-fPIC.*girth_core' core/plan || { echo 'wrong: the core is not position-independent'; failed=1; }
grep -q -- '-Werror' core/plan && { echo 'wrong: warnings are errors'; failed=1; }
grep 'mine.cpp' core/plan | grep -q -- '-Wall\|GIRTH\|ffp-contract' && { echo 'wrong: flags of Girth reach the parent'; failed=1; }
[ -z "$(find core/build -path '*girth*' -name cmake_install.cmake -exec grep -l 'file(INSTALL' {} +)" ] ||
  { echo 'wrong: Girth installs something into its parent'; failed=1; }
(cd core/build && ctest -N) | grep -q 'Total Tests: 0' || { echo 'wrong: the parent has tests of Girth'; failed=1; }

project shared "$fetch" 'target_link_libraries(mine PRIVATE girth::io)' -DBUILD_SHARED_LIBS=ON
plans shared yes 'libgirth_io.so'
plans shared no 'girth_study'

project fixed "$fetch" 'target_link_libraries(mine PRIVATE girth::core)' -DCMAKE_POSITION_INDEPENDENT_CODE=OFF
grep -q -- '-fPIC' fixed/plan && { echo 'wrong: the wish of the parent does not count'; failed=1; }

project small "$fetch" 'target_link_libraries(mine PRIVATE girth::core)' -DGIRTH_BUILD_IO=OFF \
  -DCMAKE_DISABLE_FIND_PACKAGE_draco=ON -DCMAKE_DISABLE_FIND_PACKAGE_meshoptimizer=ON
plans small yes 'libgirth_core.a'
finish
