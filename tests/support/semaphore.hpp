// SPDX-License-Identifier: MIT
// A count that threads wait for. Those of libstdc++ 12 can sleep for ever: a release() between a look at the
// count and the sleep wakes nobody.
#pragma once

#include <condition_variable>
#include <mutex>

namespace raytorus::test {

class Semaphore {
public:
    void release(int more = 1) {
        const std::scoped_lock lock(mutex);
        count += more;
        changed.notify_all();
    }
    void acquire() {
        std::unique_lock lock(mutex);
        changed.wait(lock, [this] { return count > 0; });
        --count;
    }

private:
    std::mutex mutex;
    std::condition_variable changed;
    int count = 0;
};

}  // namespace raytorus::test
