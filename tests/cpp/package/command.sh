#!/bin/bash
# The installed command, used as people at work use it: `command.sh PREFIX DATA FOLDER`. PREFIX: what it is
# installed under; DATA: tests/data; FOLDER: where to work, which is made anew. Prints what is wrong and ends with 1.
set -u
prefix=$1 data=$2 folder=$3
girth=$prefix/bin/girth
share=$prefix/share
. "$(dirname "$0")/expect.sh"
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
expect 0 'exact naive ms' bash -c "source '$share/bash-completion/completions/girth'
  COMP_WORDS=(girth igf --method '') COMP_CWORD=3; _girth; echo \"\${COMPREPLY[@]}\""
expect 0 'accuracy robustness' bash -c "source '$share/bash-completion/completions/girth'
  COMP_WORDS=(girth study '') COMP_CWORD=2; _girth; echo \"\${COMPREPLY[@]}\""
expect 0 'compdef girth' cat "$share/zsh/site-functions/_girth"
expect 0 '-l resume' cat "$share/fish/vendor_completions.d/girth.fish"

# Pipes, packed models, names that begin with a dash.
"$girth" igf model.obj -q -o values.csv || failed=1
"$girth" igf - -o - --format csv < model.obj > piped.csv || failed=1
same values.csv piped.csv
gzip -k model.obj && "$girth" igf model.obj.gz -o - --format csv > packed.csv || failed=1
same values.csv packed.csv
cp model.obj ./-model.obj
expect 0 'closed surface' "$girth" info -- -model.obj
head -c 300 model.obj.gz > cut.obj.gz
expect 2 'MALFORMED_FILE' "$girth" info cut.obj.gz
head -c 300000000 /dev/zero | gzip > bomb.obj.gz
expect 3 'LIMIT_EXCEEDED' bash -c "ulimit -v 400000; '$girth' info bomb.obj.gz"
expect 1 'both write to standard output' "$girth" igf model.obj -o - --format csv --json
expect 1 'add --format' "$girth" igf model.obj -o -
expect 1 'use .csv' "$girth" igf model.obj -o values.xyz
expect 1 '--jobs: 0' "$girth" igf model.obj --jobs 0
mkdir locked && chmod 500 locked
[ "$(id -u)" -eq 0 ] || expect 2 'FILE_UNWRITABLE' "$girth" igf model.obj -o locked/values.csv

# Nothing of the user's is lost.
cp model.obj kept.obj
expect 1 'add --force' "$girth" remesh model.obj --faces 60 -o model.obj
same model.obj kept.obj
printf old > private.csv && chmod 600 private.csv && ln -s private.csv link.csv
expect 0 '' "$girth" igf model.obj -q -o link.csv
same values.csv private.csv
[ -L link.csv ] || { echo 'wrong: the link was replaced'; failed=1; }
expect 0 '600' stat -c %a private.csv
if "$girth" remesh model.obj --refine 20000 -q -o large.obj; then
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
  expect 1 '--resume' "$girth" igf large.obj -o large.csv
fi

# Many models.
mkdir values
answers=$("$girth" info model.obj absent.obj kept.obj --json --jobs 2 2> errors | grep -c '^{')
[ "$answers" -eq 3 ] || { echo "wrong: $answers answers for three models"; failed=1; }
expect 0 '' "$girth" igf model.obj kept.obj -q --jobs 2 -o values/ --format csv
same values.csv values/kept.csv

finish
