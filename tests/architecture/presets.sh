#!/usr/bin/env bash
# The presets that no usual build touches can be configured: presets.sh FOLDER, which is emptied.
set -euo pipefail
cd "$(dirname "$0")/../.."
for preset in asan tsan; do
  rm -rf "$1"
  cmake --preset "$preset" -B "$1" >"$1.log" 2>&1 || { echo "$preset cannot be configured:"; grep -A5 Error "$1.log"; exit 1; }
done
rm -rf "$1"
