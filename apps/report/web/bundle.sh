#!/usr/bin/env bash
# bundle.sh SOURCE TARGET: makes TARGET/page.html, the page of report.html, from the folder SOURCE. The packages that it
# is made from are installed once, and again only when the lock file has changed. Without npm, or when npm cannot reach
# its registry, says so, leaves no page, and ends well: the program is built all the same.
set -euo pipefail
source=$1 target=$2
mkdir -p "$target"
cd "$target"
rm -f page.html

give_up() {
  printf 'report.html will not be written: %s\n' "$*" >&2
  exit 0
}

install() {
  command -v npm >/dev/null || give_up "npm is not installed (Debian package npm)"
  cp "$source/package.json" "$source/package-lock.json" .
  rm -f installed-lock.json
  npm ci --no-audit --no-fund --loglevel=error --fetch-retries=1 --fetch-timeout=60000 >npm.log 2>&1 ||
    give_up "npm could not install its packages; the log is $target/npm.log"
  mv package-lock.json installed-lock.json
}

cmp -s "$source/package-lock.json" installed-lock.json || install
cp "$source/build.mjs" .
node build.mjs "$source" >build.log 2>&1 || { cat build.log >&2; exit 1; }
