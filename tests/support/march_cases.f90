! SPDX-License-Identifier: GPL-3.0-or-later
!> Surfaces for the time stepping of any heights: rows from heights, a spectrum and adhesion, in the units of the time stepping.
module stepping_cases
   use adfric_base_kinds, only: dp
   use adfric_solid_prony, only: prony_t, new_prony
   use adfric_shape_height_line, only: height_line_t, new_cosine_line
   use adfric_foundation_stepping_equilibrium, only: stepping_surface_t, stepping_equilibrium_t
   use adfric_foundation_stepping_law, only: new_stepping_law
   use adfric_foundation_stepping_solid, only: solid_t, new_solid
   use adfric_foundation_stepping_path, only: new_path
   implicit none (type, external)
   private
   public :: stepping_case_t, stepping_sums_t, make_surface, make_line_surface, set_law, begin_rows, add_row, sum_of

   !> A sum of waves a_m cos(2 pi m x + phi_m) over one strip.
   type :: stepping_case_t
      real(dp), allocatable :: amplitudes(:), phases(:)
      !> Stiffnesses of the arms, and their times.
      real(dp), allocatable :: stiffness(:), times(:)
      real(dp) :: stress = 0, range = 0
      integer :: edge = 1
      logical :: is_approach = .false.
   end type stepping_case_t

   !> Means over the rows, sums of counts, and the largest mismatches of the balances.
   type :: stepping_sums_t
      real(dp) :: load = 0, friction = 0, contact = 0, adhesion = 0, dissipation = 0, edge_loss = 0
      real(dp) :: load_mismatch = 0, energy_mismatch = 0
      integer :: n_contacts = 0, n_adhesions = 0, n_free = 0, n_snaps = 0
   end type stepping_sums_t

contains

   !> The surface of a case.
   subroutine make_surface(trial, surface)
      type(stepping_case_t), intent(in) :: trial
      type(stepping_surface_t), intent(out) :: surface
      type(height_line_t) :: line

      call new_cosine_line(line, trial%amplitudes, trial%phases)
      call make_line_surface(line, trial%stiffness, trial%times, surface)
      call set_law(surface, trial)
   end subroutine make_surface

   !> A surface of one row without adhesion; its heights are measured from the highest one.
   subroutine make_line_surface(line, stiffness, times, surface)
      type(height_line_t), intent(in) :: line
      real(dp), intent(in) :: stiffness(:), times(:)
      type(stepping_surface_t), intent(out) :: surface
      real(dp) :: lowest, highest
      integer :: piece

      call line%get_extremes(lowest, highest, piece)
      call begin_rows(surface, 1)
      call add_row(surface, 1, line, stiffness, times, highest)
   end subroutine make_line_surface

   !> A number of rows, which are not there yet.
   subroutine begin_rows(surface, n_rows)
      type(stepping_surface_t), intent(out) :: surface
      integer, intent(in) :: n_rows

      allocate (surface%rows(n_rows))
   end subroutine begin_rows

   !> One of the rows.
   subroutine add_row(surface, number, line, stiffness, times, highest)
      type(stepping_surface_t), intent(inout) :: surface
      integer, intent(in) :: number
      type(height_line_t), intent(in) :: line
      real(dp), intent(in) :: stiffness(:), times(:)
      !> The highest height of all rows.
      real(dp), intent(in) :: highest
      type(height_line_t) :: lowered
      type(prony_t) :: prony
      type(solid_t) :: solid
      real(dp) :: low, high
      integer :: piece

      lowered = line
      call lowered%get_extremes(low, high, piece)
      call lowered%rotate(piece)
      lowered%coefficients(0, :) = lowered%coefficients(0, :) - highest
      call new_prony(prony, 1.0_dp, stiffness, times)
      call new_solid(solid, prony, 1.0_dp)
      call new_path(surface%rows(number), lowered, solid)
   end subroutine add_row

   !> Adhesion and branch of a surface whose rows are there.
   subroutine set_law(surface, trial)
      type(stepping_surface_t), intent(inout) :: surface
      type(stepping_case_t), intent(in) :: trial

      surface%is_approach = trial%is_approach
      call new_stepping_law(surface%law, trial%stress, trial%range, trial%edge, surface%rows(1)%solid%glassy)
   end subroutine set_law

   !> What the rows of an equilibrium add up to.
   function sum_of(equilibrium) result(sums)
      type(stepping_equilibrium_t), intent(in) :: equilibrium
      type(stepping_sums_t) :: sums
      integer :: i

      do i = 1, size(equilibrium%forces)
         associate (f => equilibrium%forces(i), weight => 1/real(size(equilibrium%forces), dp))
            sums%load = sums%load + weight*f%load
            sums%friction = sums%friction + weight*f%friction
            sums%contact = sums%contact + weight*f%contact
            sums%adhesion = sums%adhesion + weight*f%adhesion
            sums%dissipation = sums%dissipation + weight*f%dissipation
            sums%edge_loss = sums%edge_loss + weight*f%edge_loss
            sums%load_mismatch = max(sums%load_mismatch, abs(f%load_mismatch))
            sums%energy_mismatch = max(sums%energy_mismatch, abs(f%energy_mismatch))
            sums%n_contacts = sums%n_contacts + f%n_contacts
            sums%n_adhesions = sums%n_adhesions + f%n_adhesions
            sums%n_free = sums%n_free + f%n_free
            sums%n_snaps = sums%n_snaps + f%n_snaps
         end associate
      end do
   end function sum_of

end module stepping_cases
