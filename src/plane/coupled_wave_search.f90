! SPDX-License-Identifier: GPL-3.0-or-later
!> The contact of a wave that shear moves (`adfric_plane_sliding_coupling`) under a prescribed mean pressure, or at a penetration.
module adfric_plane_coupled_wave_search
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_numerics_secant_root, only: rising_equation_t, find_rising_root
   use adfric_plane_sliding_coupling, only: add_extremes, add_integrals, coupled_wave_t, is_pressing, set_width
   implicit none (type, external)
   private
   public :: solve_coupled_wave

   !> Ends of x = ln tan(w/2), and what is 0 of a logarithm.
   real(dp), parameter :: least_x = -340.0_dp, largest_x = 36.0_dp, round_off = 4*epsilon(1.0_dp)
   !> Halvings of a bracket.
   integer, parameter :: most_halvings = 100

   !> ln of mean pressure or penetration over the prescribed one, for x = ln tan(w/2).
   type, extends(rising_equation_t) :: coupled_width_t
      !> The contact, whose eta and tilt count.
      type(coupled_wave_t) :: wave
      !> The prescribed value.
      real(dp) :: goal = 0
      !> Is it the mean pressure?
      logical :: is_pressure = .true.
   contains
      procedure :: evaluate => evaluate_width
   end type coupled_width_t

contains

   !> Find the contact of a wave under a mean pressure or at a penetration.
   pure subroutine solve_coupled_wave(wave, m, tilt, goal, is_pressure, is_converged)
      !> The contact.
      type(coupled_wave_t), intent(out) :: wave
      !> m = mu beta, and s = 2 beta tau/(E* k D) [-].
      real(dp), intent(in) :: m, tilt
      !> Mean pressure over E* k D, below cos(pi eta)/2, or penetration over D, below 1; > 0.
      real(dp), intent(in) :: goal
      logical, intent(in) :: is_pressure
      !> Was it found? With a tilt there may be none.
      logical, intent(out) :: is_converged
      type(coupled_width_t) :: equation
      real(dp) :: x, high, low, middle
      integer :: k

      equation%wave%eta = atan(m)/pi
      equation%wave%tilt = tilt
      equation%goal = goal
      equation%is_pressure = is_pressure
      is_converged = .false.
      high = largest_x
      call set_width(equation%wave, high)
      if (.not. is_pressing(equation%wave)) then
         ! the widest contact that presses everywhere
         low = least_x
         do k = 1, most_halvings
            middle = (low + high)/2
            call set_width(equation%wave, middle)
            if (is_pressing(equation%wave)) then
               low = middle
            else
               high = middle
            end if
         end do
         high = low
         call set_width(equation%wave, high)
         call add_integrals(equation%wave, is_converged)
         if (.not. is_converged) return
         is_converged = merge(equation%wave%mean_pressure, equation%wave%penetration, is_pressure) >= goal
         if (.not. is_converged) return
      end if
      x = log(goal)/2
      call find_rising_root(equation, least_x, high, 2.0_dp, round_off, x, is_converged)
      if (.not. is_converged) return
      wave = equation%wave
      call set_width(wave, x)
      call add_integrals(wave, is_converged)
      if (is_converged) call add_extremes(wave, is_converged)
   end subroutine solve_coupled_wave

   !> Mean pressure or penetration of a width.
   pure subroutine evaluate_width(self, x, value)
      class(coupled_width_t), intent(in) :: self
      real(dp), intent(in) :: x
      real(dp), intent(out) :: value
      type(coupled_wave_t) :: wave
      logical :: is_found

      wave = self%wave
      call set_width(wave, x)
      call add_integrals(wave, is_found)
      value = not_a_number()
      if (.not. is_found) return
      value = merge(wave%mean_pressure, wave%penetration, self%is_pressure)
      if (value > 0) then
         value = log(value/self%goal)
      else
         value = -huge(value)
      end if
   end subroutine evaluate_width

end module adfric_plane_coupled_wave_search
