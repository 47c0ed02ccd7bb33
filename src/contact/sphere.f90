! SPDX-License-Identifier: GPL-3.0-or-later
!> Adhesive contact of an elastic sphere with a plane by Maugis's theory with Dugdale's law, with plain numbers or arrays of them.
!>
!> All but the units are in the reduced variables of Johnson (1997, eq. 2.11): `get_sphere_units` says what one of each is in SI
!> units. Maugis's parameter lambda is the adhesion stress in the unit of stress; for large lambda the theory is that of Johnson,
!> Kendall and Roberts, for small lambda that of Derjaguin, Muller and Toporov. Loads press and approaches close where they are
!> positive. Each procedure is elemental and pure, keeps nothing, and may be called by many threads at once.
!>
!> Status: `status_solved` (0), `status_no_equilibrium` (1: there is no such contact, which is an answer), `status_not_converged`
!> (2), `status_bad_argument` (-2). All other results are NaN where the status is not `status_solved`.
module adfric_contact_sphere
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_contact_arguments, only: largest_ratio, lies_between, status_bad_argument
   use adfric_describe_status, only: status_no_equilibrium, status_not_converged, status_solved
   use adfric_round_sphere_contact, only: branch_stable, branch_unstable, sphere_contact_t, control_approach, control_load, &
      & control_radius, &
      & find_contact, part_bodies, theory_maugis_dugdale
   use adfric_round_sphere_maugis_dugdale, only: maugis_t
   use adfric_round_sphere_theory_choice, only: get_mismatch
   use adfric_round_sphere_units, only: get_sphere_units
   implicit none (type, external)
   private
   public :: solve_sphere_load, solve_sphere_approach, solve_sphere_radius, find_sphere_pull_off, get_sphere_units
   public :: dp, status_solved, status_no_equilibrium, status_not_converged, status_bad_argument

contains

   !> Find the contact under a load.
   elemental subroutine solve_sphere_load(lambda, load, contact_radius, adhesion_radius, approach, status, is_unstable)
      !> Maugis's parameter [-], 1e-30 to 1e30.
      real(dp), intent(in) :: lambda
      !> Load P, reduced; tension is negative.
      real(dp), intent(in) :: load
      !> Receives the radius a of intimate contact, reduced.
      real(dp), intent(out) :: contact_radius
      !> Receives the radius c up to which adhesion acts, reduced.
      real(dp), intent(out) :: adhesion_radius
      !> Receives the approach, reduced.
      real(dp), intent(out) :: approach
      !> Receives what has become of the contact, see above.
      integer, intent(out) :: status
      !> Where two states carry the load, is the one meant that is not stable under it? False if absent.
      logical, intent(in), optional :: is_unstable
      real(dp) :: load_found

      call solve(lambda, control_load, load, branch_of(is_unstable), contact_radius, adhesion_radius, load_found, approach, status)
   end subroutine solve_sphere_load

   !> Find the contact at an approach. Bodies apart, beyond all attraction, have load 0 and both radii 0.
   elemental subroutine solve_sphere_approach(lambda, approach, contact_radius, adhesion_radius, load, status, is_unstable)
      !> Maugis's parameter [-], 1e-30 to 1e30.
      real(dp), intent(in) :: lambda
      !> Approach, reduced; separation is negative.
      real(dp), intent(in) :: approach
      !> Receives the radius a of intimate contact, reduced; 0: the surfaces only attract each other.
      real(dp), intent(out) :: contact_radius
      !> Receives the radius c up to which adhesion acts, reduced.
      real(dp), intent(out) :: adhesion_radius
      !> Receives the load P, reduced.
      real(dp), intent(out) :: load
      !> Receives what has become of the contact, see above.
      integer, intent(out) :: status
      !> Where two states have the approach, is the one meant that is not stable at it? False if absent.
      logical, intent(in), optional :: is_unstable
      real(dp) :: approach_found

      call solve(lambda, control_approach, approach, branch_of(is_unstable), contact_radius, adhesion_radius, load, &
         & approach_found, status)
   end subroutine solve_sphere_approach

   !> Find the contact of a radius.
   elemental subroutine solve_sphere_radius(lambda, contact_radius, adhesion_radius, load, approach, status)
      !> Maugis's parameter [-], 1e-30 to 1e30.
      real(dp), intent(in) :: lambda
      !> Radius a of intimate contact, reduced, >= 0.
      real(dp), intent(in) :: contact_radius
      !> Receives the radius c up to which adhesion acts, reduced.
      real(dp), intent(out) :: adhesion_radius
      !> Receives the load P, reduced.
      real(dp), intent(out) :: load
      !> Receives the approach, reduced.
      real(dp), intent(out) :: approach
      !> Receives what has become of the contact, see above.
      integer, intent(out) :: status
      real(dp) :: radius_found

      call solve(lambda, control_radius, contact_radius, branch_stable, radius_found, adhesion_radius, load, approach, status)
   end subroutine solve_sphere_radius

   !> Find where a contact that is pulled ends: the least load, or the least approach, that has a stable contact.
   elemental subroutine find_sphere_pull_off(lambda, load, approach, contact_radius, status, holds_approach)
      !> Maugis's parameter [-], 1e-30 to 1e30.
      real(dp), intent(in) :: lambda
      !> Receives the load at the end, reduced.
      real(dp), intent(out) :: load
      !> Receives the approach at the end, reduced.
      real(dp), intent(out) :: approach
      !> Receives the radius a of intimate contact at the end, reduced.
      real(dp), intent(out) :: contact_radius
      !> Receives whether the end was found, see above.
      integer, intent(out) :: status
      !> Is the approach prescribed, and not the load? False if absent.
      logical, intent(in), optional :: holds_approach
      type(maugis_t) :: theory
      type(sphere_contact_t) :: contact
      integer :: control

      control = control_load
      if (present(holds_approach)) control = merge(control_approach, control_load, holds_approach)
      status = status_bad_argument
      if (lies_between(lambda, 1/largest_ratio, largest_ratio)) then
         theory%lambda = lambda
         call theory%pull_off(control, contact)
         status = merge(status_solved, status_not_converged, contact%is_found .and. contact%is_converged)
      end if
      load = give(contact%load, status)
      approach = give(contact%approach, status)
      contact_radius = give(contact%radius, status)
   end subroutine find_sphere_pull_off

   !> The branch that is meant.
   pure integer function branch_of(is_unstable)
      !> Is it the unstable one? Not if absent.
      logical, intent(in), optional :: is_unstable

      branch_of = branch_stable
      if (present(is_unstable)) branch_of = merge(branch_unstable, branch_stable, is_unstable)
   end function branch_of

   !> Find the contact for what is prescribed.
   elemental subroutine solve(lambda, control, value, branch, contact_radius, adhesion_radius, load, approach, status)
      real(dp), intent(in) :: lambda
      !> What is prescribed, one of `control_...`.
      integer, intent(in) :: control
      !> Value of what is prescribed, reduced.
      real(dp), intent(in) :: value
      !> Which state is meant where there are two, one of `branch_...`.
      integer, intent(in) :: branch
      real(dp), intent(out) :: contact_radius, adhesion_radius, load, approach
      integer, intent(out) :: status
      type(maugis_t) :: theory
      type(sphere_contact_t) :: contact
      logical :: is_apart

      status = status_bad_argument
      if (lies_between(lambda, 1/largest_ratio, largest_ratio) .and. &
         & lies_between(value, merge(0.0_dp, -largest_ratio, control == control_radius), largest_ratio)) then
         theory%lambda = lambda
         call find_contact(theory, control, value, branch, contact)
         is_apart = .false.
         if (.not. contact%is_found) call part_bodies(control, value, branch, contact, is_apart)
         status = status_solved
         if (.not. contact%is_converged) then
            status = status_not_converged
         else if (.not. contact%is_found) then
            status = status_no_equilibrium
         else if (.not. is_apart) then
            if (.not. get_mismatch(theory, theory_maugis_dugdale, control, contact) < 1) status = status_not_converged
         end if
      end if
      contact_radius = give(contact%radius, status)
      adhesion_radius = give(contact%adhesion_radius, status)
      load = give(contact%load, status)
      approach = give(contact%approach, status)
   end subroutine solve

   !> A value of a contact that is solved, or else NaN.
   elemental real(dp) function give(value, status)
      !> The value, which has a meaning if the contact is solved.
      real(dp), intent(in) :: value
      integer, intent(in) :: status

      give = not_a_number()
      if (status == status_solved) give = value
   end function give

end module adfric_contact_sphere
