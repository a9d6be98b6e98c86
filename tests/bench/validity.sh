#!/bin/sh
# Accuracy of the times of measurements on this machine, in real time: every protocol on ptys, each
# baud rate, and an IMU on vcan (in user-mode Linux if this kernel has none). Each table ends with
# the results of a bare timer and a bare pty in the same run; compare the figures with these.
# usage: validity.sh DRYDOCK [SECONDS]
set -eu
drydock=$(realpath "$1")
here=$(cd "$(dirname "$0")" && pwd)
seconds=${2:-20}
# Takes priority over other programs if the user may.
ahead=
chrt -f 20 true 2>/dev/null && ahead="chrt -f 20"

table() { sed -n '/^time of validity/,$p'; }

rig=$here/../../rig_config/rigs/every-protocol.toml
$ahead "$drydock" validity "$rig" --for "${seconds}s" | table
$ahead "$drydock" validity "$rig" --bauds --for "${seconds}s" | sed -n '/^p99 of/,$p'
# User-mode Linux does not run under a real-time policy.
"$here/../vcan/with-vcan.sh" "$drydock" validity "$here/vcan-imu.toml" --for "${seconds}s" |
  sed -n '/^CAN level/p; /^time of validity/,$p' || [ $? = 77 ]
