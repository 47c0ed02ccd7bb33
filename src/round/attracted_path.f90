! SPDX-License-Identifier: GPL-3.0-or-later
!> All states of a round body that a law of attraction draws, from far apart to as deep as is asked for.
!>
!> The coordinate z of `attracted_state` follows them: less and less gap on the axis, then more and more contact. Load and approach may
!> rise and fall along it, so several states may carry a load or have an approach. A step is taken if Newton's method finds the next
!> state, if the determinant of that method keeps its sign (the path has no fold in z, and none is passed), and if load and approach
!> change as their slopes at both ends say. Folds are where a slope changes its sign.
module adfric_round_attracted_path
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_round_attracted_sample, only: body_t, attracted_sample_t, take_sample
   use adfric_round_attracted_nodes, only: attracted_t, grid_of_rigid_body, grid_of_state, node_grid_t
   use adfric_round_attracted_state, only: solve_state
   implicit none (type, external)
   private
   public :: path_t, stop_t, begin_path, follow_path, n_fine

   !> Nodes of the states along the path, and of the finer grid of samples.
   integer, parameter :: n_coarse = 50, n_fine = 100
   !> Most states of a path.
   integer, parameter :: most_stops = 2000

   !> A state of a path.
   type :: stop_t
      !> Coordinate, approach and load.
      real(dp) :: z = 0, approach = 0, load = 0
      !> d approach/dz and d load/dz before the state and after it; they differ where contact begins.
      real(dp) :: approach_slopes(2) = 0, load_slopes(2) = 0
      !> Grid that serves up to the next state.
      type(node_grid_t) :: grid
      !> Its state on the coarse grid.
      type(attracted_t), allocatable :: state
   end type stop_t

   !> A path.
   type :: path_t
      !> Body and law.
      type(body_t) :: body
      !> Number of states.
      integer :: n = 0
      !> The states; shape `(most_stops)`.
      type(stop_t), allocatable :: stops(:)
      !> Has every step been taken?
      logical :: is_certain = .true.
      !> Next step in z, and scales of load and approach.
      real(dp) :: step = 0, load_scale = 0, approach_scale = 0
   end type path_t

contains

   !> Begin a path where the body is far away.
   subroutine begin_path(body, farthest, path)
      type(body_t), intent(in) :: body
      !> Gap on the axis up to which states are wanted, below the end of the law if it has one; at least it is one where next to
      !> nothing is attracted.
      real(dp), intent(in) :: farthest
      type(path_t), intent(out) :: path
      type(node_grid_t) :: grid
      type(attracted_t), allocatable :: none
      type(stop_t) :: first
      real(dp) :: gap
      real(dp), parameter :: nothing = 1.0e-4_dp, within_end = 0.999_dp
      integer :: k
      integer, parameter :: n_parts = 400

      path%body = body
      allocate (path%stops(most_stops))
      associate (law => body%law)
         gap = max(merge(within_end*law%range, law%reach(nothing), law%has_end()), farthest)
         ! rigid pull in contact, 2 pi int s(f) r dr
         do k = 1, n_parts
            associate (r => body%shape%radius_of_height(20*law%range)*(k - 0.5_dp)/n_parts)
               path%load_scale = path%load_scale + two_pi*r*law%tension(height_at(body, r)) &
                  & *body%shape%radius_of_height(20*law%range)/n_parts
            end associate
         end do
         path%approach_scale = law%range
      end associate
      call grid_of_rigid_body(body%shape, body%law, gap, grid)
      allocate (first%state)
      call solve_state(body%shape, body%law, -gap, grid, n_coarse, none, first%state)
      path%is_certain = first%state%is_found
      if (.not. path%is_certain) return
      first%z = -gap
      path%step = 0.1_dp*gap
      call grid_of_state(first%state, body%law%has_wall(), first%grid)
      call take_slopes(path, first, path%is_certain)
      if (path%is_certain) call add_stop(path, first)
   end subroutine begin_path

   !> Height of the profile.
   pure real(dp) function height_at(body, r) result(height)
      type(body_t), intent(in) :: body
      real(dp), intent(in) :: r
      real(dp) :: slope

      height = huge(height)
      if (r < body%shape%edge) call body%shape%get_profile(r, height, slope)
   end function height_at

   !> Take a state, of which the coarse state and the slopes are known.
   subroutine add_stop(path, next)
      type(path_t), intent(inout) :: path
      type(stop_t), intent(inout) :: next
      type(attracted_sample_t) :: sample

      call take_sample(path%body, next%z, next%grid, n_fine, next%state, sample)
      path%is_certain = sample%is_found .and. next%state%orientation == 1
      if (.not. path%is_certain) return
      next%approach = sample%approach
      next%load = sample%load
      path%n = path%n + 1
      path%stops(path%n) = next
   end subroutine add_stop

   !> Slopes of approach and load on the grid of a state. Where contact begins, its radius a has just begun to grow: a^2, a of a cone,
   !> goes on as the gap has shrunk, and the forces of contact are of higher order. So the slopes after that have the signs of those
   !> before, and vanish.
   subroutine take_slopes(path, next, is_found)
      type(path_t), intent(in) :: path
      type(stop_t), intent(inout) :: next
      logical, intent(out) :: is_found
      type(attracted_t) :: own, near
      type(attracted_t), allocatable :: guess
      real(dp), parameter :: small = 1.0e-4_dp, vanishing = 1.0e-12_dp
      real(dp) :: step

      step = small*path%step
      if (next%z < 0) step = min(step, -next%z/2)
      if (.not. abs(next%z) > 0) step = -small*path%body%law%range
      allocate (guess, source=next%state)
      call solve_state(path%body%shape, path%body%law, next%z, next%grid, n_coarse, guess, own)
      is_found = own%is_found
      if (.not. is_found) return
      call solve_state(path%body%shape, path%body%law, next%z + step, next%grid, n_coarse, guess, near)
      is_found = near%is_found
      if (.not. is_found) return
      next%approach_slopes = (near%approach - own%approach)/step
      next%load_slopes = (near%load - own%load)/step
      if (.not. abs(next%z) > 0) then
         next%approach_slopes(2) = vanishing*next%approach_slopes(1)
         next%load_slopes(2) = vanishing*next%load_slopes(1)
      end if
      next%state = own
   end subroutine take_slopes

   !> Follow a path until load, approach and coordinate are beyond given ones, and both rise.
   subroutine follow_path(path, load, approach, z)
      type(path_t), intent(inout) :: path
      !> Load and approach; coordinate.
      real(dp), intent(in) :: load, approach, z
      type(stop_t) :: next
      logical :: is_taken
      integer :: k
      integer, parameter :: most_halvings = 40

      do while (path%is_certain)
         associate (last => path%stops(path%n))
            if (last%load > max(load, 0.0_dp) .and. last%approach > max(approach, 0.0_dp) .and. last%z > z &
               & .and. last%approach_slopes(2) > 0 .and. last%load_slopes(2) > 0) return
         end associate
         path%is_certain = path%n < most_stops
         if (.not. path%is_certain) return
         do k = 1, most_halvings
            call try_step(path, next, is_taken)
            if (is_taken) exit
            path%step = path%step/2
         end do
         path%is_certain = is_taken
      end do
   end subroutine follow_path

   !> Try the next step, and add its state.
   subroutine try_step(path, next, is_taken)
      type(path_t), intent(inout) :: path
      type(stop_t), intent(out) :: next
      logical, intent(out) :: is_taken
      real(dp), parameter :: largest_change = 0.15_dp, largest_miss = 0.02_dp, growth = 1.5_dp
      real(dp) :: step, change(2), miss(2)

      is_taken = .false.
      associate (last => path%stops(path%n), body => path%body)
         step = path%step
         if (last%z < 0) step = min(step, -last%z)
         if (.not. abs(last%z) > 0) step = min(step, 0.1_dp*last%grid%width)
         next%z = last%z + step
         allocate (next%state)
         call solve_state(body%shape, body%law, next%z, last%grid, n_coarse, last%state, next%state)
         if (.not. next%state%is_found) return
         call take_next(path, step, next, is_taken, change, miss)
         if (.not. is_taken) return
         is_taken = maxval(change) <= largest_change .and. maxval(miss) <= largest_miss
      end associate
      if (.not. is_taken) return
      call add_stop(path, next)
      is_taken = path%is_certain
      path%is_certain = .true.
      if (maxval(change) < largest_change/2 .and. maxval(miss) < largest_miss/3 .and. is_taken) path%step = growth*step
      if (.not. abs(path%stops(path%n)%z) > 0) path%step = max(path%step, 0.1_dp*path%stops(path%n)%grid%width)
   end subroutine try_step

   !> How much load and approach change over a step, and how far that is from what their slopes say, over their scales.
   subroutine take_next(path, step, next, is_found, change, miss)
      type(path_t), intent(in) :: path
      real(dp), intent(in) :: step
      type(stop_t), intent(inout) :: next
      logical, intent(out) :: is_found
      real(dp), intent(out) :: change(2), miss(2)
      real(dp) :: changes(2), scales(2)

      associate (last => path%stops(path%n))
         changes = [next%state%approach - last%state%approach, next%state%load - last%state%load]
         scales = [max(path%approach_scale, 0.3_dp*abs(last%approach)), max(path%load_scale, abs(last%load))]
         change = abs(changes)/scales
         is_found = all(change < 1)
         if (.not. is_found) return
         call grid_of_state(next%state, path%body%law%has_wall(), next%grid)
         call take_slopes(path, next, is_found)
         if (.not. is_found) return
         miss = abs(changes - step*([last%approach_slopes(2), last%load_slopes(2)] &
            & + [next%approach_slopes(1), next%load_slopes(1)])/2)/scales
         if (.not. abs(last%z) > 0) miss = 0
      end associate
   end subroutine take_next

end module adfric_round_attracted_path
