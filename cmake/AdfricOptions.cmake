# SPDX-License-Identifier: GPL-3.0-or-later
# Build options and compiler flags of the project.

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

option(ADFRIC_WARNINGS_AS_ERRORS "Let a warning of the compiler stop the build, as developers want it" OFF)
set(default_of_asserts OFF)
if(CMAKE_BUILD_TYPE STREQUAL "Debug")
  set(default_of_asserts ON)
endif()
option(ADFRIC_ASSERTS "Check what procedures demand of their callers; a mistake ends the program" ${default_of_asserts})
option(ADFRIC_SANITIZE "Build with the address and undefined-behaviour sanitizers" OFF)

option(ADFRIC_QUICK "Optimise less, which takes half the time to compile: for tests of what does not depend on speed" OFF)
set(CMAKE_Fortran_FLAGS_RELEASE "-O2 -g1")
if(ADFRIC_QUICK)
  set(CMAKE_Fortran_FLAGS_RELEASE "-O1 -g1")
endif()
set(CMAKE_Fortran_FLAGS_DEBUG
  "-Og -g -fcheck=all -fcheck=no-array-temps -ffpe-trap=zero,invalid,overflow -finit-real=snan -finit-derived -fbacktrace")
if(ADFRIC_SANITIZE)
  # half the time to compile, and reports name procedures and lines all the same
  string(REPLACE " -g " " -g1 " CMAKE_Fortran_FLAGS_DEBUG "${CMAKE_Fortran_FLAGS_DEBUG}")
  # all programs need the libraries of the sanitizers
  add_link_options(-fsanitize=address,undefined)
endif()

# Flags of the project's own sources; the Fortran of tests is not held to them. Nor do the sanitizers look at it: they take seven times as
# long to compile it, and what it hands to the library is looked at there.
function(adfric_set_flags target)
  target_compile_options(${target} PRIVATE
    $<$<COMPILE_LANGUAGE:Fortran>:-std=f2018 -Wall -Wextra -pedantic -Wimplicit-interface>
    $<$<COMPILE_LANGUAGE:C>:-std=c11 -Wall -Wextra -pedantic>
    # with less optimisation compilers see less of what is set before it is read
    $<$<AND:$<BOOL:${ADFRIC_QUICK}>,$<COMPILE_LANGUAGE:Fortran>>:-Wno-maybe-uninitialized>
    $<$<BOOL:${ADFRIC_WARNINGS_AS_ERRORS}>:-Werror>)
  adfric_add_sanitizers(${target})
endfunction()

# adfric_add_sanitizers(<target>): let the sanitizers look at the sources of a target, where they are wanted.
function(adfric_add_sanitizers target)
  if(NOT ADFRIC_SANITIZE)
    return()
  endif()
  # What the sanitizer of undefined behaviour looks at in C are bounds and pointers for the most part, which -fcheck=all has in Fortran: there
  # it would take three times as long to compile, and its overflows are those of bounds of components that are not allocated.
  target_compile_options(${target} PRIVATE -fno-omit-frame-pointer
    $<$<COMPILE_LANGUAGE:C>:-fsanitize=address,undefined>
    $<$<COMPILE_LANGUAGE:Fortran>:-fsanitize=address,shift,integer-divide-by-zero>)
endfunction()

# adfric_add_asserts(<target>): add the module adfric_base_asserts, which says whether demands are checked, to a library.
function(adfric_add_asserts target)
  set(ADFRIC_HAS_ASSERTS ".false.")
  if(ADFRIC_ASSERTS)
    set(ADFRIC_HAS_ASSERTS ".true.")
  endif()
  set(file "${PROJECT_BINARY_DIR}/asserts/asserts.f90")
  configure_file("${PROJECT_SOURCE_DIR}/src/base/asserts.f90.in" "${file}" @ONLY)
  target_sources(${target} PRIVATE "${file}")
endfunction()
