// SPDX-License-Identifier: MIT
// A move-only owner of one Vulkan object that belongs to a device. Plain vulkan.h with this template instead
// of Vulkan-Hpp's RAII header: that costs 6 s of compile time in each file that includes it, and minutes with
// UBSan.
#pragma once

#include <vulkan/vulkan.h>

#include <string_view>
#include <utility>

#include "gpu/result.hpp"

namespace raytorus::gpu {

/// What the objects of a device share. Lives in the Context, at a fixed address.
struct DeviceScope {
    VkDevice device = VK_NULL_HANDLE;
    /// Set when the device did not finish in time: it may still use its objects, so none is destroyed any
    /// more.
    bool abandoned = false;
};

/// `destroy` is the vkDestroy... or vkFree... function of the object.
template <typename Object, auto destroy>
class Handle {
public:
    Handle() = default;
    Handle(const DeviceScope& owner, Object owned) : scope(&owner), object(owned) {}
    Handle(Handle&& other) noexcept
        : scope(std::exchange(other.scope, nullptr)), object(std::exchange(other.object, Object{})) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(scope, other.scope);
        std::swap(object, other.object);
        return *this;
    }
    ~Handle() {
        if (scope != nullptr && !scope->abandoned) {
            destroy(scope->device, object, nullptr);
        }
    }

    [[nodiscard]] Object get() const { return object; }
    [[nodiscard]] const Object* address() const { return &object; }
    explicit operator bool() const { return scope != nullptr; }

private:
    const DeviceScope* scope = nullptr;
    Object object{};
};

/// Creates an object by a function of the form vkCreate...(device, &info, allocator, &object).
template <auto destroy, typename Object, typename Info>
Handle<Object, destroy> create(VkResult (*function)(VkDevice, const Info*, const VkAllocationCallbacks*,
                                                    Object*),
                               const DeviceScope& scope, const Info& info, std::string_view call) {
    Object object{};
    check(function(scope.device, &info, nullptr, &object), call);
    return {scope, object};
}

}  // namespace raytorus::gpu
