! SPDX-License-Identifier: GPL-3.0-or-later
!> One point of the model `attracted_indenter`: its path, where contact ends, and the state that is prescribed, reduced.
module adfric_round_attracted_point
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_interface_attraction, only: attraction_by_work, attraction_of_table, law_table, work_ratio
   use adfric_numerics_gauss, only: gauss_nodes_6, gauss_weights_6
   use adfric_round_attracted_path, only: begin_path, follow_path, n_fine, path_t
   use adfric_round_attracted_sample, only: body_t, by_approach, by_load, by_spring, attracted_sample_t, take_sample, with_control
   use adfric_round_attracted_search, only: find_folds, find_state, folds_t, found_t, slope_at, stop_before
   use adfric_round_attracted_nodes, only: attracted_t
   use adfric_round_case, only: indenter_case_t
   use adfric_round_contact, only: branch_inner, branch_unstable
   use adfric_round_contact_state, only: contact_t
   use adfric_round_curve, only: control_approach, control_load, control_radius, control_spring
   use adfric_round_dugdale_curve, only: dugdale_curve_t
   use adfric_round_profiles, only: pressure_at
   implicit none (type, external)
   private
   public :: survey_attraction, attracted_survey_t, attracted_point_t, find_point, make_body, pressure_of, gap_of, reaches_beyond

   !> Grids, each twice as fine as the one before; the first one is that of a path.
   integer, parameter :: n_grids = 4

   !> A path with its folds on the first two grids: all that does not depend on what is prescribed.
   type :: attracted_survey_t
      !> Path up to where load and approach are above 0 and rise.
      type(path_t) :: path
      !> Its folds on the two grids.
      type(folds_t) :: folds(2)
   end type attracted_survey_t

   !> A state that was found.
   type :: attracted_point_t
      !> Is there one, was it found, and is it stable?
      logical :: is_found = .false., is_converged = .true., is_stable = .false.
      !> The state.
      type(attracted_sample_t) :: sample
      !> d load/d approach, and the error over the sizes.
      real(dp) :: stiffness = 0, error = 0
      !> Load and approach of pull-off and of the jump into contact; NaN where there is none.
      real(dp) :: pull_off(2) = 0, jump_in(2) = 0
   end type attracted_point_t

contains

   !> Body and law of a case of the model `indenter`, whose curve is Dugdale's with the same work and largest tension.
   pure subroutine make_body(case, law, table, body)
      type(indenter_case_t), intent(in) :: case
      !> One of `law_...`.
      integer, intent(in) :: law
      !> Gaps [m] and tensions [Pa] of a table; shape `(n, 2)`.
      real(dp), allocatable, intent(in) :: table(:, :)
      type(body_t), intent(out) :: body

      allocate (body%shape, source=case%curve%shape)
      select type (curve => case%curve)
      type is (dugdale_curve_t)
         if (law == law_table) then
            body%law = attraction_of_table(table(:, 1)/case%height_unit, &
               & table(:, 2)/(case%modulus*(case%height_unit/case%length_unit)))
         else
            body%law = attraction_by_work(law, curve%stress*curve%range, curve%range/work_ratio(law))
         end if
      end select
      select case (case%control)
      case (control_approach)
         body%control = by_approach
      case (control_spring)
         body%control = by_spring
         body%compliance = case%curve%compliance
      case default
         body%control = by_load
      end select
   end subroutine make_body

   !> Does the attraction act beyond the edge of the body?
   pure logical function reaches_beyond(body)
      type(body_t), intent(in) :: body
      real(dp), parameter :: negligible = 1.0e-4_dp
      real(dp) :: height, slope

      reaches_beyond = .false.
      if (body%shape%edge >= huge(slope)) return
      call body%shape%get_profile(0.99_dp*body%shape%edge, height, slope)
      reaches_beyond = body%law%work_from(height) > negligible*body%law%work
   end function reaches_beyond

   !> Path and folds of a body.
   subroutine survey_attraction(body, survey)
      type(body_t), intent(in) :: body
      type(attracted_survey_t), intent(out) :: survey

      call begin_path(body, 0.0_dp, survey%path)
      call follow_path(survey%path, 0.0_dp, 0.0_dp, 0.0_dp)
      if (.not. survey%path%is_certain) return
      call find_folds(survey%path, n_fine, survey%folds(1))
      call find_folds(survey%path, 2*n_fine, survey%folds(2))
   end subroutine survey_attraction

   !> The state where something is prescribed.
   subroutine find_point(case, survey, tolerance, point)
      type(indenter_case_t), intent(in) :: case
      type(attracted_survey_t), intent(in) :: survey
      !> Largest error.
      real(dp), intent(in) :: tolerance
      type(attracted_point_t), intent(out) :: point
      type(path_t) :: path
      type(folds_t) :: folds
      type(found_t) :: found, last
      integer :: grid, n

      point%is_converged = survey%path%is_certain .and. all(survey%folds%is_converged)
      if (.not. point%is_converged) return
      call take_ends(survey, point)
      call reach_out(case, survey, path, folds, point%is_converged)
      if (.not. point%is_converged) return
      if (is_apart(case, path) .and. case%branch == branch_inner) then
         call take_apart()
         return
      end if
      do grid = 1, n_grids
         n = n_fine*2**(grid - 1)
         if (case%control == control_radius) then
            call take_radius(case, path, n, found)
         else
            call find_state(path, folds, case%given, case%branch, n, found)
         end if
         point%is_converged = found%is_converged
         if (.not. (found%is_found .and. found%is_converged)) exit
         if (grid > 1) then
            point%error = max(error_of_ends(survey), difference(path, found%sample, last%sample))
            if (point%error <= tolerance) exit
         end if
         last = found
      end do
      point%is_found = found%is_found
      ! the stable state is that of most contact, and bodies that are apart the last one
      if (.not. point%is_found .and. case%branch /= branch_unstable .and. is_apart(case, path)) call take_apart()
      if (.not. (point%is_found .and. point%is_converged) .or. .not. allocated(found%sample%state)) return
      point%is_converged = point%error <= tolerance
      point%sample = found%sample
      point%is_stable = found%is_stable
      call finish(path, found, case%control, point)

   contains

      !> Bodies that are apart.
      subroutine take_apart()
         point%is_found = .true.
         point%is_stable = .true.
         point%sample%approach = case%given
      end subroutine take_apart

   end subroutine find_point

   !> A path as far as what is prescribed, with its folds.
   subroutine reach_out(case, survey, path, folds, is_certain)
      type(indenter_case_t), intent(in) :: case
      type(attracted_survey_t), intent(in) :: survey
      type(path_t), intent(out) :: path
      !> Folds on the second grid.
      type(folds_t), intent(out) :: folds
      !> Receives whether all steps were taken, and all folds found.
      logical, intent(out) :: is_certain
      real(dp) :: farthest
      integer :: trial
      integer, parameter :: most_trials = 6

      path = survey%path
      folds = survey%folds(2)
      call extend(case, path, farthest)
      is_certain = path%is_certain
      if (.not. (is_certain .and. farthest > 0)) return
      do trial = 1, most_trials
         call begin_again(farthest, path)
         is_certain = path%is_certain
         if (.not. is_certain) return
         if (path%body%law%has_end() .or. is_reached(case, path)) exit
         ! the load of a blunt cone falls slowly
         farthest = 10*farthest
      end do
      ! a path that begins elsewhere has other steps
      call find_folds(path, 2*n_fine, folds)
      is_certain = folds%is_converged

   contains

      !> A path that begins farther away, up to where the other one ends.
      subroutine begin_again(gap, path)
         real(dp), intent(in) :: gap
         type(path_t), intent(inout) :: path
         type(path_t) :: longer

         call begin_path(survey%path%body, gap, longer)
         associate (stop => path%stops(path%n))
            call follow_path(longer, stop%load*(1 - epsilon(gap)), stop%approach*(1 - epsilon(gap)), 0.0_dp)
         end associate
         path = longer
      end subroutine begin_again

   end subroutine reach_out

   !> Stiffness, and for a given radius stability.
   subroutine finish(path, found, control, point)
      type(path_t), intent(in) :: path
      type(found_t), intent(in) :: found
      integer, intent(in) :: control
      type(attracted_point_t), intent(inout) :: point
      real(dp) :: load_slope

      call slope_at(path, found%before, found%sample, n_fine, point%stiffness, load_slope)
      if (control == control_radius) point%is_stable = load_slope > 0
   end subroutine finish

   !> Does the first state of a path lie beyond what is prescribed?
   pure logical function is_reached(case, path)
      type(indenter_case_t), intent(in) :: case
      type(path_t), intent(in) :: path

      associate (first => path%stops(1))
         is_reached = case%given <= first%load
         if (case%control /= control_load) is_reached = case%given >= with_control(path%body, first%approach, first%load)
      end associate
   end function is_reached

   !> Follow a path to what is prescribed; or say from how far away another one must begin, 0: from nowhere else. By a law with an end
   !> that is next to it. Far apart the load falls as the work that is left, or more slowly.
   subroutine extend(case, path, farthest)
      type(indenter_case_t), intent(in) :: case
      type(path_t), intent(inout) :: path
      real(dp), intent(out) :: farthest

      farthest = 0
      associate (body => path%body, first => path%stops(1))
         select case (case%control)
         case (control_radius)
            call follow_path(path, 0.0_dp, 0.0_dp, case%radius)
         case (control_load)
            call follow_path(path, case%given, 0.0_dp, 0.0_dp)
            if (.not. (case%given < 0 .and. case%given > first%load)) return
            if (body%law%has_end()) then
               farthest = body%law%range + first%z
               farthest = body%law%range - farthest/2*(case%given/first%load)
            else
               farthest = 2*body%law%reach_of_work(case%given/first%load*body%law%work_from(-first%z)/body%law%work)
            end if
         case default
            call follow_path(path, 0.0_dp, case%given, 0.0_dp)
            if (is_reached(case, path) .or. is_apart(case, path)) return
            farthest = min(-2*case%given, (body%law%end_of_tension() - case%given)/2)
         end select
      end associate
   end subroutine extend

   !> May the bodies be apart, beyond the end of the attraction?
   pure logical function is_apart(case, path)
      type(indenter_case_t), intent(in) :: case
      type(path_t), intent(in) :: path

      is_apart = any(case%control == [control_approach, control_spring]) .and. case%given <= -path%body%law%end_of_tension()
   end function is_apart

   !> The state of a given radius.
   subroutine take_radius(case, path, n, found)
      type(indenter_case_t), intent(in) :: case
      type(path_t), intent(in) :: path
      integer, intent(in) :: n
      type(found_t), intent(out) :: found

      found%is_found = .true.
      found%before = stop_before(path, case%radius)
      associate (stop => path%stops(found%before))
         call take_sample(path%body, case%radius, stop%grid, n, stop%state, found%sample)
      end associate
      found%is_converged = found%sample%is_found
   end subroutine take_radius

   !> Pull-off and jump into contact on the finer grid. Under a load contact pulls off at the least load of all; at an approach at the
   !> last fold, if there is one.
   pure subroutine take_ends(survey, point)
      type(attracted_survey_t), intent(in) :: survey
      type(attracted_point_t), intent(inout) :: point
      integer :: k

      point%pull_off = not_a_number()
      point%jump_in = not_a_number()
      associate (folds => survey%folds(2))
         k = index_of_pull_off(survey%path, folds)
         if (k > 0) point%pull_off = [folds%samples(k)%load, folds%samples(k)%approach]
         k = findloc(folds%is_least, .false., 1)
         if (k > 0) point%jump_in = [folds%samples(k)%load, folds%samples(k)%approach]
      end associate
   end subroutine take_ends

   !> Index of the fold of pull-off; 0 if there is none.
   pure integer function index_of_pull_off(path, folds) result(k)
      type(path_t), intent(in) :: path
      type(folds_t), intent(in) :: folds
      integer :: i

      k = 0
      do i = 1, folds%n
         if (.not. folds%is_least(i)) cycle
         if (k > 0) then
            if (with_control(path%body, folds%samples(i)%approach, folds%samples(i)%load) &
               & > with_control(path%body, folds%samples(k)%approach, folds%samples(k)%load)) cycle
         end if
         k = i
      end do
   end function index_of_pull_off

   !> What a finer grid changes of the pull-off, over its sizes.
   pure real(dp) function error_of_ends(survey) result(error)
      type(attracted_survey_t), intent(in) :: survey
      integer :: k, coarse

      error = 0
      k = index_of_pull_off(survey%path, survey%folds(2))
      coarse = index_of_pull_off(survey%path, survey%folds(1))
      if (min(k, coarse) > 0) error = abs(survey%folds(2)%samples(k)%load/survey%folds(1)%samples(coarse)%load - 1)
   end function error_of_ends

   !> What a finer grid changes of load, approach and radius, over their sizes or scales.
   pure real(dp) function difference(path, fine, coarse)
      type(path_t), intent(in) :: path
      type(attracted_sample_t), intent(in) :: fine, coarse

      difference = max(abs(fine%load - coarse%load)/max(abs(fine%load), 0.1_dp*path%load_scale), &
         & abs(fine%approach - coarse%approach)/max(abs(fine%approach), path%body%law%range), &
         & abs(fine%adhesion_radius - coarse%adhesion_radius)/max(fine%adhesion_radius, fine%state%grid%width))
   end function difference

   !> Pressure at a radius: under the body that of a contact without adhesion and of tensions around it,
   !> p = p1 - (2/pi) int s b/(b^2 + t^2) dt with b^2 = a^2 - r^2; outside minus the tension.
   pure real(dp) function pressure_of(body, state, r) result(pressure)
      type(body_t), intent(in) :: body
      type(attracted_t), intent(in) :: state
      !> Distance from the axis.
      real(dp), intent(in) :: r
      type(contact_t) :: contact
      real(dp) :: b, first, last, t, part, sum
      integer :: j, k

      if (r >= state%radius) then
         pressure = -body%law%tension(gap_of(body, state, r))
         return
      end if
      call body%shape%evaluate(body%shape%unknown_of(state%radius), .true., contact%spot)
      contact%u = body%shape%unknown_of(state%radius)
      pressure = pressure_at(body%shape, contact, r)
      b = sqrt((state%radius - r)*(state%radius + r))
      sum = 0
      do j = 0, ubound(state%t, 1) - 1
         first = atan2(state%t(j), b)
         last = atan2(state%t(j + 1), b)
         do k = 1, size(gauss_nodes_6)
            t = b*tan(first + (last - first)*(1 + gauss_nodes_6(k))/2)
            part = (t - state%t(j))*(t + state%t(j))/((state%t(j + 1) - state%t(j))*(state%t(j + 1) + state%t(j)))
            sum = sum + gauss_weights_6(k)*(last - first)/2*(state%tension(j) + part*(state%tension(j + 1) - state%tension(j)))
         end do
      end do
      pressure = pressure - 2/pi*sum
   end function pressure_of

   !> Gap at a radius.
   pure real(dp) function gap_of(body, state, r) result(gap)
      type(body_t), intent(in) :: body
      type(attracted_t), intent(in) :: state
      real(dp), intent(in) :: r

      gap = 0
      if (r > state%radius .or. .not. state%radius > 0) gap = state%gap_at_node(body%shape, &
         & sqrt(max(0.0_dp, (r - state%radius)*(r + state%radius))))
   end function gap_of

end module adfric_round_attracted_point
