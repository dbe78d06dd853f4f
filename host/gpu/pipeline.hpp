// SPDX-License-Identifier: MIT
// Compute pipelines, and graphics pipelines that draw one triangle over the whole picture. Both come with
// their descriptor set, because each of our pipelines has exactly one.
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <span>
#include <vector>

#include "gpu/buffer.hpp"
#include "gpu/image.hpp"
#include "gpu/shader_module.hpp"

namespace raytorus::gpu {

/// What a shader's binding is made of: a uniform buffer, a storage buffer or a storage image.
struct Binding {
    std::uint32_t index = 0;
    VkDescriptorType type = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
};

struct PipelineLayoutInfo {
    std::vector<Binding> bindings;        ///< of set 0
    std::uint32_t pushConstantBytes = 0;  ///< visible to every stage of the pipeline
    VkShaderStageFlags stages = VK_SHADER_STAGE_COMPUTE_BIT;
    /// Values of the specialization constants 0, 1, 2, ...; booleans are 0 and 1.
    std::vector<std::uint32_t> specialization;
    VkPipelineCreateFlags flags = 0;  ///< of compute pipelines
};

class Pipeline {
public:
    Pipeline() = default;

    /// Set 0, once for the pipeline's life or between submissions.
    void bind(std::uint32_t index, const Buffer& buffer);
    void bind(std::uint32_t index, const Image& image);

    /// Binds pipeline and descriptor set, and sets the push constants if there are any.
    void use(VkCommandBuffer commands, std::span<const std::byte> pushConstants = {}) const;

    [[nodiscard]] VkPipeline get() const { return pipeline.get(); }

private:
    friend Pipeline makeComputePipeline(const Context&, const ShaderModule&, const PipelineLayoutInfo&);
    friend Pipeline makeScreenPipeline(const Context&, const ShaderModule&, const ShaderModule&,
                                       std::uint32_t, const PipelineLayoutInfo&);
    Pipeline(const Context& context, const PipelineLayoutInfo& info, VkPipelineBindPoint point);

    void write(std::uint32_t index, const VkDescriptorBufferInfo* buffer, const VkDescriptorImageInfo* image);

    VkDevice device = VK_NULL_HANDLE;
    VkPipelineBindPoint bindPoint = VK_PIPELINE_BIND_POINT_COMPUTE;
    VkShaderStageFlags stages = 0;
    std::vector<Binding> bindings;
    Handle<VkDescriptorSetLayout, vkDestroyDescriptorSetLayout> setLayout;
    Handle<VkDescriptorPool, vkDestroyDescriptorPool> pool;
    VkDescriptorSet set = VK_NULL_HANDLE;
    Handle<VkPipelineLayout, vkDestroyPipelineLayout> layout;
    Handle<VkPipeline, vkDestroyPipeline> pipeline;
};

Pipeline makeComputePipeline(const Context& context, const ShaderModule& shader,
                             const PipelineLayoutInfo& info);

/// A full-screen triangle into `attachments` colour images of gpu::Image::format. Viewport and scissor are
/// dynamic.
Pipeline makeScreenPipeline(const Context& context, const ShaderModule& vertex, const ShaderModule& fragment,
                            std::uint32_t attachments, const PipelineLayoutInfo& info);

}  // namespace raytorus::gpu
