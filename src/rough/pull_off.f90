! SPDX-License-Identifier: GPL-3.0-or-later
!> Theories of the adhesion of rough surfaces with a tension p0 while the gap is at most r (Dugdale), w = p0 r.
!>
!> M. Ciavarella's model of the bearing area (BAM): heights are Gaussian, and the tension acts where the undeformed gap is within
!> the range; the repulsion is that of Persson's theory at the same mean gap u,
!>
!>     net(u) = p(u) - (p0/2) [erfc((u - r)/(sqrt(2) h)) - erfc(u/(sqrt(2) h))]
!>
!> and the least net pressure is that of pull-off. L. Pastewka and M. O. Robbins compare with 1
!>
!>     (g r/(2 l)) (g d/(4 r))^(2/3),   l = w/E,   d = 4 g/k,   k = half the root mean square Laplacian
module adfric_rough_pull_off
   use adfric_base_constants, only: pi
   use adfric_base_kinds, only: dp
   use adfric_shape_height_spectrum, only: height_spectrum_t
   use adfric_rough_persson, only: get_persson_states, persson_state_t
   use adfric_rough_separation_functions, only: energy_share_t, separation_functions_t
   use adfric_rough_wave_nodes, only: wave_nodes_t
   implicit none (type, external)
   private
   public :: find_pull_off, pastewka_robbins, bearing_pull_off_t

   !> The least net pressure of a theory.
   type :: bearing_pull_off_t
      !> Net pressure over E g, below 0 where there is tension, and mean gap there [m]; 0 and no meaning without tension.
      real(dp) :: pressure = 0, gap = 0
      !> Is there tension?
      logical :: has_tension = .false.
      !> Was the least pressure found?
      logical :: is_converged = .true.
   end type bearing_pull_off_t

   !> Ends of the search in ln P, and its steps: by then contact is full, or there is next to none.
   real(dp), parameter :: lightest = -20.7232658369464_dp, heaviest = 1.0986122886681_dp
   integer, parameter :: n_steps = 90

contains

   !> Find the least net pressure over all repulsive ones from 1e-9 to 3 E g.
   pure subroutine find_pull_off(spectrum, nodes, functions, share, stress, range, pull_off)
      type(height_spectrum_t), intent(in) :: spectrum
      type(wave_nodes_t), intent(in) :: nodes
      type(separation_functions_t), intent(in) :: functions
      type(energy_share_t), intent(in) :: share
      !> Tension p0 over E g, > 0, and its range r [m].
      real(dp), intent(in) :: stress, range
      type(bearing_pull_off_t), intent(out) :: pull_off
      integer, parameter :: max_iterations = 100
      real(dp) :: net, slope, low, high, x, least
      type(persson_state_t) :: state
      integer :: k, at

      ! the least value of a scan, between two positions where it falls and rises
      at = 0
      least = 0
      do k = 0, n_steps
         call get_net(position(k), net, slope, state)
         if (.not. net < least) cycle
         least = net
         at = k
      end do
      pull_off%has_tension = least < 0
      if (.not. pull_off%has_tension) return
      low = position(max(0, at - 1))
      high = position(min(n_steps, at + 1))
      x = position(at)
      pull_off%is_converged = .false.
      do k = 1, max_iterations
         call get_net(x, net, slope, state)
         least = min(net, least)
         if (slope > 0) then
            high = x
         else
            low = x
         end if
         pull_off%is_converged = high - low <= 1.0e-10_dp
         if (pull_off%is_converged) exit
         x = (low + high)/2
      end do
      pull_off%gap = state%gap
      pull_off%pressure = least

   contains

      !> Position of a step, ln P.
      pure real(dp) function position(step)
         integer, intent(in) :: step

         position = lightest + (heaviest - lightest)*step/n_steps
      end function position

      !> Net pressure over E g, and its derivative by ln P.
      pure subroutine get_net(log_pressure, value, derivative, of_gap)
         real(dp), intent(in) :: log_pressure
         real(dp), intent(out) :: value, derivative
         type(persson_state_t), intent(out) :: of_gap
         type(persson_state_t) :: states(1)
         real(dp) :: h, p, tension, by_gap

         h = sqrt(2.0_dp)*spectrum%root_mean_square_height()
         p = exp(log_pressure)
         call get_persson_states(nodes, functions, p, [share], states)
         of_gap = states(1)
         associate (u => of_gap%gap)
            tension = stress/2*(erfc((u - range)/h) - erfc(u/h))
            by_gap = stress/(sqrt(pi)*h)*(exp(-(u/h)**2) - exp(-((u - range)/h)**2))
         end associate
         value = p - tension
         ! du = -d(E g P)/K; the tension falls with the gap
         derivative = p*(1 + by_gap*nodes%slope/of_gap%stiffness)
      end subroutine get_net

   end subroutine find_pull_off

   !> The left side of Pastewka and Robbins's condition.
   pure real(dp) function pastewka_robbins(spectrum, work_over_modulus, range) result(left_side)
      type(height_spectrum_t), intent(in) :: spectrum
      !> Work of adhesion over E, and range of the tension [m].
      real(dp), intent(in) :: work_over_modulus, range

      associate (g => spectrum%root_mean_square_slope(), k => spectrum%root_mean_square_curvature())
         left_side = g*range/(2*work_over_modulus)*(g**2/(k*range))**(2/3.0_dp)
      end associate
   end function pastewka_robbins

end module adfric_rough_pull_off
