# SPDX-License-Identifier: GPL-3.0-or-later
# GMP::gmp, and the variables that CGAL's own module of this name would set.
find_path(GMP_INCLUDE_DIR gmp.h)
find_library(GMP_LIBRARIES gmp)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(GMP REQUIRED_VARS GMP_LIBRARIES GMP_INCLUDE_DIR)
if(GMP_FOUND AND NOT TARGET GMP::gmp)
    add_library(GMP::gmp UNKNOWN IMPORTED)
    set_target_properties(GMP::gmp PROPERTIES
        IMPORTED_LOCATION ${GMP_LIBRARIES} INTERFACE_INCLUDE_DIRECTORIES ${GMP_INCLUDE_DIR})
endif()
mark_as_advanced(GMP_INCLUDE_DIR GMP_LIBRARIES)
