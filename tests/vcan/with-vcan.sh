#!/bin/sh
# Runs a command with a CAN interface and gives it the interface's name in DRYDOCK_CAN:
#  1. the interface that DRYDOCK_CAN names already (real hardware, two nodes on a terminated bus);
#  2. vcan0 of this machine's kernel, made if the process may;
#  3. vcan0 of a user-mode Linux kernel that is booted around the command, with this machine's
#     files as its root (Debian: user-mode-linux, busybox-static, iproute2);
#  4. none: exit status 77 (skipped), or 1 if CI=true.
# usage: with-vcan.sh COMMAND [ARGUMENT...]     exit status of the command
#        with-vcan.sh --level                   prints which of the four it would use
# DRYDOCK_VCAN_TIMEOUT: time limit of user-mode Linux and the command together, seconds (110).
# DRYDOCK_UML_REGISTERS: the library built from uml_registers.c, for newer processors (default: that
# of build/release).
set -eu

can_type=280 # ARPHRD_CAN
limit=${DRYDOCK_VCAN_TIMEOUT:-110}

is_can() { [ "$(cat "/sys/class/net/$1/type" 2>/dev/null)" = "$can_type" ]; }
is_up() { [ $(($(cat "/sys/class/net/$1/flags" 2>/dev/null || echo 0) & 1)) = 1 ]; }

have_host_vcan() {
  is_can vcan0 || ip link add dev vcan0 type vcan 2>/dev/null || return 1
  is_up vcan0 || ip link set vcan0 mtu 72 up 2>/dev/null
}

uml_modules() { echo "/usr/lib/uml/modules/$(linux.uml --version)/kernel"; }

have_uml() {
  for tool in linux.uml busybox ip timeout; do command -v $tool >/dev/null || return 1; done
  [ -f "$(uml_modules)/drivers/net/can/vcan.ko" ]
}

find_place() {
  if [ -n "${DRYDOCK_CAN:-}" ]; then
    is_can "$DRYDOCK_CAN" || { echo "DRYDOCK_CAN=$DRYDOCK_CAN is no CAN interface of this machine" >&2; exit 1; }
    place=here level="interface $DRYDOCK_CAN (DRYDOCK_CAN)"
  elif have_host_vcan; then
    place=here level="vcan0 of this machine's kernel"
    export DRYDOCK_CAN=vcan0
  elif have_uml; then
    place=uml level="vcan in user-mode-linux (kernel $(linux.uml --version))"
    export DRYDOCK_CAN=vcan0
  else
    place=none level="none (neither a CAN interface, nor vcan, nor user-mode-linux)"
  fi
}

# Quotes an argument as one word of a shell.
quoted() { printf "'%s' " "$(printf %s "$1" | sed "s/'/'\\\\''/g")"; }

# The guest's first process: sets up the machine, runs the command, and writes its exit status to a
# file.
write_init() {
  modules=$(uml_modules)
  cat >"$work/init" <<INIT
#!/bin/sh
mount -t proc proc /proc
mount -t sysfs sys /sys
mount -t devtmpfs dev /dev 2>/dev/null
mkdir -p /dev/pts /dev/shm
[ -e /dev/fd ] || ln -s /proc/self/fd /dev/fd
mount -t devpts -o ptmxmode=666 devpts /dev/pts
mount -t tmpfs shm /dev/shm
mount -t tmpfs run /run
for module in net/can/can net/can/can-raw net/can/j1939/can-j1939 \
  drivers/net/can/dev/can-dev drivers/net/can/vcan drivers/net/can/slcan/slcan; do
  busybox insmod $modules/\$module.ko
done
ip link set lo up
ip link add dev vcan0 type vcan && ip link set vcan0 mtu 72 up && sh "$work/command" >"$work/output" 2>&1
echo \$? >"$work/status"
sync
busybox poweroff -f
INIT
  {
    export -p
    printf 'unset XDG_RUNTIME_DIR\ncd '
    quoted "$PWD"
    printf '\n'
    for argument in "$@"; do quoted "$argument"; done
    printf '\n'
  } >"$work/command"
  chmod +x "$work/init"
}

# The guest's memory is a sparse file. It is in /dev/shm if there is room, otherwise in the work
# folder.
memory_folder() {
  free_kib=$(df -Pk /dev/shm 2>/dev/null | awk 'NR == 2 { print $4 }')
  if [ "${free_kib:-0}" -gt 1500000 ] && [ -w /dev/shm ]; then echo /dev/shm; else echo "$work"; fi
}

run_in_uml() {
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
  write_init "$@"
  registers=${DRYDOCK_UML_REGISTERS:-$(dirname "$0")/../../build/release/tests/vcan/libuml_registers.so}
  [ -f "$registers" ] || registers=
  timed_out=0
  HOME=$work TMPDIR=$(memory_folder) timeout -k 5 "$limit" \
    env LD_PRELOAD="$registers" linux.uml umid="drydock-$$" uml_dir="$work/" \
    root=/dev/root rootfstype=hostfs rootflags=/ rw init="$work/init" \
    mem=1G con=null con0=fd:0,fd:1 quiet </dev/null >"$work/console" 2>&1 || timed_out=$?
  cat "$work/output" 2>/dev/null || true
  status=$(cat "$work/status" 2>/dev/null || true)
  [ -n "$status" ] && exit "$status"
  if [ "$timed_out" = 124 ] || [ "$timed_out" = 137 ]; then
    echo "user-mode Linux did not end within $limit s (DRYDOCK_VCAN_TIMEOUT)" >&2
  else
    echo "user-mode Linux ended without running the command" >&2
  fi
  echo "its console:" >&2
  cat "$work/console" >&2
  exit 1
}

find_place
if [ "${1:-}" = --level ]; then
  echo "$level"
  exit
fi
[ $# -gt 0 ] || { sed -n '2,12s/^# \{0,1\}//p' "$0" >&2; exit 2; }
echo "CAN level: $level"
case $place in
  here) exec "$@" ;;
  uml) run_in_uml "$@" ;;
  none) [ "${CI:-}" = true ] && exit 1; exit 77 ;;
esac
