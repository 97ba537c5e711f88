# SPDX-License-Identifier: GPL-3.0-or-later
# find_package(sightline COMPONENTS <modules>) for other projects: one export a module, and a config that
# brings in what the asked modules need.
include_guard()
include(CMakePackageConfigHelpers)
set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/sightline)

get_property(SIGHTLINE_MODULES GLOBAL PROPERTY SIGHTLINE_MODULES)
set(SIGHTLINE_MODULE_DEPS "")
foreach(module IN LISTS SIGHTLINE_MODULES)
    get_property(deps GLOBAL PROPERTY SIGHTLINE_${module}_DEPS)
    string(APPEND SIGHTLINE_MODULE_DEPS "set(sightline_${module}_deps ${deps})\n")
    install(EXPORT sightline_${module} NAMESPACE sightline:: FILE sightline_${module}.cmake DESTINATION ${config_dir})
endforeach()

configure_package_config_file(cmake/sightlineConfig.cmake.in ${PROJECT_BINARY_DIR}/sightlineConfig.cmake
    INSTALL_DESTINATION ${config_dir} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/sightlineConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/sightlineConfig.cmake ${PROJECT_BINARY_DIR}/sightlineConfigVersion.cmake
              cmake/FindGMP.cmake cmake/FindMPFR.cmake
        DESTINATION ${config_dir})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
