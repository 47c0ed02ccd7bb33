! SPDX-License-Identifier: GPL-3.0-or-later
!> The surface of a solid, an elastic or viscoelastic half-space or layer, under pressures periodic in x and y.
!>
!> The stiffness of a kernel (`adfric_periodic_kernel`) takes each wave of displacement to its pressure, and its inverse, the
!> compliance, pressures to displacements. Under a surface that slides the stiffness is complex: its imaginary part, `lag`, is the
!> loss, and the operator is not symmetric. Pressures are in the unit of the kernel, E* of an elastic solid and the relaxed contact
!> modulus E0 of a viscoelastic one, lengths in any unit, displacements and pressures positive into the solid. Constants have no
!> stiffness: the mean displacement is 0; `resist_mean` gives them that of a layer.
module adfric_periodic_operator
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_base_constants, only: two_pi
   use adfric_base_error, only: error_t, set_error, input_failure
   use adfric_base_text, only: show_number
   use adfric_base_watch, only: asks_for_end, watch_t
   use adfric_numerics_spectral_filter, only: spectral_filter_t, new_spectral_filter
   use adfric_periodic_kernel, only: kernel_t
   implicit none (type, external)
   private
   public :: periodic_operator_t, new_periodic_operator, is_too_long, wave_number

   !> Cells may be so many times as long as wide; beyond that modes along and across differ by more digits than there are.
   real(dp), parameter :: longest_cell = 1.0e6_dp

   !> Stiffness and compliance on a grid of cells. Not to be copied; one for each thread.
   type :: periodic_operator_t
      !> Number of cells in each direction; 1 along y for a surface that does not vary there.
      integer :: n_cells(2) = 0
      !> Size of a cell.
      real(dp) :: cell_size(2) = 0
      !> Is the grid a quarter of the period, between two pairs of planes of symmetry?
      logical :: is_quarter = .false.
      !> How often stiffness, compliance or anisotropy were applied.
      integer :: n_applied = 0
      !> Transforms of the grid.
      type(spectral_filter_t), private :: filter
      !> Mean displacement over mean pressure; 0 of a half-space.
      real(dp) :: mean_compliance = 0
      !> Is the stiffness real, so that the operator is symmetric?
      logical :: is_symmetric = .true.
      !> Stiffness of the modes over the gain of the transforms; shape of the modes, y first.
      real(dp), allocatable, private :: stiffness(:, :)
      !> Its imaginary part, of the same shape; not allocated where it is 0.
      real(dp), allocatable, private :: lag(:, :)
      !> The compliance that the mean is given, since it has none; over the gain.
      real(dp), private :: compliance_of_mean = 0
      !> Whom iterations ask whether they shall end; null: nobody.
      class(watch_t), pointer :: watch => null()
   contains
      procedure :: is_stopped
      procedure :: mean_stiffness
      procedure :: smallest_ratio
      procedure :: resist_mean
      procedure :: resists
      procedure :: apply_stiffness
      procedure :: apply_compliance
      procedure :: get_influence
      procedure :: get_slope
      procedure :: get_loss
      procedure :: apply_anisotropy
      procedure, private :: set_wave_numbers
   end type periodic_operator_t

contains

   !> Set up the operator on a grid.
   subroutine new_periodic_operator(self, kernel, n_cells, period, is_quarter, is_measured, error)
      !> The operator; not to be used after an error.
      type(periodic_operator_t), intent(out) :: self
      !> The surface of the solid; all its stiffnesses must be real where the grid is a quarter.
      class(kernel_t), intent(in) :: kernel
      !> Number of cells in each direction, of the quarter if it is one.
      integer, intent(in) :: n_cells(2)
      !> Periods in x and y, in any unit of length, > 0.
      real(dp), intent(in) :: period(2)
      !> Is the surface even about 0 and half a period in x and in y, and only that quarter given?
      logical, intent(in) :: is_quarter
      logical, intent(in) :: is_measured
      type(error_t), allocatable, intent(out) :: error

      if (.not. all(period > 0)) then
         call set_error(error, input_failure, 'the periods of a surface are given as '//show_number(period(1))//' and '// &
            & show_number(period(2))//', allowed: numbers > 0')
         return
      else if (is_too_long(n_cells, period)) then
         call set_error(error, input_failure, 'the cells of a surface are far longer than wide, given '// &
            & show_number(maxval(period/n_cells)/minval(period/n_cells))// &
            & ' times, allowed: up to '//show_number(longest_cell)//' times')
         return
      end if
      call new_spectral_filter(self%filter, n_cells(1), n_cells(2), is_quarter, is_measured, error)
      if (allocated(error)) return
      self%n_cells = n_cells
      self%is_quarter = is_quarter
      self%cell_size = period/(n_cells*merge(2, 1, is_quarter))
      self%mean_compliance = kernel%mean_compliance()
      self%is_symmetric = .true.
      allocate (self%stiffness(self%filter%n_modes(2), self%filter%n_modes(1)))
      ! that of the ring around a small contact
      self%compliance_of_mean = maxval(period)/self%filter%gain
      call set_stiffness(self, kernel, period, error)
   end subroutine new_periodic_operator

   !> Find the stiffness of all modes.
   subroutine set_stiffness(self, kernel, period, error)
      !> The operator, with its cells and transforms; receives the stiffness.
      type(periodic_operator_t), intent(inout) :: self
      class(kernel_t), intent(in) :: kernel
      !> Periods in x and y, in any unit of length, > 0.
      real(dp), intent(in) :: period(2)
      type(error_t), allocatable, intent(out) :: error
      complex(dp), allocatable :: stiffness(:, :)
      integer :: i, j

      allocate (stiffness(size(self%stiffness, 1), size(self%stiffness, 2)))
      call kernel%get_stiffness([((i - 1)/period(1), i=1, size(stiffness, 2))], &
         & [(wave_number(j - 1, self%n_cells(2), self%is_quarter)/period(2), j=1, size(stiffness, 1))], self%cell_size, stiffness)
      self%stiffness(:, :) = real(stiffness, dp)/self%filter%gain
      if (.not. any(abs(aimag(stiffness)) > 0)) return
      if (self%is_quarter) then
         call set_error(error, input_failure, 'the stiffness of a surface is complex; a quarter of it takes a real one')
         return
      end if
      self%lag = aimag(stiffness)/self%filter%gain
      self%is_symmetric = .false.
   end subroutine set_stiffness

   !> Shall iterations end before their time? What they have found is of no use then.
   logical function is_stopped(self)
      class(periodic_operator_t), intent(in) :: self

      is_stopped = asks_for_end(self%watch)
   end function is_stopped

   !> Say whether a constant has the stiffness of a layer, or none.
   pure subroutine resist_mean(self, resists)
      !> The operator, which must have a mean compliance if a constant is to have a stiffness.
      class(periodic_operator_t), intent(inout) :: self
      logical, intent(in) :: resists

      self%stiffness(1, 1) = 0
      if (resists) self%stiffness(1, 1) = 1/(self%mean_compliance*self%filter%gain)
   end subroutine resist_mean

   !> Has a constant a stiffness?
   pure logical function resists(self)
      class(periodic_operator_t), intent(in) :: self

      resists = abs(self%stiffness(1, 1)) > 0
   end function resists

   !> Mean stiffness of the waves that a coarser grid of cells has, but for the factors of its own.
   pure real(dp) function mean_stiffness(self, n_cells) result(mean)
      class(periodic_operator_t), intent(in) :: self
      !> Number of cells of the coarser grid in each direction, not more than here.
      integer, intent(in) :: n_cells(2)
      real(dp) :: rows(size(self%stiffness, 1))
      logical :: is_seen(self%n_cells(2))
      integer :: half(2), i, j

      half = merge(n_cells - 1, n_cells/2, self%is_quarter)
      rows = 0
      do i = 1, half(1) + 1
         rows(:) = rows + self%stiffness(:, i)
      end do
      associate (n => self%n_cells(2))
         is_seen = [(abs(wave_number(j - 1, n, self%is_quarter)) <= half(2), j=1, n)]
         mean = sum(rows(:n)/(half(1) + 1), mask=is_seen)*self%filter%gain/count(is_seen)
      end associate
   end function mean_stiffness

   !> Least real part of the stiffness of a wave over its size; 1 where all are real.
   pure real(dp) function smallest_ratio(self) result(ratio)
      class(periodic_operator_t), intent(in) :: self
      integer :: i, j

      ratio = 1
      if (self%is_symmetric) return
      do i = 1, size(self%stiffness, 2)
         do j = 1, size(self%stiffness, 1)
            if (i > 1 .or. j > 1) ratio = min(ratio, self%stiffness(j, i)/hypot(self%stiffness(j, i), self%lag(j, i)))
         end do
      end do
   end function smallest_ratio

   !> Are the cells longer, or wider, than can be?
   pure logical function is_too_long(n_cells, period)
      !> Number of cells in each direction; a line has 1 in one of them.
      integer, intent(in) :: n_cells(2)
      !> Periods in x and y, in any unit of length, > 0.
      real(dp), intent(in) :: period(2)

      is_too_long = .false.
      if (any(n_cells <= 1)) return
      associate (sizes => period/n_cells)
         is_too_long = .not. maxval(sizes) <= longest_cell*minval(sizes)
      end associate
   end function is_too_long

   !> Number of waves of a mode along the second direction; below 0 for those beyond the middle, that run the other way.
   pure real(dp) function wave_number(mode, n_points, is_quarter) result(number)
      !> Number of the mode along the second direction, from 0.
      integer, intent(in) :: mode
      !> Number of cells along the second direction.
      integer, intent(in) :: n_points
      !> Is the grid a quarter of the period, whose modes are cosines?
      logical, intent(in) :: is_quarter

      number = merge(mode, mode - n_points, is_quarter .or. 2*mode <= n_points)
   end function wave_number

   !> Pressures that make given displacements, up to their mean.
   subroutine apply_stiffness(self, displacement, pressure, product)
      class(periodic_operator_t), intent(inout) :: self
      !> Displacement of the surface in the middles of the cells; shape `n_cells`.
      real(dp), intent(in), contiguous :: displacement(:, :)
      !> Pressure in the middles of the cells [E*]; shape `n_cells`.
      real(dp), intent(out), contiguous :: pressure(:, :)
      !> Receives the sum of displacement times pressure over all cells.
      real(dp), intent(out), optional :: product

      if (has_asserts) call assert(all(shape(displacement) == self%n_cells) .and. all(shape(pressure) == self%n_cells), &
         & 'apply_stiffness: maps have the shape of the cells')
      if (self%is_symmetric) then
         call self%filter%apply(self%stiffness, displacement, pressure, product)
      else
         call self%filter%apply(self%stiffness, displacement, pressure, product, self%lag)
      end if
      self%n_applied = self%n_applied + 1
   end subroutine apply_stiffness

   !> Pressures that a displacement of 1 in one cell makes in the cells around it, in a surface without mirrors. Waves of a symmetric
   !> stiffness count as much along both directions of an axis. Nothing varies along an axis of one cell, which has no mirrors there.
   pure subroutine get_influence(self, reach, influence)
      class(periodic_operator_t), intent(in) :: self
      !> How many cells away in each direction.
      integer, intent(in) :: reach(2)
      !> Receives the pressures [E* over the unit of displacement], by the position from the cell.
      real(dp), intent(out), contiguous :: influence(-reach(1):, -reach(2):)
      real(dp) :: rows(size(self%stiffness, 1), 0:reach(1)), row(0:reach(1)), weight, cosine
      integer :: n(2), i, j, k

      n = self%n_cells*merge(2, 1, self%is_quarter .and. self%n_cells > 1)
      rows = 0
      do i = 1, size(self%stiffness, 2)
         weight = merge(1, 2, i == 1 .or. 2*(i - 1) == n(1))
         do k = 0, reach(1)
            cosine = weight*cos(two_pi*mod((i - 1)*k, n(1))/n(1))
            rows(:, k) = rows(:, k) + cosine*self%stiffness(:, i)
         end do
      end do
      if (self%is_quarter .and. size(self%stiffness, 2) > 1) then
         ! the wave of two cells, which no mirror shows
         do k = 0, reach(1)
            rows(:, k) = rows(:, k) + (-1)**k*next_wave(self%stiffness(:, self%n_cells(1)), self%stiffness(:, self%n_cells(1) - 1))
         end do
      end if
      influence(:, :) = 0
      do k = 0, reach(2)
         row = 0
         do j = 1, size(rows, 1)
            weight = merge(2, 1, self%is_quarter .and. j > 1)
            row = row + weight*cos(two_pi*mod((j - 1)*k, n(2))/n(2))*rows(j, :)
         end do
         if (self%is_quarter .and. size(rows, 1) > 1) row = row + (-1)**k*next_wave(rows(n(2)/2, :), rows(n(2)/2 - 1, :))
         row = row*(self%filter%gain/product(real(n, dp)))
         do i = 0, reach(1)
            influence([-i, i], k) = row(i)
            influence([-i, i], -k) = row(i)
         end do
      end do

   contains

      !> Stiffness of the wave after two others, on a straight line.
      elemental real(dp) function next_wave(last, before)
         real(dp), intent(in) :: last, before
         next_wave = 2*last - before
      end function next_wave

   end subroutine get_influence

   !> Displacements under given pressures; a positive multiple of the mean pressure in place of their mean, so that
   !> the operator is positive definite.
   subroutine apply_compliance(self, pressure, displacement)
      class(periodic_operator_t), intent(inout) :: self
      !> Pressure in the middles of the cells [E*]; shape `n_cells`.
      real(dp), intent(in), contiguous :: pressure(:, :)
      !> Displacement of the surface in the middles of the cells; shape `n_cells`.
      real(dp), intent(out), contiguous :: displacement(:, :)
      real(dp), allocatable :: compliance(:, :)

      if (has_asserts) call assert(all(shape(displacement) == self%n_cells) .and. all(shape(pressure) == self%n_cells), &
         & 'apply_compliance: maps have the shape of the cells')
      allocate (compliance, source=self%stiffness)
      where (self%stiffness > 0)
         compliance = (1/self%stiffness)/self%filter%gain**2
      elsewhere
         compliance = self%compliance_of_mean
      end where
      call self%filter%apply(compliance, pressure, displacement)
      self%n_applied = self%n_applied + 1
   end subroutine apply_compliance

   !> Slope of a map along x or y, wave by wave. Waves of two cells have none.
   subroutine get_slope(self, along, map, slope)
      !> The operator, for its cells and transforms; not of a quarter.
      class(periodic_operator_t), intent(inout) :: self
      !> Direction of the slope: 1 along x, 2 along y.
      integer, intent(in) :: along
      !> The map in the middles of the cells; shape `n_cells`.
      real(dp), intent(in), contiguous :: map(:, :)
      !> Receives its slope [unit of the map over that of lengths]; shape `n_cells`.
      real(dp), intent(out), contiguous :: slope(:, :)
      real(dp), allocatable :: nothing(:, :), numbers(:, :)

      if (has_asserts) call assert(.not. self%is_quarter, 'get_slope: not of a quarter')
      allocate (nothing, mold=self%stiffness)
      allocate (numbers, mold=self%stiffness)
      nothing(:, :) = 0
      call self%set_wave_numbers(along, numbers)
      numbers(:, :) = numbers/self%filter%gain
      call self%filter%apply(nothing, map, slope, imaginary=numbers)
   end subroutine get_slope

   !> What the pressures of given displacements do on their slope along x or y, -mean(p du/dx): the sum over all waves of wave number
   !> times -Im(stiffness) times the square of the wave. 0 where the stiffness is real.
   subroutine get_loss(self, along, displacement, loss)
      !> The operator, for its stiffness and transforms; not of a quarter.
      class(periodic_operator_t), intent(inout) :: self
      !> Direction of the slope: 1 along x, 2 along y.
      integer, intent(in) :: along
      !> Displacement of the surface in the middles of the cells; shape `n_cells`.
      real(dp), intent(in), contiguous :: displacement(:, :)
      !> Receives the loss [E*]; along the motion of a body over a viscoelastic solid it is >= 0 but for round-off.
      real(dp), intent(out) :: loss
      real(dp), allocatable :: factors(:, :), product(:, :)

      loss = 0
      if (self%is_symmetric) return
      allocate (factors, mold=self%stiffness)
      allocate (product, mold=displacement)
      call self%set_wave_numbers(along, factors)
      factors(:, :) = -factors*self%lag
      call self%filter%apply(factors, displacement, product, loss)
      loss = loss/size(displacement)
   end subroutine get_loss

   !> Displacement along x or y that shear in this direction makes on an elastic half-space through nu, less its mean over all
   !> directions of waves: (2/|k|) (1/2 - k_x^2/k^2), in units of (nu/G) times that unit of displacement.
   subroutine apply_anisotropy(self, along, shear, displacement)
      class(periodic_operator_t), intent(inout) :: self
      !> Direction of the shear: 1 along x, 2 along y.
      integer, intent(in) :: along
      !> Shear traction in the middles of the cells; shape `n_cells`.
      real(dp), intent(in), contiguous :: shear(:, :)
      !> Receives the displacement, of mean 0; shape `n_cells`.
      real(dp), intent(out), contiguous :: displacement(:, :)
      real(dp), allocatable :: symbol(:, :)
      real(dp) :: n(2), period(2)
      integer :: i, j

      allocate (symbol, mold=self%stiffness)
      period = self%cell_size*self%n_cells*merge(2, 1, self%is_quarter)
      do i = 1, size(symbol, 2)
         do j = 1, size(symbol, 1)
            n = [real(i - 1, dp), wave_number(j - 1, self%n_cells(2), self%is_quarter)]/period
            symbol(j, i) = 0
            if (any(abs(n) > 0)) symbol(j, i) = (0.5_dp - n(along)**2/sum(n**2))/(0.5_dp*two_pi*norm2(n))
         end do
      end do
      symbol(:, :) = symbol/self%filter%gain
      call self%filter%apply(symbol, shear, displacement)
      self%n_applied = self%n_applied + 1
   end subroutine apply_anisotropy

   !> Wave numbers 2 pi n of all modes along x or y, 0 for waves of two cells, whose direction cannot be told.
   pure subroutine set_wave_numbers(self, along, numbers)
      class(periodic_operator_t), intent(in) :: self
      !> 1: along x, 2: along y.
      integer, intent(in) :: along
      !> Receives the numbers [1/unit of lengths]; shape of the modes, y first.
      real(dp), intent(out) :: numbers(:, :)
      real(dp) :: n
      integer :: i, j

      associate (cells => self%n_cells(along), period => self%n_cells(along)*self%cell_size(along))
         do i = 1, size(numbers, 2)
            do j = 1, size(numbers, 1)
               n = i - 1
               if (along == 2) n = wave_number(j - 1, cells, .false.)
               if (2*abs(nint(n)) == cells) n = 0
               numbers(j, i) = two_pi*n/period
            end do
         end do
      end associate
   end subroutine set_wave_numbers

end module adfric_periodic_operator
