! SPDX-License-Identifier: GPL-3.0-or-later
!> Friction of Hertz's contact on an ellipse that slides over an elastic half-space by a law of the interface.
!>
!> The pressure is p0 u with u = sqrt(1 - x^2/a^2 - y^2/b^2), and rings of one u have the area 2 pi a b u du. So every integral over
!> the contact is one over u,
!>
!>     F = 2 pi a b int_0^1 tau(v, p0 u, T) u du
!>
!> The contact is that of frictionless faces. All parts of pressure and shear stress at a wave vector k depend on a^2 kx^2 + b^2 ky^2
!> alone, so the mean of cos^2 of the angle to the motion is b/(a + b) along the major axis and a/(a + b) along the minor one. With
!> it the shear stress changes the friction, to first order, by -2 (beta/E*) times that mean times int p q dA.
module adfric_plane_ellipse_interface
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_unset, only: is_set
   use adfric_interface_friction_law, only: friction_law_t
   use adfric_interface_friction_law_rows, only: given_law_t, get_friction_law
   use adfric_interface_shear_coupling, only: change_by_coupling
   use adfric_interface_total_friction, only: get_shear_of_area, interface_tractions, sliding_friction_t
   use adfric_numerics_double_exponential, only: integrand_t, integrate
   use adfric_plane_hertz_ellipse, only: ellipse_t
   use adfric_plane_hertz_variables, only: axis_minor, in => hertz_input, out => hertz_output
   use adfric_solid_contact_modulus, only: contact_modulus_of
   use adfric_solid_time_temperature, only: time_temperature_t
   implicit none (type, external)
   private
   public :: add_ellipse_interface, set_ellipse_tractions

   !> Integrands: the shear stress, its change by ln v, and pressure over p0 times shear stress.
   integer, parameter :: of_stress = 1, of_slope = 2, of_product = 3

   !> What is integrated over u, times u.
   type, extends(integrand_t) :: ring_t
      !> The law.
      type(friction_law_t) :: law
      !> Speed [m/s], temperature [K], and largest pressure [Pa].
      real(dp) :: speed = 0, temperature = 0, peak = 0
      !> One of `of_...`.
      integer :: what = of_stress
   contains
      procedure :: evaluate
   end type ring_t

contains

   !> The law of the interface.
   pure subroutine law_of_ellipse(values, given, law)
      real(dp), intent(in) :: values(:)
      type(given_law_t), intent(in) :: given
      type(friction_law_t), intent(out) :: law
      type(time_temperature_t) :: none

      call get_friction_law(values(in%friction), given, none, law)
   end subroutine law_of_ellipse

   !> Add the friction of the contact.
   pure subroutine add_ellipse_interface(values, given, ellipse, results, is_valid)
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> The table of the law.
      type(given_law_t), intent(in) :: given
      !> The contact.
      type(ellipse_t), intent(in) :: ellipse
      !> In: results of the contact. Out: with the friction; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Does the law hold, and have the integrals come to rest?
      logical, intent(out) :: is_valid
      type(ring_t) :: ring
      type(sliding_friction_t) :: friction
      real(dp) :: area, product

      call law_of_ellipse(values, given, ring%law)
      ring%speed = abs(values(in%velocity))
      ring%temperature = values(in%temperature)
      ring%peak = ellipse%peak_pressure
      area = pi*ellipse%major*ellipse%minor
      friction%direction = sign(1.0_dp, values(in%velocity))
      if (ring%law%depends_on_pressure() .and. area > 0) then
         call integrate_ring(ring, of_stress, area, friction%interfacial, is_valid)
         if (is_valid) call integrate_ring(ring, of_slope, area, friction%interfacial_slope, is_valid)
      else
         call get_shear_of_area(ring%law, ring%speed, ring%temperature, area, ellipse%load, friction%interfacial, &
            & friction%interfacial_slope, is_valid)
      end if
      if (.not. is_valid) return
      friction%neighbours = 0
      call friction%store(values(in%velocity), ellipse%load, results(out%friction_force), results(out%friction_coefficient), &
         & results(out%hysteretic_friction_force:out%velocity_slope))
      ! below two elastic bodies the coupling is not that of one of them
      if (is_set(values(in%second_young_modulus)) .or. .not. friction%interfacial > 0) return
      call integrate_ring(ring, of_product, area, product, is_valid)
      if (is_valid) results(out%coupling_left_out) = 2*share_along(values, ellipse)*change_by_coupling(values(in%poisson_ratio), &
         & contact_modulus_of(values(in%contact_modulus:in%second_poisson_ratio)), ring%peak*product, 0.0_dp, 0.0_dp, .false.) &
         & /friction%interfacial
   end subroutine add_ellipse_interface

   !> Mean of cos^2 of the angle between waves of the contact and the motion.
   pure real(dp) function share_along(values, ellipse) result(share)
      real(dp), intent(in) :: values(:)
      type(ellipse_t), intent(in) :: ellipse

      share = ellipse%minor/(ellipse%major + ellipse%minor)
      if (.not. is_set(values(in%tangential_axis))) return
      if (nint(values(in%tangential_axis)) == axis_minor) share = ellipse%major/(ellipse%major + ellipse%minor)
   end function share_along

   !> One of the integrals over the contact.
   pure subroutine integrate_ring(ring, what, area, integral, is_valid)
      type(ring_t), intent(inout) :: ring
      !> One of `of_...`.
      integer, intent(in) :: what
      !> Area of the contact [m^2].
      real(dp), intent(in) :: area
      !> The integral [N].
      real(dp), intent(out) :: integral
      !> Has it come to rest?
      logical, intent(out) :: is_valid

      ring%what = what
      call integrate(ring, 1.0_dp, integral, is_valid)
      integral = 2*area*integral
   end subroutine integrate_ring

   !> See `integrand_t`.
   pure real(dp) function evaluate(self, from_left, from_right)
      class(ring_t), intent(in) :: self
      !> u and 1 - u.
      real(dp), intent(in) :: from_left, from_right
      real(dp) :: u, stress, slope
      logical :: is_valid

      u = from_left
      if (from_right < from_left) u = 1 - from_right
      call self%law%get_stress(self%speed, self%peak*u, self%temperature, stress, slope, is_valid)
      select case (self%what)
      case (of_slope)
         stress = stress*slope
      case (of_product)
         stress = stress*u
      end select
      evaluate = stress*u
   end function evaluate

   !> Set the shear stress along x.
   pure subroutine set_ellipse_tractions(values, given, pressure, shear)
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> The table of the law.
      type(given_law_t), intent(in) :: given
      !> Pressure, 0 outside of contact [Pa]; shape `(n_x)`.
      real(dp), intent(in) :: pressure(:)
      !> Receives the shear stress [Pa]; shape `(n_x)`.
      real(dp), intent(out) :: shear(:)
      type(friction_law_t) :: law

      call law_of_ellipse(values, given, law)
      shear = interface_tractions(law, values(in%velocity), values(in%temperature), pressure, pressure > 0)
   end subroutine set_ellipse_tractions

end module adfric_plane_ellipse_interface
