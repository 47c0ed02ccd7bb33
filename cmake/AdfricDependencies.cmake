# SPDX-License-Identifier: GPL-3.0-or-later
# The libraries of others: GSL, FFTW, LAPACK, OpenMP, HDF5 and, on demand, MPI. All that are missing are named at once, with their
# packages, for a module of a cluster or a prefix of one's own may be what is meant (docs/guide/clusters.md).

include(AdfricMpi)
set(adfric_missing "")

# adfric_need(<variable> <what> <packages>): add a line to those of what is missing if the variable is not true.
macro(adfric_need variable what packages)
  if(NOT ${variable})
    string(APPEND adfric_missing "missing: ${what} (${packages})\n")
  endif()
endmacro()

find_package(OpenMP QUIET COMPONENTS Fortran)
adfric_need(OpenMP_Fortran_FOUND "OpenMP for ${CMAKE_Fortran_COMPILER}" "Debian: libgomp1, Fedora: libgomp, module: gcc")
find_package(LAPACK QUIET)
adfric_need(LAPACK_FOUND "LAPACK" "Debian: liblapack-dev, Fedora: lapack-devel, module: openblas or lapack")
find_package(GSL QUIET)
adfric_need(GSL_FOUND "GSL" "Debian: libgsl-dev, Fedora: gsl-devel, module: gsl")
find_package(FFTW3 QUIET)
adfric_need(FFTW3_FOUND "FFTW 3" "Debian: libfftw3-dev, Fedora: fftw-devel, module: fftw")
# adfric_find_hdf5(): is there HDF5 with all of its libraries? CMake's own answer does not hold where no h5fc says what they are.
macro(adfric_find_hdf5)
  find_package(HDF5 COMPONENTS C Fortran HL)
  set(ADFRIC_HDF5_FOUND FALSE)
  if(HDF5_FOUND AND NOT "${HDF5_LIBRARIES};${HDF5_HL_LIBRARIES};${HDF5_Fortran_HL_LIBRARIES}" MATCHES "NOTFOUND")
    set(ADFRIC_HDF5_FOUND TRUE)
  endif()
endmacro()

if(USE_MPI)
  find_package(MPI QUIET COMPONENTS Fortran)
  adfric_need(MPI_Fortran_HAVE_F08_MODULE "MPI with the module mpi_f08 for ${CMAKE_Fortran_COMPILER}"
    "Debian: libopenmpi-dev, Fedora: openmpi-devel, module: openmpi or mpich")
  adfric_find_hdf5()
  if(NOT HDF5_IS_PARALLEL)
    set(ADFRIC_HDF5_FOUND FALSE)
  endif()
  adfric_need(ADFRIC_HDF5_FOUND "HDF5 with MPI and its interfaces Fortran and HL"
    "Debian: libhdf5-openmpi-dev, Fedora: hdf5-openmpi-devel, module: hdf5 for this MPI")
else()
  adfric_find_hdf5()
  adfric_need(ADFRIC_HDF5_FOUND "HDF5 with its interfaces Fortran and HL" "Debian: libhdf5-dev, Fedora: hdf5-devel, module: hdf5")
endif()

if(adfric_missing)
  message(NOTICE "${adfric_missing}")
  message(FATAL_ERROR "Install what is missing, or load its module, or name its prefix in CMAKE_PREFIX_PATH; then start with an empty "
    "build tree (docs/guide/clusters.md)")
endif()

# what the libraries adfric::physics and adfric::run call
set(ADFRIC_FOREIGN_PHYSICS GSL::gsl FFTW3::fftw3 LAPACK::LAPACK OpenMP::OpenMP_Fortran)
set(ADFRIC_FOREIGN_RUN hdf5::hdf5_hl_fortran hdf5::hdf5_fortran hdf5::hdf5_hl hdf5::hdf5 OpenMP::OpenMP_Fortran)
if(USE_MPI)
  list(APPEND ADFRIC_FOREIGN_RUN MPI::MPI_Fortran)
endif()
