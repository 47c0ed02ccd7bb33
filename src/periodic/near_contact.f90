! SPDX-License-Identifier: GPL-3.0-or-later
!> The contact of a body that slides a little slower or faster, for the slope of the friction over the logarithm of the velocity.
!>
!> On fixed sets of open and closed cells the contact has an exact derivative by the velocity. It is that of the cells, not that of the
!> surface: an edge passes cells one by one, and within a cell losses and area rise by other slopes than on the mean. On 256 cells of
!> a wave such a derivative was off by 0.01 of d ln T/d ln v for the losses, and by up to 0.15 with the area. Contacts at velocities so far
!> apart that edges move by a part of a cell were off by up to 0.011 (`periodic_velocity_slope.pf`). Each is solved from the contact
!> of the point, so that it is the same state.
module adfric_periodic_near_contact
   use adfric_base_kinds, only: dp
   use adfric_periodic_adhesive_contact, only: find_state
   use adfric_periodic_chords, only: chord_fraction
   use adfric_periodic_contact, only: contact_state_t, solve_contact
   use adfric_periodic_friction, only: get_losses
   use adfric_periodic_gap_solver, only: gap_solver_t
   use adfric_periodic_maps, only: sum_of
   use adfric_periodic_operator, only: periodic_operator_t
   implicit none (type, external)
   private
   public :: near_contact_t, near_step, near_steps, solve_near_contact

   !> Steps of ln v: an error of the square of it, and an error of the cells over it.
   real(dp), parameter :: near_step = 0.1_dp, near_steps(2) = near_step*[-1, 1]

   !> A contact at another velocity.
   type :: near_contact_t
      !> Friction from the loss, along x and along y [E*].
      real(dp) :: loss(2) = 0
      !> Mean pressure [E*]; fractions in contact, which varies smoothly, and within the range of adhesion.
      real(dp) :: mean_pressure = 0, area = 0, share = 0
      !> Pressure, below 0 where adhesion pulls [E*], and where the faces touch; shape of the cells.
      real(dp), allocatable :: pressure(:, :)
      !> See `pressure`.
      logical, allocatable :: is_contact(:, :)
      !> Has it been found?
      logical :: is_found = .false.
   end type near_contact_t

contains

   !> Solve it.
   subroutine solve_near_contact(state, operator, gap_solver, tolerance, near)
      !> In: the contact of the point, with what is given, and the law of adhesion without shares. Out: that of the other velocity.
      type(contact_state_t), intent(inout) :: state
      !> Stiffness of the solid at the other velocity.
      type(periodic_operator_t), intent(inout) :: operator
      !> Workspace for these cells, of any velocity.
      type(gap_solver_t), intent(inout) :: gap_solver
      !> Largest residual that is allowed [-].
      real(dp), intent(in) :: tolerance
      !> Receives the contact.
      type(near_contact_t), intent(out) :: near

      ! steps are for definite stiffnesses
      if (.not. operator%smallest_ratio() > 0) return
      call operator%resist_mean(state%resists_mean)
      if (allocated(state%cohesion)) then
         call state%cohesion%set_share(state%gap)
         call find_state(state, operator, gap_solver, tolerance, near%is_found)
      else
         call solve_contact(state, operator, gap_solver, tolerance)
         near%is_found = state%is_converged
      end if
      if (.not. near%is_found) return
      associate (n => size(state%gap))
         near%is_contact = .not. state%is_open
         allocate (near%pressure, source=merge(0.0_dp, max(state%pressure, 0.0_dp), state%is_open))
         if (allocated(state%cohesion)) then
            near%share = sum_of(state%cohesion%share)/n
            near%pressure(:, :) = near%pressure - state%cohesion%stress*state%cohesion%share
         end if
         near%mean_pressure = state%mean_pressure
         if (state%resists_mean) near%mean_pressure = sum_of(near%pressure)/n
      end associate
      near%area = chord_fraction(near%pressure, merge(max(state%gap, 0.0_dp), 0.0_dp, state%is_open), operator%cell_size, .false.)
      call get_losses(operator, state%gap - state%shape, near%loss)
   end subroutine solve_near_contact

end module adfric_periodic_near_contact
