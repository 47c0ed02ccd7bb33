! SPDX-License-Identifier: GPL-3.0-or-later
!> Estimated and true errors of `wavy_sliding` on heights: sums of waves through samples and rows.
!>
!> Lengths and stresses are in units in which the period and the relaxed stiffness are 1.
module stepped_estimates
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_base_error, only: error_t
   use adfric_base_unset, only: is_set, unset
   use adfric_solid_master_curve, only: master_curve_fit_t
   use adfric_solid_prony, only: prony_t
   use adfric_describe_status, only: status_solved
   use adfric_shape_height_line, only: height_line_t, new_sampled_line, linear_pieces, cubic_pieces
   use adfric_foundation_case, only: kind_cosines, kind_map, kind_profile
   use adfric_foundation_given_surface, only: given_surface_t
   use adfric_foundation_stepping_equilibrium, only: stepping_surface_t, stepping_equilibrium_t, find_at_penetration, &
      & find_at_load, stepping_solved
   use adfric_foundation_stepping_law, only: new_stepping_law
   use adfric_foundation_stepping_relief, only: relief_t
   use adfric_foundation_stepping_solid, only: solid_t, new_solid
   use adfric_foundation_stepping_path, only: new_path
   use adfric_foundation_stepped_case, only: stepped_case_t, get_relief, get_spectrum, resolve_stepped
   use adfric_foundation_stepped_points, only: solve_stepped_block
   use adfric_foundation_model, only: wavy_model_t, new_wavy_model
   use adfric_foundation_surface, only: negligible, share_of_scale
   use adfric_foundation_variables, only: n_wavy_results, in => foundation_input, out => foundation_output
   use estimate_counts, only: counts_t, count_case
   use stepping_cases, only: stepping_case_t
   use stepping_judge, only: draw_case
   use random_dice, only: dice_t, new_dice
   implicit none (type, external)
   private
   public :: count_cosines, count_lines, count_maps

   !> Lines, and maps.
   integer, parameter :: n_lines = 1000, n_maps = 160
   !> Samples in the shortest wave, of a map from twice to half as many; rows.
   integer, parameter :: fewest_samples = 4, most_samples = 64, fewest_rows = 8, most_rows = 32
   !> The map that tells the truth: rows, and samples in the shortest wave.
   integer, parameter :: true_rows = 96, true_samples = 48

   !> Load and friction, and the sizes of their terms.
   type :: forces_t
      real(dp) :: load = 0, friction = 0, load_scale = 0, friction_scale = 0
      logical :: is_solved = .false.
   end type forces_t

contains

   !> Sums of waves, against the same sums that begin elsewhere.
   subroutine count_cosines(counts, loaded, seed)
      !> At a penetration, and under a load.
      type(counts_t), intent(out) :: counts, loaded
      integer, intent(in) :: seed
      type(dice_t) :: dice
      type(stepping_case_t) :: trial
      type(given_surface_t) :: given, moved
      type(forces_t) :: truth
      real(dp), allocatable :: values(:)
      real(dp) :: depth, position
      integer :: k, m

      counts%name = 'cosines'
      loaded%name = 'cosines under a load'
      call new_dice(dice, seed)
      do k = 1, n_lines
         call draw_line(dice, k, trial, depth)
         call begin_point(trial, kind_cosines, depth, values, given)
         call dice%between(0.0_dp, 1.0_dp, position)
         moved = given
         moved%phases = [(given%phases(m) + two_pi*m*position, m=1, size(given%phases))]
         call find_truth(values, moved, truth)
         call keep(counts, values, given, truth)
         if (.not. (truth%is_solved .and. truth%load_scale > 0)) cycle
         call load_point(values, truth%load)
         call find_truth(values, moved, truth)
         call keep(loaded, values, given, truth)
      end do
   end subroutine count_cosines

   !> Sums of waves through samples, against the sums.
   subroutine count_lines(counts, loaded, interpolation, seed)
      !> At a penetration, and under a load.
      type(counts_t), intent(out) :: counts, loaded
      !> Degree of the pieces between samples.
      integer, intent(in) :: interpolation
      integer, intent(in) :: seed
      type(dice_t) :: dice
      type(stepping_case_t) :: trial
      type(given_surface_t) :: given, sampled
      type(forces_t) :: truth
      real(dp), allocatable :: values(:), of_samples(:)
      real(dp) :: depth
      integer :: k, n

      counts%name = merge('profile, spline', 'profile, chords', interpolation == cubic_pieces)
      loaded%name = trim(counts%name)//' under a load'
      call new_dice(dice, seed)
      do k = 1, n_lines
         call draw_line(dice, k, trial, depth)
         call begin_point(trial, kind_cosines, depth, values, given)
         call draw_number(dice, fewest_samples*size(trial%amplitudes), most_samples*size(trial%amplitudes), n)
         call find_truth(values, given, truth)
         call begin_point(trial, kind_profile, depth, of_samples, sampled)
         call give_samples(trial, n, interpolation, of_samples, sampled)
         call keep(counts, of_samples, sampled, truth)
         if (.not. (truth%is_solved .and. truth%load_scale > 0)) cycle
         call load_point(values, truth%load)
         call load_point(of_samples, truth%load)
         call find_truth(values, given, truth)
         call keep(loaded, of_samples, sampled, truth)
      end do
   end subroutine count_lines

   !> Maps of few rows, against many rows with many samples.
   subroutine count_maps(counts, loaded, seed)
      !> At a penetration, and under a load.
      type(counts_t), intent(out) :: counts, loaded
      integer, intent(in) :: seed
      integer, parameter :: across = 3
      type(dice_t) :: dice
      type(stepping_case_t) :: trial
      type(given_surface_t) :: given, sampled
      type(forces_t) :: truth, half
      real(dp), allocatable :: values(:), of_rows(:)
      real(dp) :: depth, parts(across), shifts(across)
      integer :: k, m, nx, ny

      counts%name = 'map'
      loaded%name = 'map under a load'
      call new_dice(dice, seed)
      do k = 1, n_maps
         call draw_line(dice, k, trial, depth)
         do m = 1, across
            call dice%between(-1.0_dp/m, 1.0_dp/m, parts(m))
            call dice%between(0.0_dp, two_pi, shifts(m))
         end do
         call draw_number(dice, 2*fewest_samples*size(trial%amplitudes), most_samples/2*size(trial%amplitudes), nx)
         call draw_number(dice, fewest_rows, most_rows, ny)
         call begin_point(trial, kind_map, depth, values, given)
         call begin_point(trial, kind_map, depth, of_rows, sampled)
         call give_rows(trial, parts, shifts, true_samples*size(trial%amplitudes), true_rows, values, given)
         call give_rows(trial, parts, shifts, nx, ny, of_rows, sampled)
         ! the highest position of a map is that of its rows
         values(in%penetration) = depth + highest_of(given%heights) - highest_of(sampled%heights)
         call find_truth(values, given, truth)
         call find_halves(values, given, truth, half)
         call keep(counts, of_rows, sampled, truth, half)
         ! loads take long
         if (mod(k, 4) > 0 .or. .not. (truth%is_solved .and. truth%load_scale > 0)) cycle
         call load_point(values, truth%load)
         call load_point(of_rows, truth%load)
         call find_truth(values, given, truth)
         call find_halves(values, given, truth, half)
         call keep(loaded, of_rows, sampled, truth, half)
      end do
   end subroutine count_maps

   !> A sum of waves on a solid with 1 to 10 arms, a tenth to ten times as fast and one to a hundred times as stiff as those of the dice.
   subroutine draw_line(dice, number, trial, depth)
      type(dice_t), intent(inout) :: dice
      integer, intent(in) :: number
      type(stepping_case_t), intent(out) :: trial
      real(dp), intent(out) :: depth
      integer, parameter :: most_arms = 10
      real(dp) :: pace, factor

      call draw_case(dice, number, trial, depth)
      if (size(trial%times) > most_arms) then
         trial%times = trial%times(:most_arms)
         trial%stiffness = trial%stiffness(:most_arms)
      end if
      call dice%decades(-1.0_dp, 1.0_dp, pace)
      trial%times = pace*trial%times
      call dice%decades(0.0_dp, 2.0_dp, factor)
      trial%stiffness = factor*trial%stiffness
   end subroutine draw_line

   !> A whole number whose logarithm is uniform.
   subroutine draw_number(dice, low, high, number)
      type(dice_t), intent(inout) :: dice
      integer, intent(in) :: low, high
      integer, intent(out) :: number
      real(dp) :: value

      call dice%between(log(real(low, dp)), log(high + 1.0_dp), value)
      number = min(high, int(exp(value)))
   end subroutine draw_number

   !> A point on the waves of a trial, without samples.
   subroutine begin_point(trial, kind, depth, values, given)
      type(stepping_case_t), intent(in) :: trial
      integer, intent(in) :: kind
      real(dp), intent(in) :: depth
      real(dp), allocatable, intent(out) :: values(:)
      type(given_surface_t), intent(out) :: given
      type(wavy_model_t) :: model

      call new_wavy_model(model)
      values = model%variables%default
      values([in%kind, in%edge]) = [kind, trial%edge]
      values(in%branch) = merge(2, 1, trial%is_approach)
      values([in%period, in%stiffness, in%velocity]) = 1
      values(in%penetration) = depth
      if (trial%stress > 0) values([in%stress, in%range]) = [trial%stress, trial%range]
      values([in%moduli, in%relaxation_times]) = 1
      given%moduli = trial%stiffness
      given%relaxation_times = trial%times
      given%amplitudes = trial%amplitudes
      given%phases = trial%phases
   end subroutine begin_point

   !> Samples of the waves of a trial.
   subroutine give_samples(trial, n, interpolation, values, given)
      type(stepping_case_t), intent(in) :: trial
      integer, intent(in) :: n, interpolation
      real(dp), intent(inout) :: values(:)
      type(given_surface_t), intent(inout) :: given
      real(dp) :: weights(size(trial%amplitudes))

      weights = 1
      allocate (given%heights(n, 1))
      call fill_row(trial, weights, given%heights(:, 1))
      call set_samples(n, values)
      if (interpolation == linear_pieces) values(in%interpolation) = 1
   end subroutine give_samples

   !> Rows in which the waves of a trial are of changing height: the m-th has the share 1 + sum over k of parts(k) cos(2 pi k y + m
   !> shifts(k)).
   subroutine give_rows(trial, parts, shifts, nx, ny, values, given)
      type(stepping_case_t), intent(in) :: trial
      real(dp), intent(in) :: parts(:), shifts(:)
      integer, intent(in) :: nx, ny
      real(dp), intent(inout) :: values(:)
      type(given_surface_t), intent(inout) :: given
      real(dp) :: weights(size(trial%amplitudes))
      integer :: j, k, m

      allocate (given%heights(nx, ny))
      do j = 1, ny
         weights = 1
         do m = 1, size(weights)
            do k = 1, size(parts)
               weights(m) = weights(m) + parts(k)*cos(two_pi*k*(j - 1)/ny + m*shifts(k))
            end do
         end do
         call fill_row(trial, weights, given%heights(:, j))
      end do
      call set_samples(nx, values)
      values(in%strip_spacing) = 1/real(ny, dp)
   end subroutine give_rows

   !> Samples of a sum of waves.
   pure subroutine fill_row(trial, weights, heights)
      type(stepping_case_t), intent(in) :: trial
      !> Factors of the amplitudes.
      real(dp), intent(in) :: weights(:)
      real(dp), intent(out) :: heights(:)
      integer :: i, m

      heights = 0
      do m = 1, size(weights)
         do i = 1, size(heights)
            heights(i) = heights(i) + weights(m)*trial%amplitudes(m)*cos(two_pi*m*(i - 1)/size(heights) + trial%phases(m))
         end do
      end do
   end subroutine fill_row

   !> Samples are a period as they are.
   subroutine set_samples(n, values)
      integer, intent(in) :: n
      real(dp), intent(inout) :: values(:)

      values([in%heights, in%detrend, in%periodise]) = 1
      values(in%spacing) = 1/real(n, dp)
      values(in%period) = unset
   end subroutine set_samples

   !> Put a point under a load.
   subroutine load_point(values, load)
      real(dp), intent(inout) :: values(:)
      real(dp), intent(in) :: load

      values(in%penetration) = unset
      values(in%load) = load
   end subroutine load_point

   !> Highest position of rows.
   real(dp) function highest_of(heights) result(highest)
      real(dp), intent(in) :: heights(:, :)
      type(height_line_t) :: line
      real(dp) :: lowest, high
      integer :: j, piece

      highest = -huge(1.0_dp)
      do j = 1, size(heights, 2)
         call new_sampled_line(line, heights(:, j), cubic_pieces)
         call line%get_extremes(lowest, high, piece)
         highest = max(highest, high)
      end do
   end function highest_of

   !> Load and friction of a point.
   subroutine find_truth(values, given, truth)
      real(dp), intent(in) :: values(:)
      type(given_surface_t), intent(in) :: given
      type(forces_t), intent(out) :: truth
      type(relief_t) :: relief
      type(prony_t) :: prony
      type(master_curve_fit_t) :: fit
      type(stepped_case_t) :: point
      type(solid_t) :: solid
      type(stepping_surface_t) :: surface
      type(stepping_equilibrium_t) :: found
      type(error_t), allocatable :: error
      integer :: i

      call get_relief(values, given, .false., relief, error)
      if (allocated(error)) error stop 'marched_estimates: no rows'
      call get_spectrum(values, given, prony, fit)
      call resolve_stepped(values, given, relief, prony, point)
      call new_solid(solid, prony, point%pace)
      allocate (surface%rows(size(relief%rows)))
      do i = 1, size(relief%rows)
         call new_path(surface%rows(i), relief%rows(i), solid)
      end do
      call new_stepping_law(surface%law, point%stress, point%range, point%edge, solid%glassy)
      surface%is_approach = point%is_approach
      if (point%is_load_given) then
         call find_at_load(surface, point%load, found)
      else
         call find_at_penetration(surface, point%penetration, found)
      end if
      truth%is_solved = found%status == stepping_solved
      if (.not. truth%is_solved) return
      associate (f => found%forces, n => size(found%forces))
         truth%load = sum(f%load)/n*point%load_unit
         truth%friction = sum(f%friction)/n*point%friction_unit
         truth%load_scale = sum(f%load_scale)/n*point%load_unit
         truth%friction_scale = sum(f%friction_scale)/n*point%friction_unit
      end associate
   end subroutine find_truth

   !> Load and friction of every second row, under the same penetration or load as all.
   subroutine find_halves(values, given, truth, half)
      real(dp), intent(in) :: values(:)
      type(given_surface_t), intent(in) :: given
      type(forces_t), intent(in) :: truth
      type(forces_t), intent(out) :: half
      type(given_surface_t) :: every_second
      real(dp) :: of_half(size(values))

      if (.not. truth%is_solved) return
      every_second = given
      every_second%heights = given%heights(:, ::2)
      of_half = values
      of_half(in%strip_spacing) = 2*values(in%strip_spacing)
      if (is_set(values(in%penetration))) of_half(in%penetration) = values(in%penetration) &
         + highest_of(every_second%heights) - highest_of(given%heights)
      call find_truth(of_half, every_second, half)
   end subroutine find_halves

   !> Count a point.
   subroutine keep(counts, values, given, truth, half)
      type(counts_t), intent(inout) :: counts
      real(dp), intent(in) :: values(:)
      type(given_surface_t), intent(in) :: given
      type(forces_t), intent(in) :: truth
      !> What half as many rows make of the truth.
      type(forces_t), intent(in), optional :: half
      real(dp) :: results(n_wavy_results, 1), estimate(1), error
      integer :: status(1)
      logical :: is_load_given

      call solve_stepped_block(given, reshape(values, [size(values), 1]), results, estimate, status)
      if (.not. truth%is_solved .or. status(1) /= status_solved) then
         counts%n_unsolved = counts%n_unsolved + 1
         return
      end if
      is_load_given = is_set(values(in%load))
      error = true_error(results(out%load, 1), results(out%friction_force, 1), truth, is_load_given)
      if (present(half)) then
         if (.not. half%is_solved) then
            counts%n_doubtful = counts%n_doubtful + 1
         else if (true_error(half%load, half%friction, truth, is_load_given) > max(error, estimate(1))/3) then
            counts%n_doubtful = counts%n_doubtful + 1
         end if
      end if
      call count_case(counts, estimate(1), error, trim(counts%name))
   end subroutine keep

   !> Larger error of load and friction, in the sizes that the estimate is meant in; 1 is the largest that it knows.
   pure real(dp) function true_error(load, friction, truth, is_load_given) result(error)
      real(dp), intent(in) :: load, friction
      type(forces_t), intent(in) :: truth
      !> Then the load has no error.
      logical, intent(in) :: is_load_given
      real(dp) :: sizes(2), errors(2)

      sizes = max(abs([truth%load, truth%friction]), share_of_scale*[truth%load_scale, truth%friction_scale], tiny(1.0_dp))
      sizes(2) = max(sizes(2), negligible*sizes(1))
      errors = abs([load - truth%load, friction - truth%friction])
      if (is_load_given) errors(1) = 0
      error = min(1.0_dp, maxval(errors/sizes))
   end function true_error

end module stepped_estimates
