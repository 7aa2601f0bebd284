#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# run.sh SOURCE BUILD CMAKE CC CXX: use the library built in BUILD as strangers would.
# Installs into a temporary prefix, moves it, and builds programs against it in every way offered.
set -euo pipefail
source=$1 build=$2 cmake=$3
export CC=$4 CXX=$5
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

step "pkg-config: C99, C11, C++17, shared and static, both installed"
version=$(pkg-config --modversion truckride)
compile() { # STANDARD PACKAGE OUTPUT
    local compiler=("$CC" -x c)
    [[ $1 = c++* ]] && compiler=("$CXX" -x c++)
    quietly "${compiler[@]}" -std="$1" -pedantic-errors -Wall -Werror "$here/main.c" -x none -o "$3" \
        $(pkg-config --cflags --libs "$2")
}
needs_shared() { readelf -d "$1" | grep -q 'NEEDED.*libtruckride\.so\.0'; }
for standard in c99 c11 c++17; do
    compile $standard truckride "$top/pc_shared"
    library_path=$libdir expect_ok "$top/pc_shared"
    needs_shared "$top/pc_shared" || fail "pkg-config truckride: $standard does not need libtruckride.so.0"
    compile $standard truckride-static "$top/pc_static"
    expect_ok "$top/pc_static"
    needs_shared "$top/pc_static" && fail "pkg-config truckride-static: $standard needs libtruckride.so"
done

# Whatever any object of the archive needs must be on the line that pkg-config gives.
expect_whole() { # ARCHIVE LINK_LINE
    quietly "$CC" -o "$top/whole" -DTRUCKRIDE_STATIC -I"$prefix/include" "$here/main.c" \
        -Wl,--whole-archive "$1" -Wl,--no-whole-archive ${2//-ltruckride/}
    expect_ok "$top/whole"
}

step "pkg-config --static, with only the archive installed"
cp -r "$prefix" "$top/static"
find "$top/static" -name 'libtruckride.so*' -delete
archive=$(find "$top/static" -name libtruckride.a)
export PKG_CONFIG_PATH=$(dirname "$archive")/pkgconfig
quietly "$CC" "$here/main.c" -o "$top/pc_static" $(pkg-config --static --cflags --libs truckride)
expect_ok "$top/pc_static"
expect_whole "$archive" "$(pkg-config --static --libs truckride)"
pkg-config --static --cflags truckride | grep -q -e -DTRUCKRIDE_STATIC || fail "no -DTRUCKRIDE_STATIC"

step "a build without the shared library: plain pkg-config and find_package are static"
cached() { sed -n "s/^$1:[A-Z]*=//p" "$build/CMakeCache.txt"; }
features=(-DTRUCKRIDE_WITH_CHOLMOD="$(cached TRUCKRIDE_WITH_CHOLMOD)"
    -DTRUCKRIDE_WITH_LAPACK="$(cached TRUCKRIDE_WITH_LAPACK)" -DTRUCKRIDE_WITH_NLOPT="$(cached TRUCKRIDE_WITH_NLOPT)"
    -DTRUCKRIDE_WITH_JSON="$(cached TRUCKRIDE_WITH_JSON)" -DTRUCKRIDE_WITH_ARPACK="$(cached TRUCKRIDE_WITH_ARPACK)")
quietly "$cmake" "${generator[@]}" -S "$source" -B "$top/only" -DTRUCKRIDE_BUILD_SHARED=OFF \
    -DTRUCKRIDE_BUILD_TESTS=OFF -DTRUCKRIDE_BUILD_EXAMPLES=OFF -DTRUCKRIDE_BUILD_STUDY=OFF -DTRUCKRIDE_BUILD_CLI=OFF "${features[@]}"
cp "$archive" "$top/only/lib" # the same archive: compiling it again would show nothing
quietly "$cmake" --install "$top/only" --prefix "$top/archive"
archive=$(find "$top/archive" -name libtruckride.a)
export PKG_CONFIG_PATH=$(dirname "$archive")/pkgconfig
compile c11 truckride "$top/pc_static"
expect_ok "$top/pc_static"
expect_whole "$archive" "$(pkg-config --libs truckride)"
quietly "$cmake" "${generator[@]}" -S "$here/find_package" -B "$top/find_archive" \
    -DCMAKE_PREFIX_PATH="$top/archive" -DWANTED="$version"
quietly "$cmake" --build "$top/find_archive"
expect_ok "$top/find_archive/truckride_c11"
needs_shared "$top/find_archive/truckride_c11" && fail "truckride::truckride is not static"

export PKG_CONFIG_PATH=$pc
step "find_package: C99, C11, C++17, shared and static"
quietly "$cmake" "${generator[@]}" -S "$here/find_package" -B "$top/find" \
    -DCMAKE_PREFIX_PATH="$prefix" -DWANTED="$version"
quietly "$cmake" --build "$top/find"
for standard in c99 c11 cxx17; do
    expect_ok "$top/find/truckride_$standard"
    expect_ok "$top/find/static_$standard"
    needs_shared "$top/find/truckride_$standard" || fail "truckride_$standard does not need libtruckride.so.0"
    needs_shared "$top/find/static_$standard" && fail "static_$standard needs libtruckride.so"
done
expect_ok "$top/find/static_whole"

step "find_package in a project of C++ alone"
quietly "$cmake" "${generator[@]}" -S "$here/find_package" -B "$top/cxx" \
    -DCMAKE_PREFIX_PATH="$prefix" -DWANTED="$version" -DWITHOUT_C=ON
quietly "$cmake" --build "$top/cxx"
expect_ok "$top/cxx/static_cxx17"

step "find_package refuses a newer version and any other minor version"
IFS=. read -r major minor patch <<<"$version"
refused=(99 "$major.$minor.$((patch + 1))" "$major.$((minor + 1))" "$((major + 1)).0")
[ "$minor" -gt 0 ] && refused+=("$major.$((minor - 1))")
for wanted in "${refused[@]}"; do
    if "$cmake" "${generator[@]}" -S "$here/find_package" -B "$top/refused" \
            -DCMAKE_PREFIX_PATH="$prefix" -DWANTED="$wanted" >"$top/log" 2>&1; then
        fail "version $wanted was found in $version"
    fi
    grep -q "compatible with requested version" "$top/log" || { cat "$top/log"; fail "another error"; }
    rm -rf "$top/refused"
done
for wanted in 99 "$major.$minor.$((patch + 1))"; do
    pkg-config --atleast-version "$wanted" truckride && fail "pkg-config found version $wanted in $version"
done
pkg-config --atleast-version "$version" truckride || fail "pkg-config does not find $version"

step "DESTDIR"
DESTDIR=$top/stage quietly "$cmake" --install "$build" --prefix /usr
stage=$top/stage/usr
[ -f "$stage/include/truckride/truckride.h" ] || fail "DESTDIR: no header"
find "$stage" -name 'libtruckride.so.0' | grep -q . || fail "DESTDIR: no library"
for file in LICENSE README.md CHANGELOG.md docs/theory.md; do
    [ -f "$stage/share/doc/truckride/$file" ] || fail "DESTDIR: no $file"
done

step "add_subdirectory in a foreign project"
quietly "$cmake" "${generator[@]}" -S "$here/add_subdirectory" -B "$top/sub" -DTRUCKRIDE_SOURCE="$source" \
    "${features[@]}" -DCMAKE_C_COMPILER_LAUNCHER="$here/reuse.sh"
TRUCKRIDE_REUSE=$build quietly "$cmake" --build "$top/sub"
expect_ok "$top/sub/shared"
expect_ok "$top/sub/static"

echo "all ways of use work, version $version"
