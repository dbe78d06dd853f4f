// SPDX-License-Identifier: MIT
#include "gpu/pipeline.hpp"

#include <algorithm>
#include <array>

#include "gpu/result.hpp"

namespace raytorus::gpu {
namespace {

// Specialization constants 0, 1, 2, ... of 4 bytes each. Points into `info`, which must outlive it.
struct Specialization {
    explicit Specialization(const PipelineLayoutInfo& info) {
        for (std::uint32_t i = 0; i < info.specialization.size(); ++i) {
            entries.push_back(
                {i, i * static_cast<std::uint32_t>(sizeof(std::uint32_t)), sizeof(std::uint32_t)});
        }
        vulkan.mapEntryCount = static_cast<std::uint32_t>(entries.size());
        vulkan.pMapEntries = entries.data();
        vulkan.dataSize = info.specialization.size() * sizeof(std::uint32_t);
        vulkan.pData = info.specialization.data();
    }
    std::vector<VkSpecializationMapEntry> entries;
    VkSpecializationInfo vulkan{};
};

VkPipelineShaderStageCreateInfo stageInfo(VkShaderStageFlagBits stage, const ShaderModule& shader,
                                          const Specialization& specialization) {
    VkPipelineShaderStageCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO};
    info.stage = stage;
    info.module = shader.get();
    info.pName = "main";
    info.pSpecializationInfo = &specialization.vulkan;
    return info;
}

}  // namespace

Pipeline::Pipeline(const Context& context, const PipelineLayoutInfo& info, VkPipelineBindPoint point)
    : device(context.device()), bindPoint(point), stages(info.stages), bindings(info.bindings) {
    std::vector<VkDescriptorSetLayoutBinding> layoutBindings;
    std::vector<VkDescriptorPoolSize> sizes;
    for (const Binding& binding : bindings) {
        layoutBindings.push_back({binding.index, binding.type, 1, stages, nullptr});
        sizes.push_back({binding.type, info.copies});
    }
    VkDescriptorSetLayoutCreateInfo setInfo{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
    setInfo.bindingCount = static_cast<std::uint32_t>(layoutBindings.size());
    setInfo.pBindings = layoutBindings.data();
    setLayout = create<vkDestroyDescriptorSetLayout>(vkCreateDescriptorSetLayout, context.scope(), setInfo,
                                                     "vkCreateDescriptorSetLayout");
    VkDescriptorPoolCreateInfo poolInfo{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
    poolInfo.maxSets = info.copies;
    poolInfo.poolSizeCount = static_cast<std::uint32_t>(sizes.size());
    poolInfo.pPoolSizes = sizes.data();
    pool = create<vkDestroyDescriptorPool>(vkCreateDescriptorPool, context.scope(), poolInfo,
                                           "vkCreateDescriptorPool");
    VkDescriptorSetAllocateInfo allocation{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
    allocation.descriptorPool = pool.get();
    const std::vector<VkDescriptorSetLayout> layouts(info.copies, setLayout.get());
    allocation.descriptorSetCount = info.copies;
    allocation.pSetLayouts = layouts.data();
    sets.resize(info.copies);
    check(vkAllocateDescriptorSets(device, &allocation, sets.data()), "vkAllocateDescriptorSets");

    const VkPushConstantRange range{stages, 0, info.pushConstantBytes};
    VkPipelineLayoutCreateInfo layoutInfo{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
    layoutInfo.setLayoutCount = 1;
    layoutInfo.pSetLayouts = setLayout.address();
    layoutInfo.pushConstantRangeCount = info.pushConstantBytes > 0 ? 1 : 0;
    layoutInfo.pPushConstantRanges = &range;
    layout = create<vkDestroyPipelineLayout>(vkCreatePipelineLayout, context.scope(), layoutInfo,
                                             "vkCreatePipelineLayout");
}

void Pipeline::write(std::uint32_t index, std::size_t copy, const VkDescriptorBufferInfo* buffer,
                     const VkDescriptorImageInfo* image) {
    const auto found = std::find_if(bindings.begin(), bindings.end(),
                                    [index](const Binding& binding) { return binding.index == index; });
    if (found == bindings.end()) {
        return;  // this pipeline's shader has no use for it
    }
    VkWriteDescriptorSet info{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
    info.dstSet = sets.at(copy);
    info.dstBinding = index;
    info.descriptorCount = 1;
    info.descriptorType = found->type;
    info.pBufferInfo = buffer;
    info.pImageInfo = image;
    vkUpdateDescriptorSets(device, 1, &info, 0, nullptr);
}

void Pipeline::bind(std::uint32_t index, const Buffer& buffer, std::size_t copy) {
    const VkDescriptorBufferInfo info{buffer.get(), 0, VK_WHOLE_SIZE};
    write(index, copy, &info, nullptr);
}

void Pipeline::bind(std::uint32_t index, const DeviceImage& image, std::size_t copy) {
    const VkDescriptorImageInfo info{VK_NULL_HANDLE, image.view(), VK_IMAGE_LAYOUT_GENERAL};
    write(index, copy, nullptr, &info);
}

void Pipeline::use(VkCommandBuffer commands, std::span<const std::byte> pushConstants,
                   std::size_t copy) const {
    vkCmdBindPipeline(commands, bindPoint, pipeline.get());
    vkCmdBindDescriptorSets(commands, bindPoint, layout.get(), 0, 1, &sets.at(copy), 0, nullptr);
    if (!pushConstants.empty()) {
        vkCmdPushConstants(commands, layout.get(), stages, 0,
                           static_cast<std::uint32_t>(pushConstants.size()), pushConstants.data());
    }
}

Pipeline makeComputePipeline(const Context& context, const ShaderModule& shader,
                             const PipelineLayoutInfo& info) {
    Pipeline result(context, info, VK_PIPELINE_BIND_POINT_COMPUTE);
    const Specialization specialization(info);
    VkComputePipelineCreateInfo pipelineInfo{VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
    pipelineInfo.flags = info.flags;
    pipelineInfo.stage = stageInfo(VK_SHADER_STAGE_COMPUTE_BIT, shader, specialization);
    pipelineInfo.layout = result.layout.get();
    VkPipeline created = VK_NULL_HANDLE;
    check(vkCreateComputePipelines(context.device(), VK_NULL_HANDLE, 1, &pipelineInfo, nullptr, &created),
          "vkCreateComputePipelines");
    result.pipeline = {context.scope(), created};
    return result;
}

Pipeline makeScreenPipeline(const Context& context, const ShaderModule& vertex, const ShaderModule& fragment,
                            std::uint32_t attachments, const PipelineLayoutInfo& info) {
    Pipeline result(context, info, VK_PIPELINE_BIND_POINT_GRAPHICS);
    const Specialization specialization(info);
    const std::array shaderStages = {stageInfo(VK_SHADER_STAGE_VERTEX_BIT, vertex, specialization),
                                     stageInfo(VK_SHADER_STAGE_FRAGMENT_BIT, fragment, specialization)};
    const VkPipelineVertexInputStateCreateInfo vertexInput{
        VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
    VkPipelineInputAssemblyStateCreateInfo assembly{
        VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
    assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    VkPipelineViewportStateCreateInfo viewport{VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO};
    viewport.viewportCount = 1;
    viewport.scissorCount = 1;
    VkPipelineRasterizationStateCreateInfo rasterization{
        VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
    rasterization.polygonMode = VK_POLYGON_MODE_FILL;
    rasterization.cullMode = VK_CULL_MODE_NONE;
    rasterization.lineWidth = 1.0F;
    VkPipelineMultisampleStateCreateInfo multisample{
        VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
    multisample.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
    VkPipelineColorBlendAttachmentState blend{};
    blend.colorWriteMask = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT |
                           VK_COLOR_COMPONENT_A_BIT;
    const std::vector<VkPipelineColorBlendAttachmentState> blends(attachments, blend);
    VkPipelineColorBlendStateCreateInfo blending{VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
    blending.attachmentCount = attachments;
    blending.pAttachments = blends.data();
    const std::array dynamicStates = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
    VkPipelineDynamicStateCreateInfo dynamic{VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO};
    dynamic.dynamicStateCount = static_cast<std::uint32_t>(dynamicStates.size());
    dynamic.pDynamicStates = dynamicStates.data();
    const std::vector<VkFormat> formats(attachments, DeviceImage::format);
    VkPipelineRenderingCreateInfo rendering{VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO};
    rendering.colorAttachmentCount = attachments;
    rendering.pColorAttachmentFormats = formats.data();

    VkGraphicsPipelineCreateInfo pipelineInfo{VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO};
    pipelineInfo.pNext = &rendering;
    pipelineInfo.stageCount = static_cast<std::uint32_t>(shaderStages.size());
    pipelineInfo.pStages = shaderStages.data();
    pipelineInfo.pVertexInputState = &vertexInput;
    pipelineInfo.pInputAssemblyState = &assembly;
    pipelineInfo.pViewportState = &viewport;
    pipelineInfo.pRasterizationState = &rasterization;
    pipelineInfo.pMultisampleState = &multisample;
    pipelineInfo.pColorBlendState = &blending;
    pipelineInfo.pDynamicState = &dynamic;
    pipelineInfo.layout = result.layout.get();
    VkPipeline created = VK_NULL_HANDLE;
    check(vkCreateGraphicsPipelines(context.device(), VK_NULL_HANDLE, 1, &pipelineInfo, nullptr, &created),
          "vkCreateGraphicsPipelines");
    result.pipeline = {context.scope(), created};
    return result;
}

}  // namespace raytorus::gpu
