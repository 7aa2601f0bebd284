# SPDX-License-Identifier: MIT
# truckride::truckride (shared if it was built, else static) and truckride::static.
# The static library names what it links as -l<name>: nothing to find, nothing absolute.
include(CMakeFindDependencyMacro)
find_dependency(Threads)
include(${CMAKE_CURRENT_LIST_DIR}/truckrideTargets.cmake)
if(NOT TARGET truckride::truckride)
    add_library(truckride::truckride ALIAS truckride::static)
endif()
