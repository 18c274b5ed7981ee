# pencil_discover_suites(target COST each PROPERTIES properties...): a test for each suite of a GoogleTest program, known once it is built.
# One for each of its tests, as gtest_discover_tests has it, would load the image library and open the device again for tests of milliseconds.
# COST: about what one of its tests takes, an integer: long suites are to start first. As a script, after the build: writes them to OUTPUT.
if(CMAKE_SCRIPT_MODE_FILE)
    execute_process(COMMAND ${PROGRAM} --gtest_list_tests OUTPUT_VARIABLE listed COMMAND_ERROR_IS_FATAL ANY)
    string(REGEX MATCHALL "(^|\n)[^ \n]+\\.[^\n]*" suites "${listed}")
    set(script "")
    foreach(suite IN LISTS suites)
        string(REGEX REPLACE "\n|\\.( .*)?$" "" suite "${suite}")
        string(REGEX REPLACE "^.*\n?${suite}\\.[^\n]*" "" own "\n${listed}")  # its tests are indented
        string(REGEX REPLACE "\n[^ \n].*" "" own "${own}")
        string(REGEX REPLACE "\n  DISABLED_[^\n]*" "" own "${own}")
        string(REGEX MATCHALL "\n  " tests "${own}")
        list(LENGTH tests count)
        if(count EQUAL 0 OR suite MATCHES "^DISABLED_")
            continue()
        endif()
        math(EXPR cost "${count} * ${COST}")
        string(APPEND script "add_test([=[${suite}]=] [=[${PROGRAM}]=] [=[--gtest_filter=${suite}.*]=])\n"
                             "set_tests_properties([=[${suite}]=] PROPERTIES COST ${cost} FAIL_REGULAR_EXPRESSION [=[Running 0 tests]=] ${PROPERTIES})\n")
    endforeach()
    file(WRITE ${OUTPUT} "${script}")
    return()
endif()

function(pencil_discover_suites target)
    cmake_parse_arguments(ARG "" "COST" "PROPERTIES" ${ARGN})
    set(output ${CMAKE_CURRENT_BINARY_DIR}/${target}_suites.cmake)
    add_custom_command(TARGET ${target} POST_BUILD BYPRODUCTS ${output}
        COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:${target}> -DCOST=${ARG_COST} "-DPROPERTIES=${ARG_PROPERTIES}" -DOUTPUT=${output}
                -P ${CMAKE_CURRENT_FUNCTION_LIST_FILE}
        VERBATIM)
    if(NOT EXISTS ${output})
        file(WRITE ${output} "add_test(${target}_NOT_BUILT ${target}_NOT_BUILT)\n")
    endif()
    set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${output})
endfunction()
