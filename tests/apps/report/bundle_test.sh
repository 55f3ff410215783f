#!/usr/bin/env bash
# bundle_test.sh SOURCE: without npm the page of the report is not made, an older one goes, a line says why, and the build
# goes on.
set -euo pipefail
source=$1 folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/bin" "$folder/out"
for tool in bash mkdir rm cmp cp mv; do ln -s "$(command -v "$tool")" "$folder/bin/"; done
echo old >"$folder/out/page.html"

said=$(PATH=$folder/bin bash "$source/bundle.sh" "$source" "$folder/out" 2>&1)
[[ $said == "report.html will not be written: npm is not installed (Debian package npm)" ]] || { echo "said: $said"; exit 1; }
[[ ! -e $folder/out/page.html ]] || { echo "the old page is left"; exit 1; }
