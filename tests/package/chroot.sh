#!/usr/bin/env bash
# Installs the packages into a fresh Debian 12, tries the program there, looks at them with lintian, removes them.
# usage: chroot.sh PACKAGE.deb...    Needs root, debootstrap and this machine's own apt sources.
set -euo pipefail
[ "$(id -u)" = 0 ] || { echo "package-test: needs root, for chroot" >&2; exit 1; }
command -v debootstrap >/dev/null || { apt-get update -qq && apt-get install -y -qq --no-install-recommends debootstrap >/dev/null; }

root=$(mktemp -d /var/tmp/drydock-chroot-XXXXXX)
chmod 755 "$root"  # for the user _apt
undo() {
  for m in dev/shm dev/pts dev sys proc; do ! mountpoint -q "$root/$m" || umount -l "$root/$m"; done
  mountpoint -q "$root/proc" || rm -rf --one-file-system "$root"
}
trap undo EXIT

mirror() { # the first source of Debian that apt on this machine reads, else Debian's own
  awk '/^URIs:/ {print $2; exit}' /etc/apt/sources.list.d/*.sources 2>/dev/null | grep . ||
    awk '$1 == "deb" {print $2; exit}' /etc/apt/sources.list 2>/dev/null | grep . || echo http://deb.debian.org/debian
}

inside() { chroot "$root" /usr/bin/env -i HOME=/root TERM=dumb PATH=/usr/sbin:/usr/bin:/sbin:/bin DEBIAN_FRONTEND=noninteractive LC_ALL=C "$@"; }
step() { echo "package-test: $*"; }
failed() { echo "package-test: FAILED: $*" >&2; exit 1; }
# The files of the system, but not what apt and dpkg keep for themselves.
files() { inside find / -xdev \( -path /proc -o -path /sys -o -path /dev -o -path /tmp -o -path /var/cache -o -path /var/lib/apt -o -path /var/lib/dpkg -o -path /var/log \) -prune -o -print | sort; }

step "a fresh Debian 12"
debootstrap --variant=minbase --include=ca-certificates bookworm "$root" "$(mirror)" >"$root.log" 2>&1 || { tail -3 "$root.log"; exit 1; }
rm -f "$root.log"
cp -r /etc/apt/apt.conf.d/. "$root/etc/apt/apt.conf.d/" 2>/dev/null || true
if ls /etc/apt/sources.list.d/*.sources >/dev/null 2>&1; then
  rm -f "$root/etc/apt/sources.list"
  cp /etc/apt/sources.list.d/*.sources "$root/etc/apt/sources.list.d/"
fi
cp /etc/resolv.conf /etc/hosts "$root/etc/" 2>/dev/null || true
for m in proc sys dev dev/pts dev/shm; do mount --bind "/$m" "$root/$m"; done
mkdir "$root/tmp/packages"
cp "$@" "$root/tmp/packages"
names=$(for p in "$@"; do dpkg-deb -f "$p" Package; done)
inside apt-get update -qq
# The libraries of others stay when the package goes, so they come first.
needs=$(for p in "$@"; do dpkg-deb -f "$p" Depends; done | sed 's/([^)]*)//g; s/,/\n/g' | awk '{print $1}' | sort -u)
# shellcheck disable=SC2086
inside apt-get install -y -qq --no-install-recommends $needs >/dev/null
files >"$root/tmp/before"

step "install: $(du -h --apparent-size -c "$@" | tail -1 | cut -f1) in packages"
inside sh -c 'apt-get install -y -qq --no-install-recommends /tmp/packages/*.deb >/dev/null'
step "$(inside drydock --version), without a source tree"

step "drydock run demo.toml --for 10s --speed max"
inside sh -c 'cd /tmp && drydock run demo.toml --for 10s --speed max' | tail -1 | grep -q 'expectations met' || failed "the demo rig"
inside sh -c 'cd /tmp && drydock run demo --for 5s --expect-streaming' >"$root/tmp/run" 2>&1 || { tail -20 "$root/tmp/run"; failed "the demo rig in real time"; }
step "drydock study mixing --runs 5"
inside sh -c 'cd /tmp && drydock study mixing --runs 5' >/dev/null || failed "the study"
step "import drydock: ten seconds of a rig with an estimator in Python"
inside python3 -c '
import drydock
run = drydock.run("demo", 10, estimators={"mine": lambda step: {"valid_at_ns": step.now_ns - 1, "roll_deg": 0, "pitch_deg": 0}})
assert len(run.measurements["imu"]["imu"]["valid_at_ns"]) > 990 and len(run.estimates["mine"]["roll_deg"]) > 190' || failed "the Python module"
step "programs of others, built with the packages alone"
mkdir "$root/tmp/source"
cp -r --parents tests/consumers fixtures/pd0 rig_config "$root/tmp/source"
inside apt-get install -y -qq --no-install-recommends g++ cmake ninja-build pkg-config libgtest-dev >/dev/null
inside python3 -B /tmp/source/tests/consumers/run.py /usr /usr/bin/drydock /tmp/source || failed "a consumer"
step "every shipped file passes drydock check"
inside sh -c 'cd /usr/share/drydock/rig_config && drydock check rigs/*.toml missions/*.toml sensors/*.toml vehicles/*.toml devices/*.toml' | grep -v ': ok$' && failed "a shipped file"
step "manual page, completions, units, rules"
for f in man/man1/drydock.1.gz bash-completion/completions/drydock zsh/vendor-completions/_drydock; do
  [ -s "$root/usr/share/$f" ] || failed "/usr/share/$f"
done
bash -n "$root/usr/share/bash-completion/completions/drydock" || failed "the completion of bash"
inside apt-get install -y -qq --no-install-recommends systemd udev lintian >/dev/null 2>&1
inside systemd-analyze verify --man=no /usr/lib/systemd/system/drydock-record@.service /usr/lib/systemd/system/drydock-drive@.service 2>&1 | grep -i drydock && failed "a unit"
step "hardening: $(inside systemd-analyze security --offline=yes /usr/lib/systemd/system/drydock-record@.service 2>/dev/null | tail -1 | sed 's/^[^A-Za-z]*//')"
step "lintian"
inside sh -c 'lintian --allow-root --fail-on error --display-level ">=warning" /tmp/packages/*.deb' || failed "lintian"

step "removal"
# shellcheck disable=SC2086
inside apt-get purge -y -qq $names >/dev/null
files >"$root/tmp/after"
left=$(comm -13 "$root/tmp/before" "$root/tmp/after" | grep -i drydock || true)
[ -z "$left" ] || failed "left behind: $left"
step "passed"
