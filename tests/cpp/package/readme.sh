#!/bin/bash
# The lines of README and documents, as they stand: `readme.sh PREFIX SOURCE FOLDER COMPILER`. PREFIX: Girth is installed
# under it; SOURCE: the repository; FOLDER: where to work, which is made anew. All ```cpp blocks are compiled and run, and the
# examples in the headers (\code ... \endcode), which have a surface `mesh`; a
# project uses the ```cmake block of cpp.md; README's and command.md's lines of the command are run, but for the study
# of robustness, which takes minutes. Prints each failure and ends with 1.
set -u
prefix=$1 source=$2 folder=$3 compiler=$4
. "$(dirname "$0")/expect.sh"
begin "$folder"
cp "$source/tests/data/prism.obj" model.obj
libraries=$(dirname "$(dirname "$(find "$prefix" -name girth.pc)")")
export PKG_CONFIG_PATH=$libraries/pkgconfig LD_LIBRARY_PATH=$libraries

# `blocks LANGUAGE FILE PREFIX`: each block of FILE becomes PREFIX1, PREFIX2, ...
blocks() {
  awk -v language="$1" -v prefix="$3" '
    /^```/ { if (inside) { inside = 0; close(name) } else if ($0 == "```" language) { inside = 1; name = prefix (++n) } ; next }
    inside { print > name }' "$2"
}

blocks cpp "$source/README.md" README-
for document in "$source"/web/docs/*.md "$source"/web/docs/*/*.md; do
  name=${document#"$source/web/docs/"}
  name=${name%.md}
  blocks cpp "$document" "${name//\//-}-"
done
[ -f README-1 ] && [ -f cpp-1 ] || { echo 'wrong: README or cpp.md has no program in C++'; failed=1; }
flags_of girth-study --cflags --libs
for block in *-[0-9]*; do
  mv "$block" "$block.cpp"
  expect 0 '' "$compiler" -std=c++20 -Wall -Wextra -Werror "$block.cpp" -o "$block" "${flags[@]}"
  expect 0 '' "./$block" model.obj
done
[ "$(head -1 values.csv)" = 'vertex,igf,kind' ] || { echo 'wrong: README writes no values.csv'; failed=1; }
expect 1 'absent.obj: FILE_NOT_FOUND: ' ./README-1 absent.obj
expect 1 'usage: ./README-1 MODEL' ./README-1
expect 1 'usage: ./tutorials-cpp-1 MODEL' ./tutorials-cpp-1
expect 1 'Girth needs C++20: compile with -std=c++20' "$compiler" -std=c++17 README-1.cpp -c "${flags[@]}"

# Examples of headers: each becomes a function, and one program calls them all.
{
  printf '#include <%s>\n' algorithm iostream utility vector girth/girth.h girth/io/{load_mesh,save_field,save_mesh}.h
  find "$prefix/include/girth" -name '*.h' -print0 | sort -z | xargs -0 awk '
    $1 == "///" && $2 == "\\code" { inside = 1; print "void example" n++ "([[maybe_unused]] const girth::SurfaceMesh& mesh) {"; next }
    $1 == "///" && $2 == "\\endcode" { inside = 0; print "}"; next }
    inside { sub(/^ *\/\/\/ ?/, ""); print }
    END {
      print "int main() {\n  const auto mesh = girth::io::loadMesh(\"model.obj\").value().mesh;"
      for (i = 0; i < n; ++i) print "  example" i "(mesh);"
      print "}"
    }'
} > examples.cpp
[ "$(grep -c '^void example' examples.cpp)" -ge 20 ] || { echo 'wrong: headers have fewer than 20 examples'; failed=1; }
expect 0 '' "$compiler" -std=c++20 -Wall -Wextra -Werror examples.cpp -o examples "${flags[@]}"
expect 0 '' ./examples

blocks cmake "$source/web/docs/cpp.md" lines-
{
  echo 'cmake_minimum_required(VERSION 3.25)'
  echo 'project(mine LANGUAGES CXX)'
  echo 'add_executable(mine README-1.cpp)'
  cat lines-1
} > CMakeLists.txt
expect 0 '' cmake -S . -B build -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_CXX_COMPILER="$compiler"
expect 0 '' cmake --build build
expect 0 '' build/mine model.obj
# The command, on models as small as the lines allow.
if [ -x "$prefix/bin/girth" ]; then
  mkdir command && cd command || exit 1
  PATH=$prefix/bin:$PATH
  girth remesh ../model.obj --subdivide 400 -q -o model.glb && girth remesh model.glb --faces 300 -q -o model.stl &&
    girth remesh model.glb --faces 200 -q -o a.obj && girth remesh model.glb --faces 200 --even -q -o b.obj &&
    girth remesh model.glb --faces 200 -q -o scan.ply && cp model.stl vessel.stl || failed=1
  # An hourglass: three rings of six, the middle one half as wide, and a lid on each end.
  awk 'BEGIN {
    for (ring = 0; ring < 3; ++ring) for (i = 0; i < 6; ++i) {
      r = ring == 1 ? 0.5 : 1; a = i * 3.14159265358979 / 3
      printf "v %.9f %.9f %d\n", r * cos(a), r * sin(a), 2 * ring
    }
    for (ring = 0; ring < 2; ++ring) for (i = 0; i < 6; ++i) {
      a = 6 * ring + i + 1; b = 6 * ring + (i + 1) % 6 + 1
      print "f", a, b, b + 6, a + 6
    }
    print "f 6 5 4 3 2 1\nf 13 14 15 16 17 18"
  }' > hourglass.obj
  girth remesh hourglass.obj --faces 100 -q -o figure.stl || failed=1
  echo '[{ "name": "waist", "point": 12, "how": "girth" }]' > landmarks.json
  printf '0,12\n5,7\n' > pairs.csv
  mkdir -p folder/thin folder/thick && cp a.obj b.obj folder/thin && cp a.obj model.stl folder/thick
  blocks sh "$source/README.md" lines-README-
  blocks sh "$source/web/docs/command.md" lines-
  grep -h '^girth ' lines-* | sed 's/ *#.*//' > lines
  [ "$(wc -l < lines)" -ge 15 ] || { echo "wrong: command.md has only $(wc -l < lines) lines of the command"; failed=1; }
  grep -v '^girth study robustness ' lines > tried
  while read -r line; do
    # A printer's limits are not met by this model.
    code=0
    [[ "$line" == *--min-wall* ]] && code=4
    # shellcheck disable=SC2086
    expect $code '' $line
  done < tried
  # Whatever a line names after -o is there, with something in it; a folder has a page.
  grep -o -- '-o [^ ]*' tried | sed 's/^-o //; s|/$|/index.html|' | sort -u > made
  [ "$(wc -l < made)" -ge 10 ] || { echo "wrong: the lines write only $(wc -l < made) files"; failed=1; }
  while read -r made; do
    [ -s "$made" ] || { echo "wrong: the lines do not write $made"; failed=1; }
  done < made
fi
finish
