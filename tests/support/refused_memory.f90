! SPDX-License-Identifier: GPL-3.0-or-later
!> FFTW's memory, which can be refused. It stands before that of the library in every program that uses this module; the library's
!> `fftw_free` takes it back.
module refused_memory
   use, intrinsic :: iso_c_binding, only: c_int, c_null_ptr, c_ptr, c_size_t
   implicit none (type, external)
   private
   public :: refuse_memory, fftw_malloc

   !> So many more requests are granted.
   integer, protected :: n_granted = huge(1)

   interface
      !> The C library's.
      type(c_ptr) function aligned_alloc(alignment, n) bind(c)
         import :: c_ptr, c_size_t
         implicit none (type, external)
         integer(c_size_t), intent(in), value :: alignment, n
      end function aligned_alloc
   end interface

contains

   !> Refuse every request after some more; `huge(1)`: none.
   subroutine refuse_memory(after)
      integer, intent(in) :: after

      n_granted = after
   end subroutine refuse_memory

   !> FFTW's, but for those that are refused.
   type(c_ptr) function fftw_malloc(n) bind(c)
      integer(c_size_t), intent(in), value :: n
      integer(c_size_t), parameter :: line = 64

      fftw_malloc = c_null_ptr
      if (n_granted <= 0) return
      if (n_granted < huge(1)) n_granted = n_granted - 1
      fftw_malloc = aligned_alloc(line, (n + line - 1)/line*line)
   end function fftw_malloc

end module refused_memory
