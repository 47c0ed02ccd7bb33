# SPDX-License-Identifier: GPL-3.0-or-later
# Which compilers build the project.

# The oldest gfortran that builds all of it; Ubuntu 22.04 has this one.
set(ADFRIC_OLDEST_GFORTRAN 11)

# adfric_check_compiler(): end here, with one message, where the compiler cannot build the project.
function(adfric_check_compiler)
  if(NOT CMAKE_Fortran_COMPILER_ID STREQUAL "GNU" OR CMAKE_Fortran_COMPILER_VERSION VERSION_LESS ADFRIC_OLDEST_GFORTRAN)
    message(FATAL_ERROR "adfric needs gfortran ${ADFRIC_OLDEST_GFORTRAN} or newer; found ${CMAKE_Fortran_COMPILER}, which is "
      "${CMAKE_Fortran_COMPILER_ID} ${CMAKE_Fortran_COMPILER_VERSION}. Name another one in an empty build tree: "
      "-DCMAKE_Fortran_COMPILER=gfortran-12")
  endif()
endfunction()
