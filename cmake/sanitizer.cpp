// SPDX-License-Identifier: MIT
// Linked whole into each program that is built with sanitizers: which leaks are not ours, and where none are
// looked for.
#include <dlfcn.h>

namespace {

bool hasOpenImageIo() {
    return dlopen("raytorus-openimageio.so", RTLD_LAZY | RTLD_NOLOAD) != nullptr;
}

// Whether the program is linked with it, as those of the tests are.
const bool linkedWithOpenImageIo = hasOpenImageIo();

}  // namespace

extern "C" {

// The loader unloads drivers and layers before leaks are looked for; what they leaked would then have no
// module's name.
int dlclose(void*) {
    return 0;
}

// By the module that allocated. lavapipe 22.3 leaks 128 bytes or more in a process; the validation
// layers 1.3.239 leak each command buffer when they validate synchronization, even one that was allocated and
// freed only. radv 22.3 leaks each shader that it compiles without a cache.
const char* __lsan_default_suppressions() {
    return "leak:libvulkan_lvp\n"
           "leak:libvulkan_radeon\n"
           "leak:libVkLayer_khronos_validation\n";
}

// Else the list of what was suppressed stands in each program's output.
const char* __lsan_default_options() {
    return "print_suppressions=0";
}

// LeakSanitizer now and then fails at the end of a program that loaded OpenImageIO and its 250 libraries on
// the way. Such a program is not asked; the tests, which do the same work in a process that began with them,
// are.
int __lsan_is_turned_off() {
    return !linkedWithOpenImageIo && hasOpenImageIo() ? 1 : 0;
}

}  // extern "C"
