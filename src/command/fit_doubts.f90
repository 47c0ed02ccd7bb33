! SPDX-License-Identifier: GPL-3.0-or-later
!> What in a fit may not be what the user means: sizes that no contact has, points beyond the bounds of the theory, and residuals that
!> are not independent.
module adfric_command_fit_doubts
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use adfric_base_kinds, only: dp
   use adfric_base_text, only: newline, show_count, show_number
   use adfric_command_rounding, only: show_to_digits
   use adfric_fit_problem, only: fit_t, nuisance_tilt
   use adfric_fit_solution, only: solution_t, fit_solved
   use adfric_describe_doubt, only: doubt_limits, n_doubts, quantity_of
   implicit none (type, external)
   private
   public :: describe_fit_doubts

   !> Ranges of adhesion below and above are doubted [m].
   real(dp), parameter :: smallest_range = 0.05e-9_dp, largest_range = 5.0e-9_dp
   !> Correlations of neighbours beyond this in standard errors are doubted.
   real(dp), parameter :: most_lag = 3
   !> Below this part of its mean S is too small for noise.
   real(dp), parameter :: least_chi2 = 0.1_dp
   !> A slope of a base line is doubted beyond so many standard errors, and of so many points.
   real(dp), parameter :: most_slope = 6
   integer, parameter :: least_count = 8
   !> The runs of signs are doubted below this probability.
   real(dp), parameter :: least_runs = 1.0e-3_dp

contains

   !> A line for each doubt.
   function describe_fit_doubts(fit, solution) result(lines)
      type(fit_t), intent(in) :: fit
      type(solution_t), intent(in) :: solution
      character(:), allocatable :: lines

      lines = ''
      if (solution%status /= fit_solved) return
      lines = doubt_range(solution)//doubt_theory(solution)//doubt_base_lines(fit, solution)//doubt_residuals(solution)
   end function describe_fit_doubts

   !> Is the range of adhesion one of atoms?
   pure function doubt_range(solution) result(lines)
      type(solution_t), intent(in) :: solution
      character(:), allocatable :: lines
      integer :: i

      lines = ''
      if (.not. allocated(solution%derived)) return
      do i = 1, size(solution%derived)
         associate (item => solution%derived(i))
            if (item%name /= 'adhesion_range' .or. .not. ieee_is_finite(item%value)) cycle
            if (item%value >= smallest_range .and. item%value <= largest_range) cycle
            lines = 'warning: the range of adhesion w/sigma0 is '//show_to_digits(item%value, 2)//' m, usual are 0.05 nm ' &
               //'to 5 nm; are the units right?'//newline
         end associate
      end do
   end function doubt_range

   !> Do all points of contact lie within the bounds of the theory?
   function doubt_theory(solution) result(lines)
      type(solution_t), intent(in) :: solution
      character(:), allocatable :: lines
      integer :: i

      lines = ''
      do i = 1, n_doubts
         associate (measure => solution%measures(i), limit => doubt_limits(i))
            if (measure >= limit) lines = lines//'warning: '//quantity_of(i)//' is up to '//show_to_digits(measure, 2)// &
               ', the theory is off by a tenth or more from '//show_number(limit)//' on; are the units right?'//newline
         end associate
      end do
   end function doubt_theory

   !> Has a base line a slope that nothing in the fit takes up?
   function doubt_base_lines(fit, solution) result(lines)
      type(fit_t), intent(in) :: fit
      type(solution_t), intent(in) :: solution
      character(:), allocatable :: lines
      real(dp) :: slope, error
      integer :: k

      lines = ''
      if (.not. allocated(solution%data_sets)) return
      do k = 1, size(solution%data_sets)
         associate (set => fit%data_sets(k), found => solution%data_sets(k))
            if (.not. allocated(found%is_apart)) cycle
            if (fit%model%results(set%ordinate)%name /= 'load' .or. fit%model%variables(set%abscissa)%name == 'load') cycle
            if (any(fit%frees%nuisance == nuisance_tilt .and. fit%frees%data_set == k)) cycle
            if (count(found%is_apart) < least_count) cycle
            call find_slope(pack(set%x, found%is_apart), pack(set%y - found%fitted, found%is_apart), slope, error)
            if (.not. abs(slope) > most_slope*error) cycle
            lines = lines//'warning: the base line of '//set%name//' has a slope of '//show_to_digits(slope, 2)//' +- '// &
               show_to_digits(error, 2)//', which moves what is fitted; a free data['// &
               show_count(k)//']%tilt takes it up'//newline
         end associate
      end do
   end function doubt_base_lines

   !> Slope of a straight line through points of one error, and its standard error.
   pure subroutine find_slope(x, y, slope, error)
      real(dp), intent(in) :: x(:), y(:)
      real(dp), intent(out) :: slope, error
      real(dp) :: at(size(x)), remaining(size(x)), squares
      integer :: n

      n = size(x)
      at = x - sum(x)/n
      squares = sum(at**2)
      slope = 0
      error = 0
      if (.not. squares > 0) return
      slope = sum(at*y)/squares
      remaining = y - sum(y)/n - slope*at
      error = sqrt(sum(remaining**2)/(n - 2)/squares)
   end subroutine find_slope

   !> Are the residuals independent of each other?
   pure function doubt_residuals(solution) result(lines)
      type(solution_t), intent(in) :: solution
      character(:), allocatable :: lines

      lines = ''
      if (solution%chi2 < least_chi2*solution%degrees_of_freedom .and. .not. ieee_is_finite(solution%sigma_estimate)) then
         lines = 'warning: the residuals are far smaller than their standard errors'//newline
         return
      end if
      if (ieee_is_finite(solution%lag_correlation) .and. solution%points_used > 0) then
         if (solution%lag_correlation > most_lag/sqrt(real(solution%points_used, dp))) &
            lines = 'warning: neighbouring residuals have a correlation of '//show_to_digits(solution%lag_correlation, 2)// &
            '; the noise is not independent, or the model is not right, and the errors are too small'//newline
      end if
      if (.not. ieee_is_finite(solution%runs_p_value)) return
      if (solution%runs_p_value < least_runs) lines = lines//'warning: the signs of the residuals have a probability of '// &
         show_to_digits(solution%runs_p_value, 2)//'; the model is not right'//newline
   end function doubt_residuals

end module adfric_command_fit_doubts
