! SPDX-License-Identifier: GPL-3.0-or-later
!> A contact that resists shear by tau0 + alpha p as the radii e that may stick, in ranges along which the profile is smooth, reduced: T and
!> v = u/m of each e (`adfric_round_shear_sums`).
module adfric_round_sheared_contact
   use adfric_base_kinds, only: dp
   use adfric_round_contact_state, only: contact_t
   use adfric_round_shape, only: shape_t, spot_t
   use adfric_round_shear_sums, only: set_shear_radii, shear_sums_t, sum_displacement, sum_force, sum_rest
   use adfric_numerics_gauss, only: gauss_nodes, gauss_weights
   use adfric_numerics_libm, only: expm1
   implicit none (type, external)
   private
   public :: resistance_t, sheared_t, sheared_position_t, set_resistance, new_sheared, get_position, displacement_rest, range_length

   !> Below this share of u a path along the profile is an integral, not a difference.
   real(dp), parameter, public :: short = 0.1_dp
   !> Most ranges of radii: beside the contact, beyond the corner, within it.
   integer, parameter :: most_ranges = 3

   !> How a contact resists shear.
   type :: resistance_t
      !> tau0, reduced.
      real(dp) :: strength = 0
      !> alpha.
      real(dp) :: factor = 0
      !> x of the radius b = a + x (c - a) up to which friction acts.
      real(dp) :: edge_fraction = 0
   end type resistance_t

   !> A range of radii of the stick zone, from the largest to the smallest.
   type :: sheared_range_t
      !> Does it lie beside the contact, a < e < b?
      logical :: is_beside = .false.
      !> Does it lie beyond the corner of the profile?
      logical :: is_beyond = .true.
      !> Is the profile flat there, so that the unknown is e itself?
      logical :: is_flat = .false.
      !> The largest and the smallest unknown; the largest and the smallest e.
      real(dp) :: high = 0, low = 0, outer = 0, inner = 0
      !> What g and P1 have fallen before it.
      real(dp) :: depth_before = 0, load_before = 0
      !> a^2 - e^2 at its beginning.
      real(dp) :: square_before = 0
   end type sheared_range_t

   !> A contact that resists shear.
   type, extends(shear_sums_t) :: sheared_t
      !> The shape of the indenter.
      class(shape_t), allocatable :: shape
      !> Its contact.
      type(contact_t) :: contact
      !> What alpha p of a flat face holds as a whole.
      real(dp) :: face = 0
      !> Number of the ranges.
      integer :: n = 0
      !> The ranges, from b down to 0.
      type(sheared_range_t) :: ranges(most_ranges)
   end type sheared_t

   !> What a position of a range is.
   type :: sheared_position_t
      !> e and de/dx, x the unknown of the range.
      real(dp) :: e = 0, e_slope = 1
      !> sqrt(b^2 - e^2), T, v, what T still lacks to sliding, and g(e).
      real(dp) :: t = 0, force = 0, displacement = 0, rest = 0, depth = 0
      !> -dv/dx.
      real(dp) :: slope = 0
   end type sheared_position_t

contains

   !> Radii and stresses of a contact that resists.
   pure subroutine set_resistance(resistance, contact, sums)
      type(resistance_t), intent(in) :: resistance
      type(contact_t), intent(in) :: contact
      class(shear_sums_t), intent(inout) :: sums
      real(dp) :: whole_zone

      whole_zone = 0
      ! a disc of adhesion without touch bears no friction
      if (contact%stress > 0 .and. contact%spot%radius > 0) whole_zone = (contact%neck/(2*contact%stress))**2
      call set_shear_radii(sums, contact%spot%radius, contact%adhesion_radius, whole_zone, resistance%edge_fraction)
      sums%stress = contact%stress
      sums%factor = resistance%factor
      sums%uniform = max(resistance%strength - resistance%factor*contact%stress, 0.0_dp)
   end subroutine set_resistance

   !> The contact with its ranges.
   pure subroutine new_sheared(shape, resistance, contact, self)
      class(shape_t), intent(in) :: shape
      type(resistance_t), intent(in) :: resistance
      type(contact_t), intent(in) :: contact
      !> Receives the contact with its ranges.
      type(sheared_t), intent(out) :: self
      type(sheared_range_t) :: next
      type(spot_t) :: corner

      allocate (self%shape, source=shape)
      self%contact = contact
      call set_resistance(resistance, contact, self)
      if (shape%n_pieces == 0) self%face = self%factor*max(-contact%neck, 0.0_dp)
      if (self%zone > 0) call add_range(self, sheared_range_t(is_beside=.true., outer=self%b, inner=self%a))
      if (.not. self%a > 0) return
      next%outer = self%a
      next%is_beyond = contact%is_beyond .and. shape%n_pieces > 0
      if (next%is_beyond) then
         next%high = contact%u
         next%inner = shape%corner
         call add_range(self, next)
         if (.not. shape%corner > 0) return
         call shape%evaluate(0.0_dp, .true., corner)
         next%load_before = contact%spot%load - corner%load
         next%depth_before = contact%spot%depth - corner%depth
         next%square_before = contact%spot%beyond**2
         if (contact%u > 0) call integrate_profile(shape, .true., contact%u, contact%u, next%depth_before, next%load_before)
         next%outer = shape%corner
         next%is_beyond = .false.
      end if
      next%inner = 0
      next%high = next%outer
      next%is_flat = .not. shape%inner_rise() > 0
      call add_range(self, next)
   end subroutine new_sheared

   !> Add a range.
   pure subroutine add_range(self, range)
      !> The contact, whose ranges become one more.
      type(sheared_t), intent(inout) :: self
      type(sheared_range_t), intent(in) :: range

      self%n = self%n + 1
      self%ranges(self%n) = range
   end subroutine add_range

   !> A position of a range: x is how much the unknown of the range has fallen from its largest value; beside the contact it is the
   !> angle arccos(e/b).
   pure subroutine get_position(self, number, x, position)
      type(sheared_t), intent(in) :: self
      integer, intent(in) :: number
      !> The path from the beginning of the range, >= 0.
      real(dp), intent(in) :: x
      type(sheared_position_t), intent(out) :: position
      type(spot_t) :: spot
      real(dp) :: square, depth, load, slope

      associate (range => self%ranges(number))
         if (range%is_beside) then
            position%e = self%b*cos(x)
            position%e_slope = self%b*sin(x)
            position%t = position%e_slope
            position%force = 2*self%uniform*self%b**2*(x + sin(x)*cos(x))
            position%displacement = 2*self%uniform*position%t
            position%slope = 2*self%uniform*position%e
            return
         end if
         call descend(self, range, x, spot, square, depth, load)
         position%e = spot%radius
         position%e_slope = spot%radius_slope
         position%t = sqrt(self%zone + square)
         position%force = sum_force(self, position%e, square, load) + 2*self%a*self%face
         call sum_displacement(self, square, depth, position%displacement, slope)
         position%displacement = position%displacement + self%face
         position%slope = self%factor*spot%depth_slope + slope*(2*position%e*spot%radius_slope)
         ! what remains below e
         position%rest = sum_rest(self, position%e, square, spot%load)
         position%depth = spot%depth
      end associate
   end subroutine get_position

   !> What v still lacks to sliding.
   pure real(dp) function displacement_rest(self, position) result(rest)
      type(sheared_t), intent(in) :: self
      type(sheared_position_t), intent(in) :: position

      associate (e => position%e)
         rest = 2*self%uniform*e**2/(self%b + position%t) + self%factor*position%depth
         if (self%stress > 0) rest = rest + 2*self%factor*self%stress*e**2/(self%c + sqrt(max(self%c**2 - e**2, 0.0_dp)))
      end associate
   end function displacement_rest

   !> The profile at a path down a range.
   pure subroutine descend(self, range, x, spot, square, depth, load)
      type(sheared_t), intent(in) :: self
      type(sheared_range_t), intent(in) :: range
      !> How much the unknown has fallen.
      real(dp), intent(in) :: x
      type(spot_t), intent(out) :: spot
      !> Receives a^2 - e^2.
      real(dp), intent(out) :: square
      !> Receive g(a) - g(e) and P1(a) - P1(e).
      real(dp), intent(out) :: depth, load
      type(spot_t) :: first

      depth = range%depth_before
      load = range%load_before
      if (range%is_flat) then
         spot%radius = range%high - x
         square = range%square_before + x*(range%high + spot%radius)
         return
      end if
      call self%shape%evaluate(range%high - x, range%is_beyond, spot)
      call self%shape%evaluate(range%high, range%is_beyond, first)
      if (range%is_beyond .and. self%shape%edge < huge(x)) then
         ! of a sphere u = artanh(a): tanh(high) - tanh(high - x)
         square = -2*exp(-2*(range%high - x))*expm1(-2*x)/((1 + exp(-2*range%high))*(1 + exp(-2*(range%high - x)))) &
            & *(first%radius + spot%radius)
      else
         square = x*(2*range%high - x)
      end if
      square = range%square_before + square
      if (x < short*range%high) then
         call integrate_profile(self%shape, range%is_beyond, range%high, x, depth, load)
         depth = range%depth_before + depth
         load = range%load_before + load
      else
         depth = range%depth_before + (first%depth - spot%depth)
         load = range%load_before + (first%load - spot%load)
      end if
   end subroutine descend

   !> What g and P1 lose along the beginning of a range of u.
   pure subroutine integrate_profile(shape, is_beyond, high, length, depth, load)
      class(shape_t), intent(in) :: shape
      !> Does the range lie beyond the corner?
      logical, intent(in) :: is_beyond
      !> The largest u, and the length of the beginning.
      real(dp), intent(in) :: high, length
      !> Receive the losses.
      real(dp), intent(out) :: depth, load
      type(spot_t) :: spot
      integer :: node

      depth = 0
      load = 0
      do node = 1, size(gauss_nodes)
         call shape%evaluate(high - length*(1 + gauss_nodes(node))/2, is_beyond, spot)
         associate (part => gauss_weights(node)*length/2*spot%depth_slope)
            depth = depth + part
            load = load + 2*spot%radius*part
         end associate
      end do
   end subroutine integrate_profile

   !> The length of a range.
   pure real(dp) function range_length(self, number) result(length)
      type(sheared_t), intent(in) :: self
      integer, intent(in) :: number

      length = self%ranges(number)%high
      if (self%ranges(number)%is_beside) length = atan2(sqrt(self%zone), self%a)
   end function range_length

end module adfric_round_sheared_contact
