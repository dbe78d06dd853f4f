// SPDX-License-Identifier: MIT
// Linked whole into each program that is built with sanitizers: which leaks are not ours.
extern "C" {

// The loader unloads drivers and layers before leaks are looked for; what they leaked would then have no
// module's name.
int dlclose(void*) {
    return 0;
}

// By the module that allocated. lavapipe 22.3 leaks 128 bytes or more in a process; the validation
// layers 1.3.239 leak each command buffer when they validate synchronization, even one that was allocated and
// freed only.
const char* __lsan_default_suppressions() {
    return "leak:libvulkan_lvp\n"
           "leak:libVkLayer_khronos_validation\n";
}

// Else the list of what was suppressed stands in each program's output.
const char* __lsan_default_options() {
    return "print_suppressions=0";
}

}  // extern "C"
