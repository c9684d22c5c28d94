#!/bin/bash
# All public headers in a program that takes every warning for an error: `strict.sh PREFIX SOURCE FOLDER COMPILER`, by that
# compiler and by the other ones that are there, as C++20 and C++23. Prints what is wrong and ends with 1.
set -u
prefix=$1 source=$2 folder=$3
. "$(dirname "$0")/expect.sh"
begin "$folder"
include=$(find "$prefix" -type d -path '*include/girth' | head -1)
{
  (cd "$include/.." && find girth -name '*.h' | sort | sed 's/.*/#include <&>/')
  sed '/^#include <girth/d' "$source/tests/cpp/consumer/strict.cpp"
} > strict.cpp
# A member that is not listed is named by the compiler, with what to do.
cat > undescribed.cpp << 'END'
#include <girth/describe/description.h>

struct Account {
  double length, width;
};
constexpr auto describe(girth::Members<Account>) {
  return girth::described<Account>(girth::member("length", &Account::length));
}
int main() { return std::get<0>(describe(girth::Members<Account>())).name[0]; }
END
for compiler in "$4" g++ clang++; do
  command -v "$compiler" > /dev/null || continue
  name=$("$compiler" --version | head -1)
  [[ "${tried:-}" == *"$name"* ]] && continue
  tried+=$name
  for standard in c++20 c++2b; do
    for definition in GIRTH_STATIC GIRTH_SHARED; do
      [ "$definition$standard" = GIRTH_SHAREDc++20 ] && continue
      expect 0 '' "$compiler" -std=$standard -fsyntax-only -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion \
        -Wshadow -Wold-style-cast -Wnon-virtual-dtor -Woverloaded-virtual -Werror -D$definition \
        -I"$include/.." strict.cpp
    done
    expect 1 'a member of this struct is not described: list it here' \
      "$compiler" -std=$standard -fsyntax-only -DGIRTH_STATIC -I"$include/.." undescribed.cpp
  done
done
finish
