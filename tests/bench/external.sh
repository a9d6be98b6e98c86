#!/usr/bin/env bash
# The demo rig in lockstep with an estimator in another program: one line each way, a step.
# usage: external.sh DRYDOCK LEVELING_CLIENT
set -euo pipefail
drydock=$(readlink -f "$1") client=$(readlink -f "$2")
rigs=$(readlink -f "$(dirname "$0")/../../rig_config/rigs")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
sed "s#\"\.\./#\"$rigs/../#" "$rigs/demo.toml" >"$folder/rig.toml"
cat >>"$folder/rig.toml" <<T

[[estimator]]
name = "mine"
kind = "external"
imu = "imu"
gives = "attitude"
command = ["$client"]
T
"$drydock" run "$folder/rig.toml" --speed max --for 600s --json "$folder/run.json" >/dev/null
python3 - "$folder/run.json" <<'P'
import json, sys
run = json.load(open(sys.argv[1]))
program = run["estimators"][-1]["program"]
print(f"demo rig in step with another program, {run['duration_s']:.0f} s: {run['times_real_time']:.0f} times real time (goal 200); "
      f"{program['answers']} answers, {program['mean_s'] * 1e6:.0f} us each, {program['longest_s'] * 1e3:.1f} ms the longest")
P
