# With or without MPI: include it before HDF5 is looked for, which must be built with the same MPI. Which HDF5 was found stays in
# the cache, so each choice has a build tree of its own (presets release and mpi).

option(USE_MPI "Build a program that several processes run together by MPI" OFF)

if(DEFINED CACHE{ADFRIC_USED_MPI} AND NOT "$CACHE{ADFRIC_USED_MPI}" STREQUAL "${USE_MPI}")
  message(FATAL_ERROR "USE_MPI was ${ADFRIC_USED_MPI} in this build tree and stays so; take another tree, as the preset mpi does")
endif()
set(ADFRIC_USED_MPI "${USE_MPI}" CACHE INTERNAL "Whether this build tree is one with MPI")

set(ADFRIC_MPI "")
if(USE_MPI)
  set(HDF5_PREFER_PARALLEL TRUE)
  find_package(MPI REQUIRED COMPONENTS Fortran)
  if(NOT MPI_Fortran_HAVE_F08_MODULE)
    message(FATAL_ERROR "USE_MPI needs the Fortran module mpi_f08, which this MPI does not have for ${CMAKE_Fortran_COMPILER}")
  endif()
  set(ADFRIC_MPI MPI::MPI_Fortran)
endif()

# Is the HDF5 that was found the one that is needed?
function(adfric_check_mpi)
  if(USE_MPI AND NOT HDF5_IS_PARALLEL)
    message(FATAL_ERROR "USE_MPI needs HDF5 with MPI (Debian, Ubuntu: libhdf5-openmpi-dev); found is one without: "
      "${HDF5_Fortran_INCLUDE_DIRS}. Install it and start with an empty build tree")
  endif()
endfunction()

# adfric_choose_world(<list>): keep that one of the two modules which fits in a list of sources.
function(adfric_choose_world list)
  if(USE_MPI)
    list(FILTER ${list} EXCLUDE REGEX "/run/world_serial\\.f90$")
  else()
    list(FILTER ${list} EXCLUDE REGEX "/run/world_mpi\\.f90$")
  endif()
  set(${list} "${${list}}" PARENT_SCOPE)
endfunction()
