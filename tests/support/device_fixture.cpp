// SPDX-License-Identifier: MIT
#include "device_fixture.hpp"

#include <fmt/format.h>

#include <memory>

namespace raytorus::test {
namespace {

struct SharedDevice {
    std::shared_ptr<gpu::ValidationLog> log = std::make_shared<gpu::ValidationLog>();
    std::unique_ptr<gpu::Context> context;
    std::size_t reported = 0;  // messages that have failed a test already
};

SharedDevice& shared() {
    static SharedDevice instance;
    return instance;
}

void expectNoMessages() {
    const std::vector<std::string> messages = shared().log->messages();
    for (; shared().reported < messages.size(); ++shared().reported) {
        ADD_FAILURE() << "validation: " << messages[shared().reported];
    }
}

// What the layers say about objects that are still alive when the device goes counts too.
class TakeDownDevice : public testing::Environment {
    void TearDown() override {
        shared().context.reset();
        expectNoMessages();
    }
};

[[maybe_unused]] const testing::Environment* const registered =
    testing::AddGlobalTestEnvironment(new TakeDownDevice);

}  // namespace

gpu::Context& device() {
    if (!shared().context) {
        gpu::ContextOptions options;
        options.validate = true;
        shared().context = std::make_unique<gpu::Context>(options, shared().log);
        const gpu::DeviceInfo& info = shared().context->info();
        fmt::print("on {}, {} {}\n", info.name, info.driverName, info.driverInfo);
    }
    return *shared().context;
}

void DeviceTest::TearDown() {
    expectNoMessages();
}

}  // namespace raytorus::test
