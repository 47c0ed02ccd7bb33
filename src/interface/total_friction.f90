! SPDX-License-Identifier: GPL-3.0-or-later
!> The friction of a sliding body as a sum: what the solid loses under the pressure, and the shear of the interface.
!>
!>     T = T_s + mean(q),   T_s = -mean(p h_x),   q = tau(v, p, T) where the surfaces touch, 0 in gaps
!>
!> to first order in the slope: the slip velocity is that of the body. The shear q does not move the contact on columns, and on a
!> half-space of Poisson's ratio 1/2; else it does by an amount that beta q over the pressure tells,
!> beta = (1 - 2 nu)/(2 (1 - nu)), which is left out here.
!>
!> The slope of T over the velocity is taken at the prescribed load or depth and temperature: that of the contact by differences, that
!> of the law as it is.
module adfric_interface_total_friction
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_unset, only: is_set
   use adfric_interface_friction_law, only: friction_law_t
   use adfric_describe_rows, only: result_row
   use adfric_describe_table, only: result_t
   implicit none (type, external)
   private
   public :: sliding_friction_t, total_friction_results, get_shear_of_area, interface_tractions, doubt_coupling, coupling_of
   public :: n_total_results, near_ratios

   !> Number of the results of `total_friction_results`.
   integer, parameter :: n_total_results = 4
   !> Steps of ln v, and velocities at which a contact is solved for its slope, over that of the point.
   real(dp), parameter :: step = 5.0e-3_dp, near_ratios(4) = exp(step*[-2, -1, 1, 2])

   !> Friction of a point, in any unit of a stress or a force.
   type :: sliding_friction_t
      !> 1 for a velocity >= 0, or -1.
      real(dp) :: direction = 1
      !> Of losses, with the sign of the velocity or, on a leading slope, against it; that of the interface, >= 0; and its change by
      !> ln v in this contact.
      real(dp) :: hysteretic = 0, interfacial = 0, interfacial_slope = 0
      !> Change of the sum by ln v with the contact, where it is known and needs no neighbours.
      real(dp) :: contact_slope = 0
      !> Sums of both at the velocities of `near_ratios`, with the law at the velocity of the point; NaN where not solved. Of those
      !> furthest off both may be left out.
      real(dp) :: neighbours(4) = 0
      !> Are those furthest off there?
      logical :: has_outer = .true.
   contains
      procedure :: get_results
      procedure :: store
   end type sliding_friction_t

contains

   !> The rows of the results: both parts, the share of the interface, and the slope.
   function total_friction_results(kind, unit) result(rows)
      !> `force` or `stress`, and its unit.
      character(*), intent(in) :: kind, unit
      type(result_t) :: rows(n_total_results)

      rows(1) = result_row(name='hysteretic_friction_'//kind, unit=unit, long_name='part of the friction that the losses of the ' &
         & //'solid make, by the pressure on the slopes')
      rows(2) = result_row(name='interfacial_friction_'//kind, unit=unit, long_name='part of the friction that the shear stress ' &
         & //'in contact makes')
      rows(3) = result_row(name='interfacial_share', unit='-', long_name='interfacial part over the friction')
      rows(4) = result_row(name='velocity_slope', unit='-', long_name='d ln T/d ln v of the friction T over the velocity v at ' &
         & //'this temperature; below 0 steady sliding may be unstable')
   end function total_friction_results

   !> The total and what stands in the rows of `total_friction_results`.
   pure subroutine get_results(self, velocity, total, parts)
      class(sliding_friction_t), intent(in) :: self
      !> Velocity [m/s].
      real(dp), intent(in) :: velocity
      !> The friction, with the sign of the velocity.
      real(dp), intent(out) :: total
      !> The results; shape `(n_total_results)`.
      real(dp), intent(out) :: parts(:)
      real(dp) :: change

      total = self%direction*(self%hysteretic + self%interfacial)
      parts(:2) = self%direction*[self%hysteretic, self%interfacial]
      parts(3:) = not_a_number()
      if (.not. abs(total) > 0) return
      parts(3) = self%direction*self%interfacial/total
      if (.not. abs(velocity) > 0) return
      change = self%contact_slope
      associate (t => self%neighbours)
         if (self%has_outer) change = change + (8*(t(3) - t(2)) - (t(4) - t(1)))/(12*step)
         if (.not. self%has_outer) change = change + (t(3) - t(2))/(2*step)
      end associate
      parts(4) = self%direction*(change + self%interfacial_slope)/total
   end subroutine get_results

   !> Store the friction, its ratio to a load, and what stands in the rows of `total_friction_results`.
   pure subroutine store(self, velocity, load, total, coefficient, parts)
      class(sliding_friction_t), intent(in) :: self
      !> Velocity [m/s], and load in the unit of the friction.
      real(dp), intent(in) :: velocity, load
      !> The friction, with the sign of the velocity.
      real(dp), intent(out) :: total
      !> Receives friction over load [-] where the load presses.
      real(dp), intent(inout) :: coefficient
      !> The results; shape `(n_total_results)`.
      real(dp), intent(out) :: parts(:)

      call self%get_results(velocity, total, parts)
      if (load > 0) coefficient = total/load
   end subroutine store

   !> Shear of an interface whose stress is the same in all of the contact but for what goes with the pressure itself.
   pure subroutine get_shear_of_area(law, speed, temperature, area, load, shear, slope, is_valid)
      !> A law for which `depends_on_pressure` is false.
      type(friction_law_t), intent(in) :: law
      !> Speed [m/s], >= 0.
      real(dp), intent(in) :: speed
      !> Temperature [K].
      real(dp), intent(in) :: temperature
      !> Contact, as a share of the nominal area or as an area [-, m, or m^2].
      real(dp), intent(in) :: area
      !> What contact carries: the load, and the tension of adhesion outside of it [Pa, N/m, or N].
      real(dp), intent(in) :: load
      !> Shear, >= 0, and its change by ln v [unit of the load].
      real(dp), intent(out) :: shear, slope
      !> Does the law hold at this speed and temperature?
      logical, intent(out) :: is_valid
      type(friction_law_t) :: without
      real(dp) :: stress, slope_of_stress

      shear = 0
      slope = 0
      without = law
      without%pressure_factor = 0
      call without%get_stress(speed, 0.0_dp, temperature, stress, slope_of_stress, is_valid)
      if (.not. is_valid .or. .not. area > 0) return
      ! the sum of load and tension is rounded
      shear = max(stress*area + law%pressure_factor*load, 0.0_dp)
      if (shear > 0) slope = slope_of_stress*stress*area
   end subroutine get_shear_of_area

   !> Shear stress of profiles and maps [Pa], with the sign of the velocity; NaN where the law does not hold.
   elemental function interface_tractions(law, velocity, temperature, pressure, is_contact) result(stress)
      !> The law of the interface.
      type(friction_law_t), intent(in) :: law
      !> Velocity [m/s].
      real(dp), intent(in) :: velocity
      !> Temperature [K].
      real(dp), intent(in) :: temperature
      !> Pressure, below 0 where adhesion pulls [Pa].
      real(dp), intent(in) :: pressure
      !> Do the surfaces touch?
      logical, intent(in) :: is_contact
      real(dp) :: stress, slope
      logical :: is_valid

      stress = 0
      if (.not. is_contact) return
      call law%get_stress(abs(velocity), pressure, temperature, stress, slope, is_valid)
      stress = sign(1.0_dp, velocity)*stress
      if (.not. is_valid) stress = not_a_number()
   end function interface_tractions

   !> beta, by which the shear stress over the modulus tilts the surface of a half-space [-].
   pure real(dp) function coupling_of(poisson_ratio) result(beta)
      !> Poisson's ratio [-].
      real(dp), intent(in) :: poisson_ratio

      beta = (1 - 2*poisson_ratio)/(2*(1 - poisson_ratio))
   end function coupling_of

   !> A line on the shear stress that would move the contact; nothing where it does not, or where Poisson's ratio is not known.
   function doubt_coupling(poisson_ratio) result(text)
      !> Poisson's ratio of a half-space [-], or unset.
      real(dp), intent(in) :: poisson_ratio
      character(:), allocatable :: text
      character(250) :: line

      text = ''
      if (.not. is_set(poisson_ratio)) return
      if (.not. coupling_of(poisson_ratio) > 0) return
      write (line, '(a, f6.3, a, f6.3, a)') 'shear stress moves the contact where Poisson''s ratio is below 0.5, here', &
         & poisson_ratio, ': by m =', coupling_of(poisson_ratio), ' times mu; coupling_left_out is how much is left out'
      text = trim(line)//new_line('a')
   end function doubt_coupling

end module adfric_interface_total_friction
