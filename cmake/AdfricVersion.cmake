# SPDX-License-Identifier: GPL-3.0-or-later
# Gives adfric_add_version(): the module that says which program this is, renewed at every build.

find_package(Git QUIET)

# adfric_add_version(<target>): add the module adfric_base_version to the sources of a library.
function(adfric_add_version target)
  set(here "${CMAKE_CURRENT_FUNCTION_LIST_DIR}")
  set(file "${PROJECT_BINARY_DIR}/version/version.f90")
  add_custom_target(adfric_version
    COMMAND "${CMAKE_COMMAND}" "-DTEMPLATE=${here}/../src/base/version.f90.in" "-DRESULT=${file}"
      "-DPROJECT_VERSION=${PROJECT_VERSION}" "-DGIT=${GIT_EXECUTABLE}" "-DFOLDER=${here}"
      -P "${here}/write_version.cmake"
    BYPRODUCTS "${file}" VERBATIM)
  target_sources(${target} PRIVATE "${file}")
  add_dependencies(${target} adfric_version)
endfunction()
