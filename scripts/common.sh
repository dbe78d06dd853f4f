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

# port_tools: what runs the library in other languages, into build/ports.
port_tools() {
    local listed=tests/ports/requirements.txt
    [[ ! -e build/ports/installed || $listed -nt build/ports/installed ]] || return 0
    [[ ${RAYTORUS_INSTALL:-yes} != no ]] || return 0
    echo "Installing Python packages into build/ports"
    quietly build/ports.log python3 -m venv build/ports || fail "python3 -m venv build/ports failed (Debian package python3-venv)"
    quietly build/ports.log build/ports/bin/pip install --quiet --requirement "$listed" ||
        fail "pip could not install what $listed lists (is there a network? see build/ports.log)"
    touch build/ports/installed
}

# port_compilers: DXC and Slang, which are inside of Python packages that are not needed themselves.
port_compilers() {
    local folder=build/ports/fetching dxc=build/ports/dxc
    [[ ! -x $dxc || ! -x build/ports/slangc ]] || return 0
    echo "Fetching DXC and Slang into build/ports"
    mkdir -p "$folder"
    quietly build/ports.log build/ports/bin/pip download --quiet --no-deps --dest "$folder" \
        compushady==0.17.5 slangtorch==1.3.22 slangpy==0.43.1 || fail "pip could not fetch DXC and Slang, see build/ports.log"
    tar -xzf "$folder"/compushady-*.tar.gz -C "$folder"
    local headers=("$folder"/compushady-*/compushady/backends)
    quietly build/ports.log c++ -std=c++17 -w -fms-extensions "-I${headers[0]}" tests/ports/dxc.cpp -o "$dxc" -ldl ||
        fail "tests/ports/dxc.cpp does not compile"
    cp "${headers[0]}/libdxcompiler_x86_64.so.3.7" build/ports/libdxcompiler.so
    python3 - "$folder" build/ports <<'PYTHON'
import pathlib, sys, zipfile
folder, to = map(pathlib.Path, sys.argv[1:])
# slangtorch has the compiler without what writes SPIR-V; of slangpy that library alone is taken, by the name asked for.
wanted = {"slangtorch": ("slangc", "libslang-compiler", "libslang-glsl-module"), "slangpy": ("libslang-glslang",)}
for wheel in folder.glob("*.whl"):
    with zipfile.ZipFile(wheel) as archive:
        for name in archive.namelist():
            base = pathlib.PurePath(name).name
            if base.startswith(wanted[wheel.name.split("-")[0]]):
                (to / base).write_bytes(archive.read(name))
version = next(to.glob("libslang-glsl-module-*.so")).stem.rsplit("-", 1)[1]
next(to.glob("libslang-glslang-*.so")).rename(to / f"libslang-glslang-{version}.so")
(to / "slangc").chmod(0o755)
PYTHON
    rm -r "$folder"
}

# port_drivers: the Vulkan drivers' JSON files for them, with a colon between.
port_drivers() {
    local installed
    installed=$(find /usr/share/vulkan/icd.d /etc/vulkan/icd.d -name 'lvp_icd*.json' 2>/dev/null | head -n 1)
    echo "${installed:+$installed:}$PWD/build/drivers/swiftshader.json"
}
