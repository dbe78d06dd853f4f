// SPDX-License-Identifier: MIT
// A rename() that fails in this process, or is its end.
#pragma once

#include <string>

namespace raytorus::test {

/// As long as it lives, nothing can be renamed to a name with this end: the file system is read only.
class FailingRename {
public:
    explicit FailingRename(const std::string& end);
    FailingRename(const FailingRename&) = delete;
    FailingRename& operator=(const FailingRename&) = delete;
    ~FailingRename();
};

/// From now on this process is killed where something is to be renamed to such a name.
void killAtRename(const std::string& end);

}  // namespace raytorus::test
