#!/usr/bin/env bash
# Compares drydock decode with gpsdecode (Debian's gpsd-clients), and on NMEA 2000 with canboat's analyzer and canboatjs, in turn: the
# same input bytes, JSON Lines to /dev/null. A peer that is not installed is said to be missing.
# usage: decode_peers.sh DRYDOCK
set -euo pipefail
drydock=$1
fixtures=$(dirname "$(readlink -f "$0")")/../../fixtures
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

repeated() { # FILE BYTES: repeats a capture to at least that size, a multiple of eight times
  local all=$work/all times=1
  cp "$1" "$all"
  for (( ; times < 8 || $(stat -c %s "$all") < $2; times *= 2)); do
    cat "$all" "$all" >"$all.2" && mv "$all.2" "$all"
  done
  mv "$all" "$work/input"
}

seconds_of() { # COMMAND...: the least processor time of five runs, which other load hardly changes
  local TIMEFORMAT='%U %S' run
  for run in 1 2 3 4 5; do
    { time "$@" <"$work/input" >/dev/null 2>&1; } 2>&1
  done | awk 'NR == 1 || $1 + $2 < best { best = $1 + $2 } END { print best }'
}

compare() { # NAME PROTOCOL FILE
  repeated "$3" 10000000
  local bytes ours our_text theirs their_text
  bytes=$(stat -c %s "$work/input")
  ours=$(seconds_of "$drydock" decode --quiet --protocol "$2")
  our_text=$("$drydock" decode --quiet --protocol "$2" <"$work/input" | wc -c)
  head -c $((bytes / 8)) "$work/input" >"$work/part" && mv "$work/part" "$work/input"
  theirs=$(seconds_of gpsdecode -j)
  their_text=$(gpsdecode -j <"$work/input" | wc -c)
  awk -v name="$1" -v b="$bytes" -v o="$ours" -v ot="$our_text" -v t="$theirs" -v tt="$their_text" 'BEGIN {
    ours = b / o / 1e6; theirs = b / 8 / t / 1e6
    printf "%-10s %7.1f MB/s   gpsdecode -j %5.1f MB/s   ratio %4.1f (goal 10)   text written %6.1f and %5.1f MB/s\n",
      name, ours, theirs, ours / theirs, ot / o / 1e6, tt / t / 1e6 }'
}

echo "decode, file in, JSON Lines out (receivers: all captures with UBX of gpsd's own tests):"
compare "NMEA 0183" nmea0183 "$fixtures/nmea0183/golden.nmea"
compare UBX ubx "$fixtures/ubx/golden.ubx"
corpora=${DRYDOCK_CORPORA:-$fixtures/../../shared/corpora}
if [ -d "$corpora/gps/gpsd" ]; then
  grep -rlaP --include='*.log' '\xb5\x62' "$corpora/gps/gpsd" | sort | xargs cat >"$work/receivers"
  compare "receivers" ubx+nmea0183 "$work/receivers"
fi

repeated "$fixtures/nmea2000/frames.log" 50000000
frames=$(wc -l <"$work/input")
awk -v f="$frames" -v s="$(seconds_of "$drydock" decode --quiet --protocol nmea2000)" 'BEGIN {
  printf "%-10s %7.2f million candump lines a second\n", "NMEA 2000", f / s / 1e6 }'

# Messages of one frame that all three decode, of canboat's captures in canboat's own format: each line is one message.
both_decode="127245 127250 127251 127252 127257 128259 129025 129026"
lines_of_both() {
  awk -F, -v wanted="$both_decode" 'BEGIN { n = split(wanted, pgns, " "); for (i = 1; i <= n; ++i) both[pgns[i]] }
    $3 in both && $6 == 8' "$corpora/n2k/canboat/samples/furuno-130842-figure8-fast.head.raw"
}

beside_canboat() { # NAME GOAL COMMAND...: messages a second, counted in what each of the two writes
  local name=$1 goal=$2 bytes lines theirs ours our_messages their_messages
  shift 2
  bytes=$(stat -c %s "$work/input") lines=$(wc -l <"$work/input")
  ours=$(seconds_of "$drydock" decode --quiet --protocol nmea2000)
  our_messages=$("$drydock" decode --quiet --protocol nmea2000 <"$work/input" | wc -l)
  head -n $((lines / 8)) "$work/input" >"$work/part" && mv "$work/input" "$work/whole" && mv "$work/part" "$work/input"
  theirs=$(seconds_of "$@")
  their_messages=$("$@" <"$work/input" 2>/dev/null | grep -c '"pgn"')
  mv "$work/whole" "$work/input"
  awk -v name="$name" -v goal="$goal" -v n="$lines" -v on="$our_messages" -v o="$ours" -v tn="$their_messages" -v t="$theirs" 'BEGIN {
    if (on != n || tn != int(n / 8)) { printf "%-10s decodes %d of %d messages, and we %d of %d\n", name, tn, n / 8, on, n; exit 1 }
    printf "%-10s %7.2f million messages a second   %s %6.3f million   ratio %5.1f (goal %d)\n",
      "NMEA 2000", n / o / 1e6, name, tn / t / 1e6, (n / o) / (tn / t), goal }'
}

npm=$fixtures/../build/npm/node_modules
if [ ! -d "$corpora/n2k/canboat" ]; then
  echo "NMEA 2000  beside canboat: no captures"
else
  lines_of_both >"$work/both"
  repeated "$work/both" 10000000
  if command -v analyzer >/dev/null; then
    beside_canboat "analyzer" 5 analyzer -json -q
  else
    echo "NMEA 2000  beside canboat's analyzer: not installed, and Debian has no package of it"
  fi
  if [ -d "$npm/@canboat/canboatjs" ] && command -v node >/dev/null; then
    export NODE_PATH=$npm
    beside_canboat "canboatjs" 5 node "$(dirname "$(readlink -f "$0")")/canboatjs.cjs"
  else
    echo "NMEA 2000  beside canboatjs: not installed, ./rig bench installs it"
  fi
fi
