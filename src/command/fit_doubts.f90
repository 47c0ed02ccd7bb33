! SPDX-License-Identifier: GPL-3.0-or-later
!> What in a fit may not be what the user means: sizes that no contact has, points beyond the bounds of the theory, and residuals that
!> are not independent.
module adfric_command_fit_doubts
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use adfric_base_kinds, only: dp
   use adfric_base_text, only: newline, show_count, show_number
   use adfric_command_rounding, only: show_to_digits
   use adfric_base_unset, only: is_set
   use adfric_fit_parts, only: set_values_at
   use adfric_fit_problem, only: data_set_t, fit_t, nuisance_tilt
   use adfric_interface_heat_rows, only: usual_capacity, usual_conductivity
   use adfric_fit_solution, only: solution_t, fit_not_converged, fit_not_identifiable, fit_solved
   use adfric_describe_doubt, only: doubt_limits, n_doubts, quantity_of
   implicit none (type, external)
   private
   public :: describe_fit_doubts

   !> Ranges of adhesion below and above are doubted [m].
   real(dp), parameter :: smallest_range = 0.05e-9_dp, largest_range = 5.0e-9_dp
   !> Correlations of neighbours beyond this in standard errors are doubted.
   real(dp), parameter :: most_lag = 3
   !> Below this probability of a larger S the standard errors or the model are doubted.
   real(dp), parameter :: least_probability = 1.0e-4_dp
   !> Below this part of its mean S is too small for noise.
   real(dp), parameter :: least_chi2 = 0.1_dp
   !> A slope of a base line is doubted beyond so many standard errors, and of so many points.
   real(dp), parameter :: most_slope = 6
   integer, parameter :: least_count = 8
   !> A relaxation time is not known beyond this relative standard error; one of this part of the duration, or less, is a fast one.
   real(dp), parameter :: most_time_error = 0.5_dp, fast_part = 0.03_dp
   !> What two of them are together is known far better than each, below this part of the lesser error, and that is said from this
   !> relative error on.
   real(dp), parameter :: most_share = 0.2_dp
   !> The runs of signs are doubted below this probability.
   real(dp), parameter :: least_runs = 1.0e-3_dp

   !> What a curve says of arms.
   character(*), parameter :: what_curves_see = 'a curve sees arms of 0.03 to 1 times its duration, of faster ones the product '// &
      'of modulus and time, of slower ones the sum of moduli'

contains

   !> A line for each doubt.
   function describe_fit_doubts(fit, solution) result(lines)
      type(fit_t), intent(in) :: fit
      type(solution_t), intent(in) :: solution
      character(:), allocatable :: lines

      lines = ''
      if (any(solution%status == [fit_not_identifiable, fit_not_converged]) .and. count(of_times(fit)) > 0) &
         & lines = 'hint: '//what_curves_see//'; more arms than one need several speeds or a rest'//newline
      if (solution%status /= fit_solved) return
      lines = doubt_sums(fit, solution)//doubt_arms(fit, solution)//doubt_range(solution)//doubt_theory(solution)// &
         & doubt_heat_of_friction(fit, solution)//doubt_base_lines(fit, solution)//doubt_goodness(solution)// &
         & doubt_residuals(solution)
   end function describe_fit_doubts

   !> Which free variables are relaxation times, members of their list?
   pure function of_times(fit) result(is_time)
      type(fit_t), intent(in) :: fit
      logical :: is_time(size(fit%frees))
      integer :: i

      is_time = .false.
      do i = 1, size(is_time)
         if (fit%frees(i)%list == 0 .or. fit%frees(i)%variable == 0) cycle
         is_time(i) = index(fit%frees(i)%name, 'relaxation_times') > 0
      end do
   end function of_times

   !> Arms that the data do not tell apart, or of which they know a part alone.
   function doubt_arms(fit, solution) result(lines)
      type(fit_t), intent(in) :: fit
      type(solution_t), intent(in) :: solution
      character(:), allocatable :: lines
      logical :: is_time(size(fit%frees))
      real(dp) :: duration, relative, both
      integer :: i, k, partner

      lines = ''
      is_time = of_times(fit)
      ! a start has no errors yet
      if (.not. any(is_time) .or. .not. allocated(solution%error)) return
      duration = 0
      do k = 1, size(fit%data_sets)
         associate (x => fit%data_sets(k)%x)
            duration = max(duration, maxval(x, ieee_is_finite(x)) - minval(x, ieee_is_finite(x)))
         end associate
      end do
      do i = 1, size(is_time)
         if (.not. is_time(i)) cycle
         do k = 1, i - 1
            if (.not. is_time(k)) cycle
            if (abs(log(solution%estimate(i)/solution%estimate(k))) > solution%error(i)/solution%estimate(i) &
               + solution%error(k)/solution%estimate(k)) cycle
            lines = lines//'warning: '//fit%frees(k)%name//' and '//fit%frees(i)%name//' are one time within their errors; one '// &
               'arm is as good, more arms need several speeds or a rest'//newline
         end do
         if (.not. ieee_is_finite(solution%error(i))) cycle
         relative = solution%error(i)/solution%estimate(i)
         partner = modulus_of(fit, i)
         if (partner > 0) then
            if (is_no_arm(solution, partner, i)) then
               lines = lines//'warning: '//fit%frees(partner)%name//' is 0 within its error; the curve shows no such arm, and '// &
                  'is as good without it'//newline
               cycle
            end if
            both = error_of_both(solution, partner, i, 1)
            if (solution%estimate(i) < fast_part*duration .and. relative > most_share .and. both < most_share*relative) then
               lines = lines//'warning: of '//fit%frees(partner)%name//' and '//fit%frees(i)%name//' only the product is '// &
                  'known, a viscosity of '//show_to_digits(solution%estimate(i)*solution%estimate(partner), 3)//' Pa s to '// &
                  show_to_digits(100*both, 2)//' %'//newline
               cycle
            end if
         end if
         if (relative < most_time_error) cycle
         if (solution%estimate(i) > duration) then
            lines = lines//'warning: '//fit%frees(i)%name//' is longer than the curve; of such an arm only the sum of its '// &
               'modulus and the relaxed one is known'//newline
         else if (solution%estimate(i) < fast_part*duration) then
            lines = lines//'warning: '//fit%frees(i)%name//' is far shorter than the curve; of such an arm only the product of '// &
               'modulus and time, a viscosity, is known'//newline
         else
            lines = lines//'warning: '//fit%frees(i)%name//' is not known; '//what_curves_see//newline
         end if
      end do
   end function doubt_arms

   !> The free modulus of the arm of a free time; 0: there is none.
   pure integer function modulus_of(fit, time) result(at)
      type(fit_t), intent(in) :: fit
      !> Number of the free time.
      integer, intent(in) :: time

      do at = size(fit%frees), 1, -1
         if (fit%frees(at)%list == 0 .or. fit%frees(at)%member /= fit%frees(time)%member) cycle
         if (index(fit%frees(at)%name, 'moduli') > 0) return
      end do
   end function modulus_of

   !> Relative error of the product (+1) or the ratio (-1) of two estimates that are fitted by their logarithms.
   pure real(dp) function error_of_both(solution, first, second, sign) result(error)
      type(solution_t), intent(in) :: solution
      integer, intent(in) :: first, second, sign
      real(dp) :: parts(2)

      parts = solution%error([first, second])/solution%estimate([first, second])
      error = sqrt(max(0.0_dp, parts(1)**2 + parts(2)**2 + 2*sign*solution%correlation(first, second)*parts(1)*parts(2)))
   end function error_of_both

   !> Does an arm differ from none neither by its modulus, nor by its viscosity, nor by the speed at which it relaxes?
   pure logical function is_no_arm(solution, modulus, time)
      type(solution_t), intent(in) :: solution
      !> Numbers of the free modulus and the free time.
      integer, intent(in) :: modulus, time

      is_no_arm = solution%error(modulus) > most_time_error*solution%estimate(modulus) .and. &
         & min(error_of_both(solution, modulus, time, 1), error_of_both(solution, modulus, time, -1)) > most_time_error
   end function is_no_arm

   !> Moduli of which the data know little but the sum.
   pure function doubt_sums(fit, solution) result(lines)
      type(fit_t), intent(in) :: fit
      type(solution_t), intent(in) :: solution
      character(:), allocatable :: lines
      real(dp) :: error
      integer :: i, k

      lines = ''
      if (.not. allocated(solution%error) .or. .not. allocated(solution%correlation)) return
      do i = 1, size(fit%frees)
         if (.not. is_relaxed_modulus(fit%frees(i)%name) .or. .not. ieee_is_finite(solution%error(i))) cycle
         do k = 1, size(fit%frees)
            if (index(fit%frees(k)%name, 'moduli') == 0 .or. .not. ieee_is_finite(solution%error(k))) cycle
            associate (e => solution%error([i, k]))
               error = sqrt(max(0.0_dp, e(1)**2 + e(2)**2 + 2*solution%correlation(i, k)*e(1)*e(2)))
               if (error > most_share*minval(e) .or. maxval(e/solution%estimate([i, k])) < most_share) cycle
            end associate
            lines = lines//'warning: '//fit%frees(i)%name//' and '//fit%frees(k)%name//' are known by their sum, '// &
               show_to_digits(sum(solution%estimate([i, k])), 4)//' +- '//show_to_digits(error, 2)//' Pa, far better than each'// &
               newline
         end do
      end do
   end function doubt_sums

   !> Is it the relaxed modulus of a solid with arms?
   pure logical function is_relaxed_modulus(name)
      !> Name of a free variable, with its group or without.
      character(*), intent(in) :: name
      character(:), allocatable :: last

      last = name(index(name, '%', back=.true.) + 1:)
      is_relaxed_modulus = last == 'modulus' .or. last == 'young_modulus'
   end function is_relaxed_modulus

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

   !> Are there velocities at which the heat of friction changes the friction?
   function doubt_heat_of_friction(fit, solution) result(lines)
      type(fit_t), intent(in) :: fit
      type(solution_t), intent(in) :: solution
      character(:), allocatable :: lines
      real(dp) :: values(size(fit%base)), fastest, least
      integer :: g, velocity

      lines = ''
      velocity = 0
      do g = 1, size(values)
         if (fit%model%variables(g)%name == 'velocity') velocity = g
      end do
      if (velocity == 0) return
      do g = 1, size(fit%data_sets)
         associate (set => fit%data_sets(g))
            if (index(fit%model%results(set%ordinate)%name, 'friction') == 0) cycle
            call take_fastest(fit, solution, set, velocity, values)
            fastest = abs(values(velocity))
            least = fit%model%velocity_of_heat(values)
            if (.not. (is_set(least) .and. is_set(fastest) .and. fastest >= least)) cycle
            lines = lines//'warning: '//set%name//' goes up to '//show_to_digits(fastest, 2)//' m/s, and heat changes the '// &
               'shear stress by a hundredth from '//show_to_digits(least, 2)//' m/s on'
            if (counts_heat(fit, values)) then
               lines = lines//'; what is fitted depends on &heat'//newline
            else
               lines = lines//' in a polymer of '//show_number(usual_conductivity)//' W/m/K and '//show_number(usual_capacity)// &
                  ' J/m^3/K; without &heat it is not counted'//newline
            end if
         end associate
      end do
   end function doubt_heat_of_friction

   !> Does the input count heat?
   pure logical function counts_heat(fit, values)
      type(fit_t), intent(in) :: fit
      !> Values of all variables.
      real(dp), intent(in) :: values(:)
      integer :: k

      counts_heat = .false.
      do k = 1, size(values)
         if (fit%model%variables(k)%group == 'heat' .and. is_set(values(k))) counts_heat = .true.
      end do
   end function counts_heat

   !> Values of the point with the largest velocity.
   subroutine take_fastest(fit, solution, set, velocity, values)
      type(fit_t), intent(in) :: fit
      type(solution_t), intent(in) :: solution
      !> The points.
      type(data_set_t), intent(in) :: set
      !> Index of the velocity among the variables.
      integer, intent(in) :: velocity
      !> Receives the values of all variables.
      real(dp), intent(out) :: values(:)
      real(dp) :: speed(size(set%x))
      integer :: k, other

      values = fit%base
      do k = 1, size(fit%frees)
         if (fit%frees(k)%variable > 0) values(fit%frees(k)%variable) = solution%estimate(k)
      end do
      speed = abs(values(velocity))
      if (set%abscissa == velocity) speed = abs(set%x)
      if (allocated(set%others)) then
         other = findloc(set%others, velocity, 1)
         if (other > 0) speed = abs(set%at(other, :))
      end if
      where (.not. ieee_is_finite(speed)) speed = -1
      if (allocated(set%is_used)) speed = merge(speed, -1.0_dp, set%is_used)
      k = maxloc(speed, 1)
      if (k == 0) return
      values(set%abscissa) = set%x(k)
      call set_values_at(set, k, values)
   end subroutine take_fastest

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

   !> Is S what the standard errors of the points make of it? An S by which these were found says nothing.
   pure function doubt_goodness(solution) result(lines)
      type(solution_t), intent(in) :: solution
      character(:), allocatable :: lines

      lines = ''
      if (solution%degrees_of_freedom < 1 .or. ieee_is_finite(solution%sigma_estimate)) return
      if (.not. ieee_is_finite(solution%p_value)) return
      if (solution%p_value < least_probability) lines = 'warning: S = '//show_to_digits(solution%chi2, 3)//' is far above n = ' &
         //show_count(solution%degrees_of_freedom)//' degrees of freedom: the model does not fit, or the standard errors of the ' &
         //'points are too small, by '//show_to_digits(sqrt(solution%chi2/solution%degrees_of_freedom), 2)//' times'//newline
   end function doubt_goodness

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
