#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# reuse.sh COMPILER ARGUMENT...: compiler launcher of builds whose point is not the objects. A source
# of lib/ is only checked, with the flags given, and its object taken from the build
# in TRUCKRIDE_REUSE, which has compiled it before. The kernels take long.
arguments=("$@")
while [ $# -gt 1 ]; do
    [ "$1" = -o ] && output=$2
    shift
done
object=$TRUCKRIDE_REUSE/lib/CMakeFiles/truckride_objects.dir/${output#*/truckride_objects.dir/}
if [[ ${output-} = */truckride_objects.dir/*.o && -f $object ]]; then
    "${arguments[@]}" -fsyntax-only && cp "$object" "$output"
else
    "${arguments[@]}"
fi
