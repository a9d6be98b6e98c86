#!/usr/bin/env bash
# Makes the pictures of the pages anew: pictures.sh DRYDOCK. The demo rig runs for 50 s; from 15 s to 25 s its DVL hangs.
set -euo pipefail
cd "$(dirname "$0")/../.."
drydock=$1
folder=$(mktemp -d)
export XDG_RUNTIME_DIR=$folder NODE_PATH=$PWD/build/npm/node_modules
trap 'kill "${run:-}" 2>/dev/null || true; rm -rf "$folder"' EXIT

printf '[[fault]]\ndevice = "dvl"\nfault = "hang"\nstart_s = 15\nfor_s = 10\n' >"$folder/hang.toml"
shot() { node tests/docs/shot.cjs "$(command -v chromium)" "$@"; }

"$drydock" run rig_config/rigs/demo.toml --for 60s --speed max --faults "$folder/hang.toml" --report "$folder" >/dev/null
shot "file://$folder/index.html" docs/use/report.png 1100 1150 "Estimator leveling"

: >"$folder/run.txt"
"$drydock" run rig_config/rigs/demo.toml --for 80s --faults "$folder/hang.toml" --serve 0 >"$folder/run.txt" &
run=$!
until url=$(sed -n 's/^live: //p' "$folder/run.txt") && [ -n "$url" ]; do sleep 0.2; done
sleep 50  # the page shows the past, too
shot "$url" docs/use/live.png 1100 1150 streaming
