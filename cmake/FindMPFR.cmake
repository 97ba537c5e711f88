# SPDX-License-Identifier: GPL-3.0-or-later
# MPFR::mpfr, and the variables that CGAL's own module of this name would set.
find_path(MPFR_INCLUDE_DIR mpfr.h)
find_library(MPFR_LIBRARIES mpfr)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(MPFR REQUIRED_VARS MPFR_LIBRARIES MPFR_INCLUDE_DIR)
if(MPFR_FOUND AND NOT TARGET MPFR::mpfr)
    add_library(MPFR::mpfr UNKNOWN IMPORTED)
    set_target_properties(MPFR::mpfr PROPERTIES
        IMPORTED_LOCATION ${MPFR_LIBRARIES} INTERFACE_INCLUDE_DIRECTORIES ${MPFR_INCLUDE_DIR})
endif()
mark_as_advanced(MPFR_INCLUDE_DIR MPFR_LIBRARIES)
