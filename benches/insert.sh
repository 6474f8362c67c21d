#!/usr/bin/env bash
# Puts what was measured into a document, between `<!-- NAME -->` and `<!-- end -->`, and writes docs/PERFORMANCE.md and
# its charts anew, which sum up these documents.
#
# Usage: insert.sh NAME FILE DOCUMENT
set -euo pipefail
cd "$(dirname "$0")/.."
name=$1 measured=$2 document=$3
if ! grep -qx "<!-- $name -->" "$document"; then
  echo "$document has no region $name" >&2
  exit 1
fi
sed -i -e "/^<!-- $name -->/,/^<!-- end -->/{//!d}" -e "/^<!-- $name -->/r $measured" "$document"
cargo run --quiet -p performance
