// SPDX-License-Identifier: MIT
#include "render/pipeline_store.hpp"

#include <algorithm>
#include <deque>
#include <mutex>
#include <thread>

namespace raytorus::render {

// Threads that take tasks in their order and end when there is none.
class PipelineStore::Workers {
public:
    using Task = std::packaged_task<gpu::Pipeline()>;

    ~Workers() {
        const std::scoped_lock lock(mutex);
        waiting.clear();
    }

    std::future<gpu::Pipeline> add(Make make) {
        Task task(std::move(make));
        std::future<gpu::Pipeline> result = task.get_future();
        const std::scoped_lock lock(mutex);
        waiting.push_back(std::move(task));
        if (running < std::max(1U, std::thread::hardware_concurrency())) {
            ++running;
            threads.emplace_back([this] { run(); });
        }
        return result;
    }

private:
    void run() {
        while (true) {
            Task task;
            {
                const std::scoped_lock lock(mutex);
                if (waiting.empty()) {
                    --running;
                    return;
                }
                task = std::move(waiting.front());
                waiting.pop_front();
            }
            task();
        }
    }

    std::mutex mutex;
    std::deque<Task> waiting;
    unsigned running = 0;
    std::vector<std::jthread> threads;  // last: they are joined before the rest goes
};

PipelineStore::PipelineStore() = default;
PipelineStore::PipelineStore(PipelineStore&&) noexcept = default;
PipelineStore& PipelineStore::operator=(PipelineStore&&) noexcept = default;
PipelineStore::~PipelineStore() = default;

void PipelineStore::prepare(Route route, const std::vector<std::uint32_t>& specialization, Make make) {
    const Key key(route, specialization);
    if (pipelines.contains(key) || coming.contains(key)) {
        return;
    }
    if (!workers) {
        workers = std::make_unique<Workers>();
    }
    coming.emplace(key, workers->add(std::move(make)));
}

gpu::Pipeline& PipelineStore::find(Route route, const std::vector<std::uint32_t>& specialization,
                                   const Make& make) {
    const Key key(route, specialization);
    if (const auto prepared = coming.extract(key)) {
        return pipelines.emplace(key, prepared.mapped().get()).first->second;
    }
    auto found = pipelines.find(key);
    if (found == pipelines.end()) {
        found = pipelines.emplace(key, make()).first;
    }
    return found->second;
}

}  // namespace raytorus::render
