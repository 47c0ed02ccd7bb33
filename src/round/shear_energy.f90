! SPDX-License-Identifier: GPL-3.0-or-later
!> What a cycle of shear takes from a contact that resists by tau0 + alpha p, reduced:
!>
!>     W = 8 m int v(s) [v(e) - v(s)] ds,  e < s < b
module adfric_round_shear_energy
   use adfric_base_kinds, only: dp
   use adfric_round_sheared_contact, only: get_position, sheared_position_t, range_length, sheared_t
   use adfric_numerics_gauss, only: gauss_nodes, gauss_weights
   implicit none (type, external)
   private
   public :: energy_of

   !> Where a decaying exponential is round-off, and the longest panel of a logarithm.
   real(dp), parameter :: decayed = 40.0_dp, longest = 2.0_dp
   !> Where t^2 changes by less than its part along a stretch, v is as good as straight.
   real(dp), parameter :: straight = 1.0e2_dp

contains

   !> W/m, from the ranges that slip.
   pure real(dp) function energy_of(self, number, x, stick) result(energy)
      type(sheared_t), intent(in) :: self
      !> Number of the range where the stick zone ends, and the path in it.
      integer, intent(in) :: number
      real(dp), intent(in) :: x
      type(sheared_position_t), intent(in) :: stick
      integer :: k

      energy = 0
      do k = 1, number
         energy = energy + range_energy(self, k, merge(x, range_length(self, k), k == number), stick%displacement)
      end do
      energy = 8*energy
   end function energy_of

   !> int v(s) [v(e) - v(s)] ds along a range: its outer half of u, and what remains of u.
   pure real(dp) function range_energy(self, number, length, total) result(energy)
      type(sheared_t), intent(in) :: self
      integer, intent(in) :: number
      !> How much of the range slips.
      real(dp), intent(in) :: length
      !> v(e).
      real(dp), intent(in) :: total
      real(dp) :: change

      energy = 0
      if (.not. length > 0) return
      if (self%ranges(number)%is_beside) then
         energy = smooth_energy(self, number, 0.0_dp, length, total)
         return
      end if
      change = min(length, self%ranges(number)%high/2)
      energy = outer_energy(self, number, change, total)
      if (length > change) energy = energy + inner_energy(self, number, length, total)
   end function range_energy

   !> The integral along a stretch where v is smooth.
   pure real(dp) function smooth_energy(self, number, first, last, total) result(energy)
      type(sheared_t), intent(in) :: self
      integer, intent(in) :: number
      !> Ways to the ends of the stretch.
      real(dp), intent(in) :: first, last
      real(dp), intent(in) :: total
      integer :: node

      energy = 0
      do node = 1, size(gauss_nodes)
         energy = energy + gauss_weights(node)*(last - first)/2 &
            & *loss_at(self, number, first + (last - first)*(1 + gauss_nodes(node))/2, total)
      end do
   end function smooth_energy

   !> The integral along the beginning of a range. Near the edge of friction and of adhesion v goes by the root of the path:
   !> x = x0 sinh(w)^2 takes that.
   pure real(dp) function outer_energy(self, number, change, total) result(energy)
      type(sheared_t), intent(in) :: self
      integer, intent(in) :: number
      !> The way to the end of the stretch.
      real(dp), intent(in) :: change
      real(dp), intent(in) :: total
      real(dp) :: start, rate, last, w
      integer :: panel, n_panels, node

      ! t^2 = t0^2 (1 + x/start)
      start = self%zone + self%ranges(number)%square_before
      associate (high => self%ranges(number)%high)
         rate = 2*high
         if (self%shape%edge < huge(start)) rate = 8*self%a*exp(-2*high)/(1 + exp(-2*high))**2
      end associate
      energy = 0
      if (start > straight*rate*change) then
         energy = smooth_energy(self, number, 0.0_dp, change, total)
      else if (start > 0) then
         start = start/rate
         last = asinh(sqrt(change/start))
         n_panels = max(1, ceiling(last/longest))
         do panel = 1, n_panels
            do node = 1, size(gauss_nodes)
               w = last*(2*panel - 1 + gauss_nodes(node))/(2*n_panels)
               energy = energy + gauss_weights(node)*last/n_panels*start*sinh(w)*cosh(w) &
                  & *loss_at(self, number, start*sinh(w)**2, total)
            end do
         end do
      else
         do node = 1, size(gauss_nodes)
            w = (1 + gauss_nodes(node))/2
            energy = energy + gauss_weights(node)*change*w*loss_at(self, number, change*w**2, total)
         end do
      end if
   end function outer_energy

   !> The integral along the inner half of u. Where u is small its logarithm is the variable, for g may be a power of it; where g is analytic
   !> one panel does.
   pure real(dp) function inner_energy(self, number, length, total) result(energy)
      type(sheared_t), intent(in) :: self
      integer, intent(in) :: number
      real(dp), intent(in) :: length, total
      real(dp) :: low, reach, decades, u
      integer :: panel, n_panels, node

      energy = 0
      associate (range => self%ranges(number), half => self%ranges(number)%high/2)
         low = range%high - length
         reach = half
         if (range%is_beyond) reach = min(self%shape%reach, half)
         reach = max(reach, low)
         if (half > reach) then
            decades = decayed
            if (reach > 0) decades = min(log(half/reach), decayed)
            n_panels = max(1, ceiling(decades/longest))
            do panel = 1, n_panels
               do node = 1, size(gauss_nodes)
                  u = half*exp(-decades*(2*panel - 1 + gauss_nodes(node))/(2*n_panels))
                  energy = energy + gauss_weights(node)*decades/(2*n_panels)*u*loss_at(self, number, range%high - u, total)
               end do
            end do
         end if
         if (reach > low) energy = energy + smooth_energy(self, number, range%high - reach, range%high - low, total)
      end associate
   end function inner_energy

   !> v(s) [v(e) - v(s)] ds/dx at a position of a range.
   pure real(dp) function loss_at(self, number, x, total) result(loss)
      type(sheared_t), intent(in) :: self
      integer, intent(in) :: number
      !> The path to the position.
      real(dp), intent(in) :: x
      real(dp), intent(in) :: total
      type(sheared_position_t) :: position

      call get_position(self, number, x, position)
      loss = position%e_slope*position%displacement*(total - position%displacement)
   end function loss_at

end module adfric_round_shear_energy
