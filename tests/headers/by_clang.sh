#!/bin/sh
# by_clang.sh LAUNCHER COMPILER ARGUMENTS...: runs clang++ in the place of the compiler that CMake names. Some arguments are gcc's
# own. What the headers of all tests instantiate is compiled once, with their precompiled header.
launcher=$1
shift 2
exec "$launcher" clang++ -Qunused-arguments -fpch-instantiate-templates "$@"
