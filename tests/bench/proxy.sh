#!/bin/sh
# The latency that an inline proxy adds: between ptys, between slcan adapters, and between two CAN
# interfaces (in user-mode Linux if this kernel has no vcan). Each case is compared with a bare hop
# in the same run.
# usage: proxy.sh FOLDER_OF_PROGRAMS
set -eu
bin=$(realpath "$1")
here=$(cd "$(dirname "$0")" && pwd)
ahead=
chrt -f 20 true 2>/dev/null && ahead="chrt -f 20"
$ahead "$bin/proxy_bench"
# User-mode Linux does not run under a real-time policy.
# shellcheck disable=SC2016
"$here/../vcan/with-vcan.sh" sh -eu -c '
trap "for name in benchcan0 benchcan1 benchcan2; do ip link del \$name 2>/dev/null || true; done" EXIT
for name in benchcan0 benchcan1 benchcan2; do
  ip link add dev $name type vcan
  ip link set $name up
done
"$0" benchcan0 benchcan1 benchcan2' "$bin/proxy_can_bench" || [ $? = 77 ]
