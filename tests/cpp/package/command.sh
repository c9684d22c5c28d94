#!/bin/bash
# The installed command, used as people at work use it: `command.sh PREFIX DATA FOLDER`. PREFIX: what it is
# installed under; DATA: tests/data; FOLDER: where to work, which is made anew. Prints what is wrong and ends with 1.
set -u
prefix=$1 data=$2 folder=$3
girth=$prefix/bin/girth
share=$prefix/share
scripts=$(cd "$(dirname "$0")" && pwd)
. "$scripts/expect.sh"
begin "$folder"
cp "$data/prism.obj" model.obj

# Help, slips, exit codes.
expect 0 'girth ' "$girth" -V
expect 0 '--resume' "$girth" help igf
expect 0 '4 a check fails' "$girth" help
expect 0 'Examples:' "$girth" study accuracy --help
expect 1 'did you mean igf?' "$girth" ifg model.obj
expect 1 'did you mean --faces?' "$girth" igf model.obj --facess 9
expect 1 'see girth igf --help' "$girth" igf
expect 2 'FILE_NOT_FOUND' "$girth" igf absent.obj
expect 4 'too thin' "$girth" parts model.obj --min-wall 5

# Pages and completions that are installed.
for page in girth girth-igf girth-study-robustness; do
  expect 0 '.SH EXIT STATUS' cat "$share/man/man1/$page.1"
done
expect 0 '--resume' bash -c "source '$share/bash-completion/completions/girth'
  COMP_WORDS=(girth igf --res) COMP_CWORD=2; _girth; echo \"\${COMPREPLY[@]}\""
expect 0 'exact refined naive ms' bash -c "source '$share/bash-completion/completions/girth'
  COMP_WORDS=(girth igf --method '') COMP_CWORD=3; _girth; echo \"\${COMPREPLY[@]}\""
expect 0 'accuracy robustness' bash -c "source '$share/bash-completion/completions/girth'
  COMP_WORDS=(girth study '') COMP_CWORD=2; _girth; echo \"\${COMPREPLY[@]}\""
if command -v fish > /dev/null; then
  mkdir home
  fish_completes() {
    expect 0 "$1" env PATH="$prefix/bin:$PATH" HOME="$PWD/home" XDG_DATA_DIRS="$share" timeout 20 fish -c "complete -C '$2'"
  }
  fish_completes 'igf' 'girth ig'
  fish_completes 'accuracy' 'girth study '
  fish_completes '--faces' 'girth study accuracy --fa'
  fish_completes '--resume' 'girth igf --res'
  fish_completes '--resume' 'girth -q igf --res'
  fish_completes 'naive' 'girth igf --method '
  fish_completes '--method=exact' 'girth igf --method=e'
  fish_completes 'retrieve' 'girth help ret'
  fish_completes 'robustness' 'girth help study '
  fish_completes 'model.obj' 'girth igf mod'
  fish_completes 'model.obj' 'girth igf -o mod'
  # Nothing where it does not belong: no commands behind a command, no files where none can be.
  for line in 'girth mod' 'girth igf stud' 'girth igf --faces mod' 'girth help igf mod' 'girth loop --resu'; do
    answer=$(PATH="$prefix/bin:$PATH" HOME="$PWD/home" XDG_DATA_DIRS="$share" timeout 20 fish -c "complete -C '$line'" 2>&1)
    [ -z "$answer" ] || { echo "wrong: fish completes '$line' to $answer"; failed=1; }
  done
else
  echo 'skipped: the completions of fish, which is not here'
fi
if command -v zsh > /dev/null; then
  zsh_completes() {
    expect 0 "$1" timeout 20 zsh -f "$scripts/complete.zsh" "$share/zsh/site-functions" "$2"
  }
  zsh_completes 'girth igf' 'girth ig'
  zsh_completes 'girth study accuracy' 'girth study acc'
  zsh_completes 'girth study accuracy --faces' 'girth study accuracy --fac'
  zsh_completes 'girth igf --resume' 'girth igf --res'
  zsh_completes 'girth igf --method exact' 'girth igf --method ex'
  zsh_completes 'girth help retrieve' 'girth help ret'
  zsh_completes 'girth igf model.obj' 'girth igf mod'
else
  echo 'skipped: the completions of zsh, which is not here'
fi

# Pipes, packed models, names that begin with a dash.
"$girth" igf model.obj -q -o values.csv || failed=1
"$girth" igf - -o - --format csv < model.obj > piped.csv || failed=1
same values.csv piped.csv
gzip -k model.obj && "$girth" igf model.obj.gz -o - --format csv > packed.csv || failed=1
same values.csv packed.csv
cp model.obj ./-model.obj
expect 0 'closed surface' "$girth" info -- -model.obj
expect 1 'no option' "$girth" info -model.obj
expect 0 '' "$girth" igf -q --output=-values.csv -- -model.obj
same values.csv ./-values.csv

# Bad input, each refused with its own words.
echo 'no model' > unknown.txt
expect 2 'UNKNOWN_FORMAT' "$girth" info unknown.txt
head -c 300 model.obj.gz > cut.obj.gz
expect 2 'MALFORMED_FILE' "$girth" info cut.obj.gz
head -c 300000000 /dev/zero | gzip > bomb.obj.gz
expect 3 'LIMIT_EXCEEDED' bash -c "ulimit -v 400000; '$girth' info bomb.obj.gz"
# `zip_of GZIP SIZE`: a zip of bomb.obj with the data of a gzip file, which claims so many bytes.
little_endian() {
  local number=$1 i
  for ((i = 0; i < $2; i++)); do printf "\\x$(printf %02x $((number >> 8 * i & 255)))"; done
}
zip_of() {
  local packed=$(($(stat -c %s "$1") - 18)) name=bomb.obj
  # Version, flags, method, time, date, checksum, both sizes, lengths of the name and of what is extra.
  about() { little_endian 20 4 && little_endian 8 2 && little_endian 0 8 && little_endian $packed 4 &&
    little_endian "$1" 4 && little_endian ${#name} 4; }
  printf 'PK\3\4' && about "$2" && printf %s $name && tail -c +11 "$1" | head -c $packed
  printf 'PK\1\2' && little_endian 20 2 && about "$2" && little_endian 0 14 && printf %s $name
  printf 'PK\5\6' && little_endian 0 4 && little_endian 1 2 && little_endian 1 2
  little_endian $((46 + ${#name})) 4 && little_endian $((30 + ${#name} + packed)) 4 && little_endian 0 2
}
head -c 300000000 /dev/zero | gzip -n > zeros.gz
zip_of zeros.gz 300000000 > bomb.zip
expect 3 'LIMIT_EXCEEDED' bash -c "ulimit -v 400000; '$girth' info bomb.zip"
zip_of zeros.gz 1000 > lie.zip
expect 2 'larger than they claim' bash -c "ulimit -v 400000; '$girth' info lie.zip"
expect 1 'both write to standard output' "$girth" igf model.obj -o - --format csv --json
expect 1 'add --format' "$girth" igf model.obj -o -
expect 1 'use .csv' "$girth" igf model.obj -o values.xyz
for command in igf info; do
  for jobs in 0 -1 2.5 many; do
    expect 1 '--jobs' "$girth" $command model.obj --jobs $jobs
  done
done
expect 1 '--jobs: 0' "$girth" igf model.obj --jobs 0

# Folders and files without rights; root has them all, and so becomes somebody else.
mkdir locked closed && cp model.obj closed/ && cp model.obj secret.obj
chmod 555 locked && chmod 000 closed secret.obj
somebody=()
[ "$(id -u)" -ne 0 ] || somebody=(setpriv --reuid=65534 --regid=65534 --clear-groups)
if "${somebody[@]}" "$girth" info "$PWD/model.obj" > /dev/null 2>&1; then
  expect 2 'FILE_UNWRITABLE' "${somebody[@]}" "$girth" igf model.obj -o locked/values.csv
  expect 2 'FILE_UNWRITABLE' "${somebody[@]}" "$girth" igf model.obj -o locked/ --format csv
  expect 2 'FILE_UNWRITABLE' "${somebody[@]}" "$girth" retrieve . -o locked/report
  expect 2 'FILE_UNREADABLE' "${somebody[@]}" "$girth" info secret.obj
  expect 2 'girth: closed/model.obj: FILE_' "${somebody[@]}" "$girth" info closed/model.obj
else
  echo 'skipped: folders without rights, as nobody else can run what is installed here'
fi
chmod 700 closed

# Nothing of the user's is lost.
cp model.obj kept.obj
expect 1 'add --force' "$girth" remesh model.obj --faces 60 -o model.obj
same model.obj kept.obj
printf old > private.csv && chmod 600 private.csv && ln -s private.csv link.csv
expect 0 '' "$girth" igf model.obj -q -o link.csv
same values.csv private.csv
[ -L link.csv ] || { echo 'wrong: the link was replaced'; failed=1; }
expect 0 '600' stat -c %a private.csv
if "$girth" remesh model.obj --subdivide 20000 -q -o large.obj; then
  printf whole > large.csv
  "$girth" igf large.obj --threads 1 -o large.csv > stopped 2>&1 &
  # As soon as it catches interrupts: the second bit of what /proc calls SigCgt.
  for _ in {1..300}; do
    caught=$(sed -n 's/^SigCgt:\s*//p' /proc/$!/status 2> /dev/null)
    [ -n "$caught" ] && (( 0x$caught & 2 )) && break
    sleep 0.01
  done
  kill -INT $! && wait $!
  expect 0 'whole' cat large.csv
  expect 0 '# girth igf, stopped' head -1 large.partial.csv
  expect 1 'INVALID_OPTION' "$girth" igf large.obj -o large.csv --resume --method ms
  expect 1 'INVALID_OPTION' "$girth" igf large.obj -o large.csv --resume --weld 0.5
  expect 1 'INVALID_OPTION' "$girth" igf model.obj -o large.csv --resume
  expect 1 '--resume' "$girth" igf large.obj -o large.csv
  expect 0 'whole' cat large.csv
fi

# Many models.
mkdir values
names=()
for i in {1..48}; do
  cp model.obj "values/$i.obj"
  names+=("values/$i.obj" "values/absent$i.obj")
done
names+=(unknown.txt cut.obj.gz bomb.obj.gz model.obj)
for command in igf info; do
  answers=$("$girth" $command "${names[@]}" --json --jobs 4 2> errors)
  [ "$(grep -c '^{"file":' <<< "$answers")" -eq 100 ] && [ "$(grep -c '"error":' <<< "$answers")" -eq 51 ] ||
    { echo "wrong: $command has not 100 answers for 100 models"; failed=1; }
done
expect 0 '' "$girth" igf model.obj kept.obj -q --jobs 2 -o values/ --format csv
same values.csv values/kept.csv

finish
