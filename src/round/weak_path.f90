! SPDX-License-Identifier: GPL-3.0-or-later
!> The states of an indenter while friction takes from its adhesion, as data, and its curve with less of it (`adfric_round_weak_contact`).
module adfric_round_weak_path
   use adfric_base_kinds, only: dp
   use adfric_round_contact_state, only: contact_t
   use adfric_round_curve, only: control_load, curve_t
   use adfric_round_dugdale_curve, only: dugdale_curve_t
   implicit none (type, external)
   private
   public :: path_node_t, weak_path_t, weaken, middle

   !> A state at one X.
   type :: path_node_t
      !> X.
      real(dp) :: ratio = 1
      !> The state.
      type(contact_t) :: contact
   end type path_node_t

   !> The states of contact as X falls.
   type :: weak_path_t
      !> The curve with all of its adhesion.
      class(curve_t), allocatable :: curve
      !> What is prescribed; not `control_radius`.
      integer :: control = control_load
      !> Load, approach, or approach of the base that is prescribed.
      real(dp) :: given = 0
      !> Are its states known in closed form (JKR, DMT, a flat face)?
      logical :: is_closed = .true.
      !> Is it followed in steps?
      logical :: is_followed = .false.
      !> The smallest X where there is a state, if that is known; else 0.
      real(dp) :: least_ratio = 0
      !> Has X such an end above 0, where the state is lost?
      logical :: is_lost = .false.
      !> Number of nodes; 0 without contact.
      integer :: n = 0
      !> The nodes from X = 1 down, so far.
      type(path_node_t), allocatable :: nodes(:)
      !> The last state in closed form: the lower end of the unknown, and whether it lies beyond the corner.
      real(dp) :: low = 0
      !> Does it lie beyond the corner?
      logical :: low_is_beyond = .true.
   end type weak_path_t

contains

   !> A curve with less adhesion.
   pure subroutine weaken(curve, ratio)
      !> In: the curve with all of its adhesion. Out: that with X of it.
      class(curve_t), intent(inout) :: curve
      !> X, from 0 to 1.
      real(dp), intent(in) :: ratio
      ! the reach of a stress of nothing is still that of the gap
      real(dp), parameter :: nothing = 1.0e-30_dp

      curve%tension = sqrt(ratio)*curve%tension
      curve%outer_pull = ratio*curve%outer_pull
      select type (curve)
      type is (dugdale_curve_t)
         curve%stress = max(ratio, nothing)*curve%stress
      end select
   end subroutine weaken

   !> A position between two, in the middle of their logarithms where that is possible.
   pure real(dp) function middle(low, high)
      !> The positions, >= 0.
      real(dp), intent(in) :: low, high
      real(dp), parameter :: share = 1.0e-2_dp

      middle = low + (high - low)/2
      if (low < share*high) middle = max(sqrt(low)*sqrt(high), 0.1_dp*high)
      if (.not. (middle > low .and. middle < high)) middle = low + (high - low)/2
   end function middle

end module adfric_round_weak_path
