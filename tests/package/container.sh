#!/usr/bin/env bash
# Builds the container file of .packaging/debian around the packages with buildah, which needs no daemon, and runs the program in
# it. The base image is made here by debootstrap, so that only a mirror of Debian is needed.
# usage: container.sh PACKAGE.deb...    Needs root, for debootstrap.
set -euo pipefail
here=$(cd "$(dirname "$0")/../.." && pwd)
[ "$(id -u)" = 0 ] || { echo "container-test: needs root, for debootstrap" >&2; exit 1; }
missing=$(for p in buildah debootstrap; do command -v "$p" >/dev/null || echo "$p"; done)
[ -z "$missing" ] || { echo "container-test: these programs are missing: $missing (apt-get install buildah debootstrap)" >&2; exit 1; }

work=$(mktemp -d /var/tmp/drydock-container-XXXXXX)
# Storage of its own: images of this machine are neither seen nor touched. The driver vfs needs no kernel module.
builder() { buildah --root "$work/storage" --runroot "$work/run" --storage-driver vfs "$@"; }
undo() {
  builder rm --all >/dev/null 2>&1 || true
  if grep -q " $work/" /proc/self/mounts; then
    echo "container-test: something is still mounted in $work, which stays" >&2
  else
    rm -rf --one-file-system "$work"
  fi
}
trap undo EXIT
step() { echo "container-test: $*"; }

mirror() { # the first source of Debian that apt on this machine reads, else Debian's own
  awk '/^URIs:/ {print $2; exit}' /etc/apt/sources.list.d/*.sources 2>/dev/null | grep . ||
    awk '$1 == "deb" {print $2; exit}' /etc/apt/sources.list 2>/dev/null | grep . || echo http://deb.debian.org/debian
}

step "a base image of Debian 12 ($(buildah --version))"
mkdir "$work/base" "$work/context"
chmod 755 "$work" "$work/base" # for the user _apt
debootstrap --variant=minbase --include=ca-certificates bookworm "$work/base" "$(mirror)" >"$work/log" 2>&1 || { tail -3 "$work/log"; exit 1; }
cp -r /etc/apt/apt.conf.d/. "$work/base/etc/apt/apt.conf.d/" 2>/dev/null || true
base=$(builder from scratch)
builder copy --quiet "$base" "$work/base" / >/dev/null
builder commit --quiet "$base" localhost/debian:12-slim >/dev/null
rm -rf --one-file-system "$work/base"

step "buildah build with .packaging/debian/Containerfile"
cp "$@" "$work/context"
builder build --isolation chroot --network host --from localhost/debian:12-slim --tag rig --quiet \
  --file "$here/.packaging/debian/Containerfile" "$work/context" >"$work/log" 2>&1 || { tail -5 "$work/log"; exit 1; }
rig=$(builder from --pull-never localhost/rig)
inside() { builder run --isolation chroot --network host "$rig" -- "$@"; }

step "$(inside drydock --version) in the container"
step "drydock run demo.toml --for 10s --speed max"
inside sh -c 'cd /tmp && drydock run demo.toml --for 10s --speed max' | tail -1
step "drydock run demo --for 5s --expect-streaming, in real time"
inside sh -c 'cd /tmp && drydock run demo --for 5s --expect-streaming' >"$work/log" 2>&1 || { tail -20 "$work/log"; exit 1; }
step "passed"
