// SPDX-License-Identifier: MIT
// What the host works out about the picture that is shown: reference and golden, for the views of that name,
// and a pixel taken apart.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "gpu/context.hpp"
#include "image/image.hpp"
#include "trace/shader_source.hpp"
#include "viewer/analysis.hpp"
#include "viewer/commands.hpp"
#include "viewer/event_log.hpp"
#include "viewer/pictures.hpp"
#include "viewer/state.hpp"
#include "viewer/view_pass.hpp"

namespace raytorus::viewer {

/// A golden picture and how it was made.
struct Golden {
    std::string name;  ///< of its file
    image::Image truth;
    int samplesPerSide = 1;
};

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

    /// What `raytorus explain` says of a pixel. deviceWords: what its command has of the device. Throws
    /// Error{Usage} for a pixel outside the picture.
    [[nodiscard]] Pick takeApart(const TakeApart& pixel, const Pictures& pictures,
                                 const trace::ShaderSource& shaders, const std::string& deviceWords) const;

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
