! SPDX-License-Identifier: GPL-3.0-or-later
!> The path of a column along one period of heights, with what does not depend on the state of the column.
!>
!> In contact the arms are linear in the heights, so contact is endless contact and a disturbance that decays. Endless contact, its
!> sums, and bounds over blocks of pieces are found here once for heights and velocity; they hold at every penetration, load,
!> adhesion and branch. A time stepping then visits the pieces in which something may happen, and no others.
!>
!> Time is in periods, and runs along the pieces of the heights; theta is its share in a piece. An arm is fast if it relaxes in less
!> than a piece; of the others the lengths of the dashpots are kept as what they have grown by since the period began, so that
!> slow arms lose no digits. The file is long: apart from each other, its procedures compile to other last digits.
module adfric_foundation_stepping_path
   use adfric_base_kinds, only: dp
   use adfric_numerics_exact_pairs, only: get_sum
   use adfric_numerics_libm, only: expm1
   use adfric_numerics_phi_functions, only: get_phi_functions, get_exponential_moments
   use adfric_shape_height_line, only: height_line_t
   use adfric_foundation_stepping_solid, only: solid_t
   implicit none (type, external)
   private
   public :: column_path_t, new_path, height_at, steepness_at, stretches_at, pressure_since, decay_of, expm1_of, &
      & get_double_moment, work_of_heights, n_levels, block_length, negligible_term

   !> Levels of blocks: pieces, and blocks of them.
   integer, parameter :: n_levels = 4
   !> Pieces of a block of each level, each a multiple of the one before. Endless contact is kept at the heads of the second level.
   integer, parameter :: block_length(n_levels) = [1, 8, 64, 512]
   integer, parameter :: head_distance = block_length(2)
   !> Most terms of the series of a slow arm within a piece.
   integer, parameter :: most_terms = 20
   !> Terms of series of lengths that are left out; they fall at least as z/m.
   real(dp), parameter :: negligible_term = 1.0e-19_dp

   !> Bounds over blocks of one level.
   type :: block_bounds_t
      !> Least endless pressure, least and greatest height; shape `(n_blocks)`.
      real(dp), allocatable :: pressure(:), lowest(:), highest(:)
   end type block_bounds_t

   !> A path.
   type :: column_path_t
      !> The column.
      type(solid_t), allocatable :: solid
      !> Number of pieces of a period, and the degree of their polynomials.
      integer :: n = 0, degree = 1
      !> Time that a piece takes.
      real(dp) :: step = 1
      !> Polynomials of the heights; shape `(0:degree, n)`.
      real(dp), allocatable :: coefficients(:, :)
      !> Mean height.
      real(dp) :: mean = 0
      !> Steps over the times of the arms and of the Kelvin elements; shape `(n_arms)`.
      real(dp), allocatable :: ratio(:), open_ratio(:)
      !> Is the arm slow? Shape `(n_arms)`.
      logical, allocatable :: is_slow(:)
      !> What remains of a disturbance after a block of each level, of arms and of Kelvin elements; shape `(n_arms, n_levels)`.
      real(dp), allocatable :: decay(:, :), open_decay(:, :)
      !> Lengths of dashpots where the period begins, in endless contact, and of slow arms only; shape `(n_arms)`.
      real(dp), allocatable :: first_length(:)
      !> Endless contact at the heads of blocks of the second level: stretches of fast arms, growths of slow ones; shape `(n_arms, n_blocks)`.
      real(dp), allocatable :: head(:, :)
      !> What a slow dashpot grows by in a piece, over what it lacks of the height at the beginning; 0 of fast arms; shape `(n_arms)`.
      real(dp), allocatable :: gain(:)
      !> Weights of the coefficients in a step of an arm; shape `(n_arms, degree)`.
      real(dp), allocatable :: forcing(:, :)
      !> m times the moments m - 1 of the decay in a piece, times stiffness; shape `(n_arms, degree)`.
      real(dp), allocatable :: moments(:, :)
      !> The same for what goes into `work`: of slow arms, minus the integral of what the dashpot grows by; shape `(n_arms,
      !> degree)`.
      real(dp), allocatable :: work_moments(:, :)
      !> Integrals of the endless pressure over time up to each position, with what their rounding left: contact of a few pieces is
      !> a small difference of large sums. Shape `(0:n)`.
      real(dp), allocatable :: pressure_sum(:), pressure_rest(:)
      !> Integrals over the heights of each piece, of what fast arms push and of minus what the growths of slow ones do. The
      !> rest is a function of the heights alone, see `work_of_heights`. Shape `(n)`.
      real(dp), allocatable :: work(:)
      !> Bounds over blocks of each level; shape `(n_levels)`.
      type(block_bounds_t), allocatable :: bounds(:)
      !> Stiffness of the springs that heights alone stretch, those of slow arms and the relaxed one, and what the lengths of slow
      !> dashpots take from their stress where the period begins.
      real(dp) :: elastic_stiffness = 1, elastic_offset = 0
   end type column_path_t

contains

   !> Prepare the path of a column.
   pure subroutine new_path(self, line, solid)
      type(column_path_t), intent(out) :: self
      !> Heights along the period, the highest at or near the beginning.
      type(height_line_t), intent(in) :: line
      type(solid_t), intent(in) :: solid
      integer :: m

      allocate (self%solid, source=solid)
      allocate (self%bounds(n_levels))
      self%degree = line%degree
      self%n = size(line%coefficients, 2)
      self%step = 1/real(self%n, dp)
      allocate (self%coefficients(0:self%degree, self%n), source=line%coefficients)
      do m = 0, self%degree
         self%mean = self%mean + sum(self%coefficients(m, :))/((m + 1)*real(self%n, dp))
      end do
      call set_rates(self)
      call bound_heights(self)
      call find_endless_contact(self)
      call bound_blocks(self)
   end subroutine new_path

   !> Ratios of times, and what remains of disturbances.
   pure subroutine set_rates(self)
      !> The path, whose column and number of pieces are known.
      type(column_path_t), intent(inout) :: self
      real(dp) :: phi(self%degree + 1), factorial
      integer :: i, k, m

      associate (s => self%solid)
         allocate (self%ratio(s%n), self%open_ratio(s%n), self%is_slow(s%n), self%gain(s%n), &
            & self%forcing(s%n, self%degree))
         allocate (self%decay(s%n, n_levels), self%open_decay(s%n, n_levels))
         self%ratio = self%step/s%time
         self%open_ratio = self%step/s%retardation
         self%is_slow = self%ratio < 1
         do k = 1, n_levels
            self%decay(:, k) = decay_of(block_length(k)*self%ratio)
            self%open_decay(:, k) = decay_of(block_length(k)*self%open_ratio)
         end do
         do i = 1, s%n
            call get_phi_functions(self%ratio(i), phi)
            self%gain(i) = merge(self%ratio(i)*phi(1), 0.0_dp, self%is_slow(i))
            factorial = 1
            do m = 1, self%degree
               factorial = factorial*m
               self%forcing(i, m) = factorial*merge(self%ratio(i)*phi(m + 1), phi(m), self%is_slow(i))
            end do
         end do
      end associate
   end subroutine set_rates

   !> What remains after a time; 0 where it would be no normal number.
   elemental real(dp) function decay_of(x)
      !> The time over that of relaxation, >= 0.
      real(dp), intent(in) :: x
      real(dp), parameter :: longest = 700

      decay_of = 0
      if (x < longest) decay_of = exp(-x)
   end function decay_of

   !> Bounds of the heights of each piece, by the coefficients of its Bernstein form.
   pure subroutine bound_heights(self)
      !> The path, whose polynomials are known.
      type(column_path_t), intent(inout) :: self
      real(dp) :: bernstein(0:self%degree)
      integer :: j

      allocate (self%bounds(1)%lowest(self%n), self%bounds(1)%highest(self%n))
      do j = 1, self%n
         bernstein = to_bernstein(self%coefficients(:, j))
         self%bounds(1)%lowest(j) = minval(bernstein)
         self%bounds(1)%highest(j) = maxval(bernstein)
      end do
   end subroutine bound_heights

   !> Coefficients of the Bernstein form on 0 .. 1: a polynomial lies within them.
   pure function to_bernstein(c) result(b)
      !> Coefficients of the powers; shape `(0:degree)`.
      real(dp), intent(in) :: c(0:)
      real(dp) :: b(0:ubound(c, 1))
      integer :: i, m, n

      ! b_i = sum over m <= i of binomial(i, m)/binomial(n, m) c_m, by differences
      n = ubound(c, 1)
      b = c
      do m = 1, n
         b(m) = c(m)
         do i = 1, m
            b(m) = b(m)*i/real(n - m + i, dp)
         end do
      end do
      do m = n, 1, -1
         do i = m, n
            b(i) = b(i) + b(i - 1)
         end do
      end do
   end function to_bernstein

   !> Find endless contact: the periodic state, its sums, and bounds of its pressure in each piece.
   pure subroutine find_endless_contact(self)
      !> The path; receives heads, sums and bounds.
      type(column_path_t), intent(inout) :: self
      real(dp) :: state(self%solid%n), first(self%solid%n), total(self%degree), work(self%degree, self%degree)
      real(dp) :: mean_of(self%solid%n), weights(self%solid%n, self%degree)
      integer :: j

      allocate (self%head(self%solid%n, (self%n + head_distance - 1)/head_distance))
      allocate (self%pressure_sum(0:self%n), self%pressure_rest(0:self%n), self%work(self%n), self%bounds(1)%pressure(self%n))
      allocate (self%first_length(self%solid%n), source=0.0_dp)
      allocate (self%moments(self%solid%n, self%degree), self%work_moments(self%solid%n, self%degree))
      call set_weights(self, total, work, weights, mean_of)
      self%moments = weights
      ! once from nothing, which tells the periodic state
      state = 0
      do j = 1, self%n
         call step_arms(self, j, state)
      end do
      first = 0
      where (self%is_slow)
         self%first_length = -state/expm1_of(-1/self%solid%time)
      elsewhere
         first = -state/expm1_of(-1/self%solid%time)
      end where
      self%elastic_stiffness = 1 + sum(self%solid%stiffness, self%is_slow)
      self%elastic_offset = sum(self%solid%stiffness*self%first_length)
      state = first
      self%pressure_sum(0) = 0
      self%pressure_rest(0) = 0
      do j = 1, self%n
         if (mod(j - 1, head_distance) == 0) self%head(:, (j - 1)/head_distance + 1) = state
         call add_piece(self, j, state, total, work, mean_of)
         call step_arms(self, j, state)
      end do
   end subroutine find_endless_contact

   !> exp(x) - 1 for x <= 0, to full relative precision.
   elemental real(dp) function expm1_of(x)
      !> Exponent, <= 0.
      real(dp), intent(in) :: x

      expm1_of = -1
      if (x > -40) expm1_of = expm1(x)
   end function expm1_of

   !> One piece of endless contact: stretches of fast arms, growths of slow ones.
   pure subroutine step_arms(self, j, state)
      type(column_path_t), intent(in) :: self
      integer, intent(in) :: j
      !> In: the arms where the piece begins. Out: where it ends; shape `(n_arms)`.
      real(dp), intent(inout), contiguous :: state(:)
      integer :: m

      state = self%decay(:, 1)*state + self%gain*(self%coefficients(0, j) - self%first_length)
      do m = 1, self%degree
         state = state + self%forcing(:, m)*self%coefficients(m, j)
      end do
   end subroutine step_arms

   !> Weights of the integrals over a piece.
   pure subroutine set_weights(self, total, work, moments, mean_of)
      !> The path; receives the weights of stretches in the work.
      type(column_path_t), intent(inout) :: self
      !> Integral over theta of all forced stretches times stiffness, by coefficient; shape `(degree)`.
      real(dp), intent(out) :: total(:)
      !> Integral over heights of forced stretches of fast arms, less that of forced growths of slow ones, by two coefficients; shape
      !> `(degree, degree)`.
      real(dp), intent(out) :: work(:, :)
      !> m times the moments m - 1 of the decay, times stiffness; shape `(n_arms, degree)`.
      real(dp), intent(out) :: moments(:, :)
      !> Mean of the decay over a piece, times stiffness; shape `(n_arms)`.
      real(dp), intent(out) :: mean_of(:)
      real(dp) :: phi(2*self%degree + 1), chi(0:self%degree), factorial
      integer :: i, l, m

      ! where a stretch decays a length grows: 1 - exp(-z t) is z times the integral of the decay, and by parts the power rises by 1
      total = 0
      work = 0
      do i = 1, self%solid%n
         associate (k => self%solid%stiffness(i), z => self%ratio(i))
            call get_phi_functions(z, phi)
            call get_exponential_moments(z, chi)
            mean_of(i) = k*phi(1)
            factorial = 1
            do m = 1, self%degree
               factorial = factorial*m
               total(m) = total(m) + k*factorial*phi(m + 1)
               moments(i, m) = k*m*chi(m - 1)
               do l = 1, self%degree
                  if (self%is_slow(i)) then
                     work(m, l) = work(m, l) - k*z/(l + 1)*get_double_moment(z, l + 1, m)
                  else
                     work(m, l) = work(m, l) + k*get_double_moment(z, l, m)
                  end if
               end do
            end do
            self%work_moments(i, :) = moments(i, :)
            if (self%is_slow(i)) self%work_moments(i, :) = -k*z*(chi(0) - chi(1:))
         end associate
      end do
   end subroutine set_weights

   !> The integral of l s^(l-1) m t^(m-1) exp(-z (t - s)) over 0 <= s <= t <= 1.
   pure real(dp) function get_double_moment(z, l, m) result(integral)
      !> Step over relaxation time, >= 0.
      real(dp), intent(in) :: z
      !> The powers, >= 1.
      integer, intent(in) :: l, m
      integer, parameter :: n_terms = 60
      real(dp), parameter :: small_term = 1.0e-18_dp
      real(dp) :: inner, term
      integer :: k

      if (z <= 2) then
         ! the inner integral is l! t^l sum over k of (-z t)^k/(l + k)!
         term = 1
         integral = 0
         do k = 0, n_terms
            integral = integral + term*m/real(m + l + k, dp)
            if (abs(term) < small_term) exit
            term = -term*z/(l + k + 1)
         end do
         return
      end if
      ! the inner integral I_l(t) obeys I_l = (l t^(l-1) - l I_(l-1))/z for l > 1, I_1 = (1 - exp(-z t))/z
      integral = (1 - m*first_moment(z, m - 1))/z
      do k = 2, l
         inner = k*m/real(m + k - 1, dp)
         integral = (inner - k*integral)/z
      end do
   end function get_double_moment

   !> The integral of s^j exp(-z s) over 0 .. 1.
   pure real(dp) function first_moment(z, j)
      !> Exponent, >= 0.
      real(dp), intent(in) :: z
      !> Power, >= 0.
      integer, intent(in) :: j
      real(dp) :: chi(0:j)

      call get_exponential_moments(z, chi)
      first_moment = chi(j)
   end function first_moment

   !> Add a piece of endless contact to the sums, and bound its pressure.
   pure subroutine add_piece(self, j, state, total, work, mean_of)
      !> The path; receives sums and bound of the piece.
      type(column_path_t), intent(inout) :: self
      integer, intent(in) :: j
      !> The arms where the piece begins, as `step_arms` has them; shape `(n_arms)`.
      real(dp), intent(in), contiguous :: state(:)
      !> Weights, see `set_weights`.
      real(dp), intent(in), contiguous :: total(:), work(:, :), mean_of(:)
      real(dp) :: stretch(self%solid%n), pressure, energy, rest, slopes(0:self%degree - 1), least_slope, above, below
      integer :: m

      associate (c => self%coefficients(:, j), low => self%bounds(1)%lowest(j), &
            & high => self%bounds(1)%highest(j))
         stretch = state
         where (self%is_slow) stretch = self%coefficients(0, j) - self%first_length - state
         pressure = sum(mean_of*stretch)
         energy = -sum(self%solid%stiffness*state, self%is_slow)*sum(c(2:))
         do m = 1, self%degree
            ! c starts at 1 here
            energy = energy + c(m + 1)*(sum(self%work_moments(:, m)*stretch) + sum(work(m, :)*c(2:)))
            pressure = pressure + total(m)*c(m + 1)
            slopes(m - 1) = m*c(m + 1)
         end do
         do m = 0, self%degree
            pressure = pressure + c(m + 1)/(m + 1)
         end do
         call get_sum(self%pressure_sum(j - 1), pressure*self%step, self%pressure_sum(j), rest)
         self%pressure_rest(j) = self%pressure_rest(j - 1) + rest
         self%work(j) = energy
         least_slope = minval(to_bernstein(slopes))
         above = high - self%coefficients(0, j)
         below = low - self%coefficients(0, j)
         ! a slow dashpot follows the heights, of which the highest draws it fastest; a fast arm is stretched by slopes
         self%bounds(1)%pressure(j) = low + sum(self%solid%stiffness*merge(below + stretch &
            & - max(0.0_dp, self%ratio*(above + stretch)), min(stretch, least_slope*self%solid%time/self%step), self%is_slow))
      end associate
   end subroutine add_piece

   !> Bounds over blocks of pieces.
   pure subroutine bound_blocks(self)
      !> The path, whose bounds over pieces are known.
      type(column_path_t), intent(inout) :: self

      integer :: k

      do k = 2, n_levels
         associate (length => block_length(k)/block_length(k - 1), fine => self%bounds(k - 1), coarse => self%bounds(k))
            call gather(fine%pressure, length, .true., coarse%pressure)
            call gather(fine%lowest, length, .true., coarse%lowest)
            call gather(fine%highest, length, .false., coarse%highest)
         end associate
      end do
   end subroutine bound_blocks

   !> Least or greatest values of groups.
   pure subroutine gather(values, length, is_least, groups)
      !> Values in their order.
      real(dp), intent(in) :: values(:)
      !> Values of a group.
      integer, intent(in) :: length
      !> The least? Else the greatest.
      logical, intent(in) :: is_least
      !> Receives one value of each group; the last group may have fewer.
      real(dp), allocatable, intent(out) :: groups(:)
      integer :: k, last

      allocate (groups((size(values) + length - 1)/length))
      do k = 1, size(groups)
         last = min(size(values), k*length)
         if (is_least) then
            groups(k) = minval(values((k - 1)*length + 1:last))
         else
            groups(k) = maxval(values((k - 1)*length + 1:last))
         end if
      end do
   end subroutine gather

   !> Height at a position.
   pure real(dp) function height_at(self, j, theta) result(height)
      type(column_path_t), intent(in) :: self
      !> The piece.
      integer, intent(in) :: j
      !> Share of it that is passed, 0 to 1.
      real(dp), intent(in) :: theta
      integer :: m

      height = 0
      do m = self%degree, 0, -1
         height = height*theta + self%coefficients(m, j)
      end do
   end function height_at

   !> Integral over heights of the pressure that follows from the heights alone, without the penetration: of the relaxed spring, and
   !> of slow arms whose dashpots stay as they are where the period begins.
   pure real(dp) function work_of_heights(self, first, last, stress) result(work)
      type(column_path_t), intent(in) :: self
      !> Heights where the integral begins and ends.
      real(dp), intent(in) :: first, last
      !> A stress that stays and adds to the pressure.
      real(dp), intent(in) :: stress

      work = (last - first)*(self%elastic_stiffness*(last + first)/2 - (self%elastic_offset - stress))
   end function work_of_heights

   !> Derivative of the height with respect to theta.
   pure real(dp) function steepness_at(self, j, theta) result(slope)
      type(column_path_t), intent(in) :: self
      integer, intent(in) :: j
      real(dp), intent(in) :: theta
      integer :: m

      slope = 0
      do m = self%degree, 1, -1
         slope = slope*theta + m*self%coefficients(m, j)
      end do
   end function steepness_at

   !> Endless contact at a position: the stretches of all arms, the growths of slow ones, and the integral of the pressure over time
   !> since the piece began.
   pure subroutine stretches_at(self, j, theta, stretch, growth)
      type(column_path_t), intent(in) :: self
      integer, intent(in) :: j
      real(dp), intent(in) :: theta
      !> Receives r_i; shape `(n_arms)`.
      real(dp), intent(out) :: stretch(:)
      !> Receives what the dashpots have grown by since the period began, of slow arms, 0 of others; shape `(n_arms)`.
      real(dp), intent(out) :: growth(:)
      real(dp) :: state(self%solid%n), height
      integer :: i, block

      block = (j - 1)/head_distance
      state = self%head(:, block + 1)
      do i = block*head_distance + 1, j - 1
         call step_arms(self, i, state)
      end do
      if (theta > 0) then
         do i = 1, self%solid%n
            if (self%is_slow(i)) then
               state(i) = state(i) + grown_length(self%coefficients(:, j), self%ratio(i), self%first_length(i) + state(i), theta)
            else
               state(i) = relaxed_stretch(self%coefficients(:, j), self%ratio(i), state(i), theta)
            end if
         end do
      end if
      height = height_at(self, j, theta)
      stretch = state
      growth = 0
      where (self%is_slow)
         stretch = height - self%first_length - state
         growth = state
      end where
   end subroutine stretches_at

   !> What a slow dashpot grows by within a piece, by its power series.
   pure real(dp) function grown_length(c, z, start, theta) result(growth)
      !> Coefficients of the heights; shape `(0:degree)`.
      real(dp), intent(in) :: c(0:)
      !> Step over relaxation time, < 1.
      real(dp), intent(in) :: z
      !> Length where the piece begins.
      real(dp), intent(in) :: start
      !> Share of the piece that is passed.
      real(dp), intent(in) :: theta
      real(dp) :: term, power
      integer :: m

      ! e = sum of e_m theta^m, e_(m+1) = z (c_m - e_m)/(m + 1)
      term = z*(c(0) - start)
      power = theta
      growth = term*power
      do m = 1, most_terms
         if (m <= ubound(c, 1)) then
            term = z*(c(m) - term)/(m + 1)
         else
            term = -z*term/(m + 1)
         end if
         power = power*theta
         growth = growth + term*power
         if (m > ubound(c, 1) .and. abs(term) < negligible_term) exit
      end do
   end function grown_length

   !> The stretch of a fast arm within a piece: a polynomial, and what decays.
   pure real(dp) function relaxed_stretch(c, z, start, theta) result(stretch)
      real(dp), intent(in) :: c(0:)
      !> Step over relaxation time, >= 1.
      real(dp), intent(in) :: z
      !> Stretch where the piece begins.
      real(dp), intent(in) :: start
      real(dp), intent(in) :: theta
      real(dp) :: b
      integer :: m

      ! z b_m = (m + 1) (c_(m+1) - b_(m+1))
      b = 0
      stretch = 0
      do m = ubound(c, 1) - 1, 0, -1
         b = (m + 1)*(c(m + 1) - b)/z
         stretch = stretch*theta + b
      end do
      stretch = stretch + (start - b)*decay_of(z*theta)
   end function relaxed_stretch

   !> Integral of the pressure of endless contact at no penetration over time, from the end of one piece to a position in another
   !> one.
   pure real(dp) function pressure_since(self, first, j, theta, stretch, growth) result(total)
      type(column_path_t), intent(in) :: self
      !> Number of the piece whose end the integral begins at; 0 for the beginning of the period.
      integer, intent(in) :: first
      integer, intent(in) :: j
      real(dp), intent(in) :: theta
      !> Stretches and growths there, see `stretches_at`; shape `(n_arms)`.
      real(dp), intent(in) :: stretch(:), growth(:)
      real(dp) :: at_head(self%solid%n), grown(self%solid%n), lengths(self%solid%n), height
      integer :: m

      total = (self%pressure_sum(j - 1) - self%pressure_sum(first)) + (self%pressure_rest(j - 1) - self%pressure_rest(first))
      if (.not. theta > 0) return
      call stretches_at(self, j, 0.0_dp, at_head, grown)
      height = 0
      do m = self%degree, 0, -1
         height = height*theta + self%coefficients(m, j)/(m + 1)
      end do
      ! the integral of r_i is tau_i times the growth of e_i
      lengths = (height_at(self, j, theta) - self%coefficients(0, j)) - (stretch - at_head)
      where (self%is_slow) lengths = growth - grown
      total = total + height*theta*self%step + sum(self%solid%stiffness*self%solid%time*lengths)
   end function pressure_since

end module adfric_foundation_stepping_path
