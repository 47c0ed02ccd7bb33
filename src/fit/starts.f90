! SPDX-License-Identifier: GPL-3.0-or-later
!> Where a search starts: the user's values, or what the data say at a glance.
!>
!> Of a sphere: w from the lowest load in contact, or the pull-off event, with the reduced pull-off load of the theory (-3/2 to -2);
!> the zero of the load from the free points, the contact point from the first contact, E* from the largest load and its approach
!> (Hertz), or from the size of an area, tau0 from the size of a friction force. The last two are exact scalings, of powers -2/3 and 1, at
!> given w and lambda.
module adfric_fit_starts
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_unset, only: is_set
   use adfric_fit_curve_starts, only: find_curve_starts, has_curve_starts
   use adfric_fit_objective, only: objective_t, take_estimate
   use adfric_fit_problem, only: fit_t, event_pull_off_load, event_jump_in_approach, nuisance_load_offset, &
      & nuisance_friction_offset, nuisance_contact_point, nuisance_lateral_gain, nuisance_spring_stiffness
   use adfric_fit_sphere_basis, only: theory_of
   use adfric_fit_time_starts, only: level_moduli, scale_moduli, touch_of
   use adfric_fit_path, only: sphere_path_t, set_path
   use adfric_solid_contact_modulus, only: contact_modulus_of
   use adfric_numerics_bounded_least_squares, only: squares_work_t
   use adfric_round_sphere_contact, only: theory_hertz
   use adfric_round_sphere_units, only: get_sphere_units
   use adfric_round_sphere_variables, only: in => sphere_input, out => sphere_output
   implicit none (type, external)
   private
   public :: get_start, get_more_starts, lambda_free, position_of_lambda

   !> Sizes where nothing better is known: lambda, E* [Pa], tau0 [Pa], R [m], x.
   real(dp), parameter :: usual_lambda = 1.0_dp, usual_modulus = 1.0e9_dp, usual_strength = 1.0e8_dp, usual_radius = 1.0e-6_dp, &
      & usual_edge = 0.4_dp

contains

   !> Which free variable sets lambda; 0: none.
   pure integer function lambda_free(fit)
      type(fit_t), intent(in) :: fit
      integer :: k

      lambda_free = 0
      do k = 1, size(fit%frees)
         if (fit%frees(k)%variable == 0 .or. .not. fit%frees(k)%is_log) cycle
         associate (name => fit%model%variables(fit%frees(k)%variable)%name)
            if (name == 'lambda') lambda_free = k
            if (fit%model%name /= 'sphere') cycle
            if (name == 'adhesion_stress' .or. name == 'adhesion_range') lambda_free = k
         end associate
      end do
   end function lambda_free

   !> The number that is fitted where lambda has a value: ln of lambda, of the stress or of the range of adhesion.
   pure real(dp) function position_of_lambda(self, free, lambda, v) result(position)
      type(objective_t), intent(in) :: self
      !> Number of the free variable that sets lambda.
      integer, intent(in) :: free
      real(dp), intent(in) :: lambda
      !> Values of the free variables, of which those beside this one count.
      real(dp), intent(in) :: v(:)
      type(objective_t) :: other
      real(dp) :: length, approach, force, stress

      position = log(lambda)
      if (self%frees(free)%variable == in%lambda .or. size(self%spheres) == 0) return
      other%n_free = self%n_free
      other%frees = self%frees
      other%values = self%spheres(1)%values_of(self%values)
      other%nuisance = self%nuisance
      call other%set_values(v)
      associate (values => other%values)
         call get_sphere_units(values(in%radius), contact_modulus_of(values(in%contact_modulus:in%second_poisson_ratio)), &
            & values(in%work_of_adhesion), length, approach, force, stress)
         position = log(lambda*stress)
         if (self%frees(free)%variable == in%adhesion_range) position = log(values(in%work_of_adhesion)/(lambda*stress))
      end associate
   end function position_of_lambda

   !> A start, with lambda at a value where the user gives none.
   subroutine get_start(self, fit, lambda, work, q)
      type(objective_t), intent(inout) :: self
      type(fit_t), intent(in) :: fit
      !> Maugis's parameter; not set: the user's, or 1.
      real(dp), intent(in) :: lambda
      type(squares_work_t), intent(inout) :: work
      !> Receives the numbers that are fitted.
      real(dp), intent(out) :: q(:)
      real(dp) :: v(size(q)), value
      real(dp), allocatable :: starts(:, :)
      integer :: k, of_lambda

      of_lambda = lambda_free(fit)
      value = usual_lambda
      if (is_set(lambda)) value = lambda
      do k = 1, size(q)
         v(k) = plain_start(self, fit, k)
      end do
      call self%set_values(v)
      if (of_lambda > 0) then
         if (is_set(lambda) .or. .not. is_set(fit%frees(of_lambda)%start)) then
            v(of_lambda) = exp(position_of_lambda(self, of_lambda, value, v))
         end if
      end if
      call self%set_values(v)
      if (size(self%spheres) > 0) call look_at_loads(self, fit, value, v)
      if (of_lambda > 0) then
         if (is_set(lambda)) v(of_lambda) = exp(position_of_lambda(self, of_lambda, value, v))
      end if
      allocate (starts(size(v), 0))
      if (size(self%others) > 0) then
         if (has_curve_starts(fit)) call find_curve_starts(self, fit, v, starts)
      end if
      if (size(starts, 2) > 0) v = starts(:, 1)
      call take_numbers(self, v, q)
      if (size(self%spheres) > 0) call look_at_sizes(self, fit, work, v, q)
      if (any([(allocated(fit%data_sets(k)%prescribed), k=1, size(fit%data_sets))])) call look_at_moduli(self, fit, work, v, q)
   end subroutine get_start

   !> Starts beside the first one, the best first; none where a look at the curve says nothing.
   subroutine get_more_starts(self, fit, first, starts)
      type(objective_t), intent(inout) :: self
      type(fit_t), intent(in) :: fit
      !> The first start, as numbers that are fitted.
      real(dp), intent(in) :: first(:)
      !> Receives the numbers that are fitted; shape `(n_free, n)`.
      real(dp), allocatable, intent(out) :: starts(:, :)
      real(dp) :: v(size(first)), slopes(size(first))
      real(dp), allocatable :: found(:, :)
      integer :: k

      allocate (starts(size(first), 0))
      if (.not. has_curve_starts(fit)) return
      call take_estimate(self, first, v, slopes)
      call find_curve_starts(self, fit, v, found)
      ! the first one is the best of them already, but for a sphere
      if (size(self%others) > 0 .and. size(found, 2) > 0) found = found(:, 2:)
      if (size(found, 2) == 0) return
      starts = found
      do k = 1, size(starts, 2)
         call take_numbers(self, found(:, k), starts(:, k))
      end do
   end subroutine get_more_starts

   !> The numbers that are fitted, within their bounds.
   pure subroutine take_numbers(self, v, q)
      type(objective_t), intent(in) :: self
      real(dp), intent(in) :: v(:)
      !> Receives the numbers.
      real(dp), intent(out) :: q(:)

      where (self%frees%is_log)
         q = log(max(v, tiny(v)))
      elsewhere
         q = v/self%unit
      end where
      q = min(max(q, self%lower), self%upper)
   end subroutine take_numbers

   !> The user's start of a variable, or a usual size.
   real(dp) function plain_start(self, fit, k) result(value)
      type(objective_t), intent(in) :: self
      type(fit_t), intent(in) :: fit
      !> Number of the free variable.
      integer, intent(in) :: k

      associate (free => fit%frees(k))
         value = free%start
         if (is_set(value)) return
         value = free%prior
         if (is_set(value)) return
         if (free%nuisance > 0) then
            value = start_of_nuisance(fit, free%data_set, free%nuisance)
            return
         end if
         if (fit%model%name == 'sphere') then
            value = start_of_sphere(free%variable)
            return
         end if
         value = fit%model%variables(free%variable)%default
         if (is_set(value) .and. (value > 0 .or. .not. free%is_log)) return
         value = 1
         if (is_set(free%minimum) .and. is_set(free%maximum)) then
            value = (free%minimum + free%maximum)/2
            if (free%is_log) value = sqrt(free%minimum*free%maximum)
         end if
      end associate
      associate (unused => self)
      end associate
   end function plain_start

   !> A usual size of a variable of the sphere.
   pure real(dp) function start_of_sphere(variable) result(value)
      !> Position of the variable.
      integer, intent(in) :: variable

      select case (variable)
      case (in%radius)
         value = usual_radius
      case (in%lambda)
         value = usual_lambda
      case (in%edge_fraction)
         value = usual_edge
      case (in%shear_strength)
         value = usual_strength
      case (in%work_of_adhesion)
         value = 0.05_dp
      case (in%adhesion_range)
         value = 1.0e-9_dp
      case default
         value = usual_modulus
      end select
   end function start_of_sphere

   !> A nuisance as the data show it: zeros from the free points, the contact point from the first contact, a spring from the slope of
   !> the stiffest part.
   pure real(dp) function start_of_nuisance(fit, data_set, nuisance) result(value)
      type(fit_t), intent(in) :: fit
      integer, intent(in) :: data_set
      !> One of `nuisance_...`.
      integer, intent(in) :: nuisance
      logical, dimension(size(fit%data_sets(data_set)%x)) :: is_number, is_contact, is_first
      logical :: is_load
      integer :: k

      associate (data => fit%data_sets(data_set))
         is_number = ieee_is_finite(data%x) .and. ieee_is_finite(data%y)
         is_contact = is_number
         if (allocated(data%is_contact)) is_contact = is_number .and. data%is_contact
         is_first = is_contact
         if (allocated(data%segment) .and. any(is_contact)) is_first = is_first .and. data%segment == minval(data%segment, &
            & is_contact)
         if (.not. any(is_first)) is_first = is_contact
         is_load = fit%model%results(data%ordinate)%name == 'load'
         value = 0
         select case (nuisance)
         case (nuisance_lateral_gain)
            value = 1
         case (nuisance_load_offset)
            if (is_load .and. any(is_number .neqv. is_contact)) value = sum(data%y, is_number .and. .not. is_contact) &
               & /count(is_number .and. .not. is_contact)
         case (nuisance_friction_offset)
            if (.not. is_load .and. any(is_number .neqv. is_contact)) value = sum(data%y, is_number .and. &
               & .not. is_contact)/count(is_number .and. .not. is_contact)
         case (nuisance_contact_point)
            if (any(is_first)) value = minval(data%x, is_first)
            if (allocated(data%prescribed)) value = touch_of(pack(data%prescribed, is_first), pack(data%y, is_first))
            if (allocated(fit%events)) then
               do k = 1, size(fit%events)
                  if (fit%events(k)%data_set == data_set .and. fit%events(k)%kind == event_jump_in_approach) &
                     & value = fit%events(k)%value
               end do
            end if
         case (nuisance_spring_stiffness)
            value = 1
            if (any(is_first)) value = 2*(maxval(data%y, is_first) - minval(data%y, is_first)) &
               & /max(maxval(data%x, is_first) - minval(data%x, is_first), tiny(value))
         end select
      end associate
   end function start_of_nuisance

   !> Moduli of a history in time: loads are proportional to all of them together.
   subroutine look_at_moduli(self, fit, work, v, q)
      type(objective_t), intent(inout) :: self
      type(fit_t), intent(in) :: fit
      type(squares_work_t), intent(inout) :: work
      !> Values of the free variables; moduli are changed.
      real(dp), intent(inout) :: v(:)
      !> The same as numbers that are fitted.
      real(dp), intent(inout) :: q(:)

      call level_moduli(fit, v)
      call take_numbers(self, v, q)
      call scale_moduli(self, fit, work, q, v)
      call take_numbers(self, v, q)
   end subroutine look_at_moduli

   !> The work of adhesion from the lowest load, and E* from the largest one.
   subroutine look_at_loads(self, fit, lambda, v)
      !> The sum of squares, with the other values.
      type(objective_t), intent(inout) :: self
      type(fit_t), intent(in) :: fit
      real(dp), intent(in) :: lambda
      !> Values of the free variables; those without a start of the user's are changed.
      real(dp), intent(inout) :: v(:)
      type(sphere_path_t) :: path
      real(dp) :: lowest, largest, deepest, work, radius, values(size(self%values))
      integer :: k, theory

      theory = theory_of(self%values)
      call get_extremes(self, fit, lowest, largest, deepest)
      values = self%spheres(1)%values_of(self%values)
      radius = values(in%radius)
      do k = 1, size(v)
         if (is_set(fit%frees(k)%start) .or. is_set(fit%frees(k)%prior)) cycle
         if (fit%frees(k)%variable == in%work_of_adhesion) then
            call set_path(path, theory, .false., lambda, 0.0_dp)
            work = largest/(10*pi*radius)
            if (lowest < 0 .and. theory /= theory_hertz) work = lowest/(path%fold%p*pi*radius)
            if (work > 0) v(k) = work
         else if (fit%frees(k)%variable == in%contact_modulus .and. deepest > 0 .and. largest > 0) then
            v(k) = 0.75_dp*largest/(sqrt(radius)*deepest*sqrt(deepest))
         end if
      end do
      call self%set_values(v)
   end subroutine look_at_loads

   !> Lowest and largest load in contact, and the approach of the latter where the base of a spring is prescribed.
   pure subroutine get_extremes(self, fit, lowest, largest, deepest)
      type(objective_t), intent(in) :: self
      type(fit_t), intent(in) :: fit
      real(dp), intent(out) :: lowest, largest
      !> Receives the approach of the largest load; 0: not known.
      real(dp), intent(out) :: deepest
      integer :: k, i

      lowest = 0
      largest = 0
      deepest = 0
      do k = 1, size(self%spheres)
         associate (curve => self%spheres(k), nuisance => self%nuisance(:, self%spheres(k)%data_set))
            do i = 1, curve%n
               if (.not. curve%is_contact(i)) cycle
               if (curve%is_base .and. curve%ordinate == out%load) then
                  lowest = min(lowest, curve%y(i) - nuisance(nuisance_load_offset))
                  if (curve%y(i) - nuisance(nuisance_load_offset) <= largest) cycle
                  largest = curve%y(i) - nuisance(nuisance_load_offset)
                  deepest = curve%x(i) - nuisance(nuisance_contact_point)
                  if (is_set(nuisance(nuisance_spring_stiffness))) deepest = deepest - largest/nuisance(nuisance_spring_stiffness)
               else if (.not. curve%is_base) then
                  lowest = min(lowest, curve%x(i) - nuisance(nuisance_load_offset))
                  largest = max(largest, curve%x(i) - nuisance(nuisance_load_offset))
               end if
            end do
         end associate
      end do
      if (.not. allocated(fit%events)) return
      do k = 1, size(fit%events)
         if (fit%events(k)%kind == event_pull_off_load) lowest = fit%events(k)%value &
            & - self%nuisance(nuisance_load_offset, fit%events(k)%data_set)
      end do
   end subroutine get_extremes

   !> E* from the size of areas, then tau0 from the size of friction forces.
   subroutine look_at_sizes(self, fit, work, v, q)
      type(objective_t), intent(inout) :: self
      type(fit_t), intent(in) :: fit
      type(squares_work_t), intent(inout) :: work
      real(dp), intent(inout) :: v(:)
      !> The same as numbers that are fitted.
      real(dp), intent(inout) :: q(:)
      real(dp) :: cost, share
      logical :: is_valid
      integer :: k

      do k = 1, size(v)
         if (is_set(fit%frees(k)%start) .or. is_set(fit%frees(k)%prior)) cycle
         if (fit%frees(k)%variable == in%contact_modulus) then
            call self%evaluate(q, work%n_rows, work%r, work%j, cost, is_valid)
            share = share_of([out%contact_area, out%friction_area])
            if (is_valid .and. share > 0) v(k) = v(k)/(share*sqrt(share))
         end if
      end do
      call take_numbers(self, v, q)
      do k = 1, size(v)
         if (is_set(fit%frees(k)%start) .or. is_set(fit%frees(k)%prior)) cycle
         if (fit%frees(k)%variable == in%shear_strength) then
            call self%evaluate(q, work%n_rows, work%r, work%j, cost, is_valid)
            share = share_of([out%friction_force])
            if (is_valid .and. share > 0) v(k) = v(k)*share
         end if
      end do
      call take_numbers(self, v, q)

   contains

      !> What the ordinates of some kinds are of those of the model, by least squares; 0: there are none.
      pure real(dp) function share_of(kinds)
         !> Positions of the results.
         integer, intent(in) :: kinds(:)
         real(dp) :: product, square, zero
         integer :: i, at

         product = 0
         square = 0
         do at = 1, size(self%spheres)
            associate (curve => self%spheres(at))
               if (.not. any(kinds == curve%ordinate) .or. curve%is_base) cycle
               zero = self%nuisance(nuisance_friction_offset, curve%data_set)
               do i = 1, curve%n
                  if (.not. curve%is_contact(i)) cycle
                  product = product + (curve%fitted(i) - zero)*(curve%y(i) - zero)/curve%sigma(i)**2
                  square = square + ((curve%fitted(i) - zero)/curve%sigma(i))**2
               end do
            end associate
         end do
         share_of = 0
         if (square > 0) share_of = product/square
      end function share_of

   end subroutine look_at_sizes

end module adfric_fit_starts
