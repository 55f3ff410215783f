#!/usr/bin/env bash
# browser_test.sh PROGRAM WEB: opens reports that PROGRAM writes in a headless Chromium. WEB is the folder in which the page
# of the report was built, with its packages. Ends with 77, skipped, where a tool is absent, and says which.
set -euo pipefail
program=$1 web=$2

skip() {
  printf 'SKIPPED, NOT TESTED: the report in a browser: %s\n' "$*" >&2
  exit 77
}

command -v node >/dev/null || skip "node is not installed (Debian package npm)"
[[ -f $web/page.html ]] || skip "the page was not built ($web)"
[[ -d $web/node_modules/playwright-core ]] || skip "playwright-core is not installed in $web"
chromium=
for name in chromium-headless-shell chromium google-chrome; do
  [[ -z $chromium ]] && chromium=$(command -v "$name" || true)
done
[[ -n $chromium ]] || skip "no Chromium (Debian package chromium-headless-shell)"

# Modules are looked for beside the file that asks for them.
cp "$(dirname "${BASH_SOURCE[0]}")/browser_test.mjs" "$web/"
exec node "$web/browser_test.mjs" "$program" "$chromium"
