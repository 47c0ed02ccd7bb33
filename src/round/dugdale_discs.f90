! SPDX-License-Identifier: GPL-3.0-or-later
!> Discs of adhesion without touch, in Maugis's theory: of radius c, P = -pi S c^2 and delta = f(c) - 4 S c/pi - h. On a spring of
!> compliance s (0: a given approach) they are stable where
!>
!>     F(c) = f'(c) - 4 S/pi - 2 pi s S c > 0
!>
!> On each side of a corner f' of every kind is convex or concave, and so is F. A function of that sort which has one sign at both ends
!> of a range has the other one in one piece at most, around its extreme value; else its sign changes once. So no disc is missed.
module adfric_round_dugdale_discs
   use adfric_base_kinds, only: dp
   use adfric_round_curve, only: disc_range_t, most_disc_ranges
   use adfric_round_shape, only: shape_t
   implicit none (type, external)
   private
   public :: find_stable_discs

   !> Halvings of a range, down to the smallest disc beside the largest.
   integer, parameter :: most_halvings = 1100
   real(dp), parameter :: smallest_disc = 1.0e-30_dp

   !> F with its parameters.
   type :: margin_t
      !> The shape of the indenter.
      class(shape_t), allocatable :: shape
      !> 4 S/pi and 2 pi s S.
      real(dp) :: constant = 0, pull = 0
      !> The corner, where f' may jump: is it seen from beyond?
      logical :: is_beyond = .true.
   contains
      procedure :: at
   end type margin_t

contains

   !> The discs that are stable.
   pure subroutine find_stable_discs(shape, constant, pull, largest, discs, n)
      class(shape_t), intent(in) :: shape
      !> 4 S/pi and 2 pi s S.
      real(dp), intent(in) :: constant, pull
      !> Radius of the disc that touches.
      real(dp), intent(in) :: largest
      !> Receives the ranges, from the smallest discs to the largest.
      type(disc_range_t), intent(out) :: discs(most_disc_ranges)
      integer, intent(out) :: n
      type(margin_t) :: margin

      n = 0
      allocate (margin%shape, source=shape)
      margin%constant = constant
      margin%pull = pull
      if (shape%corner > 0) then
         margin%is_beyond = .false.
         call add_ranges(margin, 0.0_dp, min(shape%corner, largest), discs, n)
         margin%is_beyond = .true.
      end if
      if (largest > shape%corner) call add_ranges(margin, shape%corner, largest, discs, n)
      if (n > 0) discs(n)%touches = .not. discs(n)%high < largest
   end subroutine find_stable_discs

   !> F at a radius.
   pure real(dp) function at(self, c)
      class(margin_t), intent(in) :: self
      !> Radius of the disc.
      real(dp), intent(in) :: c
      real(dp) :: height, slope, position

      position = c
      if (.not. self%is_beyond) position = min(c, self%shape%corner*(1 - epsilon(c)))
      if (self%is_beyond .and. self%shape%corner > 0) position = max(c, self%shape%corner*(1 + epsilon(c)))
      call self%shape%get_profile(position, height, slope)
      at = slope - self%constant - self%pull*c
   end function at

   !> Add the ranges of one side of a corner.
   pure subroutine add_ranges(margin, low, high, discs, n)
      type(margin_t), intent(in) :: margin
      !> Ends of the side.
      real(dp), intent(in) :: low, high
      !> The ranges; one that goes on from the last is joined to it.
      type(disc_range_t), intent(inout) :: discs(:)
      integer, intent(inout) :: n
      real(dp) :: turn
      logical :: begins, ends

      begins = margin%at(low) > 0
      ends = margin%at(high) > 0
      if (begins .neqv. ends) then
         turn = change_between(margin, low, high, begins)
         if (begins) call add_range(discs, n, low, turn)
         if (ends) call add_range(discs, n, turn, high)
         return
      end if
      turn = extreme_between(margin, low, high, merge(-1.0_dp, 1.0_dp, begins))
      if ((margin%at(turn) > 0) .eqv. begins) then
         if (begins) call add_range(discs, n, low, high)
      else if (begins) then
         call add_range(discs, n, low, change_between(margin, low, turn, .true.))
         call add_range(discs, n, change_between(margin, turn, high, .false.), high)
      else
         call add_range(discs, n, change_between(margin, low, turn, .false.), change_between(margin, turn, high, .true.))
      end if
   end subroutine add_ranges

   !> Add a range.
   pure subroutine add_range(discs, n, first, last)
      type(disc_range_t), intent(inout) :: discs(:)
      integer, intent(inout) :: n
      !> Ends of the range; nothing is added if it is empty.
      real(dp), intent(in) :: first, last

      if (.not. first < last) return
      if (n > 0) then
         if (.not. discs(n)%high < first) then
            discs(n)%high = last
            return
         end if
      end if
      n = n + 1
      discs(n) = disc_range_t(first, last, .false.)
   end subroutine add_range

   !> Where F changes its sign.
   pure real(dp) function change_between(margin, first, last, begins) result(position)
      type(margin_t), intent(in) :: margin
      !> Ends of a range where its sign changes once.
      real(dp), intent(in) :: first, last
      logical, intent(in) :: begins
      real(dp) :: low, high
      integer :: k

      low = first
      high = last
      do k = 1, most_halvings
         position = (low + high)/2
         if (.not. (position > low .and. position < high)) exit
         if ((margin%at(position) > 0) .eqv. begins) then
            low = position
         else
            high = position
         end if
         if (.not. high > smallest_disc*last) exit
      end do
      position = merge(low, high, begins)
      if (.not. high > smallest_disc*last) position = 0
   end function change_between

   !> Where F, or -F, is largest, by the golden section.
   pure real(dp) function extreme_between(margin, first, last, sign_of_f) result(position)
      type(margin_t), intent(in) :: margin
      !> Ends of a range where it is convex or concave.
      real(dp), intent(in) :: first, last
      !> 1, or -1 for -F.
      real(dp), intent(in) :: sign_of_f
      real(dp), parameter :: golden = 0.6180339887498949_dp
      integer, parameter :: most_steps = 80
      real(dp) :: low, high, positions(2), values(2)
      integer :: k

      low = first
      high = last
      positions = [high - golden*(high - low), low + golden*(high - low)]
      values = sign_of_f*[margin%at(positions(1)), margin%at(positions(2))]
      do k = 1, most_steps
         if (values(1) > values(2)) then
            high = positions(2)
            positions = [high - golden*(high - low), positions(1)]
            values = [sign_of_f*margin%at(positions(1)), values(1)]
         else
            low = positions(1)
            positions = [positions(2), low + golden*(high - low)]
            values = [values(2), sign_of_f*margin%at(positions(2))]
         end if
      end do
      position = positions(1)
   end function extreme_between

end module adfric_round_dugdale_discs
