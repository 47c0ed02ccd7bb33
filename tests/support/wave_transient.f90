! SPDX-License-Identifier: GPL-3.0-or-later
!> A wave that begins to slide over a viscoelastic half-plane which adheres to it, integrated in time until it is steady. It judges
!> the steady states of the program, and so it uses none of its modules.
!>
!> Lengths count in 1/k with the wave number k, heights in the amplitude D, pressures in E0 k D with the relaxed modulus E0, and
!> friction in E0 k^2 D^2. The body h = cos x moves to +x, so that material passes one cell to -x in a step. With the displacement u
!> and the stretch s_i of arm i, pressure is
!>
!>     p = q + |k|/2 (u + sum E_i s_i),      ds_i/dt = du/dt - s_i/t_i,      gap g = u - h + const.
!>
!> Along the path of the material u changes linearly within a step, which arms follow exactly. So in a step the solid is elastic,
!> with a known past. Where the gap is within the range the surface pulls with p0: a share t of each cell, for linear gaps between nodes.
!> Rounds of shares and contacts lower the energy of the step and stand still at its state.
!>
!> An arm that remembers many periods would need many of them. It takes the memory of a body that has always slid with the present
!> surface: another past, of the same steady states.
module wave_transient
   implicit none (type, external)
   private
   public :: transient_t, new_transient, start_flat, start_full, start_full_at_speed, rest_under, slide_under, slide_at_gap, &
      & settle, contact_fraction_of, friction_of, full_pressure_of

   integer, parameter :: dp = kind(1.0d0)
   real(dp), parameter :: two_pi = 8*atan(1.0_dp)
   !> Relaxation length from which on an arm has the memory of steady sliding.
   real(dp), parameter :: long_memory = 10
   !> Rounds of a step, and changes of the contact in a round, at most; change of a share that ends the rounds.
   integer, parameter :: most_rounds = 10, most_changes = 200
   real(dp), parameter :: resting_share = 1.0e-7_dp

   !> What no result is like.
   real(dp), parameter :: unlike = 1.0e30_dp

   !> A wave on its half-plane.
   type :: transient_t
      !> Cells of the period.
      integer :: n = 0
      !> Tension and range of adhesion.
      real(dp) :: stress = 0, range = 0
      !> Arms: moduli, what a step leaves of a stretch, and what it adds of a change of the displacement; shape `(n_arms)`.
      real(dp), allocatable :: moduli(:), decay(:), gain(:)
      !> Has an arm the memory of steady sliding? Shape `(n_arms)`.
      logical, allocatable :: is_slow(:)
      !> Stiffness |k|/2 and derivative, matrices of shape `(n, n)`; memory of slow arms, by distance, shape `(0:n-1)`.
      real(dp), allocatable :: stiffness(:, :), derivative(:, :), memory(:)
      !> Heights of the body, displacement, gap, pressure and shares in range; shape `(n)`.
      real(dp), allocatable :: heights(:), u(:), gap(:), pressure(:), share(:)
      !> Stretches of the arms; shape `(n, n_arms)`.
      real(dp), allocatable :: stretch(:, :)
      !> Cells without contact; shape `(n)`.
      logical, allocatable :: is_open(:)
      !> Mean pressure.
      real(dp) :: load = 0
      !> Has contact been lost?
      logical :: is_apart = .false.
      !> Did all rounds end?
      logical :: is_sound = .true.
      !> Factor of the stiffness among open cells, and the cells and modulus it is of.
      real(dp), allocatable :: factor(:, :)
      logical, allocatable :: factored(:)
      real(dp) :: factored_modulus = 0
   end type transient_t

   interface
      !> Cholesky factor of LAPACK.
      subroutine dpotrf(uplo, n, a, lda, info)
         import :: dp
         implicit none (type, external)
         !> 'L' for the lower triangle.
         character, intent(in) :: uplo
         !> Order of the matrix, and its first dimension.
         integer, intent(in) :: n, lda
         !> In: the matrix. Out: its factor.
         real(dp), intent(inout) :: a(lda, *)
         !> 0 if the matrix is positive definite.
         integer, intent(out) :: info
      end subroutine dpotrf

      !> Solution from the factor.
      subroutine dpotrs(uplo, n, nrhs, a, lda, b, ldb, info)
         import :: dp
         implicit none (type, external)
         !> 'L' for the lower triangle.
         character, intent(in) :: uplo
         !> Order of the matrix, number of right-hand sides, first dimensions.
         integer, intent(in) :: n, nrhs, lda, ldb
         !> The factor.
         real(dp), intent(in) :: a(lda, *)
         !> In: right-hand sides. Out: solutions.
         real(dp), intent(inout) :: b(ldb, *)
         !> 0 if all went well.
         integer, intent(out) :: info
      end subroutine dpotrs
   end interface

contains

   !> A wave on a half-plane, apart and relaxed.
   subroutine new_transient(self, n, moduli, lengths, stress, range)
      type(transient_t), intent(out) :: self
      !> Cells of the period.
      integer, intent(in) :: n
      !> Moduli E_i/E0 and relaxation lengths k V t_i of the arms; shape `(n_arms)`.
      real(dp), intent(in) :: moduli(:), lengths(:)
      !> Tension and range of adhesion.
      real(dp), intent(in) :: stress, range
      complex(dp) :: memory, symbol, step
      real(dp) :: stiffness(0:n - 1), derivative(0:n - 1), s
      integer :: i, j, k, wave

      self%n = n
      self%stress = stress
      self%range = range
      self%moduli = moduli
      self%decay = exp(-two_pi/n/lengths)
      allocate (self%gain(size(moduli)))
      do i = 1, size(moduli)
         s = two_pi/n/lengths(i)
         self%gain(i) = merge((1 - exp(-s))/s, 1 - s/2 + s**2/6 - s**3/24, s > 1.0e-3_dp)
      end do
      self%is_slow = lengths > long_memory
      allocate (self%memory(0:n - 1), self%stretch(n, size(moduli)))
      self%memory = 0
      stiffness = 0
      derivative = 0
      do k = 1, n - 1
         wave = merge(k, k - n, 2*k <= n)
         step = exp(cmplx(0, two_pi*wave/n, dp))
         memory = 0
         do i = 1, size(moduli)
            if (.not. self%is_slow(i)) cycle
            symbol = self%gain(i)*(1 - step)/(1 - self%decay(i)*step)
            memory = memory + moduli(i)*step*(self%decay(i)*symbol - self%gain(i))
         end do
         do j = 0, n - 1
            symbol = exp(cmplx(0, two_pi*modulo(int(k, 8)*j, int(n, 8))/n, dp))/n
            stiffness(j) = stiffness(j) + abs(wave)*real(symbol)/2
            if (2*k /= n) derivative(j) = derivative(j) - wave*aimag(symbol)
            self%memory(j) = self%memory(j) + real(memory*symbol)
         end do
      end do
      allocate (self%stiffness(n, n), self%derivative(n, n))
      do j = 1, n
         do i = 1, n
            self%stiffness(i, j) = stiffness(modulo(i - j, n))
            self%derivative(i, j) = derivative(modulo(i - j, n))
         end do
      end do
      self%heights = [(cos(two_pi*i/n), i=0, n - 1)]
      allocate (self%u(n), self%gap(n), self%pressure(n), self%share(n), self%is_open(n))
      call start_flat(self)
   end subroutine new_transient

   !> A flat and relaxed surface, apart.
   subroutine start_flat(self)
      type(transient_t), intent(inout) :: self

      self%u = 0
      self%stretch = 0
      self%gap = 1 - self%heights
      call get_shares(self, self%share)
      self%share = 0
      self%is_open = self%gap > 0.01_dp
      self%is_apart = .false.
      self%is_sound = .true.
   end subroutine start_flat

   !> Full contact, relaxed at rest.
   subroutine start_full(self)
      type(transient_t), intent(inout) :: self

      self%u = self%heights
      self%stretch = 0
      self%gap = 0
      self%share = 1
      self%is_open = .false.
      self%is_apart = .false.
      self%is_sound = .true.
   end subroutine start_full

   !> Full contact that has always slid.
   subroutine start_full_at_speed(self)
      type(transient_t), intent(inout) :: self
      complex(dp) :: step, symbol
      integer :: i, j

      call start_full(self)
      step = exp(cmplx(0, two_pi/self%n, dp))
      do i = 1, size(self%moduli)
         symbol = self%gain(i)*(1 - step)/(1 - self%decay(i)*step)
         self%stretch(:, i) = [(real(symbol*exp(cmplx(0, two_pi*j/self%n, dp))), j=0, self%n - 1)]
      end do
   end subroutine start_full_at_speed

   !> Least mean pressure of full contact without adhesion, sliding.
   real(dp) function full_pressure_of(self) result(pressure)
      type(transient_t), intent(in) :: self
      complex(dp) :: step

      step = exp(cmplx(0, two_pi/self%n, dp))
      pressure = abs(1 + sum(self%moduli*self%gain*(1 - step)/(1 - self%decay*step)))/2
   end function full_pressure_of

   !> The relaxed contact at rest under a load, from the shares of before.
   subroutine rest_under(self, load)
      type(transient_t), intent(inout) :: self
      real(dp), intent(in) :: load
      real(dp) :: past(self%n)

      past = 0
      self%load = load
      call solve_step(self, 1.0_dp, past, .false.)
      self%u = self%gap + self%heights
   end subroutine rest_under

   !> One cell under a load.
   subroutine slide_under(self, load)
      type(transient_t), intent(inout) :: self
      real(dp), intent(in) :: load

      self%load = load
      call slide(self, .false.)
   end subroutine slide_under

   !> One cell at a mean gap. Out: with the load that it needs.
   subroutine slide_at_gap(self, mean_gap)
      type(transient_t), intent(inout) :: self
      real(dp), intent(in) :: mean_gap

      call slide(self, .true., mean_gap)
   end subroutine slide_at_gap

   !> One cell.
   subroutine slide(self, has_gap, mean_gap)
      type(transient_t), intent(inout) :: self
      logical, intent(in) :: has_gap
      real(dp), intent(in), optional :: mean_gap
      real(dp) :: past(self%n), moved(self%n)
      integer :: i, j

      moved = cshift(self%u, 1)
      past = 0
      do i = 1, size(self%moduli)
         if (self%is_slow(i)) cycle
         self%stretch(:, i) = self%decay(i)*cshift(self%stretch(:, i), 1) - self%gain(i)*moved
         past = past + self%moduli(i)*self%stretch(:, i)
      end do
      if (any(self%is_slow)) then
         do j = 0, self%n - 1
            past = past + self%memory(j)*cshift(self%u, -j)
         end do
      end if
      call solve_step(self, 1 + sum(self%moduli*self%gain), past, has_gap, mean_gap)
      self%u = self%gap + self%heights
      do i = 1, size(self%moduli)
         if (.not. self%is_slow(i)) self%stretch(:, i) = self%stretch(:, i) + self%gain(i)*self%u
      end do
   end subroutine slide

   !> The elastic problem of a step.
   subroutine solve_step(self, modulus, past, has_gap, mean_gap)
      type(transient_t), intent(inout) :: self
      !> Modulus of the step.
      real(dp), intent(in) :: modulus
      !> Displacement that the past brings, times its moduli; shape `(n)`.
      real(dp), intent(in) :: past(:)
      logical, intent(in) :: has_gap
      real(dp), intent(in), optional :: mean_gap
      real(dp) :: rest(self%n), share(self%n), known(self%n)
      integer :: k

      known = modulus*self%heights + past
      rest = matmul(self%stiffness, known)
      do k = 1, most_rounds
         if (.not. has_gap .and. self%load + self%stress*sum(self%share)/self%n <= 0) then
            self%is_apart = .true.
            return
         end if
         call find_contact(self, modulus, rest, has_gap, mean_gap)
         call get_shares(self, share)
         if (maxval(abs(share - self%share)) <= resting_share) exit
         self%share = share
      end do
      ! rounds that go on do so in the next step
   end subroutine solve_step

   !> Gap and pressure for the shares: open cells carry no load above their tension, the others have no gap.
   subroutine find_contact(self, modulus, rest, has_gap, mean_gap)
      type(transient_t), intent(inout) :: self
      real(dp), intent(in) :: modulus, rest(:)
      logical, intent(in) :: has_gap
      real(dp), intent(in), optional :: mean_gap
      real(dp), allocatable :: solution(:, :)
      integer, allocatable :: open(:)
      logical :: becomes_open(self%n)
      integer :: k, i, n_open, info

      do k = 1, most_changes
         if (has_gap .and. .not. any(self%is_open)) self%is_open(minloc(rest, 1)) = .true.
         if (all(self%is_open)) self%is_open(maxloc(rest + self%stress*self%share, 1)) = .false.
         open = pack([(i, i=1, self%n)], self%is_open)
         n_open = size(open)
         self%gap = 0
         if (n_open > 0) then
            call factorise(self, modulus, open)
            if (allocated(solution)) deallocate (solution)
            allocate (solution(n_open, 2))
            solution(:, 1) = -(rest(open) + self%stress*self%share(open))
            solution(:, 2) = 1
            call dpotrs('L', n_open, 2, self%factor, n_open, solution, n_open, info)
            if (has_gap) self%load = (sum(solution(:, 1)) - self%n*mean_gap)/sum(solution(:, 2))
            self%gap(open) = solution(:, 1) - self%load*solution(:, 2)
         end if
         self%pressure = self%load + rest + modulus*matmul(self%stiffness(:, open), self%gap(open))
         becomes_open = merge(self%gap > 0, self%pressure + self%stress*self%share < -1.0e-13_dp*modulus, self%is_open)
         if (all(becomes_open .eqv. self%is_open)) return
         self%is_open = becomes_open
      end do
      self%is_sound = .false.
   end subroutine find_contact

   !> Factor of the stiffness among open cells, if it is not that of before.
   subroutine factorise(self, modulus, open)
      type(transient_t), intent(inout) :: self
      real(dp), intent(in) :: modulus
      integer, intent(in) :: open(:)
      integer :: info

      if (allocated(self%factored)) then
         if (all(self%factored .eqv. self%is_open) .and. abs(modulus - self%factored_modulus) <= 0) return
      end if
      self%factor = modulus*self%stiffness(open, open)
      call dpotrf('L', size(open), self%factor, size(open), info)
      if (info /= 0) self%is_sound = .false.
      self%factored = self%is_open
      self%factored_modulus = modulus
   end subroutine factorise

   !> Share of each cell within the range.
   subroutine get_shares(self, share)
      type(transient_t), intent(in) :: self
      real(dp), intent(out) :: share(:)
      integer :: i

      associate (g => self%gap, n => self%n)
         do i = 1, n
            share(i) = half_share(g(i) - self%range, g(modulo(i, n) + 1) - self%range) &
               & + half_share(g(i) - self%range, g(modulo(i - 2, n) + 1) - self%range)
         end do
      end associate
   end subroutine get_shares

   !> Part of half a hat where what is linear between its middle and its end is not above 0.
   pure real(dp) function half_share(middle, end) result(share)
      real(dp), intent(in) :: middle, end

      if (middle <= 0 .and. end <= 0) then
         share = 0.5_dp
      else if (middle > 0 .and. end > 0) then
         share = 0
      else if (middle <= 0) then
         share = middle/(middle - end)
         share = share - share**2/2
      else
         share = (end/(end - middle))**2/2
      end if
   end function half_share

   !> Slide on until friction and gap repeat themselves from period to period, with what they would still change.
   subroutine settle(self, most_periods, has_gap, digits, is_settled)
      type(transient_t), intent(inout) :: self
      integer, intent(in) :: most_periods
      !> Is the mean gap of now kept? Else the load is.
      logical, intent(in) :: has_gap
      !> Change that is still allowed, of the friction in units of itself, of the mean gap in those of the amplitude.
      real(dp), intent(in) :: digits
      logical, intent(out) :: is_settled
      real(dp) :: now(2), before(2), change, last, mean_gap
      integer :: k, i, still

      mean_gap = sum(self%gap)/self%n
      before = unlike
      last = unlike
      still = 0
      is_settled = .false.
      do k = 1, most_periods
         do i = 1, self%n
            if (has_gap) then
               call slide_at_gap(self, mean_gap)
            else
               call slide_under(self, self%load)
            end if
            if (self%is_apart .or. .not. self%is_sound) return
         end do
         now = [friction_of(self), merge(self%load, sum(self%gap)/self%n, has_gap)]
         change = max(abs(now(1) - before(1))/max(abs(now(1)), 1.0e-12_dp), abs(now(2) - before(2)))
         if (change <= digits*(1 - min(change/max(last, 1.0e-30_dp), 0.999_dp)) .or. change <= 1.0e-10_dp) then
            still = still + 1
         else
            still = 0
         end if
         is_settled = still >= 2
         if (is_settled) return
         before = now
         last = change
      end do
   end subroutine settle

   !> Friction, from the loss.
   real(dp) function friction_of(self) result(friction)
      type(transient_t), intent(in) :: self

      friction = -sum(self%pressure*matmul(self%derivative, self%u))/self%n
   end function friction_of

   !> Share of the cells in contact.
   real(dp) function contact_fraction_of(self) result(fraction)
      type(transient_t), intent(in) :: self

      fraction = real(count(.not. self%is_open), dp)/self%n
   end function contact_fraction_of

end module wave_transient
