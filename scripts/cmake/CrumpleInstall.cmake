# SPDX-License-Identifier: MIT
# What `cmake --install` puts where, and find_package(crumple COMPONENTS runtime store cook) finds:
#   runtime   core, material, bundle, solver: MIT, needs no package
#   store     reads and writes bundles: MIT, needs HDF5 and OpenSSL
#   cook      the stages, the program and its recipes: GPL
include(CMakePackageConfigHelpers)

set(_component_of_core runtime)
set(_component_of_material runtime)
set(_component_of_bundle runtime)
set(_component_of_solver runtime)
set(_component_of_store store)

get_property(_modules GLOBAL PROPERTY CRUMPLE_MODULES)
list(REMOVE_ITEM _modules samples)
foreach(_module IN LISTS _modules)
    set(_component cook)
    if(DEFINED _component_of_${_module})
        set(_component ${_component_of_${_module}})
    endif()
    get_property(_folder GLOBAL PROPERTY CRUMPLE_MODULE_DIR_${_module})
    install(TARGETS crumple_${_module} EXPORT crumple-${_component}
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${_component})
    install(DIRECTORY ${_folder}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/crumple/${_module} COMPONENT ${_component}
        FILES_MATCHING PATTERN "*.h")
    list(APPEND _components ${_component})
endforeach()
list(REMOVE_DUPLICATES _components)

set(_config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/crumple)
foreach(_component IN LISTS _components)
    install(EXPORT crumple-${_component} NAMESPACE crumple:: DESTINATION ${_config_folder} COMPONENT ${_component})
endforeach()
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/crumple-config.cmake.in
    ${PROJECT_BINARY_DIR}/crumple-config.cmake INSTALL_DESTINATION ${_config_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/crumple-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/crumple-config.cmake ${PROJECT_BINARY_DIR}/crumple-config-version.cmake
    DESTINATION ${_config_folder} COMPONENT runtime)

if(TARGET crumple)
    install(TARGETS crumple RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT cook)
endif()
install(DIRECTORY pipelines DESTINATION ${CMAKE_INSTALL_DATADIR}/crumple COMPONENT cook FILES_MATCHING PATTERN "*.json")
install(DIRECTORY schemas DESTINATION ${CMAKE_INSTALL_DATADIR}/crumple COMPONENT cook FILES_MATCHING PATTERN "*.json")
install(FILES LICENSE LICENSE.MIT.txt DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT runtime)
install(FILES lib/bundle/FORMAT.md lib/bundle/FORMAT_BLOB.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT runtime OPTIONAL)
install(FILES LICENSE.GPL-3.0.txt README.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT cook OPTIONAL)
