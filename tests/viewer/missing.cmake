# SPDX-License-Identifier: MIT
# The test that stands for those of raytorus-view where it was not built.
set(text "raytorus-view was not built: install the Debian packages libglfw3-dev and libimgui-dev")
if("$ENV{CI}" STREQUAL "true")
    message(FATAL_ERROR "${text}")
endif()
message("skipped: ${text}")
