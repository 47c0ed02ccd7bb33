! SPDX-License-Identifier: GPL-3.0-or-later
!> Folds of a path under what is prescribed, and the states that carry a load or have an approach.
module adfric_round_attracted_search
   use adfric_base_kinds, only: dp
   use adfric_round_attracted_path, only: n_fine, path_t
   use adfric_round_attracted_sample, only: attracted_sample_t, take_sample, with_control
   use adfric_round_contact, only: branch_inner, branch_stable, branch_unstable
   implicit none (type, external)
   private
   public :: folds_t, find_folds, find_state, found_t, slope_at, stop_before

   !> Where what is prescribed has a largest or a least value along a path.
   type :: folds_t
      !> Have all been found?
      logical :: is_converged = .true.
      !> Number of folds.
      integer :: n = 0
      !> The folds in the order of the path; shape `(n)`.
      type(attracted_sample_t), allocatable :: samples(:)
      !> Is a fold a least value? Shape `(n)`.
      logical, allocatable :: is_least(:)
      !> Index of the last state of the path before each fold; shape `(n)`.
      integer, allocatable :: before(:)
   end type folds_t

   !> A state that was sought.
   type :: found_t
      !> Is there one, and was it found?
      logical :: is_found = .false., is_converged = .true.
      !> Is it stable under what is prescribed?
      logical :: is_stable = .false.
      !> The state.
      type(attracted_sample_t) :: sample
      !> Index of the last state of the path before it.
      integer :: before = 0
   end type found_t

contains

   !> All folds of a path. Two in a row that differ by less than the grids resolve are none.
   subroutine find_folds(path, n, folds)
      type(path_t), intent(in) :: path
      !> Nodes of the finer grid.
      integer, intent(in) :: n
      type(folds_t), intent(out) :: folds
      real(dp), parameter :: resolved = 1.0e-3_dp
      logical, allocatable :: is_kept(:), is_sharp(:)
      real(dp) :: scale
      integer :: k, i

      allocate (folds%before(0))
      do k = 1, path%n - 1
         if (slope_of(path, k, 2)*slope_of(path, k + 1, 1) < 0) folds%before = [folds%before, k]
      end do
      folds%n = size(folds%before)
      allocate (folds%samples(folds%n), folds%is_least(folds%n), is_sharp(folds%n))
      do i = 1, folds%n
         folds%is_least(i) = slope_of(path, folds%before(i), 2) < 0
         call find_fold(path, folds%before(i), folds%is_least(i), n, folds%samples(i), is_sharp(i))
      end do
      allocate (is_kept(folds%n), source=.true.)
      scale = with_control(path%body, path%approach_scale, path%load_scale)
      i = 1
      do while (i < folds%n)
         if (all(folds%samples(i:i + 1)%is_found)) is_kept(i:i + 1) = abs(value_of(path, folds%samples(i)) &
            & - value_of(path, folds%samples(i + 1))) > resolved*scale
         i = i + merge(1, 2, is_kept(i))
      end do
      folds%is_converged = all(is_sharp .or. .not. is_kept)
      folds%samples = pack(folds%samples, is_kept)
      folds%is_least = pack(folds%is_least, is_kept)
      folds%before = pack(folds%before, is_kept)
      folds%n = count(is_kept)
   end subroutine find_folds

   !> What is prescribed in a state.
   pure real(dp) function value_of(path, sample) result(value)
      type(path_t), intent(in) :: path
      type(attracted_sample_t), intent(in) :: sample

      value = with_control(path%body, sample%approach, sample%load)
   end function value_of

   !> Slope of what is prescribed at a state of a path, before it (1) or after it (2).
   pure real(dp) function slope_of(path, k, side) result(slope)
      type(path_t), intent(in) :: path
      integer, intent(in) :: k, side

      slope = with_control(path%body, path%stops(k)%approach_slopes(side), path%stops(k)%load_slopes(side))
   end function slope_of

   !> The fold within a step: golden sections, then parabolas through three states that come closer. It is long by what
   !> both do where a state is not found.
   subroutine find_fold(path, k, is_least, n, fold, is_sharp)
      type(path_t), intent(in) :: path
      !> Index of the state before it.
      integer, intent(in) :: k
      logical, intent(in) :: is_least
      integer, intent(in) :: n
      !> Receives the fold; not `is_found` if a state was not found.
      type(attracted_sample_t), intent(out) :: fold
      !> Do parabolas agree on it?
      logical, intent(out) :: is_sharp
      real(dp), parameter :: golden = 0.6180339887498949_dp, spans(2) = [1.0e-2_dp, 2.0e-3_dp], flat = 1.0e-8_dp
      integer, parameter :: n_sections = 12, most_rounds = 60
      real(dp) :: low, high, inner(2), values(3), z, h, scale, step
      integer :: i, round, stage
      type(attracted_sample_t) :: section
      logical :: is_found

      is_sharp = .false.
      scale = with_control(path%body, path%approach_scale, path%load_scale)
      low = path%stops(k)%z
      high = path%stops(k + 1)%z
      is_found = .true.
      inner = [high - golden*(high - low), low + golden*(high - low)]
      values(1) = value_at(inner(1), n_fine)
      values(2) = value_at(inner(2), n_fine)
      do i = 1, n_sections
         if (.not. is_found) return
         if (values(1) < values(2)) then
            high = inner(2)
            inner = [high - golden*(high - low), inner(1)]
            values(1:2) = [value_at(inner(1), n_fine), values(1)]
         else
            low = inner(1)
            inner = [inner(2), low + golden*(high - low)]
            values(1:2) = [values(2), value_at(inner(2), n_fine)]
         end if
      end do
      z = (low + high)/2
      values(2) = value_at(z, n)
      if (.not. is_found) return
      section = fold
      do stage = 1, size(spans)
         h = spans(stage)*(path%stops(k + 1)%z - path%stops(k)%z)
         step = 0
         do round = 1, most_rounds
            ! the coordinate has a corner where contact begins; elsewhere finer grids may have the fold beyond the step
            if (.not. abs(path%stops(k + 1)%z) > 0) z = min(z, -h)
            if (.not. abs(path%stops(k)%z) > 0) z = max(z, h)
            is_found = z > 2*path%stops(k)%z - path%stops(k + 1)%z .and. z < 2*path%stops(k + 1)%z - path%stops(k)%z
            do i = 1, 3
               if (is_found) values(i) = value_at(z + (i - 2)*h, n)
            end do
            if (.not. is_found) exit
            if (values(2) <= min(values(1), values(3)) .or. maxval(values) - minval(values) <= flat*scale) exit
            ! the coarser grid of the path may have had the fold in the step before or behind: go on, faster the farther it is
            if (step*(values(1) - values(3)) > 0) then
               step = 1.6_dp*step
            else
               step = sign(max(h, abs(step)/2), values(1) - values(3))
            end if
            z = z + step
         end do
         if (round > most_rounds .or. .not. is_found) then
            ! what sections have found tells whether grids resolve it
            fold = section
            return
         end if
         ! where all three are the same but for round-off, the middle one is the fold
         if (values(1) - 2*values(2) + values(3) > flat*scale) &
            & z = z + h/2*(values(1) - values(3))/(values(1) - 2*values(2) + values(3))
      end do
      values(2) = value_at(z, n)
      is_sharp = is_found

   contains

      !> What is least at the fold.
      real(dp) function value_at(at, nodes) result(value)
         real(dp), intent(in) :: at
         integer, intent(in) :: nodes

         call take_sample(path%body, at, path%stops(k)%grid, nodes, path%stops(k)%state, fold)
         is_found = is_found .and. fold%is_found
         value = with_control(path%body, fold%approach, fold%load)
         if (.not. is_least) value = -value
      end function value_at

   end subroutine find_fold

   !> The state of a path that has what is prescribed, and lies on a branch.
   subroutine find_state(path, folds, given, branch, n, found)
      type(path_t), intent(in) :: path
      type(folds_t), intent(in) :: folds
      !> Load, approach, or that of the base of a spring.
      real(dp), intent(in) :: given
      !> One of `branch_...` of `contact`.
      integer, intent(in) :: branch
      !> Nodes of the finer grid.
      integer, intent(in) :: n
      type(found_t), intent(out) :: found
      real(dp) :: z(path%n + folds%n), values(path%n + folds%n)
      integer :: before(path%n + folds%n), k, i, m, chosen
      logical :: rises

      m = 0
      i = 1
      do k = 1, path%n
         m = m + 1
         z(m) = path%stops(k)%z
         values(m) = with_control(path%body, path%stops(k)%approach, path%stops(k)%load)
         before(m) = k
         if (i > folds%n) cycle
         if (folds%before(i) /= k) cycle
         m = m + 1
         z(m) = folds%samples(i)%z
         values(m) = with_control(path%body, folds%samples(i)%approach, folds%samples(i)%load)
         before(m) = k
         i = i + 1
      end do
      chosen = 0
      do k = 1, m - 1
         if ((values(k) - given)*(values(k + 1) - given) > 0 .or. .not. abs(values(k + 1) - given) > 0) cycle
         rises = values(k + 1) > values(k)
         if (rises .eqv. branch == branch_unstable) cycle
         if (branch == branch_inner .and. chosen > 0) cycle
         chosen = k
      end do
      if (chosen == 0) return
      found%is_found = .true.
      found%is_stable = branch /= branch_unstable
      found%before = before(chosen)
      call find_root(path, before(chosen), given, z(chosen:chosen + 1), n, found%sample, found%is_converged)
   end subroutine find_state

   !> The root between two coordinates, by secants that keep it in between.
   subroutine find_root(path, k, given, ends, n, root, is_converged)
      type(path_t), intent(in) :: path
      integer, intent(in) :: k
      real(dp), intent(in) :: given
      !> The coordinates.
      real(dp), intent(in) :: ends(2)
      integer, intent(in) :: n
      type(attracted_sample_t), intent(out) :: root
      logical, intent(out) :: is_converged
      real(dp) :: low, high, f_low, f_high, f, z, reach
      integer :: round
      integer, parameter :: most_rounds = 60
      real(dp), parameter :: at_rest = 1.0e-11_dp

      is_converged = .false.
      low = ends(1)
      high = ends(2)
      reach = high - low
      ! the path has other grids at both ends: what is sought may lie a little beyond
      call miss_at(low, f_low)
      do round = 1, 4
         if (.not. root%is_found) return
         call miss_at(high, f_high)
         if (.not. root%is_found .or. f_low*f_high <= 0) exit
         low = low - 0.01_dp*reach*2**round
         high = high + 0.01_dp*reach*2**round
         call miss_at(low, f_low)
      end do
      if (.not. root%is_found .or. .not. f_low*f_high <= 0) return
      do round = 1, most_rounds
         z = low
         if (abs(f_high - f_low) > 0) z = low - f_low*(high - low)/(f_high - f_low)
         call miss_at(z, f)
         if (.not. root%is_found) return
         is_converged = abs(f) <= at_rest*(abs(given) + with_control(path%body, path%approach_scale, path%load_scale)) .or. &
            & .not. abs(high - low) > 4*epsilon(z)*max(abs(low), abs(high))
         if (is_converged) return
         if (f*f_high < 0) then
            low = high
            f_low = f_high
         else
            f_low = f_low/2
         end if
         high = z
         f_high = f
      end do

   contains

      !> What a state has less what is given.
      subroutine miss_at(at, miss)
         real(dp), intent(in) :: at
         real(dp), intent(out) :: miss

         miss = 0
         call take_sample(path%body, at, path%stops(k)%grid, n, path%stops(k)%state, root)
         if (root%is_found) miss = with_control(path%body, root%approach, root%load) - given
      end subroutine miss_at

   end subroutine find_root

   !> Index of the last state of a path before a coordinate.
   pure integer function stop_before(path, z) result(k)
      type(path_t), intent(in) :: path
      real(dp), intent(in) :: z

      k = max(1, count(path%stops(:path%n)%z <= z))
   end function stop_before

   !> d load/d approach along the path at a state.
   subroutine slope_at(path, k, sample, n, stiffness, load_slope)
      type(path_t), intent(in) :: path
      !> Index of the state of the path before it.
      integer, intent(in) :: k
      type(attracted_sample_t), intent(in) :: sample
      integer, intent(in) :: n
      !> Receives d load/d approach, and d load/dz.
      real(dp), intent(out) :: stiffness, load_slope
      type(attracted_sample_t) :: sides(2)
      real(dp), parameter :: small = 1.0e-2_dp
      real(dp) :: step
      integer :: last, i

      stiffness = 0
      load_slope = 0
      last = min(k + 1, path%n)
      step = small*(path%stops(last)%z - path%stops(max(last - 1, 1))%z)
      if (sample%z < 0) step = min(step, -sample%z/2)
      if (sample%z < 0 .and. path%body%law%has_end()) step = min(step, (path%body%law%range + sample%z)/2)
      if (sample%z > 0) step = min(step, sample%z/2)
      do i = 1, 2
         call take_sample(path%body, sample%z + (2*i - 3)*step, path%stops(k)%grid, n, sample%state, sides(i))
         if (.not. sides(i)%is_found) return
      end do
      load_slope = (sides(2)%load - sides(1)%load)/(2*step)
      if (abs(sides(2)%approach - sides(1)%approach) > 0) &
         & stiffness = (sides(2)%load - sides(1)%load)/(sides(2)%approach - sides(1)%approach)
   end subroutine slope_at

end module adfric_round_attracted_search
