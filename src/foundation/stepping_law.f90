! SPDX-License-Identifier: GPL-3.0-or-later
!> The law of adhesion of a time stepping, for a column with any number of relaxation times.
!>
!> As in `adfric_foundation_adhesion`, in units of the foundation of the time stepping: stresses in k0 times the unit of length.
!> States are ordered by the lengths of the dashpots, from which continuous edges take the shift that the dashpots have while the
!> column is attached. In these lengths, m is the position where a free column would be, and an attached one is at m - drop or in
!> contact.
module adfric_foundation_stepping_law
   use adfric_base_kinds, only: dp
   use adfric_foundation_adhesion, only: edge_continuous, edge_front
   use adfric_foundation_stepping_attraction, only: column_attraction_t, new_column_attraction
   use adfric_interface_attraction, only: attraction_t
   implicit none (type, external)
   private
   public :: stepping_law_t, new_stepping_law, new_attracting_law

   !> What steps in time do not tell, in units of the time stepping.
   real(dp), parameter :: resolved = 1.0e-11_dp

   !> Adhesion as a time stepping needs it.
   type :: stepping_law_t
      !> Adhesion stress p0, >= 0.
      real(dp) :: stress = 0
      !> Range of adhesion d0, > 0 where there is a stress.
      real(dp) :: range = 0
      !> Contact ends where the pressure falls to minus this.
      real(dp) :: strength = 0
      !> Gap at which adhesion takes hold of a free column, and that at which an adhering one is lost.
      real(dp) :: attach_gap = 0, release_gap = 0
      !> By how much the displacement jumps there.
      real(dp) :: jump = 0
      !> By how much all dashpots jump there (continuous edges), >= 0.
      real(dp) :: shift = 0
      !> Where an attached column would be above m, and how far m is from the surface when it is let go.
      real(dp) :: drop = 0, release_reach = 0
      !> Are there zones of adhesion beside contacts?
      logical :: has_zones = .false.
      !> Does the surface snap into contact where adhesion takes hold?
      logical :: snaps = .false.
      !> Another law than Dugdale's; not allocated without one. Then stress, strength and range alone count of the others.
      type(column_attraction_t), allocatable :: attraction
      !> Lengths and loads, in the units of the time stepping, that steps in time do not tell; 0 where all is exact.
      real(dp) :: resolution = 0
   end type stepping_law_t

contains

   !> The law for a column.
   pure subroutine new_stepping_law(self, stress, range, edge, glassy)
      type(stepping_law_t), intent(out) :: self
      !> Adhesion stress, >= 0; 0 without adhesion.
      real(dp), intent(in) :: stress
      !> Range of adhesion, > 0 where there is a stress.
      real(dp), intent(in) :: range
      !> Edge rule, one of `edge_...`.
      integer, intent(in) :: edge
      !> Instantaneous over relaxed stiffness of the column, >= 1.
      real(dp), intent(in) :: glassy
      real(dp) :: reach

      if (.not. stress > 0) return
      self%stress = stress
      self%range = range
      self%strength = stress
      self%has_zones = .true.
      self%attach_gap = range
      self%release_gap = range
      self%jump = stress/glassy
      ! an elastic column has w = p at all times, so its displacement must jump
      if (edge == edge_continuous .and. glassy > 1) then
         self%jump = 0
         self%shift = stress/(glassy - 1)
      else if (edge == edge_front) then
         if (self%jump > 2*range) then
            ! straight into contact and out of it, where both have the same energy
            reach = sqrt(2*self%jump*range)
            self%has_zones = .false.
            self%jump = reach
            self%strength = glassy*reach
            self%attach_gap = reach
            self%release_gap = 0
         else
            self%attach_gap = range + self%jump/2
            self%release_gap = range - self%jump/2
         end if
      end if
      self%drop = self%jump
      self%release_reach = self%release_gap + self%jump
      self%snaps = .not. self%has_zones .or. self%jump >= self%attach_gap
   end subroutine new_stepping_law

   !> Another law than Dugdale's for a column.
   pure subroutine new_attracting_law(self, law, glassy)
      type(stepping_law_t), intent(out) :: self
      !> The law, which has a wall, in units of the time stepping.
      type(attraction_t), intent(in) :: law
      !> Instantaneous over relaxed stiffness of the column, >= 1.
      real(dp), intent(in) :: glassy

      self%stress = law%stress
      self%range = law%range
      self%strength = law%stress
      self%resolution = resolved*(1 + law%stress)
      allocate (self%attraction)
      call new_column_attraction(self%attraction, law, glassy)
   end subroutine new_attracting_law

end module adfric_foundation_stepping_law
