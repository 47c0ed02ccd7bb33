! SPDX-License-Identifier: GPL-3.0-or-later
!> Starts of a whole curve, load against approach, of a sphere or any indenter: where contact begins, how stiff it is, and what adheres.
!>
!> Load is E* p(delta, w/E*) with a function p of lengths alone. So only the contact point and the length w/E* are looked for, at
!> positions that fill their box evenly (Halton), the contact point within the data and somewhat beyond, w/E* over the decades up to
!> their range. E*, the zero of the load and the slope of the base line are then linear, and the sum of squares over some of the
!> points says which positions are the best.
module adfric_fit_curve_starts
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: is_set
   use adfric_fit_curve, only: fit_curve_t
   use adfric_fit_model_points, only: fold_t, model_points_t, new_model_points
   use adfric_fit_objective, only: objective_t
   use adfric_fit_order, only: order_of
   use adfric_fit_parts, only: has_others
   use adfric_fit_problem, only: fit_t, nuisance_load_offset, nuisance_friction_offset, nuisance_contact_point, &
      & nuisance_lateral_gain, nuisance_spring_stiffness, nuisance_tilt
   use adfric_fit_sphere_curve, only: is_plain_sphere
   use adfric_numerics_column_factors, only: factor_columns, solve_triangle
   implicit none (type, external)
   private
   public :: find_curve_starts, has_curve_starts

   !> Positions that are looked at, points at which they are, and how near two starts may be as a part of the box.
   integer, parameter :: n_positions = 160, n_points = 60
   real(dp), parameter :: least_distance = 0.04_dp
   !> How far the contact point may lie before the data, as a part of their range, and decades of w/E* below it.
   real(dp), parameter :: before_data = 0.5_dp, decades = 5.0_dp

   !> What is looked for.
   type :: scan_t
      !> Numbers of the free variables: modulus, work of adhesion, contact point, zero of the load, slope; 0: not looked for.
      integer :: modulus = 0, work = 0, contact_point = 0, offset = 0, tilt = 0
      !> Does anything adhere?
      logical :: adheres = .false.
      !> What is asked of the model.
      type(model_points_t) :: points
      !> Points that are looked at: abscissas, ordinates, standard errors, and whether they are in contact.
      real(dp), allocatable :: x(:), y(:), sigma(:)
      !> Which of them are in contact.
      logical, allocatable :: is_contact(:)
      !> Ends of the contact point, and the range of the data.
      real(dp) :: low = 0, high = 0, range = 1
   end type scan_t

contains

   !> Is a fit one of a load against an approach that is not that of the base of a spring beside the model?
   logical function has_curve_starts(fit)
      type(fit_t), intent(in) :: fit

      has_curve_starts = size(fit%data_sets) == 1
      if (.not. has_curve_starts) return
      associate (data => fit%data_sets(1))
         has_curve_starts = fit%model%results(data%ordinate)%name == 'load' .and. index(fit%model%variables(data%abscissa)%name, &
            & 'approach') > 0 .and. .not. is_set(data%nuisance(nuisance_spring_stiffness)) &
            & .and. .not. any(fit%frees%nuisance == nuisance_spring_stiffness) .and. .not. has_others(data) &
            & .and. (fit%model%name == 'indenter' .or. is_plain_sphere(fit, data))
      end associate
   end function has_curve_starts

   !> Find starts, the best one first.
   subroutine find_curve_starts(self, fit, v, starts)
      type(objective_t), intent(inout) :: self
      type(fit_t), intent(in) :: fit
      !> A start; what is not looked for keeps its values.
      real(dp), intent(in) :: v(:)
      !> Receives starts; shape `(n_free, n)`, n = 0 if no position has a value.
      real(dp), allocatable, intent(out) :: starts(:, :)
      type(scan_t) :: scan
      real(dp) :: all_starts(size(v), n_positions), sums(n_positions), position(2, n_positions)
      integer :: order(n_positions), taken(n_positions), k, n

      call new_scan(self, fit, scan)
      allocate (starts(size(v), 0))
      if (scan%modulus + scan%work + scan%contact_point == 0 .or. count(scan%is_contact) < 3) return
      do k = 1, n_positions
         position(:, k) = [radical_inverse(k, 2), radical_inverse(k, 3)]
         call look_at(self, fit, scan, position(:, k), v, all_starts(:, k), sums(k))
      end do
      order = order_of(sums)
      n = 0
      do k = 1, n_positions
         if (.not. sums(order(k)) < huge(sums)) exit
         if (n > 0) then
            if (any(norm2(position(:, taken(:n)) - spread(position(:, order(k)), 2, n), 1) < least_distance)) cycle
         end if
         n = n + 1
         taken(n) = order(k)
      end do
      starts = all_starts(:, taken(:n))
   end subroutine find_curve_starts

   !> What is looked for, and at which points.
   subroutine new_scan(self, fit, scan)
      type(objective_t), intent(in) :: self
      type(fit_t), intent(in) :: fit
      type(scan_t), intent(out) :: scan
      integer :: k

      do k = 1, self%n_free
         associate (free => fit%frees(k))
            select case (free%nuisance)
            case (nuisance_load_offset, nuisance_friction_offset)
               if (.not. is_known(k)) scan%offset = k
            case (nuisance_tilt)
               if (.not. is_known(k)) scan%tilt = k
            case (nuisance_contact_point)
               if (.not. is_known(k)) scan%contact_point = k
            end select
            if (free%variable == 0) cycle
            select case (fit%model%variables(free%variable)%name)
            case ('contact_modulus', 'young_modulus')
               if (.not. is_known(k)) scan%modulus = k
            case ('work_of_adhesion')
               scan%adheres = .true.
               if (.not. is_known(k)) scan%work = k
            end select
         end associate
      end do
      do k = 1, size(fit%model%variables)
         if (fit%model%variables(k)%name /= 'work_of_adhesion' .or. any(fit%frees%variable == k)) cycle
         if (is_set(fit%base(k))) scan%adheres = fit%base(k) > 0
      end do
      if (size(self%others) > 0) then
         call take_points(self%others(1))
      else
         call take_points(self%spheres(1))
      end if

   contains

      !> Take some points of the curve, and their range.
      subroutine take_points(curve)
         class(fit_curve_t), intent(in) :: curve
         integer :: positions(curve%n), i, n

         associate (data => fit%data_sets(1))
            call new_model_points(scan%points, fit%model, fit%base, data%abscissa, data%ordinate, is_plain_sphere(fit, data))
         end associate
         positions = order_of(curve%x)
         n = min(size(positions), n_points)
         positions(:n) = positions([(1 + ((i - 1)*(size(positions) - 1))/max(n - 1, 1), i=1, n)])
         scan%x = curve%x(positions(:n))
         scan%y = curve%y(positions(:n))
         scan%sigma = curve%sigma(positions(:n))
         scan%is_contact = curve%is_contact(positions(:n))
         if (.not. any(curve%is_contact)) return
         scan%high = maxval(curve%x, curve%is_contact)
         scan%low = minval(curve%x, curve%is_contact)
         scan%range = scan%high - scan%low
         scan%low = scan%low - before_data*scan%range
      end subroutine take_points

      !> Does the user give a start or a prior?
      pure logical function is_known(free)
         !> Number of the free variable.
         integer, intent(in) :: free

         is_known = is_set(fit%frees(free)%start) .or. is_set(fit%frees(free)%prior)
      end function is_known

   end subroutine new_scan

   !> The best values at a position, and the sum of squares there.
   subroutine look_at(self, fit, scan, position, v, best, total)
      type(objective_t), intent(inout) :: self
      type(fit_t), intent(in) :: fit
      type(scan_t), intent(in) :: scan
      !> The position in the box, each number between 0 and 1.
      real(dp), intent(in) :: position(2)
      !> A start.
      real(dp), intent(in) :: v(:)
      !> Receives the values.
      real(dp), intent(out) :: best(:)
      !> Receives the sum of squares; the largest number where there is none.
      real(dp), intent(out) :: total
      real(dp), dimension(size(scan%x)) :: y, b, rest
      real(dp) :: length, a(size(scan%x), 3), linear(3), zero
      logical :: is_valid
      integer :: n, amplitude

      best = v
      total = huge(total)
      if (scan%contact_point > 0) best(scan%contact_point) = scan%low + position(1)*(scan%high - scan%low)
      length = scan%range*10**(-decades*position(2))
      amplitude = scan%modulus
      if (scan%adheres .and. scan%work > 0) then
         if (scan%modulus == 0) best(scan%work) = length*modulus_of(fit)
         if (scan%modulus > 0) best(scan%work) = length*best(scan%modulus)
      else if (scan%adheres .and. scan%modulus > 0) then
         best(scan%modulus) = work_of(fit, best)/length
         amplitude = 0
      end if
      if (scan%offset > 0) best(scan%offset) = 0
      if (scan%tilt > 0) best(scan%tilt) = 0
      call self%set_values(best)
      associate (nuisance => self%nuisance(:, 1))
         call model_at(self, scan, y, is_valid)
         if (.not. is_valid) return
         zero = nuisance(nuisance_load_offset) + nuisance(nuisance_friction_offset)
         rest = scan%y - zero - nuisance(nuisance_tilt)*scan%x
         n = 0
         if (amplitude > 0) then
            n = 1
            a(:, 1) = y/scan%sigma
         else
            rest = rest - y
         end if
         if (scan%offset > 0) then
            n = n + 1
            a(:, n) = 1/scan%sigma
         end if
         if (scan%tilt > 0) then
            n = n + 1
            a(:, n) = scan%x/scan%sigma
         end if
         b = rest/scan%sigma
      end associate
      if (n > 0) call solve_linear(a(:, :n), b, linear(:n), is_valid)
      if (.not. is_valid) return
      if (amplitude > 0) then
         if (.not. linear(1) > 0) return
         best(amplitude) = best(amplitude)*linear(1)
         if (scan%work > 0) best(scan%work) = best(scan%work)*linear(1)
      end if
      if (scan%offset > 0) best(scan%offset) = linear(n - merge(1, 0, scan%tilt > 0))
      if (scan%tilt > 0) best(scan%tilt) = linear(n)
      total = dot_product(b(n + 1:), b(n + 1:))
   end subroutine look_at

   !> The model at the points; 0 at free ones.
   subroutine model_at(self, scan, y, is_valid)
      type(objective_t), intent(in) :: self
      type(scan_t), intent(in) :: scan
      real(dp), intent(out) :: y(:)
      !> Has the model a value at all of them?
      logical, intent(out) :: is_valid
      integer :: contacts(count(scan%is_contact)), regimes(count(scan%is_contact)), k
      real(dp) :: found(count(scan%is_contact)), unused
      type(fold_t) :: fold

      contacts = pack([(k, k=1, size(y))], scan%is_contact)
      y = 0
      call scan%points%ask(self%values, scan%x(contacts) - self%nuisance(nuisance_contact_point, 1), found, regimes, unused, fold)
      is_valid = all(regimes >= 0)
      y(contacts) = self%nuisance(nuisance_lateral_gain, 1)*found
   end subroutine model_at

   !> Linear least squares.
   pure subroutine solve_linear(a, b, x, is_valid)
      !> Columns.
      real(dp), intent(inout) :: a(:, :)
      !> In: the right-hand side. Out: in the rows behind those of the columns what remains.
      real(dp), intent(inout) :: b(:)
      !> Receives the factors of the columns.
      real(dp), intent(out) :: x(:)
      logical, intent(out) :: is_valid
      real(dp), parameter :: least_share = 1.0e-12_dp
      real(dp) :: length(size(x))
      integer :: k

      x = 0
      length = norm2(a, 1)
      is_valid = all(length > 0) .and. size(a, 1) > size(x)
      if (.not. is_valid) return
      do k = 1, size(x)
         a(:, k) = a(:, k)/length(k)
      end do
      call factor_columns(a, b)
      do k = 1, size(x)
         is_valid = is_valid .and. abs(a(k, k)) > least_share
      end do
      if (is_valid) call solve_triangle(a(:size(x), :), b(:size(x)), x)
      x = x/length
   end subroutine solve_linear

   !> The modulus that is given, for the size of w/E*.
   pure real(dp) function modulus_of(fit)
      type(fit_t), intent(in) :: fit
      integer :: k

      modulus_of = 1
      do k = 1, size(fit%model%variables)
         if (.not. is_set(fit%base(k))) cycle
         if (fit%model%variables(k)%name == 'contact_modulus' .or. fit%model%variables(k)%name == 'young_modulus') &
            & modulus_of = fit%base(k)
      end do
   end function modulus_of

   !> The work of adhesion that is given or known.
   pure real(dp) function work_of(fit, v)
      type(fit_t), intent(in) :: fit
      real(dp), intent(in) :: v(:)
      integer :: k, i

      work_of = 0
      do k = 1, size(fit%model%variables)
         if (fit%model%variables(k)%name /= 'work_of_adhesion') cycle
         if (is_set(fit%base(k))) work_of = fit%base(k)
         do i = 1, size(v)
            if (fit%frees(i)%variable == k) work_of = v(i)
         end do
      end do
   end function work_of

   !> The digits of a number behind the point, the last one first.
   pure real(dp) function radical_inverse(number, base) result(x)
      integer, intent(in) :: number, base
      real(dp) :: digit
      integer :: n

      x = 0
      digit = 1
      n = number
      do while (n > 0)
         digit = digit/base
         x = x + digit*modulo(n, base)
         n = n/base
      end do
   end function radical_inverse

end module adfric_fit_curve_starts
