! SPDX-License-Identifier: GPL-3.0-or-later
!> The points of a curve of any model that are nearest to measured ones, in standard errors of both coordinates: their feet.
!>
!> A foot is sought over a position s: x = x_f + s^2 where the curve ends at a loaded fold x_f, beside which the ordinate is smooth
!> over s, else x = x_f + s. With u = (x - X_i)/sX and v = (y - Y_i)/sY the slope of half the squared distance is u u_s + v v_s. Its
!> root lies between positions with slopes of both signs. A step of Gauss and Newton is the first one, secants follow, and one that
!> leaves the bracket is halved. All points go together, for a model answers many points at once. The curve ends at a loaded fold,
!> and so may the search.
!>
!> No foot is farther from the point than the state with the measured abscissa, or the fold, is. So samples within that distance show which
!> foot is the nearest where there are several, as beside a fold.
module adfric_fit_model_foot
   use adfric_base_kinds, only: dp
   use adfric_fit_model_points, only: model_points_t, fold_t
   implicit none (type, external)
   private
   public :: feet_t, find_feet

   !> Feet.
   type :: feet_t
      !> Abscissas of the model at the feet.
      real(dp), allocatable :: x(:)
   end type feet_t

   !> Measured points that remain, with what is known of their feet.
   type :: foot_search_t
      !> Positions, and brackets of the feet.
      real(dp), allocatable :: s(:), low(:), high(:)
      !> The positions before, and the slopes there; 0 at first.
      real(dp), allocatable :: last(:), last_slope(:)
      !> Which points have no foot yet.
      integer, allocatable :: open(:)
      !> Is a position the root of the distance from the fold, and does the distance fall from the lower end of each bracket?
      logical :: is_root = .false.
      !> Not known of the end of the curve until it has been looked at.
      logical, allocatable :: is_end_known(:)
   end type foot_search_t

   !> Most steps; a step that is shorter than this part of the position, or of the error of the abscissa, is the last.
   integer, parameter :: max_steps = 80
   real(dp), parameter :: last_step = 1.0e-9_dp
   !> Samples to each side of the measured abscissa.
   integer, parameter :: n_samples = 4
   !> Relative step of the difference over a position.
   real(dp), parameter :: difference = 1.0e-6_dp

contains

   !> Find the feet.
   subroutine find_feet(points, values, x, y, x_sigma, sigma, gain, feet, is_valid)
      type(model_points_t), intent(in) :: points
      real(dp), intent(in) :: values(:)
      !> Measured abscissas and ordinates, less their zeros.
      real(dp), intent(in) :: x(:), y(:)
      !> Their standard errors; where that of an abscissa is 0 the foot has the measured one.
      real(dp), intent(in) :: x_sigma(:), sigma(:)
      !> Factor between the model and the ordinates.
      real(dp), intent(in) :: gain
      type(feet_t), intent(inout) :: feet
      !> Has the model a value at all positions?
      logical, intent(out) :: is_valid
      type(foot_search_t) :: search
      type(fold_t) :: fold
      integer :: k, step

      is_valid = .true.
      call points%find_fold(values, fold)
      search%is_root = fold%is_known .and. abs(fold%y) > 0
      search%s = x - fold%x
      if (search%is_root) search%s = sqrt(max(search%s, 0.0_dp))
      search%low = spread(merge(0.0_dp, -huge(1.0_dp), search%is_root), 1, size(x))
      search%high = spread(huge(1.0_dp), 1, size(x))
      allocate (search%is_end_known(size(x)), source=.not. search%is_root)
      allocate (search%last(size(x)), search%last_slope(size(x)), source=0.0_dp)
      search%open = pack([(k, k=1, size(x))], x_sigma > 0)
      call look_around(points, values, fold, x, y, x_sigma, sigma, gain, search, is_valid)
      if (.not. is_valid) return
      do step = 1, max_steps
         if (size(search%open) == 0) exit
         call make_step(points, values, fold, x, y, x_sigma, sigma, gain, search, is_valid)
         if (.not. is_valid) exit
      end do
      feet%x = fold%x + search%s
      if (search%is_root) feet%x = fold%x + search%s**2
   end subroutine find_feet

   !> Start at the nearest of some samples, between its neighbours.
   subroutine look_around(points, values, fold, x, y, x_sigma, sigma, gain, search, is_valid)
      type(model_points_t), intent(in) :: points
      real(dp), intent(in) :: values(:)
      type(fold_t), intent(in) :: fold
      real(dp), intent(in) :: x(:), y(:)
      !> Their standard errors.
      real(dp), intent(in) :: x_sigma(:), sigma(:)
      real(dp), intent(in) :: gain
      type(foot_search_t), intent(inout) :: search
      logical, intent(out) :: is_valid
      real(dp), dimension(size(search%open)) :: at, first, distance, least, positions, nearest
      integer :: regimes(size(search%open)), k
      real(dp) :: unused
      type(fold_t) :: other

      associate (open => search%open)
         do k = 0, 2*n_samples
            ! the measured abscissa, then to both sides of it
            if (k == 0) then
               positions = x(open)
            else
               positions = x(open) + x_sigma(open)*first*(-1)**k*((k + 1)/2)/n_samples
            end if
            if (search%is_root) positions = max(positions, fold%x)
            call points%ask(values, positions, at, regimes, unused, other)
            is_valid = all(regimes >= 0)
            if (.not. is_valid) return
            distance = hypot((positions - x(open))/x_sigma(open), (gain*at - y(open))/sigma(open))
            if (k == 0) then
               first = distance
               least = distance
               nearest = positions
            else
               where (distance < least) nearest = positions
               least = min(distance, least)
            end if
         end do
         search%s(open) = nearest - fold%x
         search%low(open) = nearest - fold%x - x_sigma(open)*first/n_samples
         search%high(open) = nearest - fold%x + x_sigma(open)*first/n_samples
         if (.not. search%is_root) return
         search%s(open) = sqrt(search%s(open))
         search%is_end_known(open) = search%low(open) > 0
         search%low(open) = sqrt(max(search%low(open), 0.0_dp))
         search%high(open) = sqrt(search%high(open))
      end associate
   end subroutine look_around

   !> One step of all points that have no foot yet.
   subroutine make_step(points, values, fold, x, y, x_sigma, sigma, gain, search, is_valid)
      type(model_points_t), intent(in) :: points
      real(dp), intent(in) :: values(:)
      type(fold_t), intent(in) :: fold
      real(dp), intent(in) :: x(:), y(:), x_sigma(:), sigma(:), gain
      type(foot_search_t), intent(inout) :: search
      logical, intent(out) :: is_valid
      real(dp), dimension(size(search%open)) :: h, at, beside, u_s
      logical :: is_left(size(search%open))
      real(dp) :: u, v, v_s, slope, step, size_of, bend
      integer :: i, k

      associate (open => search%open)
         if (search%is_root) then
            h = difference*max(search%s(open), sqrt(x_sigma(open)))
            u_s = 2*search%s(open)/x_sigma(open)
         else
            h = difference*max(abs(search%s(open)), x_sigma(open))
            u_s = 1/x_sigma(open)
         end if
         call ask_at(search%s(open), at, is_valid)
         if (is_valid) call ask_at(search%s(open) + h, beside, is_valid)
         if (.not. is_valid) return
         do k = 1, size(open)
            i = open(k)
            u = (search%s(i) + fold%x - x(i))/x_sigma(i)
            if (search%is_root) u = (search%s(i)**2 + fold%x - x(i))/x_sigma(i)
            v = (gain*at(k) - y(i))/sigma(i)
            v_s = gain*(beside(k) - at(k))/h(k)/sigma(i)
            slope = u*u_s(k) + v*v_s
            if (slope > 0) then
               search%high(i) = search%s(i)
            else
               search%low(i) = search%s(i)
               search%is_end_known(i) = .true.
            end if
            size_of = x_sigma(i)
            if (search%is_root) size_of = sqrt(x_sigma(i))
            step = -slope/(u_s(k)**2 + v_s**2)
            bend = (slope - search%last_slope(i))*(search%s(i) - search%last(i))
            if (bend > 0 .and. abs(search%last_slope(i)) > 0) step = -slope*(search%s(i) - search%last(i))**2/bend
            search%last(i) = search%s(i)
            search%last_slope(i) = slope
            step = position_after(search, i, step, size_of) - search%s(i)
            search%s(i) = search%s(i) + step
            is_left(k) = abs(step) > last_step*max(abs(search%s(i)), size_of)
         end do
      end associate
      search%open = pack(search%open, is_left)

   contains

      !> Ask the model at positions.
      subroutine ask_at(s, ordinates, is_there)
         !> The positions.
         real(dp), intent(in) :: s(:)
         real(dp), intent(out) :: ordinates(:)
         !> Has the model a value at all of them?
         logical, intent(out) :: is_there
         integer :: regimes(size(s))
         real(dp) :: unused, positions(size(s))
         type(fold_t) :: other

         positions = fold%x + s
         if (search%is_root) positions = fold%x + s**2
         call points%ask(values, positions, ordinates, regimes, unused, other)
         is_there = all(regimes >= 0)
      end subroutine ask_at

   end subroutine make_step

   !> The position after a step, within what is known of where the foot is.
   pure real(dp) function position_after(search, i, step, size_of) result(position)
      type(foot_search_t), intent(in) :: search
      integer, intent(in) :: i
      !> The step that is wanted.
      real(dp), intent(in) :: step
      !> A step where one side of the bracket is not known.
      real(dp), intent(in) :: size_of

      associate (low => search%low(i), high => search%high(i), s => search%s(i))
         position = s + step
         if (position > low .and. position < high) return
         if (position <= low .and. .not. search%is_end_known(i)) then
            ! the end of the curve is the foot, unless the distance falls from there
            position = low
         else if (abs(low) < huge(low) .and. high < huge(high)) then
            position = (low + high)/2
         else
            position = s + sign(size_of, step)
         end if
      end associate
   end function position_after

end module adfric_fit_model_foot
