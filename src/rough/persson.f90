! SPDX-License-Identifier: GPL-3.0-or-later
!> B. N. J. Persson's theory of the elastic contact of a rough surface. With the mean pressure p, the modulus E, the slope g of all
!> waves, P = p/(E g), and x = sqrt(2) p/(E t), t the slope of the waves up to the wave number q,
!>
!>     A = erf(sqrt(2) P),
!>     u = sqrt(2/pi) int_0^g dt/q Phi(x),   1/K = (1/p) sqrt(2/pi) int_0^g dt/q W'(erf x) exp(-x^2),   U = (E/2) int_0^g t dt/q W(erf x)
!>
!> are area, mean gap, stiffness K = -dp/du and energy of an area: each wave stores the share W of its energy of full contact, and
!> dU = -p du.
module adfric_rough_persson
   use adfric_base_constants, only: pi
   use adfric_base_kinds, only: dp
   use adfric_rough_separation_functions, only: energy_share_t, separation_functions_t
   use adfric_rough_wave_nodes, only: n_of_panel, wave_nodes_t
   implicit none (type, external)
   private
   public :: persson_fraction, persson_mean_square, persson_state_t, get_persson_states, most_pressure

   !> Waves of this x and beyond are in full contact.
   real(dp), parameter :: full = 26
   !> Largest P whose gap is a number with digits: h exp(-400).
   real(dp), parameter :: most_pressure = 20/sqrt(2.0_dp)

   !> Gap [m], stiffness [1/m] and energy [m] over a modulus.
   type :: persson_state_t
      !> Mean gap [m].
      real(dp) :: gap = 0
      !> Stiffness over modulus K/E [1/m].
      real(dp) :: stiffness = 0
      !> Energy of an area over modulus U/E [m].
      real(dp) :: energy = 0
   end type persson_state_t

contains

   !> Part of the area in contact.
   elemental real(dp) function persson_fraction(pressure) result(fraction)
      !> P = p/(E g), >= 0.
      real(dp), intent(in) :: pressure

      fraction = erf(sqrt(2.0_dp)*pressure)
   end function persson_fraction

   !> Mean square of the pressure over (E g)^2.
   elemental real(dp) function persson_mean_square(pressure) result(mean_square)
      !> P = p/(E g), >= 0.
      real(dp), intent(in) :: pressure

      mean_square = (0.25_dp + pressure**2)*erf(sqrt(2.0_dp)*pressure) + pressure/2*sqrt(2/pi)*exp(-2*min(pressure, full)**2)
   end function persson_mean_square

   !> States of several shares W under one pressure.
   pure subroutine get_persson_states(nodes, functions, pressure, shares, states)
      type(wave_nodes_t), intent(in) :: nodes
      type(separation_functions_t), intent(in) :: functions
      !> P = p/(E g), > 0, below `most_pressure`.
      real(dp), intent(in) :: pressure
      type(energy_share_t), intent(in) :: shares(:)
      !> Receives the state of each share.
      type(persson_state_t), intent(out) :: states(:)
      real(dp) :: x, a, e, f(3), gap(size(shares)), compliance(size(shares)), energy(size(shares)), weight
      integer :: first, i, k, n

      first = max(1, count(nodes%ends(:size(nodes%weights, 2) - 1) <= sqrt(2.0_dp)*pressure/full))
      gap = 0
      compliance = 0
      energy = 0
      do i = first, size(nodes%weights, 2)
         do k = 1, n_of_panel
            x = sqrt(2.0_dp)*pressure/nodes%t(k, i)
            weight = nodes%weights(k, i)*nodes%t(k, i)/nodes%q(k, i)
            a = erf(x)
            energy = energy + weight*nodes%t(k, i)*shares%share(a)
            if (x > full) cycle
            e = exp(-x**2)
            call functions%get_f(x, f)
            do n = 1, size(shares)
               gap(n) = gap(n) + weight*e*shares(n)%separation(f)
               compliance(n) = compliance(n) + weight*e*shares(n)%slope(a)
            end do
         end do
      end do
      states%gap = sqrt(2/pi)*nodes%slope*gap
      states%stiffness = pressure/(sqrt(2/pi)*compliance)
      ! longer waves than those of the first panel have their energy of full contact
      states%energy = nodes%m_1(first - 1)/4 + nodes%slope**2*energy/2
   end subroutine get_persson_states

end module adfric_rough_persson
