# SPDX-License-Identifier: MIT
# Third-party libraries that a build may leave out. Each has an option TRUCKRIDE_WITH_<FEATURE>
# and a macro of that name in the sources. The target truckride_features carries them.
add_library(truckride_features INTERFACE)
set(feature_link_names "") # what a user of the installed static library links: -l<name>

function(truckride_require variable name feature description)
    mark_as_advanced(${variable})
    if(NOT ${variable})
        message(FATAL_ERROR "${name} was not found. Install it, or configure with "
            "-DTRUCKRIDE_WITH_${feature}=OFF to build without: ${description}.")
    endif()
endfunction()

# truckride_feature(<feature> <description> [HEADER <header> <folder of it>] LIBRARIES <name>...)
macro(truckride_feature feature description)
    cmake_parse_arguments(feature "" "" "HEADER;LIBRARIES" ${ARGN})
    option(TRUCKRIDE_WITH_${feature} "${description}" ON)
    if(TRUCKRIDE_WITH_${feature})
        target_compile_definitions(truckride_features INTERFACE TRUCKRIDE_WITH_${feature})
        foreach(name ${feature_LIBRARIES})
            find_library(TRUCKRIDE_LIBRARY_${name} ${name})
            truckride_require(TRUCKRIDE_LIBRARY_${name} lib${name} ${feature} "${description}")
            target_link_libraries(truckride_features INTERFACE ${TRUCKRIDE_LIBRARY_${name}})
            list(APPEND feature_link_names ${name})
        endforeach()
        if(feature_HEADER)
            list(GET feature_HEADER 0 header)
            list(GET feature_HEADER 1 folder)
            find_path(TRUCKRIDE_INCLUDE_${feature} ${header} PATH_SUFFIXES ${folder})
            truckride_require(TRUCKRIDE_INCLUDE_${feature} ${header} ${feature} "${description}")
            target_include_directories(truckride_features SYSTEM INTERFACE
                ${TRUCKRIDE_INCLUDE_${feature}})
        endif()
    endif()
endmacro()

truckride_feature(CHOLMOD "sparse solver" HEADER cholmod.h suitesparse
                  LIBRARIES cholmod suitesparseconfig)
truckride_feature(LAPACK "modes, frequency response" LIBRARIES lapack blas)
truckride_feature(NLOPT "calibration" HEADER nlopt.h nlopt LIBRARIES nlopt)
truckride_feature(JSON "reading model files" HEADER jansson.h jansson LIBRARIES jansson)
truckride_feature(ARPACK "modes of large models" LIBRARIES arpack)

set_property(GLOBAL PROPERTY TRUCKRIDE_LINK_NAMES ${feature_link_names}) # for truckride.pc
