! SPDX-License-Identifier: GPL-3.0-or-later
!> Which theory a point needs, and its contact.
!>
!> `auto` takes DMT or JKR where inequalities (see `theory_bounds`) prove that it is within the tolerance of
!> Maugis-Dugdale, and Maugis-Dugdale otherwise.
module adfric_round_sphere_theory_choice
   use adfric_base_kinds, only: dp
   use adfric_round_sphere_contact, only: sphere_contact_t, theory_t, theory_hertz, theory_jkr, theory_dmt, theory_maugis_dugdale, &
      & control_load, control_approach, control_radius, branch_stable, find_contact
   use adfric_round_sphere_dmt, only: dmt_t
   use adfric_round_sphere_dugdale_curve, only: dugdale_point_t, get_curve_point, get_disc
   use adfric_round_sphere_hertz, only: hertz_t
   use adfric_round_sphere_jkr, only: jkr_t
   use adfric_round_sphere_maugis_dugdale, only: maugis_t
   use adfric_round_sphere_theory_bounds, only: limit_t, new_limit
   implicit none (type, external)
   private
   public :: new_theory, theory_choice_t, new_choice, is_choice_of, choose_theory, get_mismatch

   !> A relative error is the error over the value, or over this where the value is smaller.
   real(dp), parameter :: least_value = 0.1_dp
   !> Below this X nothing is proved.
   real(dp), parameter :: least_ratio = 1.0e-30_dp
   !> Largest t^2 and u of a proof (see `theory_bounds`), which leave space for the neighbouring radii, and largest z (see `prove`).
   real(dp), parameter :: largest_square = 0.08_dp, largest_cosine = 0.35_dp, largest_share = 0.09_dp
   !> Relative round-off of a term of an equation.
   real(dp), parameter :: round_off = 2*epsilon(1.0_dp)

   !> What a choice needs that does not depend on what is prescribed. It follows from its parameters alone.
   type :: theory_choice_t
      !> The parameters; see `new_choice`.
      real(dp) :: lambda = 0, ratio = 0, tolerance = 0
      !> What is prescribed, one of `control_...`.
      integer :: control = 0
      !> Does a result depend on c, so that DMT, which has none, cannot do?
      logical :: needs_edge = .false.
      !> The limit theory that may do.
      type(limit_t) :: limit
      !> JKR for this X.
      type(jkr_t) :: jkr
      !> DMT for this X.
      type(dmt_t) :: dmt
      !> Only between these values of what is prescribed a proof is tried.
      real(dp) :: low = huge(1.0_dp), high = -huge(1.0_dp)
   end type theory_choice_t

contains

   !> A theory by its number, for X = 1.
   subroutine new_theory(theory, number, lambda)
      class(theory_t), allocatable, intent(out) :: theory
      integer, intent(in) :: number
      !> Maugis's parameter [-], > 0; only Maugis-Dugdale uses it.
      real(dp), intent(in) :: lambda

      select case (number)
      case (theory_hertz)
         allocate (hertz_t :: theory)
      case (theory_jkr)
         allocate (jkr_t :: theory)
      case (theory_dmt)
         allocate (dmt_t :: theory)
      case default
         allocate (theory, source=maugis_t(lambda=lambda))
      end select
   end subroutine new_theory

   !> The limit theory that may do, and the range of prescribed values where it may.
   pure subroutine new_choice(self, lambda, ratio, control, needs_edge, tolerance)
      !> Receives the limit theory that may do, and its range of what is prescribed.
      type(theory_choice_t), intent(out) :: self
      !> Maugis's parameter [-], > 0.
      real(dp), intent(in) :: lambda
      !> X, the share of adhesion that remains [-], >= 0.
      real(dp), intent(in) :: ratio
      integer, intent(in) :: control
      !> Is the radius c of adhesion needed, too? Then DMT will not do.
      logical, intent(in) :: needs_edge
      !> Relative error of radii, load and approach that is allowed [-].
      real(dp), intent(in) :: tolerance

      self%lambda = lambda
      self%ratio = ratio
      self%control = control
      self%needs_edge = needs_edge
      self%tolerance = tolerance
      if (.not. ratio > least_ratio) return
      if (lambda >= 1) then
         call new_limit(self%limit, theory_jkr, lambda, ratio)
         self%jkr%ratio = ratio
         call set_range_of_jkr(self)
      else if (.not. needs_edge) then
         call new_limit(self%limit, theory_dmt, lambda, ratio)
         self%dmt%ratio = ratio
         call set_range_of_dmt(self)
      end if
   end subroutine new_choice

   !> Was the choice made for these parameters?
   pure logical function is_choice_of(self, lambda, ratio, control, needs_edge, tolerance)
      type(theory_choice_t), intent(in) :: self
      real(dp), intent(in) :: lambda, ratio
      integer, intent(in) :: control
      !> Is the radius c of adhesion needed, too?
      logical, intent(in) :: needs_edge
      real(dp), intent(in) :: tolerance

      is_choice_of = .not. (abs(lambda - self%lambda) > 0 .or. abs(ratio - self%ratio) > 0 .or. control /= self%control &
         & .or. (needs_edge .neqv. self%needs_edge) .or. abs(tolerance - self%tolerance) > 0)
   end function is_choice_of

   !> Below a radius t^2 is too large for a proof, or c/a - 1, or what the far term of the bounds makes of load and approach, is
   !> more than the tolerance.
   pure subroutine set_range_of_jkr(self)
      !> In: with its parameters and JKR. Out: with the range of what is prescribed, too.
      type(theory_choice_t), intent(inout) :: self
      type(sphere_contact_t) :: contact
      real(dp) :: least

      least = self%limit%far/self%tolerance
      if (self%control /= control_radius) least = 4*least/3
      least = max(least, self%limit%length/largest_square)
      if (self%needs_edge) least = max(least, 1.2_dp*self%limit%length/self%tolerance)
      call self%jkr%of_radius(least, contact)
      self%low = least
      if (self%control == control_load) then
         self%low = -2*self%ratio
         if (contact%is_stable) self%low = contact%load
      else if (self%control == control_approach) then
         ! JKR's least approach is about -0.91 X^(2/3), and at a^3 = X/6
         self%low = -1
         if (6*least**3 > self%ratio) self%low = contact%approach
      end if
      self%high = huge(1.0_dp)
   end subroutine set_range_of_jkr

   !> Above a radius u is too large; below another one the error of radius or approach is more than the tolerance, even where the
   !> bounds are smallest.
   pure subroutine set_range_of_dmt(self)
      !> In: with its parameters and DMT. Out: with the range of what is prescribed, too.
      type(theory_choice_t), intent(inout) :: self
      real(dp) :: approach

      approach = self%limit%far/self%tolerance
      self%high = largest_cosine*self%limit%length
      select case (self%control)
      case (control_load)
         self%low = max(2*self%ratio*self%limit%near/(3*self%tolerance), &
            & (self%ratio/(self%limit%length**2*self%tolerance))**3)
         if (approach > least_value) self%low = max(self%low, approach*sqrt(approach))
         self%low = self%low - 2*self%ratio
         self%high = self%high**3 - 2*self%ratio
      case (control_approach)
         self%low = approach/2
         self%high = self%high**2
      case default
         self%low = 0
         if (approach > least_value) self%low = sqrt(approach)
      end select
   end subroutine set_range_of_dmt

   !> The simplest theory that is proved to be within the tolerance, and its contact. It depends on the parameters of the choice
   !> and on what is prescribed, and on nothing else.
   pure subroutine choose_theory(self, value, branch, number, error, contact)
      type(theory_choice_t), intent(in) :: self
      real(dp), intent(in) :: value
      !> One of `branch_...`; a limit theory will do for the stable state only.
      integer, intent(in) :: branch
      !> Receives the number of the theory, one of `theory_...`.
      integer, intent(out) :: number
      !> Proved bound of the relative error of that theory [-]; 0 for Maugis-Dugdale.
      real(dp), intent(out) :: error
      !> Receives the contact of the limit theory; for Maugis-Dugdale none is found.
      type(sphere_contact_t), intent(out) :: contact

      number = theory_maugis_dugdale
      error = 0
      if (branch /= branch_stable .or. .not. (value > self%low .and. value < self%high)) return
      if (self%limit%theory == theory_dmt) then
         call find_contact(self%dmt, self%control, value, branch, contact)
      else
         call find_contact(self%jkr, self%control, value, branch, contact)
      end if
      if (contact%is_found .and. contact%is_converged .and. contact%is_stable .and. contact%radius > 0) then
         call prove(self, contact, error)
         if (error <= self%tolerance) number = self%limit%theory
      end if
      if (number == self%limit%theory) return
      contact = sphere_contact_t()
      error = 0
   end subroutine choose_theory

   !> Bound of the relative error of radius, load and approach of a contact; huge where there is none.
   !>
   !> Where a load P is prescribed, Maugis-Dugdale's radius lies between a (1 - s) and a (1 + s) if the bounds there leave no doubt
   !> on which side of P its load is. With the bound E of the load, S = a dP/da, s0 = E/S and z = m s0, m = 3 a^3/S, that is so for
   !> s = s0 (1 + 4 z), z <= 0.09:
   !>
   !> - Downwards P falls by S (s - m s^2) or more, and E falls.
   !> - Upwards JKR's P grows by S s or more, E by (1 + s)^2 or less; DMT's by S s (1 + s), and (1 + s)^3.3.
   !>
   !> Where an approach is prescribed it is the same with m = 2 a^2/S; E grows downwards, too, by (1 - s)^(-1/2) or less, and
   !> upwards by 1 + s or less.
   pure subroutine prove(self, contact, error)
      type(theory_choice_t), intent(in) :: self
      type(sphere_contact_t), intent(in) :: contact
      !> Bound of the relative error [-]; huge where there is none.
      real(dp), intent(out) :: error
      real(dp) :: load, approach, load_slope, approach_slope, s, z, cube, square

      error = huge(1.0_dp)
      call self%limit%get_bounds(contact%radius, load, approach)
      if (.not. load < huge(load)) return
      associate (a => contact%radius)
         s = 0
         if (self%control == control_load .or. self%control == control_approach) then
            call get_slopes(self%limit%theory, self%ratio, a, load_slope, approach_slope)
            load_slope = a*load_slope
            approach_slope = a*approach_slope
            square = a*a
            cube = a*square
            if (self%control == control_load) then
               if (.not. load < load_slope) return
               s = load/load_slope
               z = s*3*cube/load_slope
            else
               if (.not. approach < approach_slope) return
               s = approach/approach_slope
               z = s*2*square/approach_slope
            end if
            if (.not. (s <= self%tolerance .and. z <= largest_share)) return
            s = s*(1 + 4*z)
            ! bounds at the radius of Maugis-Dugdale, and what the limit theory changes on the way to it
            load = load*(1 + 4*s) + (abs(load_slope) + 3*cube*s*(1 + s))*s
            approach = approach*(1 + s) + (approach_slope + 2*square*s)*s
            if (self%control == control_load) load = 0
            if (self%control == control_approach) approach = 0
         end if
         ! relative to the least that the values of Maugis-Dugdale can be
         error = s/(1 - s)
         if (self%needs_edge) error = error + 1.2_dp*self%limit%length/a
         error = max(error, load/max(abs(contact%load) - load, least_value), &
            & approach/max(abs(contact%approach) - approach, least_value))
      end associate
   end subroutine prove

   !> How well a contact is known: how far it is from fulfilling the equations of its theory at the position where it was found,
   !> and what the round-off of what is prescribed does to the position. The largest relative error of radius, load and approach.
   pure real(dp) function get_mismatch(theory, number, control, contact) result(mismatch)
      !> Theory that has found the contact.
      class(theory_t), intent(in) :: theory
      !> Number of this theory, one of `theory_...`.
      integer, intent(in) :: number
      !> One of `control_...`: what is prescribed.
      integer, intent(in) :: control
      !> The contact, which has been found.
      type(sphere_contact_t), intent(in) :: contact
      type(sphere_contact_t) :: again
      type(dugdale_point_t) :: point
      real(dp), dimension(3) :: values, others, terms, slopes, sizes, powers
      real(dp) :: shift
      integer :: prescribed

      again = sphere_contact_t()
      slopes = 0
      select type (theory)
      type is (maugis_t)
         if (contact%radius > 0) then
            call get_curve_point(theory%lambda, theory%ratio, contact%position, point)
            again%radius = point%radius
            again%load = point%load
            again%approach = point%approach
            slopes = [point%radius_slope, point%load_slope, point%approach_slope]
         else
            call get_disc(theory%lambda, theory%ratio, contact%adhesion_radius, again%load, again%approach)
         end if
      class default
         call theory%of_radius(contact%radius, again)
         if (contact%radius > 0) then
            call get_slopes(number, theory%ratio, contact%radius, slopes(2), slopes(3))
            slopes = [1.0_dp, slopes(2:3)]*contact%radius
         end if
      end select
      values = [contact%radius, contact%load, contact%approach]
      others = [again%radius, again%load, again%approach]
      sizes = max(abs(values), [tiny(mismatch), least_value, least_value])
      ! load and approach are differences of these
      terms = [contact%radius, contact%radius**3 + abs(contact%load - contact%radius**3), &
         & contact%radius**2 + abs(contact%approach - contact%radius**2)]
      prescribed = 1
      if (control == control_load) prescribed = 2
      if (control == control_approach) prescribed = 3
      ! at the end of stability what is prescribed has no slope, but a curvature of about that of a, a^3 or a^2
      powers = [contact%radius, contact%radius**3, contact%radius**2]
      shift = 0.5_dp
      if (round_off*terms(prescribed) < shift**2*powers(prescribed)) shift = sqrt(round_off*terms(prescribed)/powers(prescribed))
      if (round_off*terms(prescribed) < shift*abs(slopes(prescribed))) shift = round_off*terms(prescribed)/abs(slopes(prescribed))
      mismatch = maxval((abs(others - values) + abs(slopes)*shift + round_off*terms)/sizes)
   end function get_mismatch

   !> Changes of load and approach with the radius.
   pure subroutine get_slopes(number, ratio, radius, load_slope, approach_slope)
      !> `theory_jkr`; any other number means DMT or Hertz.
      integer, intent(in) :: number
      real(dp), intent(in) :: ratio
      !> Radius a of the contact, reduced, > 0.
      real(dp), intent(in) :: radius
      !> dP/da, reduced.
      real(dp), intent(out) :: load_slope
      !> d delta/da, reduced.
      real(dp), intent(out) :: approach_slope

      load_slope = 3*radius**2
      approach_slope = 2*radius
      if (number /= theory_jkr) return
      load_slope = load_slope - 1.5_dp*sqrt(6*ratio*radius)
      approach_slope = approach_slope - sqrt(6*ratio/radius)/3
   end subroutine get_slopes

end module adfric_round_sphere_theory_choice
