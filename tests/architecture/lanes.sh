#!/usr/bin/env bash
# Files for AVX2 and AVX-512 share no inline function with the rest of the program. The linker keeps one of two equal ones, and where
# that is the wide one, the program fails on a processor without such registers. So each weak symbol of theirs has lanes in its type.
# lanes.sh FOLDER: with their objects somewhere below it.
set -euo pipefail
found=0 failed=0
for kind in avx2 avx512; do
  while read -r object; do
    found=$((found + 1))
    if nm -C "$object" | grep -E '^[0-9a-f ]+ [uVvWw] ' | grep -vE 'lanes::Lanes<|__gxx_personality|^ +w '; then
      echo "$object shares these with other files"
      failed=1
    fi
  done < <(find "$1" -name "run_group_$kind.cpp.o")
done
[[ $found == 2 ]] || { echo "found $found objects in place of 2"; exit 1; }
exit $failed
