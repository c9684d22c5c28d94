#!/bin/sh
# The girth of every model in a folder:
#
#   girth_of_folder.sh FOLDER RESULTS [options of girth igf, such as --faces 10000]
#
# RESULTS/NAME.csv has the values at the vertices of FOLDER/NAME; RESULTS/table.csv one row for each
# model. A model that fails gets a row with its error, and the others go on. Ends with 1 where one
# failed. The variable GIRTH names the command where it is not on the PATH.
set -eu

if [ $# -lt 2 ]; then
  echo "usage: $0 FOLDER RESULTS [options of girth igf]" >&2
  exit 2
fi
folder=$1
results=$2
shift 2
girth=${GIRTH:-girth}
mkdir -p "$results"
table=$results/table.csv
trap 'exit 130' INT TERM

# A text as a field of CSV.
quoted() { printf '"%s"' "$(printf '%s' "$1" | sed 's/"/""/g')"; }

# A number of the summary that `girth igf --json` prints: one object on one line.
number() { printf '%s' "$summary" | sed -n "s/.*[{,]\"$1\":\([-+.0-9e]*\).*/\1/p"; }

echo 'file,vertices,min,median,max,seconds,error' > "$table"
failures=0
for model in "$folder"/*; do
  case $model in
    *.[gG][lL][bB] | *.[gG][lL][tT][fF] | *.[oO][bB][jJ] | *.[pP][lL][yY] | *.[sS][tT][lL] | *.[oO][fF][fF]) ;;
    *) continue ;;
  esac
  name=${model##*/}
  if summary=$("$girth" igf "$model" -o "$results/$name.csv" --json "$@" 2> "$results/error.txt"); then
    row=$(number vertices),$(number min),$(number median),$(number max),$(number seconds),
  else
    failures=$((failures + 1))
    row=,,,,,$(quoted "$(cat "$results/error.txt")")
  fi
  echo "$(quoted "$name"),$row" | tee -a "$table"
done
rm -f "$results/error.txt"
[ "$failures" -eq 0 ]
