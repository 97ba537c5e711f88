# SPDX-License-Identifier: GPL-3.0-or-later
# What a module is, once: library and alias, public headers that compile alone, tests, installation.
include_guard()

# Sources that match the patterns, without those that need VTK when there is none.
function(sightline_glob result)
    file(GLOB_RECURSE files CONFIGURE_DEPENDS ${ARGN})
    if(NOT SIGHTLINE_VTK_TARGETS)
        list(FILTER files EXCLUDE REGEX "_vtk\\.cpp$")
    endif()
    set(${result} ${files} PARENT_SCOPE)
endfunction()

# Other people's headers that our public headers don't need: no trace of them in an installation.
function(sightline_hide_header_only result)
    set(targets)
    foreach(target IN LISTS ARGN)
        if(target MATCHES "^(CGAL::CGAL|Boost::headers|nlohmann_json::nlohmann_json)$")
            list(APPEND targets $<BUILD_INTERFACE:${target}>)
        else()
            list(APPEND targets ${target})
        endif()
    endforeach()
    set(${result} ${targets} PARENT_SCOPE)
endfunction()

# sightline_module(<name> DEPS <modules> [PUBLIC <targets>] [PRIVATE <targets>] [TEST_DEPS <modules>])
# Folder = module = target = include path = test folder: include/sightline/<name>, lib/<name>, tests/<name>.
function(sightline_module name)
    cmake_parse_arguments(arg "" "" "DEPS;PUBLIC;PRIVATE;TEST_DEPS" ${ARGN})
    set(target sightline_${name})
    sightline_glob(sources ${PROJECT_SOURCE_DIR}/lib/${name}/*.cpp)
    file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/include/sightline/${name}/*.hpp)
    list(TRANSFORM arg_DEPS PREPEND sightline:: OUTPUT_VARIABLE deps)
    set(scope INTERFACE)
    if(sources)
        set(scope PUBLIC)
        sightline_hide_header_only(private ${arg_PRIVATE})
        add_library(${target} ${sources})
        target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/lib)
        target_link_libraries(${target} PRIVATE ${private} $<BUILD_INTERFACE:sightline_flags>)
        # Python's module holds these libraries: position independent, and nothing visible that could be replaced.
        set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
        if(NOT BUILD_SHARED_LIBS)
            set_target_properties(${target} PROPERTIES CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
        endif()
        if(sources MATCHES "_vtk\\.cpp")
            target_compile_definitions(${target} PUBLIC SIGHTLINE_HAS_VTK)
            vtk_module_autoinit(TARGETS ${target} MODULES ${SIGHTLINE_VTK_TARGETS})
        endif()
    else()
        add_library(${target} INTERFACE)
    endif()
    target_sources(${target} ${scope} FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}/include FILES ${headers})
    target_link_libraries(${target} ${scope} ${deps} ${arg_PUBLIC})
    target_compile_features(${target} ${scope} cxx_std_20)
    set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
    add_library(sightline::${name} ALIAS ${target})

    set_property(GLOBAL APPEND PROPERTY SIGHTLINE_MODULES ${name})
    set_property(GLOBAL PROPERTY SIGHTLINE_${name}_DEPS ${arg_DEPS})
    install(TARGETS ${target} EXPORT sightline_${name}
            ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
            FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})

    if(SIGHTLINE_TESTS)
        sightline_module_tests(${name} "${arg_PRIVATE}" "${arg_TEST_DEPS}")
    endif()
endfunction()

# test_<name> from tests/<name>/*.cpp, and test_<name>_slow from those that end in _slow.cpp.
function(sightline_module_tests name private test_deps)
    sightline_glob(quick ${PROJECT_SOURCE_DIR}/tests/${name}/*.cpp)
    set(slow ${quick})
    list(FILTER quick EXCLUDE REGEX "_slow\\.cpp$")
    list(FILTER slow INCLUDE REGEX "_slow\\.cpp$")
    list(TRANSFORM test_deps PREPEND sightline::)
    foreach(sources IN ITEMS quick slow)
        if(${sources})
            set(test test_${name})
            if(sources STREQUAL "slow")
                set(test test_${name}_slow)
            endif()
            add_executable(${test} ${${sources}})
            target_include_directories(${test} PRIVATE ${PROJECT_SOURCE_DIR}/lib ${PROJECT_SOURCE_DIR}/tests)
            target_compile_definitions(${test} PRIVATE SIGHTLINE_TESTS_DIR="${PROJECT_SOURCE_DIR}/tests")
            target_link_libraries(${test} PRIVATE sightline::${name} ${test_deps} ${private} sightline_flags
                                  GTest::gmock_main rapidcheck rapidcheck_gtest rapidcheck_gmock)
            sightline_discover_tests(${test} ${name})
        endif()
    endforeach()
endfunction()

# One ctest entry a test, named <module>.<Suite>.<Test> and labelled with the module
# and with the kind that the name of its file ends in (unit, laws, degenerate, …).
function(sightline_discover_tests target module)
    set(list ${CMAKE_CURRENT_BINARY_DIR}/${target}_tests.cmake)
    add_custom_command(TARGET ${target} POST_BUILD VERBATIM BYPRODUCTS ${list}
        COMMAND ${CMAKE_COMMAND} -D program=$<TARGET_FILE:${target}> -D module=${module} -D list=${list}
                -P ${PROJECT_SOURCE_DIR}/cmake/DiscoverTests.cmake)
    set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${PROJECT_BINARY_DIR}/${target}_include.cmake)
    file(WRITE ${PROJECT_BINARY_DIR}/${target}_include.cmake
        "if(EXISTS \"${list}\")\n    include(\"${list}\")\nelse()\n"
        "    add_test(${target}_not_built ${target}_not_built)\nendif()\n")
endfunction()
