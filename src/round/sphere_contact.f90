! SPDX-License-Identifier: GPL-3.0-or-later
!> A contact of a sphere with a plane, and what every theory of it can do.
!>
!> Reduced variables of Johnson (2.11): radii in (3 pi w R^2/4E*)^(1/3), loads in pi w R, approach in
!> (9 pi^2 w^2 R/16E*^2)^(1/3). Loads press, approach closes, tension is negative. The adhesion that friction
!> leaves is the share X = w'/w of the work of adhesion w.
module adfric_round_sphere_contact
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: sphere_contact_t, theory_t, find_contact, part_bodies, friction_radius
   public :: theory_hertz, theory_jkr, theory_dmt, theory_maugis_dugdale
   public :: control_load, control_approach, control_radius, branch_stable, branch_unstable

   !> Theories, as they stand in the results file.
   integer, parameter :: theory_hertz = 0, theory_jkr = 1, theory_dmt = 2, theory_maugis_dugdale = 3
   !> What is prescribed: the quantity whose value is given.
   integer, parameter :: control_load = 1, control_approach = 2, control_radius = 3
   !> Which of the two states that one prescribed value may have.
   integer, parameter :: branch_stable = 1, branch_unstable = 2

   !> A state of contact.
   type :: sphere_contact_t
      !> Has a contact been found?
      logical :: is_found = .false.
      !> Did the search converge to round-off?
      logical :: is_converged = .true.
      !> Is it stable under the control that was given? With a given radius: under load.
      logical :: is_stable = .false.
      !> Radii of intimate contact (0: the surfaces only attract each other) and of adhesion.
      real(dp) :: radius = 0, adhesion_radius = 0
      !> Load P and approach delta, reduced.
      real(dp) :: load = 0, approach = 0
      !> Position on the theory's curve where the contact was found; it is the first guess for a neighbour. 0: none.
      real(dp) :: position = 0
      !> Derivative of what is prescribed by the position; 0: not known.
      real(dp) :: slope = 0
      !> Slopes of load and approach along the states of contact, in any unit of these: their ratio is the stiffness. Both are 0
      !> where the bodies are apart, and not known by Maugis and Dugdale's theory.
      real(dp) :: load_slope = 0, approach_slope = 0
   end type sphere_contact_t

   !> A theory of adhesion, for one value of X (and of lambda).
   type, abstract :: theory_t
      !> X = w'/w >= 0.
      real(dp) :: ratio = 1
   contains
      procedure(find_i), deferred :: of_radius
      procedure(find_branch_i), deferred :: of_load
      procedure(find_branch_i), deferred :: of_approach
      procedure(pull_off_i), deferred :: pull_off
   end type theory_t

   abstract interface

      !> The contact of a radius >= 0.
      pure subroutine find_i(self, value, contact)
         import :: theory_t, sphere_contact_t, dp
         implicit none (type, external)
         !> The theory, for the X that its `ratio` holds.
         class(theory_t), intent(in) :: self
         !> Radius a of the contact, reduced, >= 0.
         real(dp), intent(in) :: value
         !> In: a neighbour that helps the search, or a new one. Out: the contact, with `is_found` and `is_converged`.
         type(sphere_contact_t), intent(inout) :: contact
      end subroutine find_i

      !> The contact of a load or an approach.
      pure subroutine find_branch_i(self, value, branch, contact)
         import :: theory_t, sphere_contact_t, dp
         implicit none (type, external)
         class(theory_t), intent(in) :: self
         !> Load P or approach delta of the contact, reduced; tension and separation are negative.
         real(dp), intent(in) :: value
         !> One of `branch_...`: which state is meant where there are two.
         integer, intent(in) :: branch
         type(sphere_contact_t), intent(inout) :: contact
      end subroutine find_branch_i

      !> The contact at the end of stability.
      pure subroutine pull_off_i(self, control, contact)
         import :: theory_t, sphere_contact_t
         implicit none (type, external)
         class(theory_t), intent(in) :: self
         !> One of `control_...`: what is prescribed. A given radius counts as a given load.
         integer, intent(in) :: control
         type(sphere_contact_t), intent(out) :: contact
      end subroutine pull_off_i

   end interface

contains

   !> The contact with the prescribed value.
   pure subroutine find_contact(theory, control, value, branch, contact)
      !> Theory of adhesion, for the X that its `ratio` holds.
      class(theory_t), intent(in) :: theory
      !> One of `control_...`: what is prescribed.
      integer, intent(in) :: control
      !> Value of the load, approach or radius that is prescribed, reduced.
      real(dp), intent(in) :: value
      !> One of `branch_...`: which state is meant where there are two; a radius belongs to one contact only.
      integer, intent(in) :: branch
      !> In: a neighbour that helps the search, or a new one. Out: the contact, with `is_found` and `is_converged`.
      type(sphere_contact_t), intent(inout) :: contact

      select case (control)
      case (control_load)
         call theory%of_load(value, branch, contact)
      case (control_approach)
         call theory%of_approach(value, branch, contact)
      case default
         call theory%of_radius(value, contact)
      end select
   end subroutine find_contact

   !> Bodies apart, below the approach of all contacts and of all attraction: there is no load. The other branch is one of
   !> contacts. DMT has no such state, for its pull ends nowhere.
   pure subroutine part_bodies(control, value, branch, contact, is_apart)
      !> One of `control_...`: what is prescribed. A load or a radius parts nothing.
      integer, intent(in) :: control
      !> Value of what is prescribed, reduced.
      real(dp), intent(in) :: value
      !> One of `branch_...`.
      integer, intent(in) :: branch
      !> In: what a theory with an end of adhesion has found, no contact. Out: the state, if there is one.
      type(sphere_contact_t), intent(inout) :: contact
      !> Is there one?
      logical, intent(out) :: is_apart

      is_apart = contact%is_converged .and. control == control_approach .and. branch == branch_stable .and. value < 0
      if (.not. is_apart) return
      contact = sphere_contact_t()
      contact%is_found = .true.
      contact%is_stable = .true.
      contact%approach = value
   end subroutine part_bodies

   !> Radius b of the circle that bears friction, between those of intimate contact and of adhesion (J 3.8); at radius 0
   !> the limit of a contact that shrinks, for without intimate contact there is no friction.
   elemental real(dp) function friction_radius(contact, edge_fraction)
      !> The contact, whose radii a and c are read.
      type(sphere_contact_t), intent(in) :: contact
      !> Position x of b between a and c [-], 0 to 1.
      real(dp), intent(in) :: edge_fraction

      friction_radius = contact%radius + edge_fraction*(contact%adhesion_radius - contact%radius)
   end function friction_radius

end module adfric_round_sphere_contact
