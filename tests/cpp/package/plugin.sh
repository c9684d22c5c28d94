#!/bin/bash
# Plugins: `plugin.sh PREFIX SOURCE FOLDER COMPILER`. A shared object links the libraries of PREFIX,
# and is loaded by a program that catches by type what is thrown out of it; with pkg-config. Then the same with shared
# libraries: those of PREFIX, or made of the objects of its static ones. Prints what is wrong and ends with 1.
set -u
prefix=$1 source=$2 folder=$3 compiler=$4
. "$(dirname "$0")/expect.sh"
begin "$folder"
consumer=$source/tests/cpp/consumer
libraries=$(dirname "$(dirname "$(find "$prefix" -name girth.pc)")")

# `try FOLDER`: builds plugin and program there and runs them, with the libraries of the .pc files in PKG_CONFIG_PATH.
try() {
  mkdir -p "$1"
  flags_of girth-study --cflags --libs
  expect 0 '' "$compiler" -std=c++20 -O1 -fPIC -fvisibility=hidden -shared "$consumer/plugin.cpp" -o "$1/plugin.so" \
    -Wl,-z,defs "${flags[@]}"
  flags_of girth --cflags --libs
  expect 0 '' "$compiler" -std=c++20 -O1 -fvisibility=hidden "$consumer/host.cpp" -o "$1/host" -rdynamic "${flags[@]}" -ldl
  expect 0 'caught OPEN_EDGE as girth::Error' "$1/host" "$1/plugin.so"
}

export PKG_CONFIG_PATH=$libraries/pkgconfig
if [ -f "$libraries/libgirth_core.a" ]; then
  try static
  [[ "$(pkg-config --cflags girth-study)" != *-D* ]] || { echo 'wrong: static libraries define something'; failed=1; }
  # Shared libraries of the same objects, in a copy of the package.
  cp -r "$prefix" shared
  libraries=$PWD/shared${libraries#"$prefix"}
  sed -i 's/^Cflags: .*/& -DGIRTH_SHARED/; s/^\(Libs: .* -lgirth_[a-z]*\).*/\1/' "$libraries"/pkgconfig/*.pc
  # `link LIBRARY needs...`
  link() {
    local archive=$libraries/libgirth_$1.a
    expect 0 '' "$compiler" -shared -o "${archive%.a}.so" -Wl,-soname,"libgirth_$1.so" -Wl,-z,defs \
      -Wl,--whole-archive "$archive" -Wl,--no-whole-archive -L"$libraries" "${@:2}"
    rm "$archive"
  }
  link core -pthread
  link io -lgirth_core -ldraco -lmeshoptimizer
  link study -lgirth_io -lgirth_core
  export PKG_CONFIG_PATH=$libraries/pkgconfig
else
  # Before 1.0.0 each minor version has an interface of its own.
  version=$(pkg-config --modversion girth)
  interface=${version%%.*}
  [ "$interface" -gt 0 ] || interface=${version%.*}
  for library in core io study; do
    expect 0 "[libgirth_$library.so.$interface]" readelf -d "$libraries/libgirth_$library.so.$version"
  done
fi
export LD_LIBRARY_PATH=$libraries
try dynamic
for library in core io study; do
  # Only marked symbols show, and instances of the standard library's templates; nothing of what they are made with.
  if nm -DC --defined-only "$libraries/libgirth_$library.so" | cut -d' ' -f3- |
    grep -E '^(girth::geodesic::(Propagation|Unfolding)|girth::io::readObj|tinygltf|nlohmann|Eigen|draco)'; then
    echo "wrong: libgirth_$library.so shows private parts"
    failed=1
  fi
done
finish
