// SPDX-License-Identifier: MIT
// Compute pipelines, and graphics pipelines that draw one triangle over the whole picture. Both come with
// their descriptor sets, because each of our pipelines has one, or a few alike for submissions that overlap.
#pragma once

#include <vulkan/vulkan.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "gpu/buffer.hpp"
#include "gpu/device_image.hpp"
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
    std::uint32_t copies = 1;         ///< of set 0: each may be bound to others, and is used by itself
};

class Pipeline {
public:
    Pipeline() = default;

    /// A copy of set 0, once for the pipeline's life or between submissions that use that copy.
    void bind(std::uint32_t index, const Buffer& buffer, std::size_t copy = 0);
    void bind(std::uint32_t index, const DeviceImage& image, std::size_t copy = 0);

    /// Binds pipeline and a copy of set 0, and sets the push constants if there are any.
    void use(VkCommandBuffer commands, std::span<const std::byte> pushConstants = {},
             std::size_t copy = 0) const;

    [[nodiscard]] VkPipeline get() const { return pipeline.get(); }

private:
    friend Pipeline makeComputePipeline(const Context&, const ShaderModule&, const PipelineLayoutInfo&);
    friend Pipeline makeScreenPipeline(const Context&, const ShaderModule&, const ShaderModule&,
                                       std::uint32_t, const PipelineLayoutInfo&);
    Pipeline(const Context& context, const PipelineLayoutInfo& info, VkPipelineBindPoint point);

    void write(std::uint32_t index, std::size_t copy, const VkDescriptorBufferInfo* buffer,
               const VkDescriptorImageInfo* image);

    VkDevice device = VK_NULL_HANDLE;
    VkPipelineBindPoint bindPoint = VK_PIPELINE_BIND_POINT_COMPUTE;
    VkShaderStageFlags stages = 0;
    std::vector<Binding> bindings;
    Handle<VkDescriptorSetLayout, vkDestroyDescriptorSetLayout> setLayout;
    Handle<VkDescriptorPool, vkDestroyDescriptorPool> pool;
    std::vector<VkDescriptorSet> sets;
    Handle<VkPipelineLayout, vkDestroyPipelineLayout> layout;
    Handle<VkPipeline, vkDestroyPipeline> pipeline;
};

Pipeline makeComputePipeline(const Context& context, const ShaderModule& shader,
                             const PipelineLayoutInfo& info);

/// A full-screen triangle into `attachments` colour images of gpu::DeviceImage::format. Viewport and scissor
/// are dynamic.
Pipeline makeScreenPipeline(const Context& context, const ShaderModule& vertex, const ShaderModule& fragment,
                            std::uint32_t attachments, const PipelineLayoutInfo& info);

}  // namespace raytorus::gpu
