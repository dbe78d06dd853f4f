# SPDX-License-Identifier: MIT
# What the scripts of a bundle make of programs that fail: `run`, whose exit code, sentences and JSON tell of it, and the
# starters in bin/. The programs are scripts here.
include("${CMAKE_CURRENT_LIST_DIR}/common.cmake")
set(where "${SCRATCH}/here")
set(bundle "${SCRATCH}/bundle of stubs")

# stub(<path> <shell commands>)
function(stub path commands)
    file(WRITE "${bundle}/${path}" "#!/bin/sh\n${commands}\n")
    file(CHMOD "${bundle}/${path}" PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
endfunction()

# Programs that do well: they write JSON where they are told to, and what they are told into a log.
function(begin)
    file(REMOVE_RECURSE "${bundle}" "${where}")
    file(MAKE_DIRECTORY "${where}")
    file(COPY "${root}/scripts/bundled/run" DESTINATION "${bundle}")
    file(WRITE "${bundle}/bundle.txt" "raytorus 1.2.3, commit abc\n")
    set(log "echo \"$(basename \"$0\") $*\" >>\"${SCRATCH}/log\"\n")
    file(WRITE "${SCRATCH}/log" "")
    set(to_json "while [ $# -gt 0 ]; do\n[ \"$1\" = --json ] && json=$2\n[ \"$1\" = --report ] && report=$2\nshift\ndone\n")
    stub(bin/raytorus-verify "${log}${to_json}
cat >\"$json\" <<'END'
{
 \"version\": \"1.2.3\",
 \"device\": \"A \\\"GPU\\\" / 7\",
 \"driver\": \"D\",
 \"groups\": [
  {\"class\": \"a  b\"},
  {\"class\": \"b\"}]}
END
echo every threshold is held")
    stub(bin/raytorus "${log}[ \"$1\" != doctor ] || { printf 'line \"one\"\\n\\n  back\\\\\\\\slash\\n'; exit; }
${to_json}mkdir \"$report\"
echo '{\"failed\": 0}' >\"$report/report.json\"
echo page >\"$report/index.html\"
echo all are right")
    stub(bin/raytorus-bench "${log}
${to_json}echo '{\"format\": \"b\"}' >\"$json\"")
endfunction()

# fails(<program> <exit code> <only with these arguments>): it says so and ends so, once it has done its work.
function(fails program code only)
    file(READ "${bundle}/bin/${program}" text)
    set(trap "trap 'echo \"${program}: it is ${code}\" >&2; exit ${code}' EXIT")
    string(REPLACE "#!/bin/sh\n" "#!/bin/sh\ncase \" $* \" in *\"${only}\"*) ${trap} ;; esac\n" text "${text}")
    file(WRITE "${bundle}/bin/${program}" "${text}")
endfunction()

function(read_json name)
    file(READ "${where}/${name}" json)
    set(json "${json}" PARENT_SCOPE)
endfunction()

# logged(<regular expression> <whether it is to be there>)
function(logged words wanted)
    file(READ "${SCRATCH}/log" log)
    if((log MATCHES "${words}") AND NOT wanted OR NOT (log MATCHES "${words}") AND wanted)
        fault("\"${words}\" in the commands: not ${wanted}\n${log}")
    endif()
endfunction()

# left(<files...>): all that lies in ${where}.
function(left)
    file(GLOB names RELATIVE "${where}" "${where}/*")
    if(NOT names STREQUAL "${ARGN}")
        fault("left: ${names}, not ${ARGN}")
    endif()
endfunction()

# All is well. The rays are shared out, rounded up; the name of the file is the device's; strings are quoted.
begin()
started(0 "Every step was right. Wrote raytorus-a-gpu-7.json" "${bundle}/run" --rays 1001 --seed 9 --device "G  7")
if(NOT said MATCHES "^The device is A \"GPU\" / 7, driver D.\n")
    fault("the device's name: ${said}")
endif()
left(raytorus-a-gpu-7.json)
read_json(raytorus-a-gpu-7.json)
holds("${json}" "A \"GPU\" / 7" device)
holds("${json}" 1002 rays)
holds("${json}" "raytorus 1.2.3, commit abc" bundle)
holds("${json}" "line \"one\"" doctor 0)
holds("${json}" "" doctor 1)
holds("${json}" "  back.*slash" doctor 2)
holds("${json}" "a  b" verify groups 0 class)
holds("${json}" OFF short)
logged("raytorus-verify --rays 501 --seed 9 --json [^\n]* --device G  7\n" TRUE)
logged("raytorus golden check --folder ${bundle}/golden --report [^\n]* --tolerance-factor 1 --device G  7\n" TRUE)
logged("raytorus-bench --quick --json [^\n]* --device G  7\n" TRUE)
logged("raytorus-bench --groups --json [^\n]* --device G  7\n" TRUE)

# Ten million rays unless told otherwise, fresh ones.
begin()
started(0 "what groups of 8, 32 and 64 lanes pay is counted" "${bundle}/run" -o all.json)
read_json(all.json)
holds("${json}" 10000000 rays)
holds("${json}" b groups format)
holds("${json}" groups steps 3 name)
logged("raytorus-bench --groups --json" TRUE)

# Each step that fails has its sentence, those after it are made all the same, the first one's code is the run's, and
# what the programs said stays.
begin()
fails(raytorus-verify 2 "--rays 5000000")
fails(raytorus-bench 10 "--quick")
set(words "verify failed with exit code 2, after [0-9]+ s: it is 2\n.*")
string(APPEND words "  bench failed with exit code 10, after [0-9]+ s: it is 10\n.*\nrun: not every step was right")
started(2 "${words}" "${bundle}/run" -o bad.json)
left(bad-bench.txt bad-golden.html bad-golden.txt bad-groups.txt bad-verify.txt bad.json)
read_json(bad.json)
holds("${json}" 2 exitCode)
holds("${json}" 2 steps 0 exitCode)
holds("${json}" "it is 2" steps 0 sentence)
holds("${json}" 0 steps 1 exitCode)
holds("${json}" 10 steps 2 exitCode)
logged("tolerance-factor 8" FALSE)

# Goldens that fail are checked again as Vulkan allows, unless a factor was given.
begin()
fails(raytorus 2 "tolerance-factor 1 ")
started(2 "golden failed with exit code 2.*Checking them as on a device.*right, after" "${bundle}/run" -o bad.json)
read_json(bad.json)
holds("${json}" goldenLoose steps 2 name)
holds("${json}" 0 goldenLoose failed)
logged("--tolerance-factor 8" TRUE)
begin()
fails(raytorus 2 "tolerance-factor 4")
started(2 "golden failed with exit code 2" "${bundle}/run" -o bad.json --tolerance-factor 4)
logged("--tolerance-factor 8" FALSE)

# A program that writes no JSON leaves the rest sound.
begin()
stub(bin/raytorus "exit 9")
started(9 "golden failed with exit code 9" "${bundle}/run" -o bad.json)
read_json(bad.json)
holds("${json}" b bench format)
if(NOT json MATCHES "\"doctor\": \\[\\]" OR json MATCHES "\n\"golden\"")
    fault("doctor and golden: ${json}")
endif()

# Nothing is begun, and nothing written, without a device or with a wrong option.
begin()
stub(bin/raytorus-verify "echo 'raytorus-verify: no device' >&2; exit 8")
started(8 "^run: no device\n$" "${bundle}/run")
foreach(wrong IN ITEMS "--rays;0" "--rays;1e6" "--rays;-1" "--seed;x" "--seed" "--tolerance-factor;0.5"
        "--tolerance-factor;1001" "--tolerance-factor;nan" "--tolerance-factor;2.5.1" "--fast" "file.json")
    started(5 "^run: [^\n]+ \\(see run --help\\)\n$" "${bundle}/run" ${wrong})
endforeach()
left()
begin()
started(4 "run: none/a.json cannot be written\n$" "${bundle}/run" -o none/a.json)
logged("--report" FALSE) # found out before the work
left()
started(0 "^run .option.*Examples:.*Exit code 0" "${bundle}/run" --help)
file(GLOB rest "${SCRATCH}/raytorus.*")
if(rest)
    fault("temporary files stay: ${rest}")
endif()

# The starters: the system's C++ runtime, or else the bundle's, or else a sentence; through a link, too.
file(COPY "${root}/scripts/bundled/program" DESTINATION "${bundle}/bin")
stub(libexec/program "echo \"\${LD_LIBRARY_PATH:-system} $*\"")
started(0 "^system a  b\n$" "${bundle}/bin/program" "a  b")
file(CREATE_LINK "${bundle}/bin/program" "${where}/other" SYMBOLIC)
started(0 "^system a\n$" "${where}/other" a)
stub(libexec/program "[ -n \"$LD_LIBRARY_PATH\" ] || exit 127; echo \"$LD_LIBRARY_PATH $*\"; [ \"$1\" = --version ] || exit 3")
started(3 "^${bundle}/lib/runtime a\n$" "${bundle}/bin/program" a)
foreach(row IN ITEMS "libvulkan.so.1: cannot open|8|there is no Vulkan loader" "libX11.so.6: cannot open|8|no libX11"
        "libm.so.6: version `GLIBC_2.35' not found|1|too old, its C library lacks GLIBC_2.35\n" "what else|1|what else")
    string(REPLACE "|" ";" row "${row}")
    list(GET row 0 loader)
    list(GET row 1 code)
    list(GET row 2 words)
    stub(libexec/program "cat >&2 <<'END'\nprogram: error while loading shared libraries: ${loader}\nEND\nexit 127")
    started(${code} "^program: [^\n]*${words}" "${bundle}/bin/program")
endforeach()
finish()
