// SPDX-License-Identifier: MIT
// Pipelines that outlive the pictures they were made for, and that can be made ahead of them, several at
// once.
#pragma once

#include <cstdint>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "gpu/pipeline.hpp"
#include "render/route.hpp"

namespace raytorus::render {

/// Pipelines kept from one picture to the next. Scenes with as many tori, lights and samples have the same,
/// and a driver compiles each for longer than it draws a small picture. For one context, which must outlive
/// it, and one ShaderSource.
class PipelineStore {
public:
    using Make = std::function<gpu::Pipeline()>;

    PipelineStore();
    PipelineStore(PipelineStore&&) noexcept;
    PipelineStore& operator=(PipelineStore&&) noexcept;
    /// Waits for pipelines that are being made; those that are not begun are not made.
    ~PipelineStore();

    /// Lets the pipeline for these specialization constants be made in another thread, unless there is one
    /// already. They are begun in this order, as many at a time as there are processors. What goes wrong is
    /// thrown by find().
    void prepare(Route route, const std::vector<std::uint32_t>& specialization, Make make);

    /// The pipeline for these specialization constants; `make` is called where none is there or prepared.
    gpu::Pipeline& find(Route route, const std::vector<std::uint32_t>& specialization, const Make& make);

    [[nodiscard]] std::size_t size() const { return pipelines.size(); }

private:
    class Workers;
    using Key = std::pair<Route, std::vector<std::uint32_t>>;

    std::map<Key, gpu::Pipeline> pipelines;
    std::map<Key, std::future<gpu::Pipeline>> coming;
    std::unique_ptr<Workers> workers;  // null until something is prepared
};

}  // namespace raytorus::render
