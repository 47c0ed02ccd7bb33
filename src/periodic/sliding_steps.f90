! SPDX-License-Identifier: GPL-3.0-or-later
!> Adhesive contact of a periodic surface that slides, integrated in time until it is steady: what decides where rounds
!> (`adfric_periodic_sliding_rounds`) do not settle.
!>
!> A step takes the body from one cell to the next. Displacements change linearly within it, which the arms of the solid follow exactly:
!> the modulus that waves meet in steady sliding is that of just these steps (`adfric_solid_sampled_modulus`). So what the steps settle in
!> obeys the equations of the cells, which Newton's method confirms. With the displacement u of the material, the stretch s_i of arm i,
!> its decay rho_i and gain gamma_i in a step, and M = E0 + sum E_i gamma_i,
!>
!>     p = q + A (M u + sum E_i s_i'),    s_i' = rho_i s_i - gamma_i u of the step before,    s_i = s_i' + gamma_i u
!>
!> is an elastic contact with the stiffness A and the shape g0 - sum E_i s_i'/M; its rounds of shares lower the energy of the step, and end.
!>
!> The branches are taken at their word: from apart under a load that grows slowly, or from full contact that has always slid under one
!> that falls, or with a mean gap that changes. An arm that remembers more than a period has the memory of a body that has always slid
!> with the present surface: its steady state is the same, and its true past would take thousands of periods. Steps are bounded, and so
!> are the cells. Steps that do not settle, or bodies that part, are no answer: a ramp may leave a narrow basin.
module adfric_periodic_sliding_steps
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_periodic_adhesive_contact, only: find_state, solve_again, solve_with_share
   use adfric_periodic_contact, only: contact_state_t
   use adfric_periodic_gap_solver, only: gap_solver_t, new_gap_solver
   use adfric_periodic_kernel, only: kernel_t
   use adfric_periodic_maps, only: largest_difference, sum_of
   use adfric_periodic_operator, only: new_periodic_operator, periodic_operator_t
   use adfric_periodic_sliding_kernel, only: sliding_kernel_t
   implicit none (type, external)
   private
   public :: solve_by_steps

   !> Cells at most, on a line and on a map.
   integer, parameter :: most_on_line = 1024, most_on_map = 4096
   !> Periods of the change of load or mean gap, those more for each period that an arm remembers, and those to settle at most.
   integer, parameter :: ramp = 6, ramp_of_memory = 12, most_periods = 40
   !> Power of what remains of the change with which it ends.
   integer, parameter :: ease = 2
   !> Periods of memory beyond which an arm has that of steady sliding.
   real(dp), parameter :: long_memory = 1
   !> Rounds of shares in a step at most, the change of a share that ends them, and the residual of their contacts.
   integer, parameter :: most_rounds = 40
   real(dp), parameter :: resting_share = 1.0e-4_dp, passing_tolerance = 1.0e-6_dp
   !> First load of loading, in units of the last one; margin above the load that leaves all in range.
   real(dp), parameter :: first_load = 1.0e-3_dp, margin = 0.1_dp
   !> Change of the gap that is still to come, in units of the range of the undeformed gap, below which steps have settled, and the
   !> share of a cell by which the steady state may lie beside it.
   real(dp), parameter :: settled = 1.0e-5_dp, same_share = 0.05_dp

   !> A ride in steps of time.
   type :: ride_t
      !> The contact of a step, with stresses in units of `modulus`.
      type(contact_state_t) :: step
      !> Elastic stiffness.
      type(periodic_operator_t) :: operator
      !> The workspace of its contacts.
      type(gap_solver_t) :: gap_solver
      !> Modulus M of a step; tension and present load.
      real(dp) :: modulus = 1, stress = 0, load = 0
      !> Cells of a step along x and y.
      integer :: steps(2) = 0
      !> Moduli of the arms, what a step leaves of a stretch, and what it adds of a change; shape `(n_arms)`.
      real(dp), allocatable :: moduli(:), decay(:), gain(:)
      !> Has an arm the memory of steady sliding? Shape `(n_arms)`.
      logical, allocatable :: is_slow(:)
      !> Undeformed gap and displacement; stretches of the arms, shape `(nx, ny, n_arms)`.
      real(dp), allocatable :: shape(:, :), u(:, :), stretch(:, :, :)
      !> Have the surfaces parted, did they not settle, or shall it end?
      logical :: has_failed = .false.
   end type ride_t

contains

   !> Find a state by steps of time.
   subroutine solve_by_steps(state, kernel, operator, gap_solver, tolerance, is_adhered)
      !> In: the shape, the law, and the load or with `has_fixed_mean` the mean gap. Out: the state with `is_converged`, if there is one.
      type(contact_state_t), intent(inout) :: state
      !> The solid; another one than that of a body which slides along x or along y leaves the state as it is.
      class(kernel_t), intent(in) :: kernel
      !> Operator of this grid, which counts the steps' stiffnesses, too.
      type(periodic_operator_t), intent(inout) :: operator
      type(gap_solver_t), intent(inout) :: gap_solver
      !> Largest residual that is allowed [-].
      real(dp), intent(in) :: tolerance
      !> Does the state come from full contact? Else from apart.
      logical, intent(in) :: is_adhered
      type(ride_t) :: ride
      type(contact_state_t) :: found
      type(error_t), allocatable :: error
      logical :: has_found
      integer :: n_periods

      if (operator%is_symmetric) return
      if (size(state%shape) > merge(most_on_line, most_on_map, size(state%shape, 2) == 1)) return
      select type (kernel)
      type is (sliding_kernel_t)
         if (all(kernel%steps /= 0)) return
         call prepare(ride, state, kernel, operator, n_periods, error)
      class default
         return
      end select
      if (allocated(error)) return
      call come_near(ride, state, operator, is_adhered, n_periods)
      if (.not. ride%has_failed) call settle(ride, state%has_fixed_mean)
      operator%n_applied = operator%n_applied + ride%operator%n_applied
      if (ride%has_failed) return
      found = state
      found%gap = ride%step%gap
      found%is_open = ride%step%is_open
      found%mean_pressure = ride%load
      call found%cohesion%set_share(found%gap)
      call find_state(found, operator, gap_solver, tolerance, has_found)
      if (has_found) has_found = largest_difference(found%cohesion%share, ride%step%cohesion%share) <= same_share
      if (has_found) state = found
   end subroutine solve_by_steps

   !> Set up the steps.
   subroutine prepare(self, state, kernel, operator, n_periods, error)
      !> Receives the solid, without a contact.
      type(ride_t), intent(out) :: self
      type(contact_state_t), intent(in) :: state
      type(sliding_kernel_t), intent(in) :: kernel
      !> Operator of the steady contact, for its cells and its watch.
      type(periodic_operator_t), intent(in) :: operator
      !> Receives the periods of the change of load or mean gap.
      integer, intent(out) :: n_periods
      type(error_t), allocatable, intent(out) :: error
      real(dp), allocatable :: intervals(:), memory(:)

      n_periods = ramp
      call new_periodic_operator(self%operator, kernel%solid, operator%n_cells, operator%cell_size*operator%n_cells, .false., &
         & .false., error)
      if (allocated(error)) return
      call new_gap_solver(self%gap_solver, operator%n_cells)
      self%operator%watch => operator%watch
      self%steps = kernel%steps
      intervals = max(norm2(kernel%steps*operator%cell_size)/kernel%velocity/kernel%prony%times, tiny(1.0_dp))
      self%moduli = kernel%prony%moduli
      self%decay = exp(-intervals)
      ! (1 - exp(-x))/x, with all its digits
      self%gain = (1 + self%decay)*tanh(intervals/2)/intervals
      memory = 1/(intervals*maxval(abs(kernel%steps)*operator%n_cells))
      self%is_slow = memory > long_memory
      if (.not. all(self%is_slow)) n_periods = ramp + ceiling(ramp_of_memory*maxval(memory, mask=.not. self%is_slow))
      self%modulus = kernel%prony%relaxed + sum(self%moduli*self%gain)
      self%stress = state%cohesion%stress
      self%shape = state%shape
      self%step = state
      self%step%cohesion%stress = self%stress/self%modulus
      self%step%gap = state%shape
      allocate (self%u, mold=state%shape)
      allocate (self%stretch(size(state%shape, 1), size(state%shape, 2), size(intervals)))
      self%stretch(:, :, :) = 0
      self%u(:, :) = 0
   end subroutine prepare

   !> Slide from apart, or from full contact, to the load or to the mean gap.
   subroutine come_near(self, state, operator, is_adhered, n_periods)
      type(ride_t), intent(inout) :: self
      !> What is given.
      type(contact_state_t), intent(in) :: state
      !> Operator of the steady contact.
      type(periodic_operator_t), intent(inout) :: operator
      logical, intent(in) :: is_adhered
      integer, intent(in) :: n_periods
      real(dp), allocatable :: tension(:, :)
      real(dp) :: start, end
      integer :: k, n

      end = state%mean_pressure
      if (state%has_fixed_mean) end = state%mean_gap
      if (is_adhered) then
         allocate (tension, mold=state%shape)
         call operator%apply_stiffness(state%shape, tension)
         start = maxval(tension) - self%stress
         start = start + margin*abs(start)
         if (.not. state%has_fixed_mean) start = max(start, end)
         self%u(:, :) = -self%shape
         call remember(self, all_arms=.true.)
         self%step%gap(:, :) = 0
         self%step%is_open = self%step%gap > 0
         self%step%cohesion%share = 1 + 0*self%shape
         call slide(self, start, .false.)
         if (state%has_fixed_mean .and. .not. self%has_failed) start = sum_of(self%step%gap)/size(self%step%gap)
      else
         self%step%cohesion%share = 0*self%shape
         self%step%is_open = self%shape > minval(self%shape)
         start = first_load*end
         if (state%has_fixed_mean) then
            start = sum_of(self%shape)/size(self%shape) - minval(self%shape) + state%cohesion%far_range()
            self%step%gap(:, :) = self%shape - minval(self%shape) + state%cohesion%far_range()
            self%step%is_open(:, :) = .true.
         end if
         ! nothing presses, or all is apart
         self%has_failed = merge(end >= start, .not. end > 0, state%has_fixed_mean)
      end if
      n = n_periods*maxval(abs(self%steps)*operator%n_cells)
      do k = 1, n
         if (self%has_failed) return
         ! slower and slower, since arms follow late
         call slide(self, end + (start - end)*(1 - real(k, dp)/n)**ease, state%has_fixed_mean)
      end do
   end subroutine come_near

   !> Slide on until the gap repeats itself.
   subroutine settle(self, has_fixed_mean)
      !> The solid; has failed if it does not settle.
      type(ride_t), intent(inout) :: self
      !> Is the mean gap kept? Else the load is.
      logical, intent(in) :: has_fixed_mean
      real(dp), allocatable :: before(:, :)
      real(dp) :: change, last, given
      integer :: k, i

      given = merge(sum_of(self%step%gap)/size(self%step%gap), self%load, has_fixed_mean)
      last = huge(1.0_dp)
      do k = 1, most_periods
         before = self%step%gap
         do i = 1, maxval(abs(self%steps)*self%operator%n_cells)
            call slide(self, given, has_fixed_mean)
            if (self%has_failed) return
         end do
         change = maxval(abs(self%step%gap - before))/(maxval(self%shape) - minval(self%shape))
         ! what a shrinking change adds up to
         if (change < last) then
            if (change*last/(last - change) <= settled) return
         end if
         last = max(change, tiny(1.0_dp))
      end do
      self%has_failed = .true.
   end subroutine settle

   !> One cell.
   subroutine slide(self, given, has_fixed_mean)
      type(ride_t), intent(inout) :: self
      !> The load, or the mean gap.
      real(dp), intent(in) :: given
      logical, intent(in) :: has_fixed_mean
      integer :: i

      call remember(self, all_arms=.false.)
      self%step%shape(:, :) = self%shape
      do i = 1, size(self%moduli)
         self%stretch(:, :, i) = self%decay(i)*moved(self, self%stretch(:, :, i)) - self%gain(i)*moved(self, self%u)
         self%step%shape(:, :) = self%step%shape - (self%moduli(i)/self%modulus)*self%stretch(:, :, i)
      end do
      self%step%has_fixed_mean = has_fixed_mean
      if (has_fixed_mean) then
         self%step%mean_gap = given
      else
         self%step%mean_pressure = given/self%modulus
      end if
      call solve_step(self)
      if (self%operator%is_stopped()) self%has_failed = .true.
      self%load = self%step%mean_pressure*self%modulus
      self%u(:, :) = self%step%gap - self%shape
      do i = 1, size(self%moduli)
         self%stretch(:, :, i) = self%stretch(:, :, i) + self%gain(i)*self%u
      end do
   end subroutine slide

   !> Rounds of shares in a step.
   subroutine solve_step(self)
      type(ride_t), intent(inout) :: self
      real(dp), allocatable :: share(:, :)
      real(dp) :: change
      logical :: has_contact
      integer :: k

      allocate (share, source=self%step%cohesion%share)
      change = 0
      do k = 1, most_rounds
         if (self%step%has_fixed_mean) then
            call self%step%cohesion%hold()
            self%step%cohesion%share = share
            call solve_again(self%step, self%operator, self%gap_solver, passing_tolerance)
         else
            call solve_with_share(self%step, self%operator, self%gap_solver, share, change, has_contact, .false.)
            self%has_failed = .not. has_contact
            if (self%has_failed) return
         end if
         call self%step%cohesion%set_share(self%step%gap)
         change = largest_difference(self%step%cohesion%share, share)
         ! rounds that go on do so in the next step
         if (change <= resting_share) return
         share(:, :) = self%step%cohesion%share
      end do
   end subroutine solve_step

   !> Give arms the stretches of a body that has always slid with the present surface: s of a cell is rho s + gamma (u - u') of the
   !> cell one step before, and a period repeats itself.
   subroutine remember(self, all_arms)
      type(ride_t), intent(inout) :: self
      !> All of them, or only those that remember more than a period?
      logical, intent(in) :: all_arms
      real(dp), allocatable :: change(:, :), last(:)
      integer :: i, j, k, n, along, here

      if (.not. (all_arms .or. any(self%is_slow))) return
      along = merge(1, 2, self%steps(1) /= 0)
      n = size(self%u, along)
      change = self%u - moved(self, self%u)
      allocate (last(size(self%u, 3 - along)))
      do i = 1, size(self%moduli)
         if (.not. (all_arms .or. self%is_slow(i))) cycle
         last = 0
         ! once round for what a period brings, and once more with what all before have left
         do j = 1, 2*n
            k = modulo(-j, n) + 1
            here = merge(k, n + 1 - k, self%steps(along) > 0)
            if (along == 1) then
               last = self%decay(i)*last + self%gain(i)*change(here, :)
               self%stretch(here, :, i) = last
            else
               last = self%decay(i)*last + self%gain(i)*change(:, here)
               self%stretch(:, here, i) = last
            end if
            if (j == n) last = last/max(1 - self%decay(i)**n, epsilon(1.0_dp))
         end do
      end do
   end subroutine remember

   !> What the material had a cell before.
   function moved(self, map) result(before)
      type(ride_t), intent(in) :: self
      !> A map of what goes with the material.
      real(dp), intent(in) :: map(:, :)
      real(dp), allocatable :: before(:, :)

      before = cshift(cshift(map, self%steps(1), 1), self%steps(2), 2)
   end function moved

end module adfric_periodic_sliding_steps
