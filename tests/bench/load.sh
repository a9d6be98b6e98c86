#!/bin/sh
# Forty devices at their real rates on ptys and CAN: whether each sample is out of its driver by its deadline, beside what a bare timer
# and a bare pty took in the same seconds. Ends with PASS or FAIL, and exits with 0 or 1.
# usage: load.sh DRYDOCK [SECONDS] [OPTIONS OF drydock load]
set -eu
drydock=$(realpath "$1")
here=$(cd "$(dirname "$0")" && pwd)
seconds=${2:-600}
shift "$(($# < 2 ? $# : 2))"
# Ahead of whatever else runs, where we may.
ahead=
chrt -f 20 true 2>/dev/null && ahead="chrt -f 20"
# exec: so that Ctrl-C is this program's to end well.
exec $ahead "$drydock" load "$here/../../rig_config/rigs/forty.toml" --for "${seconds}s" "$@"
