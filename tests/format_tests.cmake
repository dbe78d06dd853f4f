# SPDX-License-Identifier: MIT
# The sources as text: formatted, licensed, short. They need no program of ours.
foreach(check IN ITEMS cpp spdx length)
    add_test(NAME format.${check} COMMAND "${CMAKE_COMMAND}" -P "${CMAKE_CURRENT_SOURCE_DIR}/format/${check}.cmake")
endforeach()
