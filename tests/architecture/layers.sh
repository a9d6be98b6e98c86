#!/usr/bin/env bash
# The arrows of docs/architecture.md, read from the #include lines: each room may include only the rooms named here.
set -euo pipefail
cd "$(dirname "$0")/../.."
failed=0

# A room, then the rooms that it may include besides itself, or a single header of a room (drivers/measurement/kind).
# A room inside a room (hil/study/run) has a line of its own.
arrows='
drivers/measurement
drivers/wire               drivers/measurement/units drivers/measurement/kind drivers/measurement/sound_speed
drivers/io                 drivers/measurement drivers/terminal
drivers/terminal
drivers/capture            drivers/wire
drivers/device             drivers/wire drivers/measurement
drivers/survey             drivers/device drivers/wire drivers/measurement
drivers/guess              drivers/wire
drivers/diagnosis          drivers/device drivers/wire drivers/measurement rig_config/fault_vocabulary
drivers/link               drivers/io drivers/capture drivers/wire drivers/measurement
drivers/shell              drivers/device drivers/link drivers/io drivers/capture drivers/wire drivers/measurement rig_config
drivers/bus                drivers/measurement
drivers/live               drivers/bus drivers/io drivers/measurement
drivers/recordings/mcap
drivers/recordings/record  drivers/recordings/mcap drivers/bus drivers/shell drivers/capture/steady_times drivers/wire drivers/measurement rig_config
drivers/recordings/export  drivers/recordings/record drivers/wire drivers/measurement
drivers/recordings/slice   drivers/recordings/record drivers/recordings/mcap drivers/device drivers/wire drivers/measurement rig_config
drivers/recordings/tasks   rig_config drivers/recordings/record drivers/recordings/mcap drivers/recordings/export drivers/recordings/slice drivers/text drivers/terminal
drivers/process
drivers/text               drivers/wire drivers/measurement
drivers/decode             drivers/text drivers/shell drivers/device drivers/link drivers/io drivers/terminal drivers/capture drivers/wire drivers/measurement
drivers/doctor             drivers/terminal drivers/text drivers/link drivers/io drivers/wire rig_config
drivers/host               drivers/diagnosis drivers/shell drivers/device drivers/bus drivers/live drivers/recordings/record drivers/link drivers/io drivers/terminal drivers/wire drivers/measurement rig_config
drivers/probe              drivers/survey drivers/guess drivers/shell drivers/device drivers/doctor drivers/text drivers/link drivers/io drivers/terminal drivers/capture drivers/wire drivers/measurement rig_config/device_description/load_description
drivers/monitor            drivers/survey drivers/doctor drivers/diagnosis drivers/host drivers/probe drivers/decode drivers/text drivers/shell drivers/device drivers/bus drivers/link drivers/io drivers/terminal drivers/wire drivers/measurement rig_config
estimators/lanes
estimators/frame           estimators/lanes drivers/measurement
estimators/navigation      estimators/lanes estimators/frame
estimators/smoothing        estimators/navigation estimators/frame
estimators/calibration      estimators/smoothing estimators/frame
estimators/leveling        estimators/navigation estimators/frame drivers/measurement
estimators/mixing          estimators/frame
estimators/roll            estimators/frame drivers/measurement
estimators/hydrodynamics   estimators/lanes estimators/frame
estimators/vehicle         estimators/hydrodynamics rig_config
estimators/velocity        estimators/lanes estimators/navigation estimators/hydrodynamics estimators/frame
estimators/pipeline        estimators/leveling estimators/mixing estimators/roll estimators/velocity estimators/navigation estimators/hydrodynamics estimators/frame drivers/measurement
estimators/consistency     estimators/frame drivers/diagnosis drivers/measurement
estimators/external        estimators/pipeline estimators/frame drivers/bus drivers/process drivers/text drivers/measurement rig_config/estimator/external
estimators/setup           estimators/external estimators/pipeline estimators/leveling drivers/bus estimators/vehicle estimators/frame drivers/measurement rig_config
estimators/host            drivers/diagnosis estimators/consistency estimators/setup estimators/pipeline estimators/frame drivers/host drivers/bus drivers/link drivers/io drivers/terminal drivers/measurement rig_config
rig_config                 drivers/wire/protocols drivers/wire/hex drivers/wire/packed_content drivers/wire/described/description drivers/wire/described/frame_plan drivers/wire/dbc/database drivers/wire/dbc/reader drivers/wire/dbc/same_frame drivers/wire/described/plan drivers/wire/described/targets drivers/wire/described/crc_line drivers/wire/described/read_back drivers/measurement/units drivers/measurement/kind drivers/measurement/sound_speed drivers/measurement/actuator_order
hil/report
hil/ocean                  estimators/frame drivers/measurement rig_config
hil/motion                 hil/ocean estimators/frame estimators/hydrodynamics estimators/vehicle drivers/measurement rig_config
hil/steer                  hil/motion estimators/frame drivers/wire drivers/measurement rig_config
hil/steer/real_time        hil/steer hil/motion drivers/bus drivers/link drivers/io drivers/wire drivers/measurement rig_config
hil/steer/program          hil/steer hil/motion estimators/external estimators/pipeline drivers/text drivers/measurement rig_config
hil/pilot                  hil/motion estimators/frame drivers/device drivers/wire drivers/measurement rig_config
hil/pilot/real_time        hil/pilot drivers/host drivers/link drivers/io drivers/wire drivers/measurement rig_config
hil/sensor                 hil/motion estimators/frame drivers/measurement rig_config
hil/sky                    hil/sensor estimators/frame drivers/measurement rig_config
hil/study                  hil/report hil/sky hil/sensor hil/motion estimators/[a-z]* drivers/measurement rig_config
hil/study/run              hil/study hil/report drivers/text drivers/terminal rig_config
hil/emulate                hil/sky hil/sensor hil/motion estimators/frame drivers/shell drivers/device/timed_framer drivers/wire drivers/measurement rig_config
hil/emulate/real_time      hil/emulate drivers/link drivers/io drivers/wire drivers/measurement
hil/fault                  hil/emulate hil/sensor hil/motion drivers/link drivers/wire drivers/measurement rig_config
hil/proxy                  hil/fault drivers/device drivers/link drivers/io drivers/text drivers/terminal drivers/wire drivers/measurement rig_config
hil/bridge                 hil/proxy drivers/host drivers/shell drivers/device drivers/link drivers/io drivers/text drivers/terminal drivers/wire drivers/measurement rig_config
hil/characterize           estimators/frame drivers/measurement rig_config
hil/characterize/report    hil/characterize hil/bench hil/check hil/report hil/study hil/sensor drivers/decode drivers/recordings/record drivers/bus drivers/link drivers/text drivers/terminal drivers/measurement rig_config
hil/validity               hil/emulate drivers/measurement
hil/validity/run           hil/validity hil/bench hil/summary hil/report hil/emulate drivers/link drivers/io drivers/text drivers/terminal drivers/measurement rig_config
hil/summary                hil/pilot/loop_account drivers/bus/device drivers/diagnosis hil/report hil/motion estimators/pipeline estimators/frame drivers/host drivers/device drivers/link drivers/measurement rig_config drivers/text
hil/control/request        drivers/live drivers/terminal
hil/control                hil/control/request hil/fault hil/summary drivers/host drivers/bus drivers/live drivers/link drivers/io drivers/terminal rig_config
hil/bench                  hil/pilot hil/pilot/real_time drivers/diagnosis hil/control hil/summary hil/report hil/fault hil/emulate hil/emulate/real_time hil/steer hil/steer/program hil/steer/real_time hil/motion estimators/host estimators/setup estimators/pipeline estimators/frame drivers/host drivers/monitor drivers/bus drivers/shell drivers/device drivers/link drivers/io drivers/terminal drivers/measurement rig_config
hil/check                  hil/pilot hil/fault hil/emulate hil/motion hil/ocean estimators/setup estimators/pipeline estimators/vehicle estimators/hydrodynamics drivers/shell drivers/link drivers/text drivers/terminal drivers/wire/described/read_back drivers/wire/dbc/reader drivers/measurement rig_config
hil/replay/reference       drivers/recordings/record drivers/bus drivers/text
hil/replay/rigs            drivers/decode drivers/shell drivers/capture drivers/wire/protocols drivers/wire/can/candump drivers/host drivers/recordings/record drivers/text drivers/link drivers/terminal drivers/measurement rig_config
hil/replay                 drivers/diagnosis hil/replay/rigs drivers/decode drivers/shell hil/report hil/replay/reference hil/bench hil/motion hil/summary hil/fault estimators/host estimators/setup estimators/pipeline estimators/frame drivers/host drivers/device drivers/recordings/record drivers/text drivers/bus drivers/link drivers/io drivers/terminal drivers/measurement rig_config
hil/diff                   hil/replay hil/summary hil/report drivers/text drivers/terminal rig_config
hil/diagnose               drivers/diagnosis hil/replay hil/replay/rigs hil/summary hil/report estimators/host drivers/monitor drivers/probe drivers/host drivers/shell drivers/device drivers/recordings/record drivers/link drivers/io drivers/text drivers/terminal drivers/wire/protocols drivers/measurement rig_config
hil/score                  hil/replay hil/replay/reference estimators/frame drivers/recordings/record drivers/recordings/mcap drivers/host drivers/text drivers/terminal drivers/measurement rig_config
hil/track                  hil/replay hil/replay/rigs hil/report estimators/smoothing estimators/setup estimators/pipeline estimators/navigation estimators/frame drivers/host drivers/shell drivers/decode drivers/recordings/record drivers/link drivers/io drivers/text drivers/terminal drivers/measurement rig_config
hil/calibrate              hil/track hil/report estimators/calibration estimators/smoothing estimators/frame drivers/text drivers/terminal drivers/measurement rig_config
hil/compare                drivers/diagnosis hil/track hil/replay hil/replay/rigs hil/bench hil/summary hil/report hil/motion estimators/host estimators/setup estimators/pipeline estimators/frame drivers/decode drivers/host drivers/recordings/record drivers/io drivers/text drivers/terminal drivers/measurement rig_config
hil/twin                   hil/track hil/replay hil/replay/rigs hil/characterize hil/bench hil/check hil/report hil/motion hil/ocean hil/sensor estimators/smoothing estimators/frame drivers/recordings/record drivers/host drivers/link drivers/text drivers/terminal drivers/wire/protocols drivers/measurement rig_config
hil/scorecard              drivers/diagnosis estimators/host hil/bench hil/summary hil/study hil/study/run hil/report hil/motion estimators/pipeline estimators/frame drivers/device drivers/link drivers/terminal drivers/measurement rig_config
hil/endurance              drivers/diagnosis hil/motion hil/bench hil/summary hil/validity hil/validity/run hil/report hil/fault drivers/text drivers/link drivers/terminal rig_config
hil/info                   drivers/recordings/record drivers/recordings/mcap drivers/bus drivers/capture drivers/link drivers/probe drivers/survey drivers/text drivers/terminal drivers/measurement rig_config
hil/topic                  hil/replay/reference drivers/recordings/record drivers/recordings/mcap drivers/host drivers/bus drivers/io drivers/text drivers/terminal drivers/measurement rig_config
hil/example                drivers/terminal rig_config
hil/world                  hil/report hil/sky hil/sensor hil/motion estimators/frame drivers/measurement drivers/text drivers/terminal rig_config
hil/campaign               hil/study hil/study/run hil/report hil/sensor drivers/text drivers/terminal rig_config
hil/python                 hil/bench hil/calibrate hil/check hil/fault hil/motion hil/report hil/study hil/study/run hil/summary hil/track estimators/external estimators/pipeline drivers/decode drivers/host drivers/shell drivers/recordings/record drivers/text drivers/terminal drivers/wire drivers/measurement rig_config
hil/program                hil/[a-z/_]* estimators/[a-z]* drivers/[a-z/]* rig_config
'

declare -A in_room may
while read -r room allowed; do [ -z "$room" ] || may[$room]=$allowed; done <<<"$arrows"

# The room of a folder: the longest of the rooms that the folder's path begins with; "." without one.
while read -r folder; do
  room=$folder
  until [ "$room" = . ] || [ -v "may[$room]" ]; do
    [[ $room == */* ]] && room=${room%/*} || room=.
  done
  in_room[$folder]=$room
done < <(git ls-files --cached --others --exclude-standard 'drivers/*pp' 'estimators/*pp' 'hil/*pp' 'rig_config/*pp' |
  sed 's|/[^/]*$||' | sort -u)
for folder in "${!in_room[@]}"; do
  [ "${in_room[$folder]}" != . ] || { echo "no room for $folder"; failed=1; }
done

while IFS=: read -r file include; do
  from=${in_room[${file%/*}]:-.}
  to=${in_room[${include%/*}]:-${include%/*}}
  [ "$from" != "$to" ] || continue
  for room in ${may[$from]:-}; do
    # shellcheck disable=SC2053
    [[ $to == $room || $include == $room.hpp ]] && continue 2
  done
  echo "not allowed: $from includes $to: $file includes $include"
  failed=1
done < <(
  git grep --untracked -o -E '^#include "(drivers|estimators|hil|rig_config|tests)/[^"]+"' -- 'drivers/*pp' 'estimators/*pp' 'hil/*pp' 'rig_config/*pp' |
    sed -E 's/:#include "/:/; s/"$//' | sort -u)

never() { # FOLDER REGEX: system headers that FOLDER keeps out
  local line
  while IFS= read -r line; do
    echo "kept out of $1: $line"
    failed=1
  done < <(grep -rHnE "#include <($2)" "$1" --include='*.hpp' --include='*.cpp' 2>/dev/null || true)
}

io='boost/asio|dds/|fstream|iostream|filesystem|thread|mutex|sys/|unistd|toml'
for folder in drivers/{measurement,wire,device,survey,guess} estimators/{frame,hydrodynamics,leveling,mixing,navigation,smoothing,calibration,roll,vehicle,velocity,pipeline,consistency}; do
  never "$folder" "$io"
done
if grep -nE '(system_clock|steady_clock)::now|\brandom_device\b|\brand\(\)' -r drivers/{wire,device,survey,guess,measurement} estimators \
  hil/{ocean,motion,sensor,sky} $(ls -d hil/study/*/ | grep -v /run/) hil/{study,characterize,validity}/*pp hil/characterize/{noise,grade,compare}; then
  echo "a clock or global randomness in a pure room"
  failed=1
fi
kinds=$(sed -nE 's/.*\.name = "([a-z_-]+)".*/\1/p' rig_config/estimator/*.hpp | paste -sd'|')
if [ -z "$kinds" ] || grep -rnE "(==|!=) *\"($kinds)\"" drivers estimators hil rig_config --include='*.hpp' --include='*.cpp'; then
  echo "a kind of estimator is compared by its name; ask its row in rig_config/estimator/kinds.hpp"
  failed=1
fi
exit $failed
