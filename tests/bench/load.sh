#!/bin/sh
# Forty devices at their real rates on ptys and CAN: how late they are, beside what a bare timer and a bare pty took in the same run.
# usage: load.sh DRYDOCK [SECONDS]
set -eu
drydock=$(realpath "$1")
here=$(cd "$(dirname "$0")" && pwd)
ahead=
chrt -f 20 true 2>/dev/null && ahead="chrt -f 20"
$ahead "$drydock" validity "$here/../../rig_config/rigs/forty.toml" --for "${2:-600}s" | sed -n '/^time of validity/,$p'
