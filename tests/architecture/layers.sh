#!/usr/bin/env bash
# Checks the arrows of docs/architecture.md on the #include lines: each folder may include only the folders named here.
set -euo pipefail
cd "$(dirname "$0")/../.."
failed=0

allow() { # FOLDER ALLOWED-REGEX: the folders of this tree that files of FOLDER may include
  local line
  [ -d "$1" ] || { echo "no folder $1"; failed=1; }
  while IFS= read -r line; do
    echo "not allowed: $line"
    failed=1
  done < <(grep -rHnE '#include "(drivers|estimators|hil|rig_config|tests)/' "$1" --include='*.hpp' --include='*.cpp' 2>/dev/null |
    grep -vE "#include \"($2)/" || true)
}

never() { # FOLDER REGEX: system headers that files of FOLDER must not include
  local line
  while IFS= read -r line; do
    echo "kept out of $1: $line"
    failed=1
  done < <(grep -rHnE "#include <($2)" "$1" --include='*.hpp' --include='*.cpp' 2>/dev/null || true)
}

allow drivers/measurement 'drivers/measurement'
allow drivers/wire 'drivers/wire'
allow drivers/capture 'drivers/(capture|wire)'
allow drivers/mcap 'drivers/mcap'
allow drivers/link 'drivers/(link|capture|wire|measurement)'
allow drivers/device 'drivers/(device|wire|measurement)'
allow drivers/probe 'drivers/(probe|device|wire|measurement)'
allow drivers/shell 'drivers/(shell|device|link|capture|wire|measurement)|rig_config'
allow drivers/bus 'drivers/(bus|measurement)'
allow drivers/record 'drivers/(record|mcap|bus|shell|device|link|wire|measurement)|rig_config'
allow drivers/live 'drivers/(live|bus|link|measurement)'
allow drivers/export 'drivers/(export|record|mcap|shell|wire|measurement)'
allow drivers/slice 'drivers/(slice|record|mcap|device|wire|measurement)|rig_config'
allow drivers/cli 'drivers/[a-z]*|rig_config'
allow estimators/frame 'estimators/frame|drivers/measurement'
allow estimators/leveling 'estimators/(leveling|navigation|frame)|drivers/measurement'
allow estimators/roll 'estimators/(roll|frame)|drivers/measurement'
allow estimators/mixing 'estimators/(mixing|frame)'
allow estimators/navigation 'estimators/(navigation|frame)'
allow estimators/hydrodynamics 'estimators/(hydrodynamics|frame)'
allow estimators/velocity 'estimators/(velocity|navigation|hydrodynamics|frame)'
allow estimators/vehicle 'estimators/(vehicle|hydrodynamics)|rig_config'
allow estimators/pipeline 'estimators/(pipeline|leveling|mixing|roll|velocity|navigation|hydrodynamics|frame)|drivers/measurement'
allow estimators/cli 'estimators/[a-z]*|drivers/[a-z]*|rig_config'
allow rig_config 'rig_config'
allow hil/ocean 'hil/ocean|estimators/frame|drivers/measurement|rig_config'
allow hil/motion 'hil/(motion|ocean)|estimators/(frame|hydrodynamics|vehicle)|drivers/measurement|rig_config'
allow hil/sensor 'hil/(sensor|motion|ocean)|estimators/frame|drivers/measurement|rig_config'
allow hil/study 'hil/(study|sky|sensor|motion|ocean)|estimators/[a-z]*|drivers/measurement|rig_config'
allow hil/sky 'hil/(sky|sensor|motion|ocean)|estimators/frame|drivers/measurement|rig_config'
allow hil/emulate 'hil/(emulate|sky|sensor|motion|ocean)|estimators/frame|drivers/(device|link|shell|wire|measurement)|rig_config'
allow hil/fault 'hil/(fault|emulate|sensor|motion|ocean)|drivers/(link|wire|measurement)|rig_config'
allow hil/proxy 'hil/(proxy|fault)|drivers/(device|link|wire|measurement)|rig_config'
allow hil/characterize 'hil/characterize|estimators/frame|drivers/measurement|rig_config'
allow hil/validity 'hil/(validity|emulate)|drivers/measurement|rig_config'
allow hil/cli 'hil/[a-z]*|estimators/[a-z]*|drivers/[a-z]*|rig_config'

io='boost/asio|dds/|fstream|iostream|filesystem|thread|mutex|sys/|unistd|toml'
for folder in drivers/measurement drivers/wire drivers/device drivers/probe estimators/frame estimators/hydrodynamics estimators/leveling estimators/mixing estimators/navigation estimators/roll estimators/vehicle estimators/velocity \
  estimators/pipeline; do
  never "$folder" "$io"
done
if grep -rnE '(system_clock|steady_clock)::now|\brandom_device\b|\brand\(\)' drivers/wire drivers/device drivers/probe drivers/measurement estimators hil/ocean hil/motion hil/sensor hil/sky hil/study hil/characterize hil/validity; then
  echo "a clock or global randomness in a pure layer"
  failed=1
fi
exit $failed
