! SPDX-License-Identifier: GPL-3.0-or-later
!> The load of a surface on a fine ladder of penetrations, each solved by itself, and the state of a load read off it: what a search
!> is judged by.
module load_scan
   use adfric_base_kinds, only: dp
   use adfric_describe_status, only: status_solved
   use adfric_foundation_crosswise, only: memory_t
   use adfric_foundation_equilibrium, only: equilibrium_t, solve_penetration
   use adfric_foundation_steady_state, only: branch_adhered
   use adfric_foundation_surface, only: surface_t, attach_gap_of
   use random_strips, only: dice_t
   implicit none (type, external)
   private
   public :: scan_t, new_scan, find_state, draw_load, state_found, state_none, state_unclear

   !> What a ladder says of a load: where its state is, that there is none, or that its rungs are too far apart to tell.
   integer, parameter :: state_found = 1, state_none = 2, state_unclear = 3

   !> A ladder, from above.
   type :: scan_t
      type(surface_t) :: surface
      !> Distance of the rungs [h].
      real(dp) :: step = 0
      !> Penetrations [h] and loads [h/K], from rung 0.
      real(dp), allocatable :: penetration(:), load(:)
      logical :: is_complete = .true.
   end type scan_t

contains

   !> Solve all rungs, from where contact is endless down to where nothing adheres.
   subroutine new_scan(self, surface, n)
      type(scan_t), intent(out) :: self
      type(surface_t), intent(in) :: surface
      !> Number of steps.
      integer, intent(in) :: n
      type(memory_t) :: memory
      type(equilibrium_t) :: equilibrium
      real(dp) :: highest, lowest
      integer :: k

      self%surface = surface
      highest = 1.2_dp + 0.3_dp*surface%adhesion%stress
      ! a little further, for round-off would let the crest be just drawn in, or not
      lowest = -attach_gap_of(surface)*(1 + 1.0e-9_dp)
      if (surface%branch == branch_adhered) lowest = lowest - surface%adhesion%stress
      self%step = (highest - lowest)/n
      allocate (self%penetration(0:n), self%load(0:n))
      do k = 0, n
         self%penetration(k) = highest - k*self%step
         memory = memory_t()
         call solve_penetration(surface, self%penetration(k), memory, equilibrium)
         self%load(k) = equilibrium%totals%load
         self%is_complete = self%is_complete .and. equilibrium%status == status_solved
      end do
   end subroutine new_scan

   !> The state of a load: on the adhered branch the first one from above; on the approach branch the first one from below,
   !> after less than the load was carried. The load rises by no more than a step from rung to rung, so what lies between is
   !> unclear only where a rung is as near to the load as that.
   subroutine find_state(self, load, outcome, penetration)
      type(scan_t), intent(in) :: self
      real(dp), intent(in) :: load
      !> One of `state_...`.
      integer, intent(out) :: outcome
      real(dp), intent(out) :: penetration
      logical :: is_below
      integer :: k, n

      n = ubound(self%load, 1)
      outcome = state_none
      penetration = 0
      if (self%surface%branch == branch_adhered) then
         do k = 0, n
            if (self%load(k) < load) exit
         end do
         if (k <= n) outcome = state_found
         if (k <= n) penetration = self%penetration(k)
         if (k == 0 .or. has_near_miss(self, load, 1, min(k, n) - 2)) outcome = state_unclear
      else
         is_below = .false.
         do k = n, 0, -1
            if (is_below .and. self%load(k) >= load) exit
            is_below = is_below .or. self%load(k) < load
         end do
         outcome = merge(state_found, state_unclear, is_below .and. k >= 0)
         if (k >= 0) penetration = self%penetration(k)
         if (has_near_miss(self, load, max(k, 0) + 2, n - 1)) outcome = state_unclear
      end if
   end subroutine find_state

   !> Does the load turn next to a level between two rungs?
   logical function has_near_miss(self, load, first, last)
      type(scan_t), intent(in) :: self
      real(dp), intent(in) :: load
      integer, intent(in) :: first, last
      real(dp) :: one, two
      integer :: k

      has_near_miss = .false.
      do k = first, last
         one = self%load(k) - self%load(k - 1)
         two = self%load(k) - self%load(k + 1)
         if (one*two >= 0 .and. abs(self%load(k) - load) < 1.5_dp*self%step) has_near_miss = .true.
      end do
   end function has_near_miss

   !> A random load of the surface; of three, one just above a valley of the load, one just below a summit, and one anywhere.
   real(dp) function draw_load(self, dice, number) result(load)
      type(scan_t), intent(in) :: self
      type(dice_t), intent(inout) :: dice
      integer, intent(in) :: number
      real(dp) :: side
      integer :: k, j, n

      n = ubound(self%load, 1)
      k = 1 + int(dice%between(0.0_dp, real(n - 2, dp)))
      load = self%load(k)
      if (mod(number, 3) == 0) return
      side = merge(1, -1, mod(number, 3) == 1)
      do j = 1, n - 1
         k = 1 + mod(k, n - 1)
         if (side*(self%load(k) - self%load(k - 1)) < 0 .and. side*(self%load(k) - self%load(k + 1)) < 0) exit
      end do
      load = self%load(k) + side*dice%between_log(1.0e-4_dp, 5.0e-2_dp)*self%surface%adhesion%stress
   end function draw_load

end module load_scan
