#!/bin/sh
# by_clang.sh LAUNCHER COMPILER ARGUMENTS...: runs clang++ in the place of the compiler that CMake names. Some arguments are gcc's
# own. What the headers of all tests instantiate is compiled once, with their precompiled header.
launcher=$1
shift 2
# A precompiled header of before stands beside the one that it is made from, and clang would read it, and refuse it.
case " $* " in
  *" -x c++-header "*) rm -f "$(echo " $* " | sed 's/.* -o \([^ ]*\) .*/\1/')" ;;
esac
exec "$launcher" clang++ -Qunused-arguments -fpch-instantiate-templates "$@"
