! SPDX-License-Identifier: GPL-3.0-or-later
!> A column with any number of relaxation times under a sum of waves, followed in small steps of time: independent of every
!> closed form of the solver. For tests and benchmarks only.
!>
!> tau_i e_i' = w - e_i for the lengths of the dashpots, with the law of adhesion in terms of m, the position where the column would
!> be if it were let go. Second order where nothing jumps, first order where the column is caught or lost.
module brute_spectrum
   use adfric_base_kinds, only: dp
   use stepping_cases, only: stepping_case_t
   implicit none (type, external)
   private
   public :: brute_column_t, brute_forces_t, new_brute_column, settle

   real(dp), parameter :: two_pi = 6.283185307179586476925286766559_dp
   integer, parameter :: continuous = 1, instantaneous = 2

   !> The column and its way.
   type :: brute_column_t
      !> Heights at the ends of the steps, with the penetration; shape `(0:n_steps)`.
      real(dp), allocatable :: height(:)
      real(dp), allocatable :: stiffness(:)
      !> Weights of a step: what is kept of a length, and the shares of w where the step begins and ends.
      real(dp), allocatable :: kept(:), first(:), last(:)
      real(dp) :: stress = 0, range = 0, glassy = 1
      integer :: edge = continuous
      !> Lengths of the dashpots, without the shift of continuous edges.
      real(dp), allocatable :: length(:)
      logical :: is_attached = .false.
   end type brute_column_t

   !> What a period adds up to.
   type :: brute_forces_t
      real(dp) :: load = 0, friction = 0, contact = 0
      !> Were the last two periods the same?
      logical :: is_steady = .false.
   end type brute_forces_t

contains

   !> A column that is above all steady states (approach) or below them.
   pure subroutine new_brute_column(self, trial, depth, highest, n_steps)
      type(brute_column_t), intent(out) :: self
      type(stepping_case_t), intent(in) :: trial
      !> Penetration, and highest height of the waves.
      real(dp), intent(in) :: depth, highest
      integer, intent(in) :: n_steps
      real(dp) :: angle, z
      integer :: i, k, m

      allocate (self%height(0:n_steps), source=depth - highest)
      do m = 1, size(trial%amplitudes)
         do k = 0, n_steps
            ! x falls
            angle = two_pi*modulo(-m*real(k, dp)/n_steps, 1.0_dp) + trial%phases(m)
            self%height(k) = self%height(k) + trial%amplitudes(m)*cos(angle)
         end do
      end do
      self%stiffness = trial%stiffness
      self%glassy = 1 + sum(trial%stiffness)
      self%stress = trial%stress
      self%range = trial%range
      self%edge = trial%edge
      allocate (self%kept(size(trial%times)), self%first(size(trial%times)), self%last(size(trial%times)))
      do i = 1, size(trial%times)
         z = 1/(n_steps*trial%times(i))
         self%kept(i) = exp(-z)
         self%last(i) = 1 - (1 - self%kept(i))/z
         self%first(i) = 1 - self%kept(i) - self%last(i)
      end do
      self%is_attached = .not. trial%is_approach
      allocate (self%length(size(trial%times)), source=max(depth, 0.0_dp) + 1)
      if (self%is_attached) self%length = minval(self%height) - 1 - trial%stress
      if (self%is_attached .and. self%edge == continuous) self%length = self%length - trial%stress/(self%glassy - 1)
   end subroutine new_brute_column

   !> Where the column is at a height, for given lengths; the flag follows.
   pure subroutine position_column(self, length, height, is_attached, displacement, pressure)
      type(brute_column_t), intent(in) :: self
      real(dp), intent(in) :: length(:), height
      logical, intent(inout) :: is_attached
      !> Receive displacement and pressure.
      real(dp), intent(out) :: displacement, pressure
      real(dp) :: m, jump

      m = sum(self%stiffness*length)/self%glassy
      jump = self%stress/self%glassy
      if (.not. self%stress > 0) then
         is_attached = .false.
         displacement = max(height, m)
         pressure = self%glassy*(displacement - m)
         return
      end if
      select case (self%edge)
      case (continuous)
         is_attached = m - height <= self%range
         displacement = max(height, m)
         pressure = self%glassy*(displacement - m)
         if (is_attached) pressure = pressure - self%stress
      case (instantaneous)
         if (m - height <= self%range) is_attached = .true.
         if (m - height >= self%range + jump) is_attached = .false.
         displacement = m
         if (is_attached) displacement = max(height, m - jump)
         pressure = self%glassy*(displacement - m)
      case default
         is_attached = m - height <= self%range + jump/2
         if (jump > 2*self%range) is_attached = m - height <= sqrt(2*jump*self%range)
         displacement = m
         if (is_attached) displacement = max(height, m - jump)
         pressure = self%glassy*(displacement - m)
      end select
   end subroutine position_column

   !> Time stepping one period.
   pure subroutine step_one_period(self, forces)
      type(brute_column_t), intent(inout) :: self
      type(brute_forces_t), intent(inout) :: forces
      real(dp) :: w, p, next_w, next_p, shift, trial(size(self%length))
      logical :: flag
      integer :: k, n

      n = ubound(self%height, 1)
      forces%load = 0
      forces%friction = 0
      forces%contact = 0
      shift = 0
      if (self%edge == continuous .and. self%stress > 0) shift = self%stress/(self%glassy - 1)
      call position_column(self, self%length, self%height(0), self%is_attached, w, p)
      do k = 1, n
         flag = self%is_attached
         associate (s => merge(shift, 0.0_dp, flag))
            ! the column that stays where it is tells where it goes
            trial = self%kept*self%length + (1 - self%kept)*(w - s)
            call position_column(self, trial, self%height(k), flag, next_w, next_p)
            self%length = self%kept*self%length + self%first*(w - s) + self%last*(next_w - merge(shift, 0.0_dp, flag))
         end associate
         call position_column(self, self%length, self%height(k), self%is_attached, next_w, next_p)
         forces%load = forces%load + (p + next_p)/2/n
         forces%friction = forces%friction + (p + next_p)/2*(self%height(k) - self%height(k - 1))
         if (.not. next_w > self%height(k)) forces%contact = forces%contact + 1.0_dp/n
         w = next_w
         p = next_p
      end do
   end subroutine step_one_period

   !> Time stepping until periods do not differ any more.
   pure subroutine settle(self, most_periods, forces)
      type(brute_column_t), intent(inout) :: self
      integer, intent(in) :: most_periods
      type(brute_forces_t), intent(out) :: forces
      real(dp), parameter :: tolerance = 1.0e-10_dp
      real(dp) :: before(size(self%length))
      logical :: flag
      integer :: k

      do k = 1, most_periods
         before = self%length
         flag = self%is_attached
         call step_one_period(self, forces)
         forces%is_steady = maxval(abs(self%length - before)) <= tolerance .and. (flag .eqv. self%is_attached)
         if (forces%is_steady) return
      end do
   end subroutine settle

end module brute_spectrum
