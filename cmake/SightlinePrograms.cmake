# SPDX-License-Identifier: GPL-3.0-or-later
# The shipped surfaces: the program `sightline` (lib/cli) and the Python package of the same name (lib/python).
include_guard()
get_property(sightline_modules GLOBAL PROPERTY SIGHTLINE_MODULES)
list(TRANSFORM sightline_modules PREPEND sightline:: OUTPUT_VARIABLE SIGHTLINE_ALL)

if(SIGHTLINE_PROGRAMS AND EXISTS ${PROJECT_SOURCE_DIR}/lib/cli/main.cpp)
    find_package(CLI11 REQUIRED)
    sightline_glob(sources ${PROJECT_SOURCE_DIR}/lib/cli/*.cpp)
    add_executable(sightline_cli ${sources})
    set_target_properties(sightline_cli PROPERTIES OUTPUT_NAME sightline)
    target_include_directories(sightline_cli PRIVATE ${PROJECT_SOURCE_DIR}/lib)
    target_link_libraries(sightline_cli PRIVATE ${SIGHTLINE_ALL} sightline_flags
                          CLI11::CLI11 nlohmann_json::nlohmann_json fmt::fmt TBB::tbb)
    install(TARGETS sightline_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()

if(SIGHTLINE_PYTHON AND EXISTS ${PROJECT_SOURCE_DIR}/lib/python/module.cpp)
    # build/<preset>/python is what PYTHONPATH points at: sightline/__init__.py and the compiled sightline/_core.
    set(SIGHTLINE_PYTHON_DIR ${PROJECT_BINARY_DIR}/python)
    sightline_glob(sources ${PROJECT_SOURCE_DIR}/lib/python/*.cpp)
    pybind11_add_module(sightline_python MODULE NO_EXTRAS ${sources})
    set_target_properties(sightline_python PROPERTIES
        OUTPUT_NAME _core LIBRARY_OUTPUT_DIRECTORY ${SIGHTLINE_PYTHON_DIR}/sightline)
    target_include_directories(sightline_python PRIVATE ${PROJECT_SOURCE_DIR}/lib)
    target_link_libraries(sightline_python PRIVATE ${SIGHTLINE_ALL} sightline_flags fmt::fmt TBB::tbb)
    file(GLOB scripts CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/lib/python/sightline
         ${PROJECT_SOURCE_DIR}/lib/python/sightline/*.py ${PROJECT_SOURCE_DIR}/lib/python/sightline/*.pyi
         ${PROJECT_SOURCE_DIR}/lib/python/sightline/py.typed)
    set(copies)
    foreach(script IN LISTS scripts)
        set(copy ${SIGHTLINE_PYTHON_DIR}/sightline/${script})
        add_custom_command(OUTPUT ${copy} VERBATIM
            DEPENDS ${PROJECT_SOURCE_DIR}/lib/python/sightline/${script}
            COMMAND ${CMAKE_COMMAND} -E copy ${PROJECT_SOURCE_DIR}/lib/python/sightline/${script} ${copy})
        list(APPEND copies ${copy})
    endforeach()
    add_custom_target(sightline_python_scripts ALL DEPENDS ${copies})
    add_dependencies(sightline_python sightline_python_scripts)
    install(TARGETS sightline_python LIBRARY DESTINATION lib/python3/dist-packages/sightline)
    install(DIRECTORY lib/python/sightline/ DESTINATION lib/python3/dist-packages/sightline FILES_MATCHING REGEX "\\.pyi?$|py\\.typed$")
endif()
