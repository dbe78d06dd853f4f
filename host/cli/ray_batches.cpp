// SPDX-License-Identifier: MIT
#include "cli/ray_batches.hpp"

#include <exception>
#include <future>

namespace raytorus::cli {

void runBatches(const BatchStages& stages) {
    std::span<const float> answers;  // of the batch before
    std::size_t count = stages.read(0);
    for (std::size_t place = 0; count > 0; place = 1 - place) {
        stages.start(place, count);
        std::future<void> written =
            std::async(std::launch::async, [&stages, answers] { stages.write(answers); });
        std::exception_ptr unreadable;
        try {
            count = stages.read(1 - place);
        } catch (...) {
            unreadable = std::current_exception();  // a fault of the batches before goes first
        }
        written.get();
        answers = stages.finish(place);
        if (unreadable) {
            std::rethrow_exception(unreadable);
        }
    }
    stages.write(answers);
}

}  // namespace raytorus::cli
