# shellcheck shell=bash
# SPDX-License-Identifier: MIT
# Shared by scripts/demo and scripts/test, which source it: packages, configuring, building, and the words for failing.

unset CDPATH
cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit
command_name="scripts/$(basename "$0")"

fail() {
    printf '%s: %s\n' "$command_name" "$1" >&2
    exit 1
}

# quietly <log> <command...>: the command's words go to the log, and are shown only if it fails.
quietly() {
    local log=$1
    shift
    mkdir -p "$(dirname "$log")"
    if ! "$@" >"$log" 2>&1 </dev/null; then
        cat "$log" >&2
        return 1
    fi
}

# missing <package...>: sets lack to those that are not installed.
missing() {
    local installed package
    installed=" $(dpkg-query --show --showformat '${Package}:${db:Status-Status} ' "$@" 2>/dev/null || true)"
    lack=()
    for package in "$@"; do
        [[ $installed == *" $package:installed "* ]] || lack+=("$package")
    done
}

# need <group...>: installs what packages.txt lists for the groups.
# RAYTORUS_INSTALL=no leaves that to you, for systems whose packages have other names.
need() {
    [[ ${RAYTORUS_INSTALL:-yes} != no ]] || return 0
    local -a packages lack as_root=()
    mapfile -t packages < <(awk -v groups=" $* " 'index(groups, " " $1 " ") { print $2 }' scripts/packages.txt)
    if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
        fail "there is no apt-get here; install what these Debian packages hold, then set RAYTORUS_INSTALL=no: ${packages[*]}"
    fi
    missing "${packages[@]}"
    [[ ${#lack[@]} -gt 0 ]] || return 0

    local install="apt-get install -y --no-install-recommends ${lack[*]}"
    if [[ $EUID -ne 0 ]]; then
        sudo -n true 2>/dev/null ||
            fail "packages are missing; run this as root, then try again: apt-get update && $install"
        as_root=(sudo -n)
    fi
    echo "Installing ${#lack[@]} packages and what they need (${lack[*]})"
    local log=build/packages.log
    mkdir -p build
    # Without fresh lists the installation may still succeed.
    "${as_root[@]}" apt-get update >"$log" 2>&1 </dev/null || true
    # shellcheck disable=SC2086  # the line is made of words
    if ! "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive $install >>"$log" 2>&1 </dev/null; then
        grep '^[EW]: ' "$log" | sed -n '1,4p;$p' >&2 || tail "$log" >&2
        missing "${lack[@]}"
        fail "apt-get could not install these packages (is there a network? see $log): ${lack[*]}"
    fi
}

# Ninja's lines, one for every tenth part of the work; whatever else it prints, as it is, but for CMake's status.
every_tenth() {
    local line next=10
    while IFS= read -r line; do
        if [[ $line =~ ^\ *([0-9]+)%\  ]]; then
            if ((BASH_REMATCH[1] >= next)); then
                echo "  ${BASH_REMATCH[1]} %"
                next=$((BASH_REMATCH[1] / 10 * 10 + 10))
            fi
        elif [[ $line != "-- "* && $line != "ninja: no work to do." ]]; then
            printf '%s\n' "$line"
        fi
    done
}

# build <preset> <target> [argument...]: configures, the first time with the arguments, and builds, where either is due.
build() {
    local preset=$1 target=$2
    shift 2
    local folder=build/$preset
    if [[ ! -e $folder/build.ninja || CMakePresets.json -nt $folder/build.ninja ]]; then
        echo "Configuring $folder"
        [[ ! -e $folder/CMakeCache.txt ]] || set --
        quietly "build/$preset.log" cmake --preset "$preset" "$@" || fail "configuring failed, see above"
    fi
    local -a command=(cmake --build --preset "$preset" --target "$target")
    [[ $("${command[@]}" -- -n 2>&1) != *"no work to do"* ]] || return 0
    echo "Building $folder"
    command+=(--parallel "${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}")
    if [[ -t 1 ]]; then
        "${command[@]}" || fail "building failed, see above"
    else
        NINJA_STATUS='%p ' "${command[@]}" 2>&1 | every_tenth || fail "building failed, see above"
    fi
}
