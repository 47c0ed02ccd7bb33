! SPDX-License-Identifier: GPL-3.0-or-later
!> An indenter whose contact resists shear by tau0 + alpha p: the force at which it slides, and the partial slip below it, reduced.
!>
!> Force T and displacement u = m v follow from the radius e that sticks (`adfric_material_shear_sums`); t, S and g are of that module.
!> All terms are positive and fall with e where alpha S <= tau0, and dT = 2 e dv, so there is one e for each T up to that of sliding.
!> In a cycle between T and -T a ring ds slips by v(e) - v(s) under the force 2 v(s) ds:
!>
!>     W = 8 m int v(s) [v(e) - v(s)] ds,  e < s < b
!>
!> A face without an edge that rises has a pressure that is infinite at its edge; alpha p then holds it by 2 alpha P/2a as a whole.
module adfric_indenter_shear
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_indenter_contact_state, only: contact_t
   use adfric_indenter_face_contact, only: find_face_angle
   use adfric_indenter_profiles, only: pressure_at
   use adfric_indenter_shape, only: shape_t, spot_t
   use adfric_material_shear_sums, only: shear_sums_t, set_shear_radii, sliding_force, stress_in_stick, sum_displacement, &
      & sum_force, sum_rest
   use adfric_numerics_gauss, only: gauss_nodes, gauss_weights
   use adfric_numerics_libm, only: expm1
   use adfric_numerics_scalar_root, only: equation_t, find_root
   implicit none (type, external)
   private
   public :: resistance_t, shear_slip_t, find_sliding, find_shear_slip, shear_stress_at

   !> Below this share of u a way along the profile is an integral, not a difference.
   real(dp), parameter :: short = 0.1_dp
   !> Where a decaying exponential is round-off, and the longest panel of a logarithm.
   real(dp), parameter :: decayed = 40.0_dp, longest = 2.0_dp
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
   type :: range_t
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
   end type range_t

   !> Slip under a force.
   type :: shear_slip_t
      !> The contact without adhesion that has the radius e.
      type(contact_t) :: stick
      !> e, and e/b.
      real(dp) :: radius = 0, ratio = 1
      !> v = u/m.
      real(dp) :: displacement = 0
      !> W/m.
      real(dp) :: energy = 0
   end type shear_slip_t

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
      type(range_t) :: ranges(most_ranges)
   end type sheared_t

   !> What a place of a range is.
   type :: place_t
      !> e and de/dx, x the unknown of the range.
      real(dp) :: e = 0, e_slope = 1
      !> sqrt(b^2 - e^2), T, v, and what T still lacks to sliding.
      real(dp) :: t = 0, force = 0, displacement = 0, rest = 0
      !> -dv/dx.
      real(dp) :: slope = 0
   end type place_t

   !> The logarithm of the force, or of what it lacks to sliding, as a function of the logarithm of the way or of the unknown.
   type, extends(equation_t) :: force_equation_t
      !> The contact.
      type(sheared_t) :: sheared
      !> Number of the range.
      integer :: number = 1
      !> Is the unknown what is left of the range's, and what the force lacks compared?
      logical :: is_of_rest = .false.
      !> The force, or what it lacks.
      real(dp) :: target = 1
   contains
      procedure :: evaluate => evaluate_force
   end type force_equation_t

contains

   !> The radius of friction, and the force at which the contact slides.
   pure subroutine find_sliding(resistance, contact, outer_pull, radius, force)
      !> How the contact resists.
      type(resistance_t), intent(in) :: resistance
      !> The contact.
      type(contact_t), intent(in) :: contact
      !> What adhesion outside the contact takes from the load (DMT).
      real(dp), intent(in) :: outer_pull
      !> Receives b.
      real(dp), intent(out) :: radius
      !> Receives tau0 pi b^2 + alpha times the load that r < b carries; 0 without contact, and never below.
      real(dp), intent(out) :: force
      type(shear_sums_t) :: sums

      call set_resistance(resistance, contact, sums)
      radius = sums%b
      force = sliding_force(sums, resistance%strength, contact%load + outer_pull)
   end subroutine find_sliding

   !> Radii and stresses of a contact that resists.
   pure subroutine set_resistance(resistance, contact, sums)
      !> How the contact resists.
      type(resistance_t), intent(in) :: resistance
      !> The contact.
      type(contact_t), intent(in) :: contact
      !> Receives radii and stresses.
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

   !> The slip of a contact under a force.
   pure subroutine find_shear_slip(shape, resistance, contact, force, slip, is_converged)
      !> The shape of the indenter.
      class(shape_t), intent(in) :: shape
      !> How the contact resists; alpha S is not above tau0.
      type(resistance_t), intent(in) :: resistance
      !> The contact, of a radius of friction > 0.
      type(contact_t), intent(in) :: contact
      !> T, from 0 to that of sliding.
      real(dp), intent(in) :: force
      !> Receives the slip.
      type(shear_slip_t), intent(out) :: slip
      !> Was it found to round-off?
      logical, intent(out) :: is_converged
      type(sheared_t) :: sheared
      type(place_t) :: place
      real(dp) :: x
      integer :: number

      call new_sheared(shape, resistance, contact, sheared)
      is_converged = .true.
      slip%radius = sheared%b
      slip%stick = contact
      slip%stick%neck = 0
      slip%stick%stress = 0
      if (.not. force > 0) return
      if (force <= 2*sheared%a*sheared%face) then
         ! a face that sticks as a whole
         slip%radius = sheared%a
         slip%ratio = sheared%a/sheared%b
         slip%displacement = force/(2*sheared%a)
         return
      end if
      call find_place(sheared, force, number, x, is_converged)
      call get_place(sheared, number, x, place)
      slip%radius = place%e
      slip%ratio = min(place%e/sheared%b, 1.0_dp)
      slip%displacement = place%displacement
      slip%energy = energy_of(sheared, number, x, place)
      slip%stick%spot%radius = 0
      associate (range => sheared%ranges(number))
         if (range%is_beside .or. range%is_flat) return
         slip%stick%u = range%high - x
         slip%stick%is_beyond = range%is_beyond
         call shape%evaluate(slip%stick%u, range%is_beyond, slip%stick%spot)
      end associate
   end subroutine find_shear_slip

   !> The contact with its ranges.
   pure subroutine new_sheared(shape, resistance, contact, self)
      !> The shape of the indenter.
      class(shape_t), intent(in) :: shape
      !> How the contact resists.
      type(resistance_t), intent(in) :: resistance
      !> The contact.
      type(contact_t), intent(in) :: contact
      !> Receives the contact with its ranges.
      type(sheared_t), intent(out) :: self
      type(range_t) :: next
      type(spot_t) :: corner

      allocate (self%shape, source=shape)
      self%contact = contact
      call set_resistance(resistance, contact, self)
      if (shape%n_pieces == 0) self%face = self%factor*max(-contact%neck, 0.0_dp)
      if (self%zone > 0) call add_range(self, range_t(is_beside=.true., outer=self%b, inner=self%a))
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
      !> The range.
      type(range_t), intent(in) :: range

      self%n = self%n + 1
      self%ranges(self%n) = range
   end subroutine add_range

   !> A place of a range: x is how much the unknown of the range has fallen from its largest value; beside the contact it is the angle
   !> arccos(e/b).
   pure subroutine get_place(self, number, x, place)
      !> The contact.
      type(sheared_t), intent(in) :: self
      !> Number of the range.
      integer, intent(in) :: number
      !> The way from the beginning of the range, >= 0.
      real(dp), intent(in) :: x
      !> Receives what is there.
      type(place_t), intent(out) :: place
      type(spot_t) :: spot
      real(dp) :: square, depth, load, slope

      associate (range => self%ranges(number))
         if (range%is_beside) then
            place%e = self%b*cos(x)
            place%e_slope = self%b*sin(x)
            place%t = place%e_slope
            place%force = 2*self%uniform*self%b**2*(x + sin(x)*cos(x))
            place%displacement = 2*self%uniform*place%t
            place%slope = 2*self%uniform*place%e
            return
         end if
         call descend(self, range, x, spot, square, depth, load)
         place%e = spot%radius
         place%e_slope = spot%radius_slope
         place%t = sqrt(self%zone + square)
         place%force = sum_force(self, place%e, square, load) + 2*self%a*self%face
         call sum_displacement(self, square, depth, place%displacement, slope)
         place%displacement = place%displacement + self%face
         place%slope = self%factor*spot%depth_slope + slope*(2*place%e*spot%radius_slope)
         ! what is left below e
         place%rest = sum_rest(self, place%e, square, spot%load)
      end associate
   end subroutine get_place

   !> The profile at a way down a range.
   pure subroutine descend(self, range, x, spot, square, depth, load)
      !> The contact.
      type(sheared_t), intent(in) :: self
      !> The range.
      type(range_t), intent(in) :: range
      !> How much the unknown has fallen.
      real(dp), intent(in) :: x
      !> Receives what the profile is there.
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
      !> The shape of the indenter.
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

   !> Where the force is the given one.
   pure subroutine find_place(self, force, number, x, is_converged)
      !> The contact.
      type(sheared_t), intent(in) :: self
      !> T > 0.
      real(dp), intent(in) :: force
      !> Receives the number of the range.
      integer, intent(out) :: number
      !> Receives the way in the range.
      real(dp), intent(out) :: x
      !> Was it found to round-off?
      logical, intent(out) :: is_converged
      type(place_t) :: last, first
      real(dp) :: total, end_of_range
      logical :: is_found

      call get_place(self, self%n, range_length(self, self%n), last)
      total = last%force
      is_converged = .true.
      do number = 1, self%n
         end_of_range = range_length(self, number)
         x = end_of_range
         call get_place(self, number, end_of_range, last)
         if (force > last%force) cycle
         if (.not. force < last%force) return
         if (self%ranges(number)%is_beside) then
            call find_face_angle(force/(2*self%uniform*self%b**2), end_of_range, 1.0_dp, 0.0_dp, x, is_found)
            return
         end if
         call get_place(self, number, 0.0_dp, first)
         if (.not. force > first%force) then
            x = 0
            return
         end if
         call find_in_range(self, number, force, total, x, is_converged)
         return
      end do
      ! round-off above sliding
      number = self%n
      x = range_length(self, number)
   end subroutine find_place

   !> The length of a range.
   pure real(dp) function range_length(self, number) result(length)
      !> The contact.
      type(sheared_t), intent(in) :: self
      !> Number of the range.
      integer, intent(in) :: number

      length = self%ranges(number)%high
      if (self%ranges(number)%is_beside) length = atan2(sqrt(self%zone), self%a)
   end function range_length

   !> Where the force is the given one within a range. Up to the middle the logarithm of the way is the unknown, beyond it that of
   !> what is left of the range.
   pure subroutine find_in_range(self, number, force, total, x, is_converged)
      !> The contact.
      type(sheared_t), intent(in) :: self
      !> Number of the range.
      integer, intent(in) :: number
      !> T, and that of sliding.
      real(dp), intent(in) :: force, total
      !> Receives the way.
      real(dp), intent(out) :: x
      !> Was it found to round-off?
      logical, intent(out) :: is_converged
      ! logarithm of the smallest part of a range
      real(dp), parameter :: smallest = -200.0_dp
      type(force_equation_t) :: equation
      type(place_t) :: middle
      real(dp) :: guess, high

      high = range_length(self, number)
      call get_place(self, number, high/2, middle)
      equation%sheared = self
      equation%number = number
      equation%is_of_rest = force > middle%force
      if (equation%is_of_rest) then
         equation%target = total - force
         x = high
         if (number == self%n .and. .not. equation%target > 0) then
            is_converged = .true.
            return
         end if
         guess = log(high) + min(0.0_dp, log(equation%target/total)/3)
         call find_root(equation, log(high) + smallest, log(high/2) + short, .true., guess, is_converged)
         x = high - exp(guess)
      else
         equation%target = force
         guess = log(high) + log(force/middle%force)
         if (self%uniform > 0) guess = min(guess, 2*log(force/(4*self%uniform*self%b*self%b)) + log(high))
         call find_root(equation, log(high) + smallest, log(high/2) + short, .true., guess, is_converged)
         x = exp(guess)
      end if
   end subroutine find_in_range

   !> See `equation_t`.
   pure subroutine evaluate_force(self, x, value, slope)
      !> The equation with its contact.
      class(force_equation_t), intent(in) :: self
      !> Logarithm of the way, or of what is left of the range.
      real(dp), intent(in) :: x
      !> Difference of the logarithms.
      real(dp), intent(out) :: value
      !> Derivative of the value by x.
      real(dp), intent(out) :: slope
      type(place_t) :: place
      real(dp) :: size

      size = exp(x)
      if (self%is_of_rest) then
         call get_place(self%sheared, self%number, max(range_length(self%sheared, self%number) - size, 0.0_dp), place)
         place%rest = max(place%rest, tiny(size))
         value = log(place%rest/self%target)
         slope = size*(2*place%e*place%slope/place%rest)
      else
         call get_place(self%sheared, self%number, size, place)
         place%force = max(place%force, tiny(size))
         value = log(place%force/self%target)
         slope = size*(2*place%e*place%slope/place%force)
      end if
   end subroutine evaluate_force

   !> W/m, from the ranges that slip.
   pure real(dp) function energy_of(self, number, x, stick) result(energy)
      !> The contact.
      type(sheared_t), intent(in) :: self
      !> Number of the range where the stick zone ends, and the way in it.
      integer, intent(in) :: number
      !> The way.
      real(dp), intent(in) :: x
      !> What is there.
      type(place_t), intent(in) :: stick
      integer :: k

      energy = 0
      do k = 1, number
         energy = energy + range_energy(self, k, merge(x, range_length(self, k), k == number), stick%displacement)
      end do
      energy = 8*energy
   end function energy_of

   !> int v(s) [v(e) - v(s)] ds along a range. Near the edge of friction and of adhesion v goes by the root of the way: x = x0 sinh(w)^2
   !> takes that; where u is small its logarithm is the variable, for g may be a power of it.
   pure real(dp) function range_energy(self, number, length, total) result(energy)
      !> The contact.
      type(sheared_t), intent(in) :: self
      !> Number of the range.
      integer, intent(in) :: number
      !> How much of the range slips.
      real(dp), intent(in) :: length
      !> v(e).
      real(dp), intent(in) :: total
      real(dp), parameter :: straight = 1.0e2_dp
      real(dp) :: first, start, rate, low, high, change, reach, x, w
      integer :: panel, n_panels, node

      energy = 0
      if (.not. length > 0) return
      if (self%ranges(number)%is_beside) then
         do node = 1, size(gauss_nodes)
            x = length*(1 + gauss_nodes(node))/2
            energy = energy + gauss_weights(node)*length/2*loss_at(self, number, x, total)
         end do
         return
      end if
      high = self%ranges(number)%high
      change = min(length, high/2)
      ! t^2 = t0^2 (1 + x/start)
      start = self%zone + self%ranges(number)%square_before
      rate = 2*high
      if (self%shape%edge < huge(start)) rate = 8*self%a*exp(-2*high)/(1 + exp(-2*high))**2
      if (start > straight*rate*change) then
         ! v is as good as straight
         do node = 1, size(gauss_nodes)
            x = change*(1 + gauss_nodes(node))/2
            energy = energy + gauss_weights(node)*change/2*loss_at(self, number, x, total)
         end do
      else if (start > 0) then
         start = start/rate
         first = asinh(sqrt(change/start))
         n_panels = max(1, ceiling(first/longest))
         do panel = 1, n_panels
            do node = 1, size(gauss_nodes)
               w = first*(2*panel - 1 + gauss_nodes(node))/(2*n_panels)
               x = start*sinh(w)**2
               energy = energy + gauss_weights(node)*first/n_panels*start*sinh(w)*cosh(w)*loss_at(self, number, x, total)
            end do
         end do
      else
         do node = 1, size(gauss_nodes)
            w = (1 + gauss_nodes(node))/2
            energy = energy + gauss_weights(node)*change*w*loss_at(self, number, change*w**2, total)
         end do
      end if
      if (.not. length > change) return
      ! what is left of u falls from high/2 to low; where g is analytic one panel does
      low = high - length
      reach = 0
      if (self%ranges(number)%is_beyond) reach = min(self%shape%reach, high/2)
      if (.not. self%ranges(number)%is_beyond) reach = high/2
      reach = max(reach, low)
      if (high/2 > reach) then
         first = decayed
         if (reach > 0) first = min(log(high/2/reach), decayed)
         n_panels = max(1, ceiling(first/longest))
         do panel = 1, n_panels
            do node = 1, size(gauss_nodes)
               x = high/2*exp(-first*(2*panel - 1 + gauss_nodes(node))/(2*n_panels))
               energy = energy + gauss_weights(node)*first/(2*n_panels)*x*loss_at(self, number, high - x, total)
            end do
         end do
      end if
      do node = 1, size(gauss_nodes)
         if (.not. reach > low) exit
         x = high - low - (reach - low)*(1 + gauss_nodes(node))/2
         energy = energy + gauss_weights(node)*(reach - low)/2*loss_at(self, number, x, total)
      end do
   end function range_energy

   !> v(s) [v(e) - v(s)] ds/dx at a place of a range.
   pure real(dp) function loss_at(self, number, x, total) result(loss)
      !> The contact.
      type(sheared_t), intent(in) :: self
      !> Number of the range.
      integer, intent(in) :: number
      !> The way to the place.
      real(dp), intent(in) :: x
      !> v(e).
      real(dp), intent(in) :: total
      type(place_t) :: place

      call get_place(self, number, x, place)
      loss = place%e_slope*place%displacement*(total - place%displacement)
   end function loss_at

   !> Shear stress at a distance from the axis, reduced.
   pure real(dp) function shear_stress_at(shape, resistance, contact, slip, r) result(stress)
      !> The shape of the indenter.
      class(shape_t), intent(in) :: shape
      !> How the contact resists.
      type(resistance_t), intent(in) :: resistance
      !> The contact.
      type(contact_t), intent(in) :: contact
      !> Its slip.
      type(shear_slip_t), intent(in) :: slip
      !> Distance from the axis, reduced, >= 0.
      real(dp), intent(in) :: r
      type(shear_sums_t) :: sums
      real(dp) :: pressure, stick

      stress = 0
      call set_resistance(resistance, contact, sums)
      if (r > sums%b) return
      if (slip%displacement > 0 .and. .not. slip%energy > 0 .and. shape%n_pieces == 0 .and. slip%ratio >= 1) then
         ! a face that sticks as a whole
         if (r < sums%a) stress = slip%displacement/(pi*sqrt((sums%a - r)*(sums%a + r)))
      else if (r >= slip%radius) then
         stress = resistance%strength
         if (resistance%factor > 0) stress = stress + resistance%factor*pressure_at(shape, contact, r)
      else
         pressure = 0
         stick = 0
         if (resistance%factor > 0) pressure = pressure_at(shape, contact, r)
         if (resistance%factor > 0 .and. slip%stick%spot%radius > 0) stick = pressure_at(shape, slip%stick, r)
         stress = stress_in_stick(sums, slip%radius, r, pressure, stick)
      end if
   end function shear_stress_at

end module adfric_indenter_shear
