# SPDX-License-Identifier: MIT
# raytorus::scene: scenes as data, their JSON form and the bounding volume hierarchy. Knows neither Vulkan nor images.
raytorus_add_library(scene
    SOURCES scene.cpp scene_animation.cpp scene_json.cpp scene_json_write.cpp json_node.cpp bvh.cpp
    PUBLIC raytorus::core glm::glm
    PRIVATE nlohmann_json::nlohmann_json)
