! SPDX-License-Identifier: GPL-3.0-or-later
!> Cases of friction with adhesion.
module friction_trials
   use adfric_base_kinds, only: dp
   use adfric_round_sphere_contact, only: theory_t, control_load, control_radius, branch_stable
   use adfric_round_sphere_dmt, only: dmt_t
   use adfric_round_sphere_jkr, only: jkr_t
   use adfric_round_sphere_maugis_dugdale, only: maugis_t
   use adfric_round_interaction_events, only: find_peeling_events, peeling_events_t
   use adfric_round_sphere_path, only: new_sphere_path, peeling_friction_t, peeling_path_t
   use adfric_round_sphere_peeling, only: friction_state_t, find_sliding_state, find_static_state
   implicit none (type, external)
   private
   public :: trial_t, events_of, label_of, get_trial, load_trial

   !> A case that is solved.
   type :: trial_t
      class(theory_t), allocatable :: theory
      type(peeling_friction_t) :: friction
      integer :: control = control_load, branch = branch_stable
      real(dp) :: prescribed = 0
   contains
      procedure :: get_path
      procedure :: solve
      procedure :: slide
   end type trial_t

contains

   !> The path of a trial from rest to sliding.
   subroutine get_path(self, path)
      class(trial_t), intent(in) :: self
      type(peeling_path_t), intent(out) :: path

      call new_sphere_path(path, self%theory, self%friction, self%control, self%prescribed, self%branch)
   end subroutine get_path

   !> The static state of a trial.
   function solve(self, given, value) result(state)
      class(trial_t), intent(in) :: self
      integer, intent(in) :: given
      real(dp), intent(in) :: value
      type(friction_state_t) :: state
      type(peeling_path_t) :: path

      call self%get_path(path)
      call find_static_state(path, given, value, state)
   end function solve

   !> The state of sliding of a trial.
   function slide(self) result(state)
      class(trial_t), intent(in) :: self
      type(friction_state_t) :: state
      type(peeling_path_t) :: path

      call self%get_path(path)
      call find_sliding_state(path, state)
   end function slide

   !> The events of a trial; without a stiffness nothing is on a spring.
   function events_of(trial, stiffness) result(events)
      type(trial_t), intent(in) :: trial
      real(dp), intent(in), optional :: stiffness
      type(peeling_events_t) :: events
      type(peeling_path_t) :: path
      real(dp) :: of_spring

      of_spring = 0
      if (present(stiffness)) of_spring = stiffness
      call trial%get_path(path)
      call find_peeling_events(path, of_spring, events)
   end function events_of

   !> A trial in words.
   function label_of(trial, value) result(label)
      type(trial_t), intent(in) :: trial
      real(dp), intent(in) :: value
      character(200) :: label

      associate (f => trial%friction)
         write (label, '(a, 5es11.3, 2i3, 2es11.3)') 'tau, nu, x, alpha, g0, control, branch, held, value =', f%strength, &
            & f%poisson, f%edge_fraction, f%interaction, f%slip_energy_ratio, trial%control, trial%branch, trial%prescribed, value
      end associate
   end function label_of

   !> Trial number k of many: theories, controls, weak and strong friction, with and without an end of slip.
   subroutine get_trial(k, trial)
      integer, intent(in) :: k
      type(trial_t), intent(out) :: trial
      real(dp), parameter :: lambdas(0:4) = [0.01_dp, 0.3_dp, 0.8_dp, 5.0_dp, 300.0_dp]
      real(dp), parameter :: strengths(0:2) = [0.05_dp, 0.8_dp, 6.0_dp], shares(0:3) = [0.0_dp, 0.25_dp, 0.9_dp, 1.5_dp]
      real(dp), parameter :: limits(0:3) = [0.02_dp, 0.6_dp, 5.0_dp, huge(1.0_dp)], values(0:2) = [-0.6_dp, 0.1_dp, 2.0_dp]
      type(maugis_t) :: maugis

      select case (mod(k, 7))
      case (5)
         allocate (trial%theory, source=jkr_t())
      case (6)
         allocate (trial%theory, source=dmt_t())
      case default
         maugis%lambda = lambdas(mod(k, 7))
         allocate (trial%theory, source=maugis)
      end select
      trial%friction%strength = strengths(mod(k/7, 3))
      trial%friction%poisson = 0.3_dp
      trial%friction%interaction = shares(mod(k/21, 4))
      trial%friction%slip_energy_ratio = limits(mod(k/84, 4))
      trial%prescribed = values(mod(k/336, 3))
      trial%control = 1 + mod(k/1008, 3)
      if (trial%control == control_radius) trial%prescribed = trial%prescribed + 0.7_dp
   end subroutine get_trial

   !> JKR or Maugis under a load.
   function load_trial(lambda, load, strength, interaction, limit) result(trial)
      !> 0: JKR.
      real(dp), intent(in) :: lambda
      real(dp), intent(in) :: load, strength, interaction, limit
      type(trial_t) :: trial
      type(maugis_t) :: maugis

      maugis%lambda = lambda
      if (lambda > 0) then
         allocate (trial%theory, source=maugis)
      else
         allocate (trial%theory, source=jkr_t())
      end if
      trial%prescribed = load
      trial%friction%strength = strength
      trial%friction%interaction = interaction
      trial%friction%slip_energy_ratio = limit
   end function load_trial

end module friction_trials
