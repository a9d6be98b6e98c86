#!/usr/bin/env bash
# The 5.5 h mission in lockstep: every byte is generated, sent at the rate of its line, and decoded.
# Reports speed and memory.
# usage: lockstep.sh DRYDOCK REPORT_FOLDER
set -euo pipefail
drydock=$1 folder=$2
rig=$(dirname "$(readlink -f "$0")")/../../rig_config/rigs/velocity-paper.toml
mkdir -p "$folder"
"$drydock" run "$rig" --speed max --json "$folder/lockstep.json" --report "$folder" >/dev/null
python3 - "$folder/lockstep.json" <<'P'
import json, sys
run = json.load(open(sys.argv[1]))
resident = run["resident"]
print(f"lockstep, {run['duration_s'] / 3600:.1f} h through wire bytes and drivers: {run['wall_s']:.1f} s, "
      f"{run['times_real_time']:.0f} times real time (goal 4000); "
      f"{sum(d['messages'] for d in run['devices']) / 1e6:.1f} million measurements; "
      f"resident {resident['start_mb']:.1f} MB at first, {resident['end_mb']:.1f} MB at the end")
P
echo "  the plot of resident memory: $folder/index.html, its last figure"
