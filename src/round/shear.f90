! SPDX-License-Identifier: GPL-3.0-or-later
!> An indenter whose contact resists shear by tau0 + alpha p: the force at which it slides, and the partial slip below it, reduced.
!>
!> Force T and displacement u = m v follow from the radius e that sticks (`adfric_round_shear_sums`); t, S and g are of that module.
!> All terms are positive and fall with e where alpha S <= tau0, and dT = 2 e dv, so there is one e for each T up to that of sliding.
!> In a cycle between T and -T a ring ds slips by v(e) - v(s) under the force 2 v(s) ds:
!>
!>     W = 8 m int v(s) [v(e) - v(s)] ds,  e < s < b
!>
!> A face without an edge that rises has a pressure that is infinite at its edge; alpha p then holds it by 2 alpha P/2a as a whole.
module adfric_round_shear
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_round_contact_state, only: contact_t
   use adfric_round_face_contact, only: find_face_angle
   use adfric_round_profiles, only: pressure_at
   use adfric_round_shape, only: shape_t
   use adfric_round_shear_energy, only: energy_of
   use adfric_round_sheared_contact, only: displacement_rest, get_position, new_sheared, sheared_position_t, range_length, &
      & resistance_t, set_resistance, sheared_t, short
   use adfric_round_shear_sums, only: shear_sums_t, sliding_force, stress_in_stick
   use adfric_numerics_scalar_root, only: equation_t, find_root
   implicit none (type, external)
   private
   public :: resistance_t, shear_slip_t, find_sliding, find_shear_slip, find_position, shear_stress_at

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

   !> The logarithm of the force or the displacement, or of what it lacks to sliding, as a function of the logarithm of the path or of
   !> the unknown.
   type, extends(equation_t) :: slip_equation_t
      !> The contact.
      type(sheared_t) :: sheared
      !> Number of the range.
      integer :: number = 1
      !> Is it the force, or else the displacement? Is the unknown what remains of the range's, and what is lacking compared?
      logical :: is_of_force = .true., is_of_rest = .false.
      !> Force or displacement, or what it lacks.
      real(dp) :: target = 1
   contains
      procedure :: evaluate
   end type slip_equation_t

contains

   !> The radius of friction, and the force at which the contact slides.
   pure subroutine find_sliding(resistance, contact, outer_pull, radius, force)
      type(resistance_t), intent(in) :: resistance
      type(contact_t), intent(in) :: contact
      !> What adhesion outside the contact takes from the load (DMT).
      real(dp), intent(in) :: outer_pull
      !> Receives b.
      real(dp), intent(out) :: radius
      !> Receives tau0 pi b^2 + alpha times the load that r < b carries; 0 without contact, below 0 where there is no friction
      !> of this kind.
      real(dp), intent(out) :: force
      type(shear_sums_t) :: sums

      call set_resistance(resistance, contact, sums)
      radius = sums%b
      force = sliding_force(sums, resistance%strength, contact%load + outer_pull)
   end subroutine find_sliding

   !> The slip of a contact under a force.
   pure subroutine find_shear_slip(shape, resistance, contact, force, slip, is_converged)
      class(shape_t), intent(in) :: shape
      !> How the contact resists; alpha S is not above tau0.
      type(resistance_t), intent(in) :: resistance
      !> The contact, of a radius of friction > 0.
      type(contact_t), intent(in) :: contact
      !> T, from 0 to that of sliding.
      real(dp), intent(in) :: force
      type(shear_slip_t), intent(out) :: slip
      logical, intent(out) :: is_converged
      type(sheared_t) :: sheared
      type(sheared_position_t) :: position
      real(dp) :: x, remaining
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
      call get_position(sheared, sheared%n, range_length(sheared, sheared%n), position)
      call find_position(sheared, force, .true., position%force, number, x, remaining, is_converged)
      call get_position(sheared, number, x, position)
      slip%radius = position%e
      slip%ratio = min(position%e/sheared%b, 1.0_dp)
      slip%displacement = position%displacement
      slip%energy = energy_of(sheared, number, x, position)
      slip%stick%spot%radius = 0
      associate (range => sheared%ranges(number))
         if (range%is_beside .or. range%is_flat) return
         slip%stick%u = range%high - x
         slip%stick%is_beyond = range%is_beyond
         call shape%evaluate(slip%stick%u, range%is_beyond, slip%stick%spot)
      end associate
   end subroutine find_shear_slip

   !> Where the force or the displacement is the given one.
   pure subroutine find_position(self, value, is_of_force, total, number, x, remaining, is_converged)
      type(sheared_t), intent(in) :: self
      !> T or v, > 0.
      real(dp), intent(in) :: value
      !> Is it T?
      logical, intent(in) :: is_of_force
      !> That of sliding.
      real(dp), intent(in) :: total
      !> Receives the number of the range.
      integer, intent(out) :: number
      !> Receives the path in the range.
      real(dp), intent(out) :: x
      !> Receives what remains of the range, where that has digits of its own; else 0.
      real(dp), intent(out) :: remaining
      logical, intent(out) :: is_converged
      type(sheared_position_t) :: last, first
      real(dp) :: end_of_range
      logical :: is_found

      is_converged = .true.
      remaining = 0
      do number = 1, self%n
         end_of_range = range_length(self, number)
         x = end_of_range
         call get_position(self, number, end_of_range, last)
         if (value > size_of(last, is_of_force)) cycle
         if (.not. value < size_of(last, is_of_force)) return
         if (self%ranges(number)%is_beside) then
            if (is_of_force) call find_face_angle(value/(2*self%uniform*self%b**2), end_of_range, 1.0_dp, 0.0_dp, x, is_found)
            if (.not. is_of_force) x = asin(value/(2*self%uniform*self%b))
            return
         end if
         call get_position(self, number, 0.0_dp, first)
         if (.not. value > size_of(first, is_of_force)) then
            x = 0
            return
         end if
         call find_in_range(self, number, value, is_of_force, total, x, remaining, is_converged)
         return
      end do
      ! round-off above sliding
      number = self%n
      x = range_length(self, number)
   end subroutine find_position

   !> Force or displacement of a position.
   pure real(dp) function size_of(position, is_of_force)
      type(sheared_position_t), intent(in) :: position
      logical, intent(in) :: is_of_force

      size_of = merge(position%force, position%displacement, is_of_force)
   end function size_of

   !> Where the value is the given one within a range. Up to the middle the logarithm of the path is the unknown, beyond it that of
   !> what remains of the range.
   pure subroutine find_in_range(self, number, value, is_of_force, total, x, remaining, is_converged)
      type(sheared_t), intent(in) :: self
      integer, intent(in) :: number
      !> T or v.
      real(dp), intent(in) :: value
      logical, intent(in) :: is_of_force
      !> T or v of sliding.
      real(dp), intent(in) :: total
      real(dp), intent(out) :: x, remaining
      logical, intent(out) :: is_converged
      ! logarithm of the smallest part of a range
      real(dp), parameter :: smallest = -200.0_dp
      type(slip_equation_t) :: equation
      type(sheared_position_t) :: middle
      real(dp) :: guess, high

      high = range_length(self, number)
      call get_position(self, number, high/2, middle)
      remaining = 0
      equation%sheared = self
      equation%number = number
      equation%is_of_force = is_of_force
      equation%is_of_rest = value > size_of(middle, is_of_force)
      if (equation%is_of_rest) then
         equation%target = total - value
         x = high
         if (.not. equation%target > 0) then
            ! nothing is left of the last range, or of one before it but round-off
            is_converged = .true.
            return
         end if
         guess = log(high) + min(0.0_dp, log(max(equation%target/total, tiny(1.0_dp)))/merge(3, 2, is_of_force))
         call find_root(equation, log(high) + smallest, log(high/2) + short, .true., guess, is_converged)
         remaining = exp(guess)
         x = high - remaining
      else
         equation%target = value
         guess = log(high) + log(value/size_of(middle, is_of_force))
         if (self%uniform > 0) guess = min(guess, 2*log(value/(4*self%uniform*self%b*merge(self%b, 1.0_dp, is_of_force))) &
            & + log(high))
         call find_root(equation, log(high) + smallest, log(high/2) + short, .true., guess, is_converged)
         x = exp(guess)
      end if
   end subroutine find_in_range

   !> See `equation_t`.
   pure subroutine evaluate(self, x, value, slope)
      class(slip_equation_t), intent(in) :: self
      !> Logarithm of the path, or of what remains of the range.
      real(dp), intent(in) :: x
      !> Difference of the logarithms.
      real(dp), intent(out) :: value
      real(dp), intent(out) :: slope
      type(sheared_position_t) :: position
      real(dp) :: length, size

      length = exp(x)
      if (self%is_of_rest) then
         call get_position(self%sheared, self%number, max(range_length(self%sheared, self%number) - length, 0.0_dp), position)
         size = position%rest
         if (.not. self%is_of_force) size = displacement_rest(self%sheared, position)
      else
         call get_position(self%sheared, self%number, length, position)
         size = size_of(position, self%is_of_force)
      end if
      size = max(size, tiny(size)*max(self%target, 1.0_dp))
      value = log(size/self%target)
      ! dT = 2 e dv
      slope = length*(merge(2*position%e, 1.0_dp, self%is_of_force)*position%slope/size)
   end subroutine evaluate

   !> Shear stress at a distance from the axis, reduced.
   pure real(dp) function shear_stress_at(shape, resistance, contact, slip, r) result(stress)
      class(shape_t), intent(in) :: shape
      type(resistance_t), intent(in) :: resistance
      type(contact_t), intent(in) :: contact
      type(shear_slip_t), intent(in) :: slip
      !> Distance from the axis, reduced, >= 0.
      real(dp), intent(in) :: r
      type(shear_sums_t) :: sums
      real(dp) :: pressure, stick

      stress = 0
      call set_resistance(resistance, contact, sums)
      if (r > sums%b .or. .not. sums%b > 0) return
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

end module adfric_round_shear
