# SPDX-License-Identifier: GPL-3.0-or-later
# With or without MPI: include it before HDF5 is looked for, which must be built with the same MPI. Which HDF5 was found stays in
# the cache, so each choice has a build tree of its own (presets release and mpi).

option(USE_MPI "Build a program that several processes run together by MPI" OFF)

if(DEFINED CACHE{ADFRIC_USED_MPI} AND NOT "$CACHE{ADFRIC_USED_MPI}" STREQUAL "${USE_MPI}")
  message(FATAL_ERROR "USE_MPI was ${ADFRIC_USED_MPI} in this build tree and stays so; take another tree, as the preset mpi does")
endif()
set(ADFRIC_USED_MPI "${USE_MPI}" CACHE INTERNAL "Whether this build tree is one with MPI")

# before HDF5 is looked for
if(USE_MPI)
  set(HDF5_PREFER_PARALLEL TRUE)
endif()

# adfric_choose_world(<list>): keep that one of the two modules which fits in a list of sources.
function(adfric_choose_world list)
  if(USE_MPI)
    list(FILTER ${list} EXCLUDE REGEX "/run/world_serial\\.f90$")
  else()
    list(FILTER ${list} EXCLUDE REGEX "/run/world_mpi\\.f90$")
  endif()
  set(${list} "${${list}}" PARENT_SCOPE)
endfunction()
