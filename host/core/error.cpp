// SPDX-License-Identifier: MIT
#include "core/error.hpp"

namespace raytorus {

std::string_view version() {
    return RAYTORUS_VERSION;
}

}  // namespace raytorus
