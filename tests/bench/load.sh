#!/bin/sh
# Forty devices at their real rates on ptys and CAN. It checks whether each sample leaves its driver
# by its deadline, and compares with a bare timer and a bare pty in the same seconds. Ends with PASS
# or FAIL, and exits with 0 or 1.
# usage: load.sh DRYDOCK [SECONDS] [OPTIONS OF drydock load]
set -eu
drydock=$(realpath "$1")
here=$(cd "$(dirname "$0")" && pwd)
seconds=${2:-600}
shift "$(($# < 2 ? $# : 2))"
# Takes priority over other programs if the user may.
ahead=
chrt -f 20 true 2>/dev/null && ahead="chrt -f 20"
# exec: Ctrl-C must reach this program, so that it ends in order.
exec $ahead "$drydock" load "$here/../../rig_config/rigs/forty.toml" --for "${seconds}s" "$@"
