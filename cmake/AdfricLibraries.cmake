# SPDX-License-Identifier: GPL-3.0-or-later
# The libraries adfric::physics and adfric::run, static and shared.
#
# BUILD_SHARED_LIBS=ON makes shared libraries alone, OFF static ones alone. Where it is not set there are both, and the program
# contains the static ones. The sources are compiled once: with -fno-semantic-interposition code that does not depend on its
# position executes as many instructions as other code.

include(GNUInstallDirs)

set(CMAKE_POSITION_INDEPENDENT_CODE ON)
# The places of libraries hold for what these libraries need, too: those of a prefix of one's own may not say it themselves.
add_link_options(-Wl,--disable-new-dtags)
# Where the modules of Fortran go: only the compiler that has written them reads them.
string(REGEX MATCH "^[0-9]+" ADFRIC_COMPILER_MAJOR "${CMAKE_Fortran_COMPILER_VERSION}")
set(CMAKE_INSTALL_MODULEDIR "${CMAKE_INSTALL_INCLUDEDIR}/adfric/${CMAKE_Fortran_COMPILER_ID}-${ADFRIC_COMPILER_MAJOR}"
  CACHE STRING "Folder of the Fortran modules, seen from the prefix")
mark_as_advanced(CMAKE_INSTALL_MODULEDIR)

# Which kinds there are.
if(NOT DEFINED BUILD_SHARED_LIBS)
  set(ADFRIC_KINDS static shared)
elseif(BUILD_SHARED_LIBS)
  set(ADFRIC_KINDS shared)
else()
  set(ADFRIC_KINDS static)
endif()

# adfric_add_library(adfric_<name> <file>...): a library of the project's own sources, known as adfric::<name>, too. Where there
# are both kinds it is the static one, and adfric_<name>_shared is the other one.
function(adfric_add_library target)
  list(GET ADFRIC_KINDS 0 kind)
  string(TOUPPER "${kind}" type)
  string(REPLACE "adfric_" "" name "${target}")
  add_library(${target} ${type} ${ARGN})
  add_library(adfric::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES Fortran_MODULE_DIRECTORY "${PROJECT_BINARY_DIR}/mod/${target}")
  target_compile_options(${target} PRIVATE -fno-semantic-interposition)
  adfric_set_flags(${target})
  adfric_finish_library(${target} ${kind} ${name})
  if("shared" IN_LIST ADFRIC_KINDS AND NOT kind STREQUAL "shared")
    add_library(${target}_shared SHARED "$<TARGET_OBJECTS:${target}>")
    set_target_properties(${target}_shared PROPERTIES LINKER_LANGUAGE Fortran)
    adfric_finish_library(${target}_shared shared ${name})
  endif()
endfunction()

# What a library has in common with that of the other kind: its name, its modules, and its part in the package. adfric::run is
# the file libadfric, adfric::physics the file libadfric_physics.
function(adfric_finish_library target kind name)
  string(REPLACE "adfric_run" "adfric" file "adfric_${name}")
  set_target_properties(${target} PROPERTIES OUTPUT_NAME ${file} EXPORT_NAME ${name} VERSION "${PROJECT_VERSION}"
    SOVERSION "${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}" INSTALL_RPATH "$ORIGIN" INSTALL_RPATH_USE_LINK_PATH TRUE)
  target_include_directories(${target} PUBLIC "$<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/mod/adfric_${name}>"
    "$<INSTALL_INTERFACE:${CMAKE_INSTALL_MODULEDIR}/${name}>")
  if(kind STREQUAL "shared")
    # within a library its own procedures are called without a detour
    target_link_options(${target} PRIVATE -Wl,-Bsymbolic-functions)
  endif()
  install(TARGETS ${target} EXPORT adfric_${name}_${kind})
endfunction()

# adfric_link_foreign(adfric_<name> <library>...): link with libraries of others. Who uses a shared library needs none of them,
# who uses a static one needs them to link, but not to compile.
function(adfric_link_foreign target)
  target_link_libraries(${target} PRIVATE ${ARGN})
  if(TARGET ${target}_shared)
    target_link_libraries(${target}_shared PRIVATE ${ARGN})
  endif()
endfunction()

# adfric_add_header(adfric_<name> <folder>): who uses the library from C finds its header, in the sources or where it is installed.
function(adfric_add_header target folder)
  foreach(one ${target} ${target}_shared)
    if(TARGET ${one})
      target_include_directories(${one} PUBLIC "$<BUILD_INTERFACE:${folder}>" "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>")
    endif()
  endforeach()
endfunction()

# adfric_build_upon(adfric_<name> adfric_<other>): who uses the one library uses the other one, too, of the same kind.
function(adfric_build_upon target other)
  target_link_libraries(${target} PUBLIC ${other})
  if(TARGET ${target}_shared)
    target_link_libraries(${target}_shared PUBLIC ${other}_shared)
  endif()
endfunction()
