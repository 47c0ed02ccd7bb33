! SPDX-License-Identifier: GPL-3.0-or-later
!> Contacts without friction of the same bodies under all loads: what the histories of a contact with friction are made of.
!>
!> Load P, approach g, U = int P dg, stiffness dP/dg and radius grow together, so any of P and g says which contact it is.
module adfric_interface_normal_contact
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: normal_contact_t, normal_state_t, coordinate, find_position, by_force, by_displacement, round_off
   public :: friction_holds

   !> What a step gives, the tangential force or the displacement; the coordinate that goes with it is the load or the approach.
   integer, parameter :: by_force = 1, by_displacement = 2
   !> Differences below this share are round-off.
   real(dp), parameter :: round_off = 16*epsilon(1.0_dp)

   !> A contact without friction under a load.
   type :: normal_state_t
      !> Load P, approach g, and U, the integral of P over g.
      real(dp) :: load = 0, approach = 0, work = 0
      !> dP/dg.
      real(dp) :: stiffness = 0
      !> Radius of contact.
      real(dp) :: radius = 0
   end type normal_state_t

   !> Contacts without friction of the same bodies.
   type, abstract :: normal_contact_t
      !> Approach where dP/dg is not smooth, if there is one.
      real(dp) :: kink = 0
   contains
      procedure(find_state_i), deferred :: under_load
      procedure(find_state_i), deferred :: at_approach
      procedure :: get_spot
   end type normal_contact_t

   abstract interface
      !> The state under a load, or at an approach.
      pure subroutine find_state_i(self, given, state, is_converged)
         import :: normal_contact_t, normal_state_t, dp
         implicit none (type, external)
         !> The contacts.
         class(normal_contact_t), intent(in) :: self
         !> Load or approach, >= 0.
         real(dp), intent(in) :: given
         !> Receives the state.
         type(normal_state_t), intent(out) :: state
         !> Was it found to round-off?
         logical, intent(out) :: is_converged
      end subroutine find_state_i
   end interface

contains

   !> Radius a of a round contact that no adhesion widens, and the integral of its depth function g over it: load and approach of an
   !> elastic half-space of modulus 1 are P = 2 (a delta - that integral) and delta = g(a). Shapes with a closed form have it here.
   elemental subroutine get_spot(self, depth, radius, moment)
      class(normal_contact_t), intent(in) :: self
      !> g(a), below 0 as 0.
      real(dp), intent(in) :: depth
      !> Receive a, and int g dx from 0 to a.
      real(dp), intent(out) :: radius, moment
      type(normal_state_t) :: state
      logical :: is_converged

      call self%at_approach(max(depth, 0.0_dp), state, is_converged)
      radius = state%radius
      moment = radius*max(depth, 0.0_dp) - state%load/2
   end subroutine get_spot

   !> Is a tangential force no more than that of sliding, but for round-off?
   elemental logical function friction_holds(force, largest)
      !> The force, of either sign, and mu P, in one unit.
      real(dp), intent(in) :: force, largest

      friction_holds = abs(force) <= (1 + round_off)*largest
   end function friction_holds

   !> Load or approach.
   pure real(dp) function coordinate(state, kind)
      type(normal_state_t), intent(in) :: state
      !> One of `by_...`.
      integer, intent(in) :: kind

      coordinate = merge(state%load, state%approach, kind == by_force)
   end function coordinate

   !> A normal state by its coordinate.
   pure subroutine find_position(contact, kind, given, state, is_converged)
      class(normal_contact_t), intent(in) :: contact
      !> One of `by_...`.
      integer, intent(in) :: kind
      !> Load or approach; of 0 and less the state is that without contact.
      real(dp), intent(in) :: given
      type(normal_state_t), intent(out) :: state
      !> Becomes false if it is not found to round-off.
      logical, intent(inout) :: is_converged
      logical :: is_found

      if (.not. given > 0) return
      if (kind == by_force) then
         call contact%under_load(given, state, is_found)
      else
         call contact%at_approach(given, state, is_found)
      end if
      is_converged = is_converged .and. is_found
   end subroutine find_position

end module adfric_interface_normal_contact
