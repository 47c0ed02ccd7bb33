! SPDX-License-Identifier: GPL-3.0-or-later
!> A solid whose modulus falls as a power of time, E(t) = E(1) t^(-alpha) with 0 < alpha < 1, as a sum of exponentials.
!>
!> $$ t^{-\alpha} = \frac{1}{\Gamma(\alpha)} \int_0^\infty x^{\alpha - 1} e^{-x t} dx . $$
!> The rates x of a span of times from 0 to T are summed in three parts, each by Gauss's rule of its own weight. Slow ones, x T < 2: a
!> rule with one node at 0, the relaxed modulus. Those between: a rule of ln x for each two decades. Fast ones: a rule of the times 1/x,
!> which has their viscosity and the next moments. Error of E relative at times from 10/x of the fastest middle rate to T:
!> `power_law_error`, and a hundredth of that of its integral over time. Only for a shorter time than that, right after a jump of the
!> speed, the sum is no power law: its modulus is finite.
module adfric_solid_power_law
   use adfric_base_kinds, only: dp
   use adfric_numerics_gauss, only: gauss_nodes, gauss_weights
   use adfric_solid_prony, only: new_prony, prony_t
   implicit none (type, external)
   private
   public :: get_power_law, power_law_error

   !> Largest relative error of E(t) (`tests/solid/solid_power_law.pf`).
   real(dp), parameter :: power_law_error = 2.0e-8_dp
   !> Nodes of the slow rates beside that at 0, and of the fast ones.
   integer, parameter :: n_slow = 5, n_fast = 4
   !> Rate times the longest time, from which on rates are not slow.
   real(dp), parameter :: end_of_slow = 2
   !> Fewest and most rules of the middle rates, and the decades of one.
   integer, parameter :: fewest_rules = 2, most_rules = 3, decades = 2

contains

   !> The arms of a power law.
   pure subroutine get_power_law(modulus, exponent, longest, shortest, prony)
      !> E at 1 s [any unit of a modulus], > 0.
      real(dp), intent(in) :: modulus
      !> alpha [-], > 0 and < 1.
      real(dp), intent(in) :: exponent
      !> Length in time of what the solid goes through [s], and the shortest time of it that is looked at.
      real(dp), intent(in) :: longest, shortest
      !> Receives the arms.
      type(prony_t), intent(out) :: prony
      real(dp), parameter :: margin = 30
      integer, parameter :: n_middle = size(gauss_nodes)
      real(dp), allocatable :: rates(:), moduli(:)
      real(dp) :: slow(n_slow), slow_weights(n_slow), fast(n_fast), fast_weights(n_fast), half, end, unit
      integer :: n_rules, k

      n_rules = fewest_rules
      if (longest > 10.0_dp**(decades*fewest_rules)*end_of_slow/margin*shortest) n_rules = most_rules
      end = end_of_slow*10.0_dp**(decades*n_rules)
      half = decades*log(10.0_dp)/2
      allocate (rates(n_slow + n_middle*n_rules + n_fast), moduli(n_slow + n_middle*n_rules + n_fast))
      associate (alpha => exponent)
         call get_rule(alpha, slow, slow_weights)
         ! the rule of x^alpha, over x
         rates(:n_slow) = end_of_slow*slow
         moduli(:n_slow) = end_of_slow**alpha*slow_weights/slow
         do k = 1, n_rules
            associate (first => n_slow + (k - 1)*n_middle, logs => log(end_of_slow) + half*(2*k - 1 + gauss_nodes))
               rates(first + 1:first + n_middle) = exp(logs)
               moduli(first + 1:first + n_middle) = half*gauss_weights*exp(alpha*logs)
            end associate
         end do
         call get_rule(-alpha, fast, fast_weights)
         associate (first => size(rates) - n_fast)
            rates(first + 1:) = end/fast
            moduli(first + 1:) = end**alpha*fast_weights/fast
         end associate
         unit = modulus*longest**(-alpha)/gamma(alpha)
         call new_prony(prony, unit*end_of_slow**alpha*(1/alpha - sum(slow_weights/slow)), unit*moduli, longest/rates)
      end associate
   end subroutine get_power_law

   !> Gauss's rule of the integral of x^b f(x) from 0 to 1: the roots z = 2 x - 1 of Jacobi's polynomial of the weight (1 + z)^b, by
   !> Newton's method with the roots that are known divided out.
   pure subroutine get_rule(b, nodes, weights)
      !> Exponent, > -1.
      real(dp), intent(in) :: b
      !> Receive the nodes, falling, and the weights.
      real(dp), intent(out) :: nodes(:), weights(:)
      integer, parameter :: most_steps = 60
      real(dp), parameter :: highest = 0.999_dp, above = 1.0e-3_dp
      real(dp) :: known(size(nodes)), z, value, slope, change
      integer :: n, j, step

      n = size(nodes)
      z = highest
      do j = 1, n
         ! from above all roots that are sought, Newton's steps do not pass one
         do step = 1, most_steps
            call get_jacobi(b, n, z, value, slope)
            change = value/(slope - value*sum(1/(z - known(:j - 1))))
            z = z - change
            if (abs(change) <= 2*epsilon(z)) exit
         end do
         call get_jacobi(b, n, z, value, slope)
         known(j) = z
         nodes(j) = (1 + z)/2
         weights(j) = 1/((1 - z**2)*slope**2)
         z = z + above
      end do
   end subroutine get_rule

   !> Jacobi's polynomial of the weight (1 + z)^b and its derivative.
   pure subroutine get_jacobi(b, n, z, value, slope)
      !> Exponent of the weight, degree >= 1, and where.
      real(dp), intent(in) :: b
      integer, intent(in) :: n
      real(dp), intent(in) :: z
      !> Receive the polynomial and its derivative.
      real(dp), intent(out) :: value, slope
      real(dp) :: last, next
      integer :: k

      last = 1
      value = ((2 + b)*z - b)/2
      do k = 2, n
         associate (c => 2*k + b)
            next = ((c - 1)*(c*(c - 2)*z - b**2)*value - 2*(k - 1)*(k - 1 + b)*c*last)/(2*k*(k + b)*(c - 2))
         end associate
         last = value
         value = next
      end do
      associate (c => 2*n + b)
         slope = (n*(-b - c*z)*value + 2*n*(n + b)*last)/(c*(1 - z**2))
      end associate
   end subroutine get_jacobi

end module adfric_solid_power_law
