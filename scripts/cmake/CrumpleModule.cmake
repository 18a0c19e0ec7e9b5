# SPDX-License-Identifier: MIT
# The two functions every folder of the project is built with.
#
#   crumple_module(reference SOURCES reference.cpp USES core material bundle [PACKAGES Eigen3::Eigen] [LICENSE MIT] [HOT])
#   crumple_test(recover [SOURCES test_recover.cpp ...] [USES sample ...] [PACKAGES CGAL::CGAL])
#
# A module may only use modules that were added before it, so the layers of lib/README.md hold at configure time.
# Packages are linked PRIVATE: their headers appear in .cpp files only. HOT: what loops over whole meshes; a build that
# optimizes little compiles it with CRUMPLE_HOT_FLAGS, or its tests take half as long again.

include(GNUInstallDirs)

# A package that brings in C makes CMake name precompiled headers as the C compiler would, which need not be clang as well.
# And one compiler that goes without them shows that each file names the headers it needs.
if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON)
endif()

function(_crumple_flags target)
    # Exact predicates rely on plain IEEE arithmetic: never fuse a multiplication with an addition behind our back.
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -ffp-contract=off)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
        # False alarms on "text" + string: GCC bugs 105651 and 105329.
        target_compile_options(${target} PRIVATE -Wno-restrict -Wno-array-bounds -Wno-stringop-overflow)
    endif()
    if(CRUMPLE_WERROR)
        target_compile_options(${target} PRIVATE -Werror)
    endif()
endfunction()

# What nearly every file of lib includes, compiled once: it takes a third off most files' compile time. A game that builds
# the runtime's sources in its own tree has few files, and does without.
function(_crumple_library_headers target flags)
    if(CRUMPLE_RUNTIME_ONLY)
        return()
    endif()
    string(MAKE_C_IDENTIFIER "crumple_library_headers${flags}" headers)
    if(NOT TARGET ${headers})
        file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/${headers}.cpp CONTENT "")
        add_library(${headers} OBJECT ${PROJECT_BINARY_DIR}/${headers}.cpp)
        set_target_properties(${headers} PROPERTIES POSITION_INDEPENDENT_CODE ON)
        target_compile_features(${headers} PUBLIC cxx_std_20)
        target_compile_options(${headers} PRIVATE ${flags})
        target_precompile_headers(${headers} PRIVATE <algorithm> <array> <cmath> <cstdint> <functional> <memory>
            <optional> <span> <string> <string_view> <vector>)
        _crumple_flags(${headers})
    endif()
    target_precompile_headers(${target} REUSE_FROM ${headers})
endfunction()

function(crumple_module name)
    cmake_parse_arguments(PARSE_ARGV 1 arg "HOT" "LICENSE" "SOURCES;USES;PACKAGES")
    if(NOT arg_LICENSE)
        set(arg_LICENSE GPL)
    endif()
    foreach(used IN LISTS arg_USES)
        if(NOT TARGET crumple_${used})
            message(FATAL_ERROR "module '${name}' uses '${used}', which is not a module on a layer below it")
        endif()
        get_target_property(used_license crumple_${used} CRUMPLE_LICENSE)
        if(arg_LICENSE STREQUAL "MIT" AND NOT used_license STREQUAL "MIT")
            message(FATAL_ERROR "MIT module '${name}' may not use '${used}', which is ${used_license}")
        endif()
    endforeach()
    add_library(crumple_${name} STATIC ${arg_SOURCES})
    add_library(crumple::${name} ALIAS crumple_${name})
    set_target_properties(crumple_${name} PROPERTIES
        CRUMPLE_LICENSE ${arg_LICENSE} EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
    target_include_directories(crumple_${name} PUBLIC
        $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/lib> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/crumple>)
    target_compile_features(crumple_${name} PUBLIC cxx_std_20)
    list(TRANSFORM arg_USES PREPEND crumple_ OUTPUT_VARIABLE used_targets)
    target_link_libraries(crumple_${name} PUBLIC ${used_targets} PRIVATE ${arg_PACKAGES})
    _crumple_flags(crumple_${name})
    set(hot_flags "")
    if(arg_HOT)
        set(hot_flags ${CRUMPLE_HOT_FLAGS})
        target_compile_options(crumple_${name} PRIVATE ${hot_flags})
    endif()
    _crumple_library_headers(crumple_${name} "${hot_flags}")
    set_property(GLOBAL APPEND PROPERTY CRUMPLE_MODULES ${name})
    set_property(GLOBAL PROPERTY CRUMPLE_MODULE_DIR_${name} ${CMAKE_CURRENT_SOURCE_DIR})
endfunction()

# A test's own code need not be fast, it has to be compiled: optimizing and instrumenting it less saves half of that. What
# it calls has every check.
function(_crumple_test_flags target)
    _crumple_flags(${target})
    target_compile_options(${target} PRIVATE
        $<$<CONFIG:Release>:-O1> "$<$<CONFIG:Debug>:-O0;-fno-sanitize=null,alignment,object-size,vptr>")
endfunction()

# What nearly every test includes, compiled once for all of them: it takes a third off a test's compile time.
function(_crumple_test_headers)
    if(TARGET crumple_test_headers)
        return()
    endif()
    file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/test_headers.cpp CONTENT "")
    add_library(crumple_test_headers OBJECT ${PROJECT_BINARY_DIR}/test_headers.cpp)
    target_link_libraries(crumple_test_headers PRIVATE GTest::gtest)
    target_precompile_headers(crumple_test_headers PRIVATE <algorithm> <filesystem> <fstream> <functional> <gtest/gtest.h>
        <map> <memory> <set> <sstream> <string> <vector>)
    _crumple_test_flags(crumple_test_headers)
endfunction()

# One test program a module: tests/<module>/test_*.cpp against the module and everything below it.
function(crumple_test name)
    if(NOT CRUMPLE_TESTS)
        return()
    endif()
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;USES;PACKAGES")
    add_executable(test_${name} ${arg_SOURCES})
    list(TRANSFORM arg_USES PREPEND crumple_ OUTPUT_VARIABLE used_targets)
    if(TARGET crumple_${name})
        list(APPEND used_targets crumple_${name})
    endif()
    target_link_libraries(test_${name} PRIVATE ${used_targets} ${arg_PACKAGES} GTest::gtest GTest::gtest_main)
    target_include_directories(test_${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
    target_compile_definitions(test_${name} PRIVATE CRUMPLE_DATA_DEFAULT="${PROJECT_SOURCE_DIR}/../shared/data")
    _crumple_test_flags(test_${name})
    _crumple_test_headers()
    target_precompile_headers(test_${name} REUSE_FROM crumple_test_headers)
    include(GoogleTest)
    gtest_discover_tests(test_${name} TEST_PREFIX "${name}." DISCOVERY_TIMEOUT 60 NO_PRETTY_VALUES)
endfunction()
