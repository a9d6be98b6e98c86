#!/bin/sh
# by_clang.sh LAUNCHER COMPILER ARGUMENTS...: runs clang++ in the place of the compiler that CMake names. Some arguments are gcc's own.
launcher=$1
shift 2
exec "$launcher" clang++ -Qunused-arguments "$@"
