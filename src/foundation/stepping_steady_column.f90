! SPDX-License-Identifier: GPL-3.0-or-later
!> Steady states of a column under a period of heights.
!>
!> A period maps states to states and keeps their order, so there is a least steady state, `adhered`, and a greatest one, `approach`;
!> without adhesion there is one. A step towards them takes the response of the period with its zones as they are, J0: for states
!> x <= y the period has F(y) - F(x) >= J0(x) (y - x), and J0 does not fall with x. From below, steps (I - J0)^-1 (F(e) - e) of the state
!> e itself do not pass the least steady state; from above, with J0 of any state below the greatest one, they do not pass that
!> (`adfric_foundation_stepping_approach_state`). Without adhesion F is convex, J0 is its derivative, and the same steps converge from anywhere.
!> Where the flag changes, the period itself is the step.
module adfric_foundation_stepping_steady_column
   use adfric_base_kinds, only: dp
   use adfric_numerics_lapack, only: dgesv
   use adfric_foundation_stepping_law, only: stepping_law_t
   use adfric_foundation_stepping_period, only: column_state_t, stepped_period_t, step_period, in_contact
   use adfric_foundation_stepping_response, only: get_edge_steps
   use adfric_foundation_stepping_solid, only: multiply
   use adfric_foundation_stepping_path, only: column_path_t, expm1_of
   implicit none (type, external)
   private
   public :: steady_column_t, take_step, take_edge_step, find_adhered, start_from_below, start_from_free, stepping, changes_flag, &
      & judge_step, move, get_steps, get_matrix, get_displacement_sums, most_edge_steps, most_periods

   !> Steps that are smaller than this share of lengths are round-off.
   real(dp), parameter :: round_off = 8*epsilon(1.0_dp)
   !> Steps of this share of lengths may be all that round-off leaves to do.
   real(dp), parameter :: small_step = 1.0e-12_dp
   !> So often such steps must not have become smaller.
   integer, parameter :: most_stuck = 4
   !> Most periods of one search.
   integer, parameter :: most_periods = 3000
   !> Most steps of Newton's method with edges, which are few where it converges.
   integer, parameter :: most_edge_steps = 12
   !> Newton's method with edges has failed where it goes so many times as far as lengths are.
   real(dp), parameter :: farthest = 1.0e3_dp
   !> Starts are beyond all steady states by this, so that none is met by chance.
   real(dp), parameter :: beyond = 1.0e-3_dp

   !> A state on its way to be steady.
   type :: steady_column_t
      !> The state where the period begins.
      type(column_state_t) :: state
      !> The last period from a state.
      type(stepped_period_t) :: period
      !> The step from that state; shape `(n_arms)`.
      real(dp), allocatable :: step(:)
      !> The largest component of the step.
      real(dp) :: largest_step = huge(1.0_dp)
      !> How often small steps have not become smaller.
      integer :: n_stuck = 0
      !> Load of the period with its step, and its change with the penetration while zones are as they are.
      real(dp) :: load = 0, load_slope = 0
      !> Change of the state with the penetration while zones are as they are; shape `(n_arms)`.
      real(dp), allocatable :: response(:)
      !> Number of periods stepped.
      integer :: n_periods = 0
      !> Is the state steady to round-off?
      logical :: is_steady = .false.
      !> Has something gone wrong?
      logical :: has_failed = .false.
   end type steady_column_t

contains

   !> A state below all that are steady: in endless contact or, where that is lower, attached everywhere. Both are states that a
   !> period raises, and so is the higher one of both for each arm.
   pure subroutine start_from_below(self, path, law, depth)
      type(steady_column_t), intent(inout) :: self
      type(column_path_t), intent(in) :: path
      type(stepping_law_t), intent(in) :: law
      real(dp), intent(in) :: depth

      self%state%length = depth + path%coefficients(0, 1) - path%head(:, 1) - law%shift
      where (path%is_slow) self%state%length = depth + path%first_length - law%shift
      self%state%is_attached = .true.
      self%state%branch = 0
      if (law%stress > 0) self%state%length = max(self%state%length, -law%stress - law%shift - beyond)
   end subroutine start_from_below

   !> A state above all that are steady: free.
   pure subroutine start_from_free(self, path, depth)
      type(steady_column_t), intent(inout) :: self
      type(column_path_t), intent(in) :: path
      real(dp), intent(in) :: depth

      self%state%length = spread(max(depth, 0.0_dp) + beyond, 1, path%solid%n)
      self%state%is_attached = .false.
      self%state%branch = huge(1)
   end subroutine start_from_free

   !> The least steady state, from the state that stands in `self`, which lies below it; without adhesion the only one, from any state.
   pure subroutine find_adhered(self, path, law, depth)
      !> In: where to start. Out: the steady state.
      type(steady_column_t), intent(inout) :: self
      type(column_path_t), intent(in) :: path
      type(stepping_law_t), intent(in) :: law
      real(dp), intent(in) :: depth
      integer :: k

      self%is_steady = .false.
      do k = 1, most_periods
         call take_step(self, path, law, depth)
         if (self%is_steady .or. self%has_failed) return
         call move(self)
      end do
      self%has_failed = .true.
   end subroutine find_adhered

   !> Time stepping a period and find Newton's step towards a steady state, with the edges, and how the load changes.
   pure subroutine take_edge_step(self, path, law, depth)
      !> The state; receives period and step.
      type(steady_column_t), intent(inout) :: self
      type(column_path_t), intent(in) :: path
      type(stepping_law_t), intent(in) :: law
      real(dp), intent(in) :: depth
      real(dp) :: load_step
      logical :: is_solved

      call stepping(self, path, law, depth)
      self%has_failed = self%has_failed .or. changes_flag(self, law)
      if (self%has_failed) return
      if (.not. allocated(self%response)) allocate (self%response(path%solid%n))
      call get_edge_steps(path, law, self%period, self%step, self%response, load_step, self%load_slope, is_solved)
      self%has_failed = .not. is_solved
      if (is_solved) self%has_failed = maxval([0.0_dp, abs(self%step)]) > farthest*(1 + abs(depth) + law%stress + law%shift)
      if (self%has_failed) return
      self%load = self%load + load_step
      call judge_step(self, law, depth)
   end subroutine take_edge_step

   !> Time stepping a period and find the step that follows from it, and how the load changes.
   pure subroutine take_step(self, path, law, depth)
      type(steady_column_t), intent(inout) :: self
      type(column_path_t), intent(in) :: path
      type(stepping_law_t), intent(in) :: law
      real(dp), intent(in) :: depth
      real(dp) :: steps(path%solid%n, 2), sums(2)
      logical :: is_solved

      call stepping(self, path, law, depth)
      if (self%has_failed) return
      call get_steps(path, self%period, steps, is_solved, self%period%growth)
      if (.not. changes_flag(self, law)) self%step = steps(:, 1)
      if (.not. allocated(self%response)) allocate (self%response(path%solid%n))
      self%response(:) = steps(:, 2)
      self%has_failed = .not. is_solved .or. .not. all(abs(steps) <= huge(1.0_dp))
      if (self%has_failed) return
      call get_displacement_sums(path, self%period, self%step, self%response, sums)
      if (.not. changes_flag(self, law)) self%load = self%load + sums(1)
      self%load_slope = sums(2)
      call judge_step(self, law, depth)
   end subroutine take_step

   !> Time stepping a period; until a better step is known, what it adds is the step.
   pure subroutine stepping(self, path, law, depth)
      !> The state; receives period, step and load.
      type(steady_column_t), intent(inout) :: self
      type(column_path_t), intent(in) :: path
      type(stepping_law_t), intent(in) :: law
      real(dp), intent(in) :: depth

      call step_period(path, law, depth, self%state, self%period)
      self%n_periods = self%n_periods + 1
      self%has_failed = .not. self%period%is_complete
      self%step = self%period%growth
      ! the load of a steady state is the integral of its displacement; of another one it is not that of its pressure
      self%load = self%period%load - sum(path%solid%stiffness*path%solid%time*self%period%growth)
   end subroutine stepping

   !> Does the last period attach or detach the column?
   pure logical function changes_flag(self, law)
      type(steady_column_t), intent(in) :: self
      type(stepping_law_t), intent(in) :: law

      if (allocated(law%attraction)) then
         changes_flag = self%period%branch /= self%state%branch
      else
         changes_flag = law%stress > 0 .and. (self%period%is_attached .neqv. self%state%is_attached)
      end if
   end function changes_flag

   !> Is the state steady to round-off?
   pure subroutine judge_step(self, law, depth)
      type(steady_column_t), intent(inout) :: self
      type(stepping_law_t), intent(in) :: law
      real(dp), intent(in) :: depth
      real(dp) :: previous, lengths

      previous = self%largest_step
      lengths = 1 + abs(depth) + law%stress + law%shift
      self%largest_step = maxval([0.0_dp, abs(self%step)])
      ! steps that are small and do not become smaller are the round-off of a response that is large
      if (self%largest_step > max(small_step*lengths, law%resolution)) then
         self%n_stuck = 0
      else if (self%largest_step >= previous) then
         self%n_stuck = self%n_stuck + 1
      end if
      self%is_steady = self%largest_step <= round_off*lengths .or. self%n_stuck >= most_stuck
      self%is_steady = self%is_steady .and. .not. changes_flag(self, law)
   end subroutine judge_step

   !> Take the step.
   pure subroutine move(self)
      type(steady_column_t), intent(inout) :: self

      self%state%length = self%state%length + self%step
      self%state%is_attached = self%period%is_attached
      self%state%branch = self%period%branch
   end subroutine move

   !> Steps (I - J0)^-1 of growths, and of what a unit of penetration adds in contact.
   pure subroutine get_steps(path, period, steps, is_solved, growth)
      type(column_path_t), intent(in) :: path
      type(stepped_period_t), intent(in) :: period
      !> Receives the step of the growth, or of a unit of growth of each arm, and at the end the response to the penetration; shape
      !> `(n_arms, n_steps)`.
      real(dp), intent(out) :: steps(:, :)
      logical, intent(out) :: is_solved
      !> Growth F(e) - e; shape `(n_arms)`.
      real(dp), intent(in), optional :: growth(:)
      ! the columns are I, whose growth is J0 - I, and the response to a unit of penetration
      real(dp) :: vectors(path%solid%n, path%solid%n + 1), grown(path%solid%n, path%solid%n + 1)
      integer :: pivots(path%solid%n), i, info

      is_solved = .true.
      if (path%solid%n == 0) return
      vectors = 0
      do i = 1, path%solid%n
         vectors(i, i) = 1
      end do
      steps = vectors(:, :size(steps, 2))
      if (present(growth)) steps(:, 1) = growth
      call pass_zones(path, period, vectors, grown)
      steps(:, size(steps, 2)) = grown(:, path%solid%n + 1)
      grown = -grown
      call dgesv(path%solid%n, size(steps, 2), grown, path%solid%n, pivots, steps, path%solid%n, info)
      is_solved = info == 0
   end subroutine get_steps

   !> I - J0 of a period.
   pure subroutine get_matrix(path, period, matrix)
      type(column_path_t), intent(in) :: path
      type(stepped_period_t), intent(in) :: period
      !> Receives it; shape `(n_arms, n_arms)`.
      real(dp), intent(out) :: matrix(:, :)
      real(dp) :: vectors(path%solid%n, path%solid%n + 1), grown(path%solid%n, path%solid%n + 1)
      integer :: i

      vectors = 0
      do i = 1, path%solid%n
         vectors(i, i) = 1
      end do
      call pass_zones(path, period, vectors, grown)
      matrix = -grown(:, :path%solid%n)
   end subroutine get_matrix

   !> Send disturbances of the lengths through the zones of a period. The last one has a unit of penetration with it.
   pure subroutine pass_zones(path, period, vectors, grown)
      type(column_path_t), intent(in) :: path
      type(stepped_period_t), intent(in) :: period
      !> In: disturbances where the period begins. Out: where it ends; shape `(n_arms, n_vectors)`.
      real(dp), intent(inout) :: vectors(:, :)
      !> Receives their growth, as a sum over zones; shape `(n_arms, n_vectors)`.
      real(dp), intent(out) :: grown(:, :)
      real(dp) :: elements(size(vectors, 1), size(vectors, 2)), lost(size(vectors, 1))
      integer :: i, zone, last

      grown = 0
      last = size(vectors, 2)
      do zone = 1, period%n_zones
         associate (duration => period%zones(zone)%duration, s => path%solid)
            if (period%zones(zone)%kind == in_contact) then
               lost = expm1_of(-duration/s%time)
               do i = 1, last
                  elements(:, i) = lost*vectors(:, i)
               end do
               elements(:, last) = elements(:, last) - lost
            else
               lost = expm1_of(-duration/s%retardation)
               call multiply(s%n, last, s%elements_of_lengths, vectors, .false., elements)
               do i = 1, last
                  elements(:, i) = lost*elements(:, i)
               end do
               call multiply(s%n, last, s%lengths_of_elements, elements, .true., grown)
               call multiply(s%n, last, s%lengths_of_elements, elements, .true., vectors)
               cycle
            end if
            grown = grown + elements
            vectors = vectors + elements
         end associate
      end do
   end subroutine pass_zones

   !> Integrals over the period of the displacements that two disturbances of the lengths make; the second has a unit of penetration
   !> with it.
   pure subroutine get_displacement_sums(path, period, step, response, sums)
      type(column_path_t), intent(in) :: path
      type(stepped_period_t), intent(in) :: period
      !> Disturbances where the period begins; shape `(n_arms)`.
      real(dp), intent(in) :: step(:), response(:)
      !> Receives the integrals.
      real(dp), intent(out) :: sums(2)
      real(dp) :: vectors(path%solid%n, 2), elements(path%solid%n, 2), lost(path%solid%n)
      integer :: i, zone

      vectors(:, 1) = step
      vectors(:, 2) = response
      sums = 0
      do zone = 1, period%n_zones
         associate (duration => period%zones(zone)%duration, s => path%solid)
            if (period%zones(zone)%kind == in_contact) then
               lost = expm1_of(-duration/s%time)
               vectors(:, 1) = vectors(:, 1) + lost*vectors(:, 1)
               vectors(:, 2) = vectors(:, 2) + lost*(vectors(:, 2) - 1)
               sums(2) = sums(2) + duration
            else
               lost = expm1_of(-duration/s%retardation)
               call multiply(s%n, 2, s%elements_of_lengths, vectors, .false., elements)
               do i = 1, 2
                  elements(:, i) = lost*elements(:, i)
                  sums(i) = sums(i) - sum(s%retardation*elements(:, i))
               end do
               call multiply(s%n, 2, s%lengths_of_elements, elements, .true., vectors)
            end if
         end associate
      end do
   end subroutine get_displacement_sums

end module adfric_foundation_stepping_steady_column
