!> The model `wave_1d`: a sinusoidal wave on an elastic half-plane (Westergaard).
module adfric_classical_wave_model
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_classical_contact_conditions, only: largest_violation
   use adfric_classical_model, only: halfspace_model_t
   use adfric_classical_westergaard, only: wave_half_width, wave_pressure, wave_gap, wave_mean_gap, wave_penetration, &
      & find_wave_pressure
   use adfric_material_contact_modulus, only: set_modulus_rows, contact_modulus_of, check_contact_modulus
   use adfric_model_pointwise, only: point_state_t
   use adfric_model_check, only: require, require_one
   use adfric_model_rows, only: positive, number, contact_profiles, result_row
   use adfric_model_status, only: status_solved, status_no_equilibrium, status_not_converged
   use adfric_model_table, only: result_t, variable_t, profile_axis_t
   implicit none (type, external)
   private
   public :: wave_model_t, new_wave_model

   !> Places of the variables and of the results.
   integer, parameter, public :: v_period = 1, v_amplitude = 2, v_contact_modulus = 3, v_second_poisson_ratio = 7, &
      & v_mean_pressure = 8, v_penetration = 9
   integer, parameter, public :: r_mean_pressure = 1, r_penetration = 2, r_contact_width = 3, r_contact_fraction = 4, &
      & r_peak_pressure = 5, r_mean_gap = 6, r_largest_gap = 7, r_full_contact_pressure = 8, r_regime = 9, r_violation = 10
   integer, parameter, public :: regime_none = 0, regime_partial = 1, regime_full = 2
   !> Places where the conditions of contact are checked, in the contact and beside it.
   integer, parameter :: n_places = 16

   !> The model `wave_1d`.
   type, extends(halfspace_model_t) :: wave_model_t
   contains
      procedure :: check_case
      procedure :: solve_point
      procedure :: fill_profiles
   end type wave_model_t

contains

   !> The model with its tables.
   subroutine new_wave_model(self)
      !> The new model; receives its tables.
      type(wave_model_t), intent(out) :: self
      type(variable_t) :: v(v_penetration)
      type(result_t) :: r(10)

      v(v_period) = positive(group='surface', name='period', unit='m', meaning='wavelength l')
      v(v_amplitude) = positive(group='surface', name='amplitude', unit='m', meaning='D of the wave z = D (1 - cos 2 pi x/l)')
      call set_modulus_rows(positive(group='solid', name='contact_modulus', unit='Pa', meaning=''), &
         & v(v_contact_modulus:v_second_poisson_ratio))
      v(v_mean_pressure) = number(group='operating', name='mean_pressure', unit='Pa', meaning='load over nominal area', &
         & lower=0.0_dp)
      v(v_penetration) = number(group='operating', name='penetration', unit='m', &
         & meaning='approach of the mean planes since first touch, instead')
      r(r_mean_pressure) = result_row(name='mean_pressure', unit='Pa', long_name='load over nominal area', is_main=.true.)
      r(r_penetration) = result_row(name='penetration', unit='m', long_name='approach of the mean planes since first touch', &
         & is_main=.true.)
      r(r_contact_width) = result_row(name='contact_width', unit='m', long_name='width 2a of contact on one wave', is_main=.true.)
      r(r_contact_fraction) = result_row(name='contact_fraction', unit='-', long_name='share of the wave in contact')
      r(r_peak_pressure) = result_row(name='peak_pressure', unit='Pa', long_name='pressure on the crests', is_main=.true.)
      r(r_mean_gap) = result_row(name='mean_gap', unit='m', long_name='mean gap')
      r(r_largest_gap) = result_row(name='largest_gap', unit='m', long_name='gap in the troughs')
      r(r_full_contact_pressure) = result_row(name='full_contact_pressure', unit='Pa', &
         & long_name='p* = pi E* D/l, where full contact begins')
      r(r_regime) = result_row(name='regime', unit='-', long_name='regime', flag_meanings='no_contact partial full')
      r(r_violation) = result_row(name='contact_violation', unit='-', long_name='largest violation of g >= 0, p >= 0, g p = 0')
      call self%set_tables(name='wave_1d', &
         & summary='a sinusoidal wave on an elastic half-plane: pressure and gap up to full contact', variables=v, results=r, &
         & profiles=contact_profiles(), axes='x', is_depth=.false.)
      self%solids = [v_contact_modulus, v_second_poisson_ratio]
   end subroutine new_wave_model

   !> See `halfspace_model_t`.
   subroutine check_case(self, values, problems)
      !> The model; its tables give the variables their names.
      class(wave_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      call require(self%variables, values, [v_period, v_amplitude], problems)
      call check_contact_modulus(self%variables(v_contact_modulus:v_second_poisson_ratio), &
         & values(v_contact_modulus:v_second_poisson_ratio), problems, .false.)
      call require_one(self%variables, values, [v_mean_pressure, v_penetration], .true., problems)
   end subroutine check_case

   !> Pressure p* of full contact.
   pure real(dp) function full_pressure(values)
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      full_pressure = pi*contact_modulus_of(values(v_contact_modulus:v_second_poisson_ratio))*(values(v_amplitude)/values(v_period))
   end function full_pressure

   !> See `pointwise_model_t`. Beyond full contact the penetration of a half-plane is undefined.
   subroutine solve_point(self, values, state, results, error_estimate, status, counts)
      !> The model; nothing is read from it here.
      class(wave_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Nothing is left for the next point.
      class(point_state_t), allocatable, intent(inout) :: state
      !> In: all NaN. Out: results of the point, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Estimated relative error of the main result [-].
      real(dp), intent(out) :: error_estimate
      !> Status of the point, one of `status_...`.
      integer, intent(out) :: status
      !> These models count nothing; size 0.
      real(dp), intent(inout) :: counts(:)
      real(dp) :: q, p, d, half_width, x(n_places), lift
      integer :: i
      logical :: is_converged

      status = status_solved
      error_estimate = epsilon(error_estimate)
      p = full_pressure(values)
      d = values(v_amplitude)
      results(r_full_contact_pressure) = p
      lift = 0
      if (is_set(values(v_mean_pressure))) then
         q = values(v_mean_pressure)/p
         results([r_mean_pressure, r_penetration]) = [values(v_mean_pressure), d*wave_penetration(q)]
      else
         if (values(v_penetration) > d) status = status_no_equilibrium
         if (status /= status_solved) return
         call find_wave_pressure(values(v_penetration)/d, q, is_converged)
         if (.not. is_converged) status = status_not_converged
         if (status /= status_solved) return
         results([r_mean_pressure, r_penetration]) = [q*p, values(v_penetration)]
         lift = max(0.0_dp, -values(v_penetration))
      end if
      half_width = wave_half_width(q)
      results(r_contact_fraction) = 2*half_width
      results(r_contact_width) = results(r_contact_fraction)*values(v_period)
      results(r_peak_pressure) = p*wave_pressure(q, 0.0_dp)
      results([r_mean_gap, r_largest_gap]) = d*[wave_mean_gap(q), wave_gap(q, 0.5_dp)] + lift
      results(r_regime) = regime_partial
      if (.not. q > 0) results(r_regime) = regime_none
      if (q >= 1) results(r_regime) = regime_full
      x = [((i - 0.5_dp)/n_places, i=1, n_places)]
      associate (places => [half_width*x, half_width + (0.5_dp - half_width)*x])
         results(r_violation) = largest_violation(wave_pressure(q, places), wave_gap(q, places), 1.0_dp, 1.0_dp)
      end associate
      associate (unused => self, unused_state => state, unused_counts => counts)
      end associate
   end subroutine solve_point

   !> See `pointwise_model_t`.
   subroutine fill_profiles(self, values, results, state, axes, profiles)
      !> The model; nothing is read from it here.
      class(wave_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> What `solve_block` found for this point; shape `(n_results)`.
      real(dp), intent(in) :: results(:)
      !> What `solve_point` has left, not used here.
      class(point_state_t), allocatable, intent(in) :: state
      !> Axes of the profiles, the slowest first.
      type(profile_axis_t), intent(in) :: axes(:)
      !> In: all NaN. Out: profiles of the point; shape `(n_fast, n_slow, n_profiles)`.
      real(dp), intent(inout) :: profiles(:, :, :)
      real(dp) :: q, p, lift

      lift = 0
      if (is_set(values(v_penetration))) then
         if (values(v_penetration) > values(v_amplitude)) return
         lift = max(0.0_dp, -values(v_penetration))
      end if
      p = full_pressure(values)
      q = results(r_mean_pressure)/p
      profiles(:, 1, 1) = p*wave_pressure(q, axes(1)%coordinates/values(v_period))
      profiles(:, 1, 2) = values(v_amplitude)*wave_gap(q, axes(1)%coordinates/values(v_period)) + lift
      associate (unused => self, unused_state => state)
      end associate
   end subroutine fill_profiles

end module adfric_classical_wave_model
