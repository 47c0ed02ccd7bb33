!> Steady states of a column under a period of heights.
!>
!> A period maps states to states and keeps their order, so there is a least steady state, `adhered`, and a greatest one, `approach`;
!> without adhesion there is one. A step towards them takes the response of the period with its zones as they are, J0: for states
!> x <= y the period has F(y) - F(x) >= J0(x) (y - x), and J0 does not fall with x. From below, steps (I - J0)^-1 (F(e) - e) of the state
!> e itself do not pass the least steady state; from above, with J0 of the least one, they do not pass the greatest. Without adhesion F is convex, J0
!> is its derivative, and the same steps converge from anywhere. Where the flag changes, the period itself is the step.
module adfric_wavy_march_steady_march
   use adfric_base_kinds, only: dp
   use adfric_numerics_lapack, only: dgesv
   use adfric_wavy_march_law, only: march_law_t
   use adfric_wavy_march_period, only: column_state_t, period_t, march_period, in_contact, in_adhesion
   use adfric_wavy_march_way, only: way_t, decay_of, expm1_of
   implicit none (type, external)
   private
   public :: steady_march_t, take_step, find_adhered, find_approach, start_from_below, start_from_free, move

   !> Steps that are smaller than this share of lengths are round-off.
   real(dp), parameter :: round_off = 8*epsilon(1.0_dp)
   !> Most periods of one search.
   integer, parameter :: most_periods = 20000
   !> Starts are beyond all steady states by this, so that none is met by chance.
   real(dp), parameter :: beyond = 1.0e-3_dp

   !> A state on its way to be steady.
   type :: steady_march_t
      !> The state where the period begins.
      type(column_state_t) :: state
      !> The last period from a state.
      type(period_t) :: period
      !> The step from that state; shape `(n_arms)`.
      real(dp), allocatable :: step(:)
      !> The largest component of the step, and what round-off makes of it.
      real(dp) :: largest_step = huge(1.0_dp), least_step = 0
      !> Load of the period with its step, and its change with the penetration while zones are as they are.
      real(dp) :: load = 0, load_slope = 0
      !> Change of the state with the penetration while zones are as they are; shape `(n_arms)`.
      real(dp), allocatable :: response(:)
      !> Number of periods marched.
      integer :: n_periods = 0
      !> Is the state steady to round-off?
      logical :: is_steady = .false.
      !> Has something gone wrong?
      logical :: has_failed = .false.
   end type steady_march_t

contains

   !> The state of endless contact.
   pure subroutine start_from_endless_contact(self, way, law, depth)
      !> Receives the state.
      type(steady_march_t), intent(inout) :: self
      !> The way.
      type(way_t), intent(in) :: way
      !> The law of adhesion.
      type(march_law_t), intent(in) :: law
      !> Penetration.
      real(dp), intent(in) :: depth

      self%state%length = depth + way%coefficients(0, 1) - way%head(:, 1) - law%shift
      where (way%is_slow) self%state%length = depth + way%first_length - law%shift
      self%state%is_attached = .true.
   end subroutine start_from_endless_contact

   !> A state below all that are steady: in endless contact or, where that is lower, attached everywhere. Both are states that a
   !> period raises, and so is the higher one of both for each arm.
   pure subroutine start_from_below(self, way, law, depth)
      !> Receives the state.
      type(steady_march_t), intent(inout) :: self
      !> The way.
      type(way_t), intent(in) :: way
      !> The law of adhesion.
      type(march_law_t), intent(in) :: law
      !> Penetration.
      real(dp), intent(in) :: depth

      call start_from_endless_contact(self, way, law, depth)
      if (law%stress > 0) self%state%length = max(self%state%length, -law%stress - law%shift - beyond)
   end subroutine start_from_below

   !> A state above all that are steady: free.
   pure subroutine start_from_free(self, way, depth)
      !> Receives the state.
      type(steady_march_t), intent(inout) :: self
      !> The way.
      type(way_t), intent(in) :: way
      !> Penetration.
      real(dp), intent(in) :: depth

      self%state%length = spread(max(depth, 0.0_dp) + beyond, 1, way%solid%n)
      self%state%is_attached = .false.
   end subroutine start_from_free

   !> The least steady state, from the state that stands in `self`, which lies below it; without adhesion the only one, from any state.
   pure subroutine find_adhered(self, way, law, depth)
      !> In: where to start. Out: the steady state.
      type(steady_march_t), intent(inout) :: self
      !> The way.
      type(way_t), intent(in) :: way
      !> The law of adhesion.
      type(march_law_t), intent(in) :: law
      !> Penetration.
      real(dp), intent(in) :: depth
      integer :: k

      self%is_steady = .false.
      do k = 1, most_periods
         call take_step(self, way, law, depth)
         if (self%is_steady .or. self%has_failed) return
         call move(self)
      end do
      self%has_failed = .true.
   end subroutine find_adhered

   !> The greatest steady state, from the state that stands in `self`, which lies above it.
   pure subroutine find_approach(self, least, way, law, depth)
      !> In: where to start. Out: the steady state.
      type(steady_march_t), intent(inout) :: self
      !> In: a state below all that are steady. Out: the least steady state.
      type(steady_march_t), intent(inout) :: least
      !> The way.
      type(way_t), intent(in) :: way
      !> The law of adhesion.
      type(march_law_t), intent(in) :: law
      !> Penetration.
      real(dp), intent(in) :: depth
      integer :: k

      self%is_steady = .false.
      call find_adhered(least, way, law, depth)
      self%has_failed = least%has_failed
      if (self%has_failed) return
      do k = 1, most_periods
         call take_step(self, way, law, depth, least%period)
         if (self%is_steady .or. self%has_failed) return
         call move(self)
      end do
      self%has_failed = .true.
   end subroutine find_approach

   !> March a period and find the step that follows from it.
   pure subroutine take_step(self, way, law, depth, least)
      !> The state; receives period and step.
      type(steady_march_t), intent(inout) :: self
      !> The way.
      type(way_t), intent(in) :: way
      !> The law of adhesion.
      type(march_law_t), intent(in) :: law
      !> Penetration.
      real(dp), intent(in) :: depth
      !> A period from the least steady state, whose response is taken instead of that of the period itself.
      type(period_t), intent(in), optional :: least
      real(dp), allocatable :: steps(:, :)
      real(dp) :: sums(2), lengths
      logical :: is_solved, changes_flag

      call march_period(way, law, depth, self%state, self%period)
      self%n_periods = self%n_periods + 1
      self%has_failed = .not. self%period%is_complete
      changes_flag = law%stress > 0 .and. (self%period%is_attached .neqv. self%state%is_attached)
      allocate (steps(way%solid%n, 2))
      if (present(least)) then
         call get_steps(way, least, self%period%growth, steps, is_solved)
      else
         call get_steps(way, self%period, self%period%growth, steps, is_solved)
      end if
      if (changes_flag) steps(:, 1) = self%period%growth
      self%has_failed = self%has_failed .or. .not. is_solved .or. .not. all(abs(steps) <= huge(1.0_dp))
      if (self%has_failed) return
      call get_displacement_sums(way, self%period, steps, sums)
      ! the load of a steady state is the integral of its displacement; of another one it is not that of its pressure
      self%load = self%period%load - sum(way%solid%stiffness*way%solid%time*self%period%growth)
      if (.not. (changes_flag .or. present(least))) self%load = self%load + sums(1)
      self%load_slope = sums(2)
      if (present(least)) then
         ! the load of the greatest state changes with its own zones
         call get_steps(way, self%period, self%period%growth, steps, is_solved)
         call get_displacement_sums(way, self%period, steps, sums)
         self%load_slope = sums(2)
         call get_steps(way, least, self%period%growth, steps, is_solved)
         if (changes_flag) steps(:, 1) = self%period%growth
      end if
      self%step = steps(:, 1)
      self%response = steps(:, 2)
      lengths = 1 + abs(depth) + law%stress + law%shift
      self%largest_step = maxval([0.0_dp, abs(steps(:, 1))])
      self%least_step = round_off*lengths
      self%is_steady = self%largest_step <= self%least_step .and. .not. changes_flag
   end subroutine take_step

   !> Take the step.
   pure subroutine move(self)
      !> The state, with its step.
      type(steady_march_t), intent(inout) :: self

      self%state%length = self%state%length + self%step
      self%state%is_attached = self%period%is_attached
   end subroutine move

   !> Steps (I - J0)^-1 of a growth, and of what a unit of penetration adds in contact.
   pure subroutine get_steps(way, period, growth, steps, is_solved)
      !> The way.
      type(way_t), intent(in) :: way
      !> The period, of which the zones are taken.
      type(period_t), intent(in) :: period
      !> Growth F(e) - e; shape `(n_arms)`.
      real(dp), intent(in) :: growth(:)
      !> Receives the step of the growth, and the response to the penetration; shape `(n_arms, 2)`.
      real(dp), intent(out) :: steps(:, :)
      !> Was the system solved?
      logical, intent(out) :: is_solved
      ! the columns are I, whose growth is J0 - I, and the response to a unit of penetration
      real(dp) :: vectors(way%solid%n, way%solid%n + 1), grown(way%solid%n, way%solid%n + 1)
      integer :: pivots(way%solid%n), i, info

      is_solved = .true.
      if (way%solid%n == 0) return
      vectors = 0
      do i = 1, way%solid%n
         vectors(i, i) = 1
      end do
      call pass_zones(way, period, vectors, grown)
      steps(:, 1) = growth
      steps(:, 2) = grown(:, way%solid%n + 1)
      grown = -grown
      call dgesv(way%solid%n, 2, grown, way%solid%n, pivots, steps, way%solid%n, info)
      is_solved = info == 0
   end subroutine get_steps

   !> Send disturbances of the lengths through the zones of a period. The last one has a unit of penetration with it.
   pure subroutine pass_zones(way, period, vectors, grown)
      !> The way.
      type(way_t), intent(in) :: way
      !> The period.
      type(period_t), intent(in) :: period
      !> In: disturbances where the period begins. Out: where it ends; shape `(n_arms, n_vectors)`.
      real(dp), intent(inout) :: vectors(:, :)
      !> Receives their growth, as a sum over zones; shape `(n_arms, n_vectors)`.
      real(dp), intent(out) :: grown(:, :)
      real(dp) :: elements(size(vectors, 1), size(vectors, 2)), lost(size(vectors, 1))
      integer :: i, zone, last

      grown = 0
      last = size(vectors, 2)
      do zone = 1, period%n_zones
         associate (duration => period%zones(zone)%duration, s => way%solid)
            if (period%zones(zone)%kind == in_contact) then
               lost = expm1_of(-duration/s%time)
               do i = 1, last
                  elements(:, i) = lost*vectors(:, i)
               end do
               elements(:, last) = elements(:, last) - lost
            else
               lost = expm1_of(-duration/s%retardation)
               elements = matmul(s%elements_of_lengths, vectors)
               do i = 1, last
                  elements(:, i) = lost*elements(:, i)
               end do
               elements = matmul(s%lengths_of_elements, elements)
            end if
            grown = grown + elements
            vectors = vectors + elements
         end associate
      end do
   end subroutine pass_zones

   !> Integrals over the period of the displacements that two disturbances of the lengths make; the second has a unit of penetration
   !> with it.
   pure subroutine get_displacement_sums(way, period, disturbances, sums)
      !> The way.
      type(way_t), intent(in) :: way
      !> The period.
      type(period_t), intent(in) :: period
      !> Disturbances where the period begins; shape `(n_arms, 2)`.
      real(dp), intent(in) :: disturbances(:, :)
      !> Receives the integrals.
      real(dp), intent(out) :: sums(2)
      real(dp) :: vectors(way%solid%n, 2), elements(way%solid%n, 2), lost(way%solid%n)
      integer :: i, zone

      vectors = disturbances
      sums = 0
      do zone = 1, period%n_zones
         associate (duration => period%zones(zone)%duration, s => way%solid)
            if (period%zones(zone)%kind == in_contact) then
               lost = expm1_of(-duration/s%time)
               vectors(:, 1) = vectors(:, 1) + lost*vectors(:, 1)
               vectors(:, 2) = vectors(:, 2) + lost*(vectors(:, 2) - 1)
               sums(2) = sums(2) + duration
            else
               lost = expm1_of(-duration/s%retardation)
               elements = matmul(s%elements_of_lengths, vectors)
               do i = 1, 2
                  elements(:, i) = lost*elements(:, i)
                  sums(i) = sums(i) - sum(s%retardation*elements(:, i))
               end do
               vectors = vectors + matmul(s%lengths_of_elements, elements)
            end if
         end associate
      end do
   end subroutine get_displacement_sums

end module adfric_wavy_march_steady_march
