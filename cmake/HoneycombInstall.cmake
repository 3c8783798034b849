# What an installation has: libraries with their public headers under include/honeycomb, a CMake package with a component a
# library, pkg-config files, the program.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(HONEYCOMB_PACKAGE_FOLDER ${CMAKE_INSTALL_LIBDIR}/cmake/honeycomb)
# What runs is the component runtime; all else is for who builds with the libraries.
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME development)

# honeycomb_install(NAME DESCRIPTION text HEADERS files... NEEDS components... PACKAGES names...): installs the library
# honeycomb_NAME as the component NAME. HEADERS, relative to the project's root, are all that its users can include, and are
# each compiled alone by the target all_verify_interface_header_sets. NEEDS: other components; PACKAGES: what CMake has to
# find for who links the library, "name" or "name version"; PKG_CONFIG: the same by pkg-config's names; LIBRARIES: what
# pkg-config has no name for.
function(honeycomb_install name)
  cmake_parse_arguments(LIB "" "DESCRIPTION" "HEADERS;NEEDS;PACKAGES;PKG_CONFIG;LIBRARIES" ${ARGN})
  set(target honeycomb_${name})
  list(TRANSFORM LIB_HEADERS PREPEND ${PROJECT_SOURCE_DIR}/)
  target_sources(${target} PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${LIB_HEADERS})
  target_compile_features(${target} PUBLIC cxx_std_20)
  # Both <honeycomb/far/topology/topology.h> and <far/topology/topology.h>.
  target_include_directories(${target} INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} VERSION ${PROJECT_VERSION}
                                             SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
                                             INSTALL_RPATH $ORIGIN)
  get_target_property(type ${target} TYPE)
  if(type STREQUAL "SHARED_LIBRARY")
    target_link_options(${target} PRIVATE -Wl,--version-script=${PROJECT_SOURCE_DIR}/cmake/exported.map)
    set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS ${PROJECT_SOURCE_DIR}/cmake/exported.map)
  endif()

  install(TARGETS ${target} EXPORT ${target}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT runtime NAMELINK_COMPONENT development
    FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/honeycomb)
  install(EXPORT ${target} FILE honeycomb-${name}-targets.cmake NAMESPACE honeycomb:: DESTINATION ${HONEYCOMB_PACKAGE_FOLDER})

  set(finds "")
  foreach(package IN LISTS LIB_PACKAGES)
    string(APPEND finds "find_dependency(${package})\n")
  endforeach()
  file(CONFIGURE OUTPUT honeycomb-${name}.cmake CONTENT "set(honeycomb_${name}_needs @LIB_NEEDS@)\n@finds@" @ONLY)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/honeycomb-${name}.cmake DESTINATION ${HONEYCOMB_PACKAGE_FOLDER})
  honeycomb_pkg_config(${name})
endfunction()

# Within honeycomb_install: the .pc file. Static libraries need what they are made with from whoever links them.
function(honeycomb_pkg_config name)
  string(REPLACE "_" "-" pc_name "honeycomb-${name}")
  set(requires ${LIB_NEEDS})
  list(TRANSFORM requires REPLACE "_" "-")
  list(TRANSFORM requires PREPEND "honeycomb-")
  get_target_property(library ${target} OUTPUT_NAME)
  if(NOT library)
    set(library ${target})
  endif()
  set(libraries "-l${library}")
  if(type STREQUAL "STATIC_LIBRARY")
    list(APPEND requires ${LIB_PKG_CONFIG})
    list(APPEND libraries ${LIB_LIBRARIES})
  endif()
  file(RELATIVE_PATH to_prefix /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
  string(REGEX REPLACE "/$" "" to_prefix ${to_prefix})
  list(JOIN requires ", " requires)
  list(JOIN libraries " " libraries)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/honeycomb.pc.in ${pc_name}.pc @ONLY)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/${pc_name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endfunction()

# The package that finds the components.
function(honeycomb_install_package)
  configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/honeycomb-config.cmake.in honeycomb-config.cmake
    INSTALL_DESTINATION ${HONEYCOMB_PACKAGE_FOLDER} NO_CHECK_REQUIRED_COMPONENTS_MACRO)
  # Before version 1 a minor version may change what is public.
  write_basic_package_version_file(honeycomb-config-version.cmake COMPATIBILITY SameMinorVersion)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/honeycomb-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/honeycomb-config-version.cmake
    DESTINATION ${HONEYCOMB_PACKAGE_FOLDER})
endfunction()
