# Functions that the scripts here check with; sourced. `failed` becomes 1 where something is wrong.
failed=0

# `expect CODE WORDS command...`: the exit code, and words that standard output or error must have.
expect() {
  local code=$1 words=$2 answer got
  shift 2
  answer=$("$@" 2>&1 < /dev/null)
  got=$?
  if [ "$got" -ne "$code" ] || [[ "$answer" != *"$words"* ]]; then
    printf 'wrong: %s\n  ended with %s, not %s; should contain "%s":\n%s\n' "$*" "$got" "$code" "$words" "$answer"
    failed=1
  fi
}

# `flags_of LIBRARY OPTIONS...`: what pkg-config says, as the array `flags`. It escapes blanks.
flags_of() {
  mapfile -t flags < <(pkg-config "${@:2}" "$1" | xargs printf '%s\n')
}

# `same A B`: two files alike.
same() {
  cmp -s "$1" "$2" || { echo "wrong: $1 and $2 differ"; failed=1; }
}

# `begin FOLDER`: works there; the folder is made anew.
begin() {
  rm -rf "$1" && mkdir -p "$1" && cd "$1" || exit 1
}

# The script's end.
finish() {
  [ $failed -eq 0 ] && echo 'all as it should be'
  exit $failed
}
