! SPDX-License-Identifier: GPL-3.0-or-later
!> Use the part of adfric::run that calls HDF5: create a file and close it. The modules of HDF5 are not needed for that.
program use_run
   use, intrinsic :: iso_fortran_env, only: int64
   use adfric_base_version, only: program_version
   use adfric_hdf5_calls, only: hdf5_calls_t
   use adfric_hdf5_file, only: close_file, create_file
   implicit none (type, external)
   type(hdf5_calls_t) :: calls
   integer(int64) :: file

   call calls%open_library()
   call create_file(calls, 'created.h5', file)
   call close_file(calls, file)
   if (.not. calls%is_good()) error stop 'no file'
   print '(2a)', 'run ', program_version
end program use_run
