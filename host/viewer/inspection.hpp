// SPDX-License-Identifier: MIT
// What the host works out about the picture that is shown: reference and golden, for the views of that name.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "viewer/analysis.hpp"
#include "viewer/event_log.hpp"
#include "viewer/golden_view.hpp"
#include "viewer/pictures.hpp"
#include "viewer/view_pass.hpp"

namespace raytorus::viewer {

class Inspection {
public:
    /// All are kept by reference.
    Inspection(gpu::Context& context, ViewPass& viewPass, const EventLog& log);

    /// Which golden picture belongs to the scene: the file, or if that is empty, the scene's own.
    void openGolden(const std::string& file, const std::filesystem::path& scene);

    /// Another picture is shown: what is known about the one before is of no use.
    void forget();

    /// Begins, goes on and takes what is there for the state's view. True: the view has to be drawn again.
    /// `shaders`: the left side's.
    bool update(State& state, Pictures& pictures, const trace::ShaderSource& shaders);

    /// All is known that the view shows.
    [[nodiscard]] bool complete(const State& state) const;

    /// The size of the golden picture, or of nothing.
    [[nodiscard]] VkExtent2D goldenSize() const { return sizeOfGolden; }

private:
    bool updateAnalysis(State& state, Pictures& pictures);
    void updateGolden(State& state, const trace::ShaderSource& shaders);

    gpu::Context* context;
    ViewPass* viewPass;
    const EventLog* log;
    Analysis analysis;
    std::optional<Golden> golden;
    VkExtent2D sizeOfGolden{1, 1};
    bool analysisStale = true;
    bool goldenStale = true;
};

}  // namespace raytorus::viewer
