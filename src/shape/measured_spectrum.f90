! SPDX-License-Identifier: GPL-3.0-or-later
!> The power spectral density of a map of heights that fills a period: its waves, gathered in rings of wave numbers.
!>
!>     z = sum of z_m exp(i q_m r),   q_m = 2 pi (m_x/l_x, m_y/l_y),   <z^2> = sum of |z_m|^2 without the mean
!>
!> A ring is a piece C_i (q/q_i)^s_i of the spectrum (`adfric_shape_height_spectrum`). Its two numbers are those with which it has
!> the mean square height and the mean square slope of its waves, so both are those of the map. The power s_i is the one root of a
!> rising function: with x = ln(q/q_i) the ring weighs q^2 by exp((2 + s) x), and more of it lies at its outer end as s grows. Where
!> all waves of a ring lie at one of its ends, the next ring is one with it.
!>
!> Rings are as wide as the wave number of the longest period, which is in the middle of the first one, and where there are many
!> waves 3 %.
module adfric_shape_measured_spectrum
   use adfric_base_constants, only: two_pi
   use adfric_base_error, only: error_t, file_failure, set_error
   use adfric_base_kinds, only: dp
   use adfric_numerics_wave_sum, only: find_waves
   use adfric_shape_height_spectrum, only: exponential_ratio, height_spectrum_t, new_pieces
   implicit none (type, external)
   private
   public :: map_waves_t, new_map_waves, new_measured, slope_ratio

   !> Width of a ring in ln q where there are many waves.
   real(dp), parameter :: width = 0.03_dp
   !> Largest power of a ring times its width in ln q, and halvings of the interval to it.
   real(dp), parameter :: steepest = 300
   integer, parameter :: n_halvings = 60
   !> Round-off of a wave number at the end of a ring.
   real(dp), parameter :: round_off = 1.0e-9_dp
   !> Part of the fourth moment that is round-off of waves which the map does not have.
   real(dp), parameter :: no_part = 1.0e-12_dp

   !> Waves of a map.
   type :: map_waves_t
      !> Sum of the squares of the four or fewer waves (+-mx, +-my) over `scale`^2, without the mean; shape `(0:nx/2, 0:ny/2)`.
      real(dp), allocatable :: squares(:, :)
      !> Largest height above or below the mean, in the unit of the heights; 0 if they are all the same.
      real(dp) :: scale = 0
   end type map_waves_t

contains

   !> Find the waves of a map.
   subroutine new_map_waves(self, heights, error)
      type(map_waves_t), intent(out) :: self
      !> Heights in any unit; shape `(nx, ny)`.
      real(dp), intent(in) :: heights(:, :)
      !> Allocated if there is no memory.
      type(error_t), allocatable, intent(out) :: error
      complex(dp), allocatable :: waves(:, :)
      real(dp), allocatable :: field(:, :)
      integer :: n(2), mx, my, failure

      n = shape(heights)
      allocate (field(n(1), n(2)), waves(0:n(1)/2, 0:n(2) - 1), stat=failure)
      if (failure /= 0) then
         call set_error(error, file_failure, 'there is no memory for the waves of a map')
         return
      end if
      if (.not. maxval(heights) > minval(heights)) return
      field(:, :) = heights
      field(:, :) = field - sum(field)/size(field)
      self%scale = maxval(abs(field))
      field(:, :) = field/self%scale
      call find_waves(field, waves, error)
      if (allocated(error)) return
      allocate (self%squares(0:n(1)/2, 0:n(2)/2), source=0.0_dp)
      do my = 0, n(2) - 1
         do mx = 0, n(1)/2
            associate (square => self%squares(mx, min(my, n(2) - my)))
               ! waves of mx < 0 are not in the list, and those of half of an even number of values are their own conjugates
               square = square + abs(waves(mx, my))**2*merge(1, 2, mx == 0 .or. 2*mx == n(1))
            end associate
         end do
      end do
      self%squares(0, 0) = 0
   end subroutine new_map_waves

   !> The spectrum of a map. There is none where no wave is left.
   pure subroutine new_measured(self, waves, period)
      !> Receives the spectrum; without pieces if there is none.
      type(height_spectrum_t), intent(out) :: self
      type(map_waves_t), intent(in) :: waves
      !> Periods along x and y [m].
      real(dp), intent(in) :: period(2)
      real(dp), allocatable :: ends(:), sums(:, :), q(:), density(:), power(:)
      real(dp) :: longest, total, x, of_ring(2)
      integer :: n, i, last

      longest = two_pi/maxval(period)
      call set_rings(longest, hypot(two_pi*ubound(waves%squares, 1)/period(1), two_pi*ubound(waves%squares, 2)/period(2)), ends)
      call gather(waves, period, ends, sums)
      ! rings of round-off at the outer end; and rings without waves, or with all of them at one end, which take the next one along
      total = sum(sums(3, :))
      last = size(sums, 2)
      do while (last > 1)
         if (sum(sums(3, last:)) > no_part*total) exit
         last = last - 1
      end do
      allocate (q(last + 1), density(last), power(last))
      n = 0
      of_ring = 0
      q(1) = ends(1)
      do i = 1, last
         of_ring = of_ring + sums(:2, i)
         if (i < last .and. .not. of_ring(2) > 0) cycle
         q(n + 2) = ends(i + 1)
         x = log(q(n + 2)/q(n + 1))
         power(n + 1) = power_of_ring(x, of_ring(2)/of_ring(1)*(longest/q(n + 1))**2)
         if (i < last .and. abs(power(n + 1))*x > 0.99_dp*steepest) cycle
         n = n + 1
         density(n) = waves%scale**2*of_ring(1)/(two_pi*q(n)**2*x*exponential_ratio((2 + power(n))*x))
         of_ring = 0
      end do
      call new_pieces(self, q(:n + 1), density(:n), power(:n))
      self%longest = longest
   end subroutine new_measured

   !> Ends of the rings, from the longest wave to beyond the shortest one.
   pure subroutine set_rings(longest, shortest, ends)
      !> Wave numbers of the longest wave and of the shortest one, in any unit.
      real(dp), intent(in) :: longest, shortest
      real(dp), allocatable, intent(out) :: ends(:)
      real(dp), allocatable :: longer(:)
      integer :: n

      allocate (ends(64))
      ends(1) = longest/2
      n = 1
      do while (.not. ends(n) > shortest)
         if (n == size(ends)) then
            allocate (longer(2*n))
            longer(:n) = ends
            call move_alloc(longer, ends)
         end if
         ends(n + 1) = max(ends(n) + longest, ends(n)*(1 + width))
         n = n + 1
      end do
      ends = ends(:n)
   end subroutine set_rings

   !> Sums over the waves of each ring: of their squares, and of those times q^2 and q^4, q in units of the longest wave's.
   pure subroutine gather(waves, period, ends, sums)
      type(map_waves_t), intent(in) :: waves
      real(dp), intent(in) :: period(2)
      !> Ends of the rings [rad/m].
      real(dp), intent(in) :: ends(:)
      !> Receives the sums; shape `(3, n)`.
      real(dp), allocatable, intent(out) :: sums(:, :)
      real(dp) :: longest, q, q_x, q_y
      integer :: mx, my, i

      longest = two_pi/maxval(period)
      allocate (sums(3, size(ends) - 1), source=0.0_dp)
      do my = 0, ubound(waves%squares, 2)
         q_y = two_pi*my/period(2)
         i = 1
         do mx = 0, ubound(waves%squares, 1)
            q_x = two_pi*mx/period(1)
            q = hypot(q_x, q_y)
            do while (i < size(sums, 2))
               ! a wave at an end is inside, whatever the unit of length
               if (q <= ends(i + 1)*(1 + round_off)) exit
               i = i + 1
            end do
            sums(:, i) = sums(:, i) + waves%squares(mx, my)*[1.0_dp, (q/longest)**2, (q/longest)**4]
         end do
      end do
   end subroutine gather

   !> Power of a ring whose waves have a mean of (q/q_i)^2.
   pure real(dp) function power_of_ring(x, mean) result(power)
      !> ln of its ends, outer over inner; the mean, from 1 to exp(2 x).
      real(dp), intent(in) :: x, mean
      real(dp) :: low, high
      integer :: k

      low = -steepest/x
      high = steepest/x
      do k = 1, n_halvings
         power = (low + high)/2
         if (mean_of(power) > mean) then
            high = power
         else
            low = power
         end if
      end do

   contains

      !> The mean that a power has.
      pure real(dp) function mean_of(of_power)
         real(dp), intent(in) :: of_power

         mean_of = exponential_ratio((4 + of_power)*x)/exponential_ratio((2 + of_power)*x)
      end function mean_of

   end function power_of_ring

   !> Mean square slope along x over that along y: 1 for a map whose directions are alike, and 1e30 or 1e-30 where there is but one.
   pure real(dp) function slope_ratio(waves, period)
      type(map_waves_t), intent(in) :: waves
      !> Periods along x and y [m].
      real(dp), intent(in) :: period(2)
      real(dp), parameter :: most = 1.0e30_dp
      real(dp) :: along(2)
      integer :: mx, my

      along = 0
      do my = 0, ubound(waves%squares, 2)
         do mx = 0, ubound(waves%squares, 1)
            along = along + waves%squares(mx, my)*([mx, my]*(minval(period)/period))**2
         end do
      end do
      slope_ratio = min(most, max(1/most, along(1)/max(along(2), along(1)/most)))
   end function slope_ratio

end module adfric_shape_measured_spectrum
