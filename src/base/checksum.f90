!> Checksum of numbers, to tell whether data have changed: FNV-1a with 64 bits (G. Fowler, L. C. Noll, K.-P. Vo, D. Eastlake,
!> The FNV non-cryptographic hash algorithm).
module adfric_base_checksum
   use adfric_base_kinds, only: dp, i8
   implicit none (type, external)
   private
   public :: checksum_t, checksum_length

   !> Letters of a checksum as text.
   integer, parameter :: checksum_length = 16
   !> Two halves, for Fortran has no arithmetic modulo 2**64; the factor of each byte is 2**40 + `low_factor`.
   integer(i8), parameter :: high_start = int(z'cbf29ce4', i8), low_start = int(z'84222325', i8), low_factor = int(z'1b3', i8)
   integer(i8), parameter :: half = int(z'ffffffff', i8), byte = int(z'ff', i8), digit = int(z'f', i8)
   integer, parameter :: half_bits = 32, byte_bits = 8, digit_bits = 4, bytes_of_real = 8

   !> The checksum of what has been added so far.
   type :: checksum_t
      private
      integer(i8) :: high = high_start, low = low_start
   contains
      procedure :: add_byte
      procedure :: add_reals
      procedure :: as_text
   end type checksum_t

contains

   !> Add a byte.
   elemental subroutine add_byte(self, value)
      class(checksum_t), intent(inout) :: self
      !> 0 to 255.
      integer(i8), intent(in) :: value
      integer(i8) :: low, product

      low = ieor(self%low, value)
      product = low*low_factor
      self%high = iand(self%high*low_factor + ishft(product, -half_bits) + ishft(low, byte_bits), half)
      self%low = iand(product, half)
   end subroutine add_byte

   !> Add real numbers, each as its eight bytes, the lowest first.
   pure subroutine add_reals(self, values)
      class(checksum_t), intent(inout) :: self
      real(dp), intent(in) :: values(:)
      integer(i8) :: bits
      integer :: i, k

      do i = 1, size(values)
         bits = transfer(values(i), bits)
         do k = 0, bytes_of_real - 1
            call self%add_byte(iand(ishft(bits, -byte_bits*k), byte))
         end do
      end do
   end subroutine add_reals

   !> As a number to the base of 16.
   pure function as_text(self) result(text)
      class(checksum_t), intent(in) :: self
      character(checksum_length) :: text

      character(*), parameter :: digits = '0123456789abcdef'
      integer :: i, place

      do i = 1, checksum_length
         place = int(iand(ishft(merge(self%high, self%low, i <= checksum_length/2), -digit_bits*modulo(-i, checksum_length/2)), &
            digit)) + 1
         text(i:i) = digits(place:place)
      end do
   end function as_text

end module adfric_base_checksum
