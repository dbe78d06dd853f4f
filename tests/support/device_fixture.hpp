// SPDX-License-Identifier: MIT
// The device that tests share, with core and synchronization validation on. A message of the validation
// layers, when ever it comes, fails the test that runs, or the run.
#pragma once

#include <gtest/gtest.h>

#include "gpu/context.hpp"

namespace raytorus::test {

/// Made at the first call. Throws if there is no device or no validation layer: nothing is skipped.
gpu::Context& device();

/// A test that uses device(): checks the validation log when it ends.
class DeviceTest : public testing::Test {
protected:
    void TearDown() override;
};

}  // namespace raytorus::test
