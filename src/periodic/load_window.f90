! SPDX-License-Identifier: GPL-3.0-or-later
!> What loads tell of the state of an adhesive surface at a given penetration, whatever draws it: a state that has not passed the
!> penetration, and a load whose state has. Between both lies the load in question.
module adfric_periodic_load_window
   use adfric_base_kinds, only: dp
   use adfric_periodic_contact, only: contact_state_t
   use adfric_periodic_gap_path, only: penetration_of
   implicit none (type, external)
   private
   public :: load_window_t, begin_window, most_attempts, closed, beyond, most_looks

   !> Attempts to follow the state, at most.
   integer, parameter :: most_attempts = 30
   !> Distance to the penetration from which a state is followed at once, and one that is none, in units of the range of the
   !> undeformed gap.
   real(dp), parameter :: near = 0.02_dp, none = 1.0e-9_dp
   !> Mean gap in the same unit at which contact is full.
   real(dp), parameter :: closed = 1.0e-12_dp
   !> How far beyond the loads that were passed the branch is looked at, in units of what contact carries.
   real(dp), parameter :: beyond = 2.0e-2_dp
   !> How often it is looked at twice as far beyond, where that has not told anything, but for one.
   integer, parameter :: most_looks = 4

   !> What is known of the branch under a load.
   type :: load_window_t
      !> Is the adhered branch wanted, that comes from larger loads? Else the other, that comes from smaller ones.
      logical :: is_adhered = .true.
      !> The wanted penetration, a distance that is none, and one that is near; in the unit of the gap.
      real(dp) :: penetration = 0, none = 0, near = 0
      !> Load of `state`, and load whose state has passed the penetration [E*].
      real(dp) :: load = 0, passed = 0
      !> Excess of the penetration over the wanted one under these loads.
      real(dp) :: excess = 0, passed_excess = 0
      !> Is `passed_excess` known?
      logical :: has_passed_excess = .false.
      !> The state that has not passed the penetration yet.
      type(contact_state_t) :: state
      !> Has it been found?
      logical :: has_state = .false.
      !> Is it one under `load`, so that it bounds those under loads that come after it on the branch?
      logical :: is_of_load = .false.
      !> Gap of the turn, from which contact opens; not allocated: there was none, or it is not known.
      real(dp), allocatable :: gap_of_turn(:, :)
      !> Has the last load told something?
      logical :: is_known = .true.
   contains
      procedure :: is_near
      procedure :: is_bound_of
      procedure :: next_load
      procedure :: take_note
   end type load_window_t

contains

   !> A window of which only the penetration is known.
   pure subroutine begin_window(self, penetration, shape)
      class(load_window_t), intent(inout) :: self
      !> The wanted penetration, in the unit of `shape`.
      real(dp), intent(in) :: penetration
      !> Gap of the undeformed surfaces in the middles of the cells.
      real(dp), intent(in) :: shape(:, :)

      self%penetration = penetration
      self%none = none*(maxval(shape) - minval(shape))
      self%near = near*(maxval(shape) - minval(shape))
   end subroutine begin_window

   !> Is the state so near to the penetration that it is followed at once?
   pure logical function is_near(self)
      class(load_window_t), intent(in) :: self

      is_near = abs(self%excess) <= self%near
   end function is_near

   !> Does the state bound that of a load?
   pure logical function is_bound_of(self, load)
      class(load_window_t), intent(in) :: self
      !> Mean pressure [E*].
      real(dp), intent(in) :: load

      is_bound_of = self%is_of_load .and. merge(load <= self%load, load >= self%load, self%is_adhered)
   end function is_bound_of

   !> A load between the ends of the window: on the line through both, or in the middle.
   pure real(dp) function next_load(self) result(load)
      class(load_window_t), intent(in) :: self
      real(dp) :: part

      part = 0.5_dp
      if (self%has_passed_excess) part = min(max(self%excess/(self%excess - self%passed_excess), 0.05_dp), 0.95_dp)
      load = self%load + part*(self%passed - self%load)
   end function next_load

   !> Take note on which side of the penetration the state of a load is, if the load has told anything.
   subroutine take_note(self, load, state, has_contact)
      class(load_window_t), intent(inout) :: self
      !> Mean pressure [E*].
      real(dp), intent(in) :: load
      !> Its state; of no meaning without contact.
      type(contact_state_t), intent(in) :: state
      !> Is there a state with contact?
      logical, intent(in) :: has_contact
      real(dp) :: excess

      if (.not. self%is_known) return
      if (.not. has_contact) then
         ! loads that no state of the branch carries are those below it
         if (.not. self%is_adhered) return
         self%passed = load
         self%has_passed_excess = .false.
         return
      end if
      excess = penetration_of(state) - self%penetration
      if (merge(excess >= -self%none, excess <= self%none, self%is_adhered)) then
         self%state = state
         self%load = load
         self%excess = excess
         self%has_state = .true.
         self%is_of_load = .true.
      else
         self%passed = load
         self%passed_excess = excess
         self%has_passed_excess = .true.
      end if
   end subroutine take_note

end module adfric_periodic_load_window
