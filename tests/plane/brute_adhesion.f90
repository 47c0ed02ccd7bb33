! SPDX-License-Identifier: GPL-3.0-or-later
! Adhesive contact of one wave on a grid, by labels and dense systems: half a period of cells, the tension S in the labelled ones.
! Nothing here knows of the closed form, and no path is followed.
module brute_adhesion
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_numerics_lapack, only: dgesv
   implicit none (type, external)
   private
   public :: brute_wave_t, new_brute_wave, solve_branch

   !> The grid: cells from the crest to the valley.
   type :: brute_wave_t
      integer :: n = 0
      !> Gap of the undeformed wave, and the gap per pressure of mean 0.
      real(dp), allocatable :: height(:), compliance(:, :)
   end type brute_wave_t

contains

   !> A grid of n cells of half a period.
   subroutine new_brute_wave(self, n)
      type(brute_wave_t), intent(out) :: self
      integer, intent(in) :: n
      real(dp) :: x(n), modes(n, n)
      integer :: i, k

      self%n = n
      x = [((i - 0.5_dp)/(2*n), i=1, n)]
      self%height = 1 - cos(two_pi*x)
      do k = 1, n
         modes(:, k) = cos(two_pi*k*x)
      end do
      allocate (self%compliance(n, n), source=0.0_dp)
      do k = 1, n - 1
         ! a pressure cos(2 pi k x) p* opens a gap of cos(2 pi k x)/k D
         self%compliance = self%compliance + spread(modes(:, k), 2, n)*spread(modes(:, k), 1, n)*(2.0_dp/n)/k
      end do
   end subroutine new_brute_wave

   !> Least (no labels at first) or greatest (all labels) equilibrium under a load, or the greatest below given labels.
   subroutine solve_branch(self, stress, range, load, labels, gap, pressure, has_state)
      type(brute_wave_t), intent(in) :: self
      real(dp), intent(in) :: stress, range, load
      !> In: the labels to begin with. Out: those of the state.
      logical, intent(inout) :: labels(:)
      real(dp), intent(out) :: gap(:), pressure(:)
      logical, intent(out) :: has_state
      logical :: old(size(labels))
      integer :: round

      has_state = .false.
      do round = 1, 2*self%n
         if (load + stress*count(labels)/self%n <= 0) return
         call solve_contact(self, load, merge(stress, 0.0_dp, labels), gap, pressure)
         old = labels
         labels = gap <= range
         has_state = all(labels .eqv. old)
         if (has_state) return
      end do
   end subroutine solve_branch

   !> Contact under a load and given tensions, by an active set: cells under p~ < 0 open, cells with g < 0 close.
   subroutine solve_contact(self, load, tension, gap, pressure)
      type(brute_wave_t), intent(in) :: self
      real(dp), intent(in) :: load, tension(:)
      real(dp), intent(out) :: gap(:), pressure(:)
      logical :: is_closed(self%n), old(self%n)
      real(dp) :: matrix(self%n + 1, self%n + 1), right(self%n + 1, 1)
      integer :: cells(self%n), pivots(self%n + 1), i, m, info, round

      is_closed = self%height < 1
      do round = 1, 1000
         m = count(is_closed)
         cells(1:m) = pack([(i, i=1, self%n)], is_closed)
         matrix = 0
         matrix(1:m, 1:m) = self%compliance(cells(1:m), cells(1:m))
         matrix(1:m, m + 1) = 1
         matrix(m + 1, 1:m) = 1
         right(1:m, 1) = -self%height(cells(1:m)) + matmul(self%compliance(cells(1:m), :), tension)
         right(m + 1, 1) = self%n*load + sum(tension)
         call dgesv(m + 1, 1, matrix, self%n + 1, pivots, right, self%n + 1, info)
         pressure = -tension
         pressure(cells(1:m)) = pressure(cells(1:m)) + right(1:m, 1)
         gap = self%height + matmul(self%compliance, pressure) + right(m + 1, 1)
         gap(cells(1:m)) = 0
         old = is_closed
         is_closed = (is_closed .and. pressure + tension >= 0) .or. (.not. is_closed .and. gap < 0)
         if (all(old .eqv. is_closed)) exit
         if (count(is_closed) == 0) is_closed(1) = .true.
      end do
   end subroutine solve_contact

end module brute_adhesion
