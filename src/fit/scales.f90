! SPDX-License-Identifier: GPL-3.0-or-later
!> Units, bounds and refusals of a fit, before anything is searched.
module adfric_fit_scales
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: is_set
   use adfric_fit_problem, only: fit_t, free_t, nuisance_load_offset, nuisance_friction_offset, nuisance_contact_point, &
      & nuisance_spring_stiffness, nuisance_tilt, nuisance_drift_rate
   use adfric_fit_sphere_curve, only: is_sphere_curve
   use adfric_numerics_bounded_least_squares, only: most_variables
   use adfric_round_sphere_variables, only: in => sphere_input
   implicit none (type, external)
   private
   public :: scales_t, set_scales, find_refusal, least_lambda, largest_lambda

   !> Bounds of lambda where none are given: beyond them Maugis-Dugdale is DMT or JKR within any measurement.
   real(dp), parameter :: least_lambda = 0.01_dp, largest_lambda = 100.0_dp
   !> A variable that is fitted by its logarithm is within these, whatever its unit.
   real(dp), parameter :: least_value = 1.0e-90_dp, largest_value = 1.0e90_dp

   !> Units and bounds of the numbers that are fitted.
   type :: scales_t
      !> Units of the variables that are not fitted by their logarithm, else 1.
      real(dp), allocatable :: unit(:)
      !> Bounds of the numbers that are fitted.
      real(dp), allocatable :: lower(:), upper(:)
      !> The standard error that all points get where none is known; 0 where they are.
      real(dp) :: unknown_unit = 0
   end type scales_t

contains

   !> Find units and bounds.
   subroutine set_scales(self, fit)
      type(scales_t), intent(out) :: self
      type(fit_t), intent(in) :: fit
      real(dp) :: low, high
      integer :: k

      allocate (self%unit(size(fit%frees)), self%lower(size(fit%frees)), self%upper(size(fit%frees)))
      self%unknown_unit = 0
      do k = 1, size(fit%data_sets)
         if (allocated(fit%data_sets(k)%sigma)) cycle
         self%unknown_unit = max(self%unknown_unit, largest_of(fit%data_sets(k)%y)/100)
      end do
      do k = 1, size(fit%frees)
         associate (free => fit%frees(k))
            call get_bounds(fit, free, low, high)
            if (free%is_log) then
               self%unit(k) = 1
               self%lower(k) = log(max(low, least_value))
               self%upper(k) = log(min(high, largest_value))
            else
               self%unit(k) = unit_of(fit, free)
               self%lower(k) = max(low/self%unit(k), -largest_value)
               self%upper(k) = min(high/self%unit(k), largest_value)
            end if
         end associate
      end do
   end subroutine set_scales

   !> Bounds of a variable: those given, those of lambda, those of the model's table.
   pure subroutine get_bounds(fit, free, low, high)
      type(fit_t), intent(in) :: fit
      type(free_t), intent(in) :: free
      !> Receives the bounds.
      real(dp), intent(out) :: low, high

      low = -largest_value
      high = largest_value
      if (free%variable > 0) then
         associate (variable => fit%model%variables(free%variable))
            low = max(low, variable%lower)
            high = min(high, variable%upper)
            if (variable%name == 'lambda') then
               low = least_lambda
               high = largest_lambda
            end if
         end associate
      end if
      if (is_set(free%minimum)) low = free%minimum
      if (is_set(free%maximum)) high = free%maximum
   end subroutine get_bounds

   !> The size of a variable that is not fitted by its logarithm: the error of its prior, or a hundredth of what it shifts.
   pure real(dp) function unit_of(fit, free) result(unit)
      type(fit_t), intent(in) :: fit
      type(free_t), intent(in) :: free

      unit = 0
      if (is_set(free%prior_sigma)) unit = free%prior_sigma
      if (.not. unit > 0 .and. free%data_set > 0) then
         associate (data => fit%data_sets(free%data_set))
            select case (free%nuisance)
            case (nuisance_load_offset)
               unit = largest_of(data%y)
               if (fit%model%variables(data%abscissa)%name == 'load') unit = largest_of(data%x)
            case (nuisance_friction_offset)
               unit = largest_of(data%y)
            case (nuisance_contact_point)
               unit = largest_of(data%x)
               if (allocated(data%prescribed)) unit = largest_of(data%prescribed)
            case (nuisance_drift_rate)
               if (allocated(data%prescribed)) unit = largest_of(data%prescribed)/max(largest_of(data%x), tiny(unit))
            case (nuisance_tilt)
               unit = largest_of(data%y)/max(largest_of(data%x), tiny(unit))
            end select
         end associate
         unit = unit/100
      end if
      if (.not. unit > 0 .and. is_set(free%start)) unit = abs(free%start)/10
      if (.not. unit > 0 .and. is_set(free%maximum) .and. is_set(free%minimum)) unit = (free%maximum - free%minimum)/100
      if (.not. unit > 0) unit = 1
   end function unit_of

   !> The largest size of the numbers that are finite.
   pure real(dp) function largest_of(numbers)
      real(dp), intent(in) :: numbers(:)
      integer :: i

      largest_of = 0
      do i = 1, size(numbers)
         if (ieee_is_finite(numbers(i))) largest_of = max(largest_of, abs(numbers(i)))
      end do
   end function largest_of

   !> Why a fit cannot be done as it is asked for; empty if it can.
   subroutine find_refusal(fit, reason)
      !> The fit.
      type(fit_t), intent(in) :: fit
      !> Receives the reason.
      character(:), allocatable, intent(out) :: reason
      logical :: is_sphere, is_unknown
      integer :: k, n_unknown

      reason = ''
      if (.not. associated(fit%model)) reason = 'there is no model'
      if (size(fit%frees) < 1) reason = 'no variable is free'
      if (size(fit%frees) > most_variables - 2) reason = 'more than 10 variables are free'
      if (size(fit%data_sets) < 1) reason = 'there are no data'
      if (len(reason) > 0) return
      n_unknown = 0
      do k = 1, size(fit%data_sets)
         is_unknown = .not. allocated(fit%data_sets(k)%sigma)
         if (is_unknown) n_unknown = n_unknown + 1
         is_sphere = is_sphere_curve(fit, fit%data_sets(k))
         if (allocated(fit%data_sets(k)%x_sigma)) then
            if (is_unknown) reason = 'errors of the abscissa need those of the ordinate'
            if (is_set(fit%data_sets(k)%nuisance(nuisance_spring_stiffness)) .or. any(fit%frees%nuisance == &
               & nuisance_spring_stiffness)) reason = 'errors of the abscissa are not those of the base of a spring'
         else if (.not. is_sphere .and. (is_set(fit%data_sets(k)%nuisance(nuisance_spring_stiffness)) .or. &
            & any(fit%frees%nuisance == nuisance_spring_stiffness .and. fit%frees%data_set == k))) then
            reason = 'spring_stiffness belongs to a smooth paraboloid; other bodies have machine_stiffness of &operating, and '// &
               & 'the abscissa base_approach'
         end if
         if (is_sphere .and. fit%data_sets(k)%abscissa == in%load &
            & .and. is_set(fit%data_sets(k)%nuisance(nuisance_spring_stiffness))) &
            & reason = 'a spring needs the abscissa approach'
         if (len(reason) > 0) return
      end do
      if (n_unknown > 0 .and. n_unknown < size(fit%data_sets)) reason = 'one data set has standard errors and another one has none'
      if (n_unknown == 0) return
      if (any(is_set(fit%frees%prior))) reason = 'a prior needs standard errors of the points'
      if (allocated(fit%events)) then
         if (size(fit%events) > 0) reason = 'an event needs standard errors of the points'
      end if
   end subroutine find_refusal

end module adfric_fit_scales
