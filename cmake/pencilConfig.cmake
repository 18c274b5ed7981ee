# find_package(pencil): the libraries pencil::render, pencil::scene_formats and those below them.
include(CMakeFindDependencyMacro)
foreach(dependency IN ITEMS OpenCL OpenImageIO pugixml TinyGLTF ZLIB fmt spdlog nlohmann_json glm TBB)
    find_dependency(${dependency})
endforeach()
find_dependency(embree 3)
include(${CMAKE_CURRENT_LIST_DIR}/pencilTargets.cmake)
