# pencil_library(FOLDER [USES folders...] [LINKS libraries...] [PRIVATE libraries...] [SOURCES generated files...] [PRECOMPILE headers...])
# The library pencil_<folder> of host/<folder>/*.cpp. Its headers are reached through a folder of links that holds these headers only, so
# whoever does not use the library cannot include them.

# Structs and constants that host and kernels share, the only files of kernels/ that the host includes.
file(GLOB shared_headers CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/kernels/shared/*.h ${CMAKE_SOURCE_DIR}/kernels/*.h)
add_library(pencil_shared INTERFACE)

function(pencil_link_headers root base)
    file(REMOVE_RECURSE ${root})
    foreach(header IN LISTS ARGN)
        file(RELATIVE_PATH name ${base} ${header})
        get_filename_component(place ${root}/${name} DIRECTORY)
        file(MAKE_DIRECTORY ${place})
        file(CREATE_LINK ${header} ${root}/${name} SYMBOLIC)
    endforeach()
endfunction()

pencil_link_headers(${CMAKE_BINARY_DIR}/headers/shared ${CMAKE_SOURCE_DIR}/kernels ${shared_headers})
target_include_directories(pencil_shared INTERFACE $<BUILD_INTERFACE:${CMAKE_BINARY_DIR}/headers/shared>
                           $<INSTALL_INTERFACE:include> $<INSTALL_INTERFACE:include/pencil>)
target_link_libraries(pencil_shared INTERFACE glm::glm)
set_property(TARGET pencil_shared PROPERTY EXPORT_NAME shared)

function(pencil_library folder)
    cmake_parse_arguments(ARG "" "" "USES;LINKS;PRIVATE;SOURCES;PRECOMPILE" ${ARGN})
    string(REPLACE "/" "_" name ${folder})
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/host/${folder}/*.cpp)
    file(GLOB headers CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/host/${folder}/*.h)
    list(FILTER sources EXCLUDE REGEX "/main\\.cpp$")
    set(root ${CMAKE_BINARY_DIR}/headers/${name})
    pencil_link_headers(${root} ${CMAKE_SOURCE_DIR}/host ${headers})

    add_library(pencil_${name} STATIC ${sources} ${ARG_SOURCES})
    target_include_directories(pencil_${name} PUBLIC $<BUILD_INTERFACE:${root}> $<INSTALL_INTERFACE:include> $<INSTALL_INTERFACE:include/pencil>)
    target_link_libraries(pencil_${name} PUBLIC pencil_shared ${ARG_LINKS} PRIVATE ${ARG_PRIVATE} $<BUILD_INTERFACE:pencil_warnings>)
    set_property(TARGET pencil_${name} PROPERTY EXPORT_NAME ${name})
    set_property(GLOBAL APPEND PROPERTY PENCIL_LIBRARIES pencil_${name})
    target_precompile_headers(pencil_${name} PRIVATE ${ARG_PRECOMPILE})
    foreach(used IN LISTS ARG_USES)
        string(REPLACE "/" "_" used ${used})
        target_link_libraries(pencil_${name} PUBLIC pencil_${used})
    endforeach()
endfunction()
