#!/usr/bin/env bash
# docs_test.sh SOURCE DOCS: Doxygen has nothing to complain of in the headers and the pages of SOURCE, and every link of
# what it writes to DOCS/html leads somewhere. Ends with 77, skipped, where Doxygen is absent.
set -euo pipefail
source=$1 docs=$2

command -v doxygen >/dev/null || {
  printf 'SKIPPED, NOT TESTED: the API documentation: doxygen is not installed (Debian package doxygen)\n' >&2
  exit 77
}
cd "$source"
rm -rf "$docs/html"
doxygen "$docs/Doxyfile"

failed=0
# Of the pages as they are...
while IFS=: read -r page link; do
  target=$(dirname "$page")/${link%%#*}
  [[ -e $target ]] || { echo "$page: leads nowhere: $link"; failed=1; }
done < <(find . -path ./build -prune -o -path ./out -prune -o -name '*.md' -exec grep -oE '\]\([^):]+\)' {} + |
  sed -E 's/\]\(([^)]*)\)/\1/')
# ...and as they are written.
cd "$docs/html"
while read -r link; do
  [[ -e $link ]] || { echo "leads nowhere: $link"; failed=1; }
done < <(grep -ohE '(href|src)="[^"#:]+["#]' -- *.html | sed 's/^[a-z]*="//; s/.$//' | sort -u)
for page in index md_apps_results md_apps_watch md_apps_faults md_data_README md_servo_conventions; do
  [[ -s $page.html ]] || { echo "the page $page.html is missing"; failed=1; }
done
# Commands that were taken for text.
grep -lE '@(ref|section|code|image) ' -- *.html && { echo "Doxygen garbled these pages"; failed=1; }
grep -q 'A quadrotor with a downward camera' index.html || { echo "README.md is not the main page"; failed=1; }
exit "$failed"
