// SPDX-License-Identifier: MIT
#include "gpu/timestamps.hpp"

#include <array>

#include "gpu/result.hpp"

namespace raytorus::gpu {

Timestamps::Timestamps(const Context& context)
    : device(context.device()), period(context.info().timestampPeriod) {
    if (period > 0.0) {
        VkQueryPoolCreateInfo info{VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO};
        info.queryType = VK_QUERY_TYPE_TIMESTAMP;
        info.queryCount = 2;
        pool = create<vkDestroyQueryPool>(vkCreateQueryPool, context.scope(), info, "vkCreateQueryPool");
    }
}

void Timestamps::begin(VkCommandBuffer commands) const {
    if (pool) {
        vkCmdResetQueryPool(commands, pool.get(), 0, 2);
        vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, pool.get(), 0);
    }
}

void Timestamps::end(VkCommandBuffer commands) const {
    if (pool) {
        vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, pool.get(), 1);
    }
}

std::optional<double> Timestamps::seconds() const {
    if (!pool) {
        return std::nullopt;
    }
    std::array<std::uint64_t, 2> ticks{};
    check(vkGetQueryPoolResults(device, pool.get(), 0, 2, sizeof(ticks), ticks.data(), sizeof(std::uint64_t),
                                VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
          "vkGetQueryPoolResults");
    return static_cast<double>(ticks[1] - ticks[0]) * period * 1e-9;
}

}  // namespace raytorus::gpu
