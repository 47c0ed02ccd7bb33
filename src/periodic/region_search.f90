! SPDX-License-Identifier: GPL-3.0-or-later
!> When the open region is changed, and how: all wrong cells at once while that helps, and one by one when it does not.
!>
!> A change of all wrong cells is a step of Newton's method, and it need not wait until the gap of the present region is exact. How far
!> the pressure that remains must lie below what the wrong cells violate is the strictness. Whenever a number of changes has not
!> brought fewer wrong cells, more is asked for: a tenth of what may be left, then an exact gap, then one cell at a time, the last
!> wrong one, until there are fewer wrong cells than ever. With exact gaps that ends for every matrix whose principal minors are
!> positive, since no region comes twice (J. J. Judice, F. M. Pires, Comput. Oper. Res. 21, 1994, 587); stages before it are left
!> but a finite number of times.
module adfric_periodic_region_search
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: verdict_t, region_search_t, new_region_search

   !> Pressure left over violation at which the region is changed, at first and at last before gaps are exact.
   real(dp), parameter :: loose = 0.3_dp, strict = 1.0e-3_dp
   !> Steps that have to halve the pressure that remains; it takes one or two, but for round-off.
   integer, parameter :: longest_stall = 50

   !> What is wrong with a gap and its pressure. Wrong are open cells that overlap and closed ones that pull, by more than the tolerance.
   type :: verdict_t
      !> Largest pressure or tension of an open cell, wherein there should be none [E*].
      real(dp) :: remaining = 0
      !> Largest tension of a wrong cell, or what it takes to part it [E*]; 0 if no cell is wrong.
      real(dp) :: violation = 0
   end type verdict_t

   !> How strict the search has become.
   type :: region_search_t
      !> Is only one wrong cell changed at a time?
      logical :: is_one_by_one = .false.
      !> Must the gap of a region be exact?
      logical, private :: is_exact = .false.
      !> Pressure left over violation at which the region is changed.
      real(dp), private :: strictness = loose
      !> Changes without fewer wrong cells that are borne, and how many of them are left.
      integer, private :: all_patience = 0, patience = 0
      !> Least number of wrong cells so far.
      integer, private :: fewest = huge(1)
      !> Pressure left in this region when it last had been halved [E*].
      real(dp), private :: least_remaining = huge(1.0_dp)
      !> Steps since then.
      integer, private :: n_stalled = 0
   contains
      procedure :: note_step
      procedure :: note_region
      procedure :: is_stalled
      procedure :: is_due
      procedure :: choose_wrong
      procedure :: get_stricter
   end type region_search_t

contains

   !> Begin a search.
   pure subroutine new_region_search(self, patience)
      type(region_search_t), intent(out) :: self
      !> Changes without fewer wrong cells that are borne; below 0 cells are changed one by one from the beginning.
      integer, intent(in) :: patience

      self%all_patience = max(patience, 0)
      self%patience = patience
      self%is_exact = patience < 0
      self%is_one_by_one = patience < 0
   end subroutine new_region_search

   !> Take note of what a step has left.
   pure subroutine note_step(self, verdict)
      class(region_search_t), intent(inout) :: self
      type(verdict_t), intent(in) :: verdict

      self%n_stalled = self%n_stalled + 1
      if (verdict%remaining > self%least_remaining/2) return
      self%least_remaining = verdict%remaining
      self%n_stalled = 0
   end subroutine note_step

   !> Take note that steps begin anew.
   pure subroutine note_region(self)
      class(region_search_t), intent(inout) :: self

      self%least_remaining = huge(1.0_dp)
      self%n_stalled = 0
   end subroutine note_region

   !> Have the last steps been of no use?
   pure logical function is_stalled(self)
      class(region_search_t), intent(in) :: self

      is_stalled = self%n_stalled > longest_stall
   end function is_stalled

   !> Is it time to change the wrong cells?
   pure logical function is_due(self, verdict, aim)
      class(region_search_t), intent(in) :: self
      type(verdict_t), intent(in) :: verdict
      !> Pressure left in open cells of an exact gap [E*].
      real(dp), intent(in) :: aim

      is_due = verdict%remaining <= max(aim, merge(0.0_dp, self%strictness*verdict%violation, self%is_exact))
   end function is_due

   !> Choose the cells that are changed: all that are wrong, or the last one of them. Steps begin anew.
   pure subroutine choose_wrong(self, n_wrong, is_wrong)
      class(region_search_t), intent(inout) :: self
      !> Number of wrong cells.
      integer, intent(in) :: n_wrong
      !> In: which cells are wrong. Out: which are changed.
      logical, intent(inout) :: is_wrong(:, :)
      integer :: cell(2)

      call self%note_region()
      call self%get_stricter(n_wrong)
      if (.not. self%is_one_by_one .or. n_wrong == 0) return
      cell = findloc(is_wrong, .true., back=.true.)
      is_wrong(:, :) = .false.
      is_wrong(cell(1), cell(2)) = .true.
   end subroutine choose_wrong

   !> Take note of the wrong cells that are to be changed; become stricter where they have not become fewer for a while.
   pure subroutine get_stricter(self, n_wrong)
      class(region_search_t), intent(inout) :: self
      !> Number of wrong cells.
      integer, intent(in) :: n_wrong

      if (n_wrong < self%fewest) then
         self%fewest = n_wrong
         if (self%all_patience > 0) self%is_one_by_one = .false.
         if (self%all_patience > 0) self%patience = self%all_patience
         return
      end if
      self%patience = self%patience - 1
      if (self%patience >= 0) return
      self%is_one_by_one = self%is_exact
      self%is_exact = self%is_exact .or. self%strictness <= strict
      self%strictness = self%strictness/10
      if (.not. self%is_one_by_one) self%patience = self%all_patience
   end subroutine get_stricter

end module adfric_periodic_region_search
