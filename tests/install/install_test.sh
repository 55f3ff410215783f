#!/usr/bin/env bash
# install_test.sh SOURCE BUILD: installs BUILD, moves the installation out of the tree, and takes it from there: the
# program from another folder, and the example project of SOURCE with a controller of its own.
set -euo pipefail
source=$1 build=$2
export LC_ALL=C.UTF-8
unset LINESERVO_DATA
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
prefix=$place/moved

fail() {
  printf 'FAILED: %s\n' "$*" >&2
  exit 1
}
step() { printf '%3d s  %s\n' "$SECONDS" "$*"; }
# refused WORDS COMMAND...: ends with 2 and one line on stderr that has the words.
refused() {
  local words=$1 code=0
  shift
  "$@" >"$place/out.txt" 2>"$place/err.txt" || code=$?
  [[ $code == 2 && $(wc -l <"$place/err.txt") == 1 ]] || fail "$* ended with $code: $(<"$place/err.txt")"
  grep -qF -- "$words" "$place/err.txt" || fail "$* says: $(<"$place/err.txt")"
}
# json FILE KEY: the value of a key of its own line, without its comma.
json() { sed -n "s/^ *\"$2\": //p" "$1" | sed 's/,$//' | head -1; }

step "install, and move"
rm -rf "$build/installed"
cmake --install "$build" --prefix "$build/installed" >"$place/install.log"
mv "$build/installed" "$prefix"
[[ -f $prefix/include/lineservo/servo/law/follow_law.h ]] || fail "the headers are not installed"
[[ -f $prefix/share/lineservo/data/layouts/warehouse.yaml ]] || fail "the data is not installed"
[[ ! -f $build/report/page.html || -f $prefix/share/lineservo/report/page.html ]] || fail "the report's page is not installed"
while read -r file; do
  ! grep -qF -e "$source" -e "$build" "$file" || fail "$file names the source tree or the build"
done < <(find "$prefix" -type f)

step "the installed program, from another folder"
cd "$place"
"$prefix/bin/lineservo" fly a13 --out flown >fly.txt || fail "fly a13: $(<fly.txt)"
[[ $(json flown/summary.json outcome) == '"arrived"' ]] || fail "outcome $(json flown/summary.json outcome)"
[[ ! -f $build/report/page.html || -s flown/report.html ]] || fail "no report.html"
"$prefix/bin/lineservo" watch sim:warehouse/a13 --frames 60 --record seen >watch.csv
refused "not in a build folder" "$prefix/bin/lineservo" test

step "a project on it"
cmake -G Ninja -S "$source/apps/example" -B example -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_CXX_FLAGS="-Wall -Wextra -Werror" >configure.log 2>&1 || fail "$(<configure.log)"
cmake --build example >build.log 2>&1 || fail "$(<build.log)"
mine=$place/example/proportional

step "its controller on the command line"
"$mine" controllers | grep -q '^proportional  *in proportion' || fail "controllers does not list it"
"$mine" fly a13 --controller proportional --out mine >fly.txt || fail "fly a13 --controller proportional: $(<fly.txt)"
[[ $(json mine/summary.json outcome) == '"arrived"' ]] || fail "outcome $(json mine/summary.json outcome)"
grep -q '^ *offset_per_s: 1$' mine/config.yaml || fail "config.yaml does not hold its gain"
"$mine" fly --config mine/config.yaml --out again >fly.txt
[[ $(json again/summary.json trajectory_sha256) == $(json mine/summary.json trajectory_sha256) ]] ||
  fail "the same flight has another hash"
"$mine" fly a13 --controller proportional --set servo.proportional.offset_per_s=0.5 --out soft >fly.txt
[[ $(json soft/summary.json trajectory_sha256) != $(json mine/summary.json trajectory_sha256) ]] ||
  fail "its gain changes nothing"
refused "must be a number from 0 to 5" "$mine" fly a13 --controller proportional --set servo.proportional.offset_per_s=6
refused "improved-carrot, vtp, proportional" "$mine" fly a13 --controller proportionate
refused "there are: ibvs" "$prefix/bin/lineservo" fly a13 --controller proportional
[[ ! -f $build/report/page.html || -s mine/report.html ]] || fail "no report.html of its flight"
"$mine" compare --controllers ibvs,proportional --instructions a03 --runs 1 --json >compare.json
grep -q '"proportional fly a03 --controller proportional ' compare.json || fail "compare does not tell how to fly it again"
"$mine" watch seen/frames --height 0.5 --controller proportional >watch.csv
"$mine" replay seen >/dev/null

step "its perception"
./example/what_line seen/frames/000059.png >line.txt || fail "what_line: $(<line.txt)"
grep -q "line: rho 0.00" line.txt || fail "what_line says: $(<line.txt)"
step "done"
