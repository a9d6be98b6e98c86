# What others link: find_package(Drydock CONFIG COMPONENTS ...). Everything here is of the install component `development`.
# docs/build/api.md says what is promised.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# A component is what it names, and all that this needs.
set(drydock_components wire device estimators record hil)
set(drydock_roots_of_wire drydock_wire drydock_capture)
set(drydock_roots_of_device drydock_device drydock_survey drydock_shell drydock_link)
set(drydock_roots_of_estimators drydock_pipeline drydock_setup)
set(drydock_roots_of_record drydock_record drydock_export)
set(drydock_roots_of_hil drydock_bench drydock_emulate drydock_fault drydock_motion)

# All libraries of this tree that a target links, however far away.
function(drydock_closure_of name result)
  set(ahead ${name})
  set(found "")
  while(ahead)
    list(POP_FRONT ahead one)
    if(one IN_LIST found OR NOT TARGET ${one})
      continue()
    endif()
    get_target_property(imported ${one} IMPORTED)
    if(imported)
      continue()
    endif()
    list(APPEND found ${one})
    foreach(property LINK_LIBRARIES INTERFACE_LINK_LIBRARIES)
      get_target_property(links ${one} ${property})
      if(links)
        string(REGEX REPLACE "\\$<LINK_ONLY:([^<>]*)>" "\\1" links "${links}")
        list(FILTER links INCLUDE REGEX "^drydock_")
        list(APPEND ahead ${links})
      endif()
    endforeach()
  endwhile()
  set(${result} ${found} PARENT_SCOPE)
endfunction()

set(drydock_exported "")
foreach(component ${drydock_components})
  set(target drydock_component_${component})
  add_library(${target} INTERFACE)
  target_link_libraries(${target} INTERFACE ${drydock_roots_of_${component}})
  target_compile_features(${target} INTERFACE cxx_std_20)
  # "drivers/wire/codec.hpp" as inside of this tree, <drydock/drivers/wire/codec.hpp> for others.
  target_include_directories(${target} INTERFACE
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/drydock>)
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${component})
  drydock_closure_of(${target} closure)
  list(APPEND drydock_exported ${closure})
endforeach()
list(REMOVE_DUPLICATES drydock_exported)

set(drydock_package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/Drydock)
install(TARGETS ${drydock_exported} EXPORT Drydock COMPONENT development
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}/drydock COMPONENT development)
install(EXPORT Drydock NAMESPACE Drydock:: FILE DrydockTargets.cmake DESTINATION ${drydock_package_folder} COMPONENT development)

configure_package_config_file(.packaging/cmake/DrydockConfig.cmake.in ${PROJECT_BINARY_DIR}/cmake/DrydockConfig.cmake
  INSTALL_DESTINATION ${drydock_package_folder})
# Before 1.0 each minor version may break what the page does not promise.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/cmake/DrydockConfigVersion.cmake COMPATIBILITY SameMinorVersion)
configure_file(.packaging/cmake/version.hpp.in ${PROJECT_BINARY_DIR}/cmake/version.hpp @ONLY)
file(RELATIVE_PATH drydock_way_to_prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(.packaging/cmake/drydock.pc.in ${PROJECT_BINARY_DIR}/cmake/drydock.pc @ONLY)

install(FILES ${PROJECT_BINARY_DIR}/cmake/DrydockConfig.cmake ${PROJECT_BINARY_DIR}/cmake/DrydockConfigVersion.cmake
  DESTINATION ${drydock_package_folder} COMPONENT development)
install(FILES ${PROJECT_BINARY_DIR}/cmake/version.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/drydock COMPONENT development)
install(FILES ${PROJECT_BINARY_DIR}/cmake/drydock.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
install(DIRECTORY drivers estimators hil rig_config DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/drydock COMPONENT development
  FILES_MATCHING PATTERN "*.hpp" PATTERN program EXCLUDE PATTERN campaign EXCLUDE PATTERN python EXCLUDE)
# One target that builds all that is installed.
add_custom_target(drydock_development DEPENDS ${drydock_exported})

if(DRYDOCK_SYSTEM_PYTHON AND NOT DRYDOCK_SANITIZE AND NOT DRYDOCK_FUZZ)
  add_test(NAME consumers.BuildAndRunAgainstTheInstalledPackage
    COMMAND ${DRYDOCK_SYSTEM_PYTHON} -B ${PROJECT_SOURCE_DIR}/tests/consumers/run.py ${PROJECT_BINARY_DIR} $<TARGET_FILE:drydock>
            ${PROJECT_SOURCE_DIR})
  set_tests_properties(consumers.BuildAndRunAgainstTheInstalledPackage PROPERTIES TIMEOUT 600)
endif()
