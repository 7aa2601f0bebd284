#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# run.sh SOURCE BUILD CMAKE CC: use the library built in BUILD as strangers would.
# Installs into a temporary prefix, moves it, and builds programs against it in every way offered.
set -euo pipefail
source=$1 build=$2 cmake=$3
export CC=$4
here=$source/tests/consumer
top=$(mktemp -d)
trap 'rm -rf "$top"' EXIT
generator=(-G "$(sed -n 's/^CMAKE_GENERATOR:INTERNAL=//p' "$build/CMakeCache.txt")")

step() { echo "== $*"; }
fail() { echo "FAILED: $*"; exit 1; }
quietly() { "$@" >"$top/log" 2>&1 || { cat "$top/log"; fail "$*"; }; }
expect_ok() {
    local said
    said=$(LD_LIBRARY_PATH=${library_path-} "$@") || fail "$* ended with $?"
    [ "$said" = ok ] || fail "$* said: $said"
}

step "install into a prefix, then move it"
quietly "$cmake" --install "$build" --prefix "$top/first"
mv "$top/first" "$top/moved"
prefix=$top/moved
pc=$(dirname "$(find "$prefix" -name truckride.pc)")
libdir=$(dirname "$pc")
export PKG_CONFIG_PATH=$pc
if grep -rlIE "$top/first|$source|$build" "$libdir/pkgconfig" "$libdir/cmake"; then
    fail "a package file names a directory of the build machine"
fi

step "pkg-config, shared, C99 and C11"
version=$(pkg-config --modversion truckride)
for standard in c99 c11; do
    quietly "$CC" -std=$standard -pedantic-errors -Wall -Werror "$here/main.c" -o "$top/pc_$standard" \
        $(pkg-config --cflags --libs truckride)
    library_path=$libdir expect_ok "$top/pc_$standard"
done

step "pkg-config --static, with only the archive installed"
cp -r "$prefix" "$top/static"
find "$top/static" -name 'libtruckride.so*' -delete
archive=$(find "$top/static" -name libtruckride.a)
# Whatever any object of the archive needs must be on the line that pkg-config gives.
PKG_CONFIG_PATH=$(dirname "$archive")/pkgconfig quietly bash -c '
    "$CC" "$1/main.c" -o "$2" -Wl,--whole-archive "$3" -Wl,--no-whole-archive \
        $(pkg-config --static --cflags --libs truckride | sed "s/-ltruckride//") &&
    "$CC" "$1/main.c" -o "$2" $(pkg-config --static --cflags --libs truckride)' \
    bash "$here" "$top/pc_static" "$archive"
expect_ok "$top/pc_static"
pkg-config --static --cflags truckride | grep -q -e -DTRUCKRIDE_STATIC || fail "no -DTRUCKRIDE_STATIC"

step "find_package: C99, C11, C++17, static"
quietly "$cmake" "${generator[@]}" -S "$here/find_package" -B "$top/find" \
    -DCMAKE_PREFIX_PATH="$prefix" -DWANTED="$version"
quietly "$cmake" --build "$top/find"
for program in shared_c99 shared_c11 shared_cxx17 static_c11; do
    expect_ok "$top/find/$program"
done
readelf -d "$top/find/static_c11" | grep -q libtruckride && fail "static_c11 needs libtruckride.so"
readelf -d "$top/find/shared_c11" | grep -q 'libtruckride\.so\.0' || fail "shared_c11 does not need libtruckride.so.0"

step "find_package refuses a newer version and any other minor version"
IFS=. read -r major minor patch <<<"$version"
refused=("$major.$minor.$((patch + 1))" "$major.$((minor + 1))" "$((major + 1)).0")
[ "$minor" -gt 0 ] && refused+=("$major.$((minor - 1))")
for wanted in "${refused[@]}"; do
    if "$cmake" "${generator[@]}" -S "$here/find_package" -B "$top/refused" \
            -DCMAKE_PREFIX_PATH="$prefix" -DWANTED="$wanted" >"$top/log" 2>&1; then
        fail "version $wanted was found in $version"
    fi
    grep -q "compatible with requested version" "$top/log" || { cat "$top/log"; fail "another error"; }
    rm -rf "$top/refused"
done
pkg-config --atleast-version "$major.$minor.$((patch + 1))" truckride && fail "pkg-config found a newer version"

step "DESTDIR"
DESTDIR=$top/stage quietly "$cmake" --install "$build" --prefix /usr
stage=$top/stage/usr
[ -f "$stage/include/truckride/truckride.h" ] || fail "DESTDIR: no header"
find "$stage" -name 'libtruckride.so.0' | grep -q . || fail "DESTDIR: no library"

step "add_subdirectory in a foreign project"
cached() { sed -n "s/^$1:[A-Z]*=//p" "$build/CMakeCache.txt"; }
quietly "$cmake" "${generator[@]}" -S "$here/add_subdirectory" -B "$top/sub" -DTRUCKRIDE_SOURCE="$source" \
    -DTRUCKRIDE_WITH_CHOLMOD="$(cached TRUCKRIDE_WITH_CHOLMOD)" -DTRUCKRIDE_WITH_LAPACK="$(cached TRUCKRIDE_WITH_LAPACK)"
quietly "$cmake" --build "$top/sub"
expect_ok "$top/sub/shared"
expect_ok "$top/sub/static"

echo "all ways of use work, version $version"
