#!/usr/bin/env bash
# Every library that find_package(Drydock) looks for is a dependency of the development package, and of the build.
set -euo pipefail
cd "$(dirname "$0")/../.."
declare -A package=([Boost]=libboost1.81-dev [Eigen3]=libeigen3-dev [fmt]=libfmt-dev [ZLIB]=zlib1g-dev
  [tomlplusplus]=libtomlplusplus-dev [nlohmann_json]=nlohmann-json3-dev [zstd]=libzstd-dev [CycloneDDS]=cyclonedds-dev)
depends=$(sed -n '/DEVELOPMENT_PACKAGE_DEPENDS/,/")/p' .packaging/debian/CMakeLists.txt)
bad=0 count=0
for library in $(sed -n 's/^ *find_dependency(\([A-Za-z0-9_]*\).*/\1/p' .packaging/cmake/DrydockConfig.cmake.in); do
  [ "$library" = Threads ] && continue
  count=$((count + 1))
  name=${package[$library]-}
  [ -n "$name" ] || { echo "$library: this test does not know its Debian package"; bad=1; continue; }
  grep -qw -- "$name" <<<"$depends" || { echo "libdrydock-dev does not depend on $name, which find_package(Drydock) needs"; bad=1; }
  grep -qx -- "$name" .ci/packages-program.txt || { echo ".ci/packages-program.txt lacks $name"; bad=1; }
done
[ "$count" -ge 8 ] || { echo "only $count libraries were found in DrydockConfig.cmake.in"; bad=1; }
exit "$bad"
