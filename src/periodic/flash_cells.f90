! SPDX-License-Identifier: GPL-3.0-or-later
!> Flash temperatures on the cells of a periodic surface.
!>
!> A wave exp(ik.x) of the flux into a solid that moves at -V below the body has the temperature T = q/(lambda s), s^2 = k^2 - i
!> k.V/kappa, Re s > 0, with the conductivity lambda and the diffusivity kappa; of a layer on a base of fixed temperature times
!> tanh(s H). The body rests in this frame: T = q/(lambda_2 |k|). The mean, k = 0, has no steady state on a half-space and is
!> left out: flash temperatures have no mean over the surface.
!>
!> Fluxes are constant in cells, and temperatures are means over cells. So a wave of the cells stands for all its aliases k + K,
!> K a multiple of 2 pi over the length of a cell, with the factor sinc^2 of each. The first ones are summed, and the rest
!> estimated.
!>
!> In contact both bodies have one temperature, and share the heat Q: A1 q = A2 (Q - q) in the cells of contact, and no flux in
!> gaps. A1 is not symmetric.
module adfric_periodic_flash_cells
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi, two_pi
   use adfric_base_error, only: error_t
   use adfric_base_not_a_number, only: not_a_number
   use adfric_numerics_gmres, only: linear_map_t, solve_by_products
   use adfric_numerics_spectral_filter, only: new_spectral_filter, spectral_filter_t
   use adfric_periodic_operator, only: wave_number
   implicit none (type, external)
   private
   public :: flash_cells_t, heated_bodies_t, new_flash_cells

   !> Aliases in each direction of a line of cells, and of a map.
   integer, parameter :: aliases_of_line = 64, aliases_of_map = 4
   !> Residual of the heat's partition.
   real(dp), parameter :: tolerance = 1.0e-10_dp
   !> A layer is deep where exp(-2 s H) is below round-off.
   real(dp), parameter :: deep = 20.0_dp

   !> The bodies.
   type :: heated_bodies_t
      !> Conductivity [W/m/K] and diffusivity [m^2/s] of the solid.
      real(dp) :: conductivity = 1, diffusivity = 1
      !> Conductivity of the body above it [W/m/K]; 0: all heat goes into the solid.
      real(dp) :: second_conductivity = 0
      !> Velocity of the body along x and y [m/s].
      real(dp) :: velocity(2) = 0
      !> Thickness of a layer [m]; 0: a half-space.
      real(dp) :: thickness = 0
   end type heated_bodies_t

   !> Temperatures of a surface. Not to be copied.
   type, extends(linear_map_t) :: flash_cells_t
      private
      !> Transforms of the cells.
      type(spectral_filter_t) :: filter
      !> Temperature over flux of each wave of the solid, and of the body, over the gain of the transforms; shape
      !> `(n_modes(2), n_modes(1))`.
      real(dp), allocatable :: re(:, :), im(:, :), second(:, :)
      !> What takes the sum of both back, likewise.
      real(dp), allocatable :: inverse_re(:, :), inverse_im(:, :)
      !> Where the surfaces touch; shape `(nx, ny)`.
      logical, allocatable :: is_contact(:, :)
      !> Is the matrix the transposed one?
      logical :: is_transposed = .false.
      !> Products that the last partition took.
      integer, public :: n_products = 0
   contains
      procedure :: get_weights
      procedure :: get_temperature
      procedure :: multiply
      procedure, private :: solve_partition
      procedure, private :: apply_solid
   end type flash_cells_t

contains

   !> Set up the waves.
   subroutine new_flash_cells(self, bodies, n_cells, period, error)
      !> Receives the waves.
      type(flash_cells_t), intent(out) :: self
      type(heated_bodies_t), intent(in) :: bodies
      !> Cells along x and y; along y there may be one.
      integer, intent(in) :: n_cells(2)
      !> Periods along x and y [m].
      real(dp), intent(in) :: period(2)
      !> Not allocated if all went well.
      type(error_t), allocatable, intent(out) :: error
      complex(dp) :: sums(2), inverse
      integer :: i, j, waves(2)

      call new_spectral_filter(self%filter, n_cells(1), n_cells(2), .false., .false., error)
      if (allocated(error)) return
      associate (n => self%filter%n_modes, gain => self%filter%gain, has_second => bodies%second_conductivity > 0)
         allocate (self%re(n(2), n(1)), self%im(n(2), n(1)), source=0.0_dp)
         if (has_second) allocate (self%second(n(2), n(1)), self%inverse_re(n(2), n(1)), self%inverse_im(n(2), n(1)), source=0.0_dp)
         do i = 1, n(1)
            do j = 1, n(2)
               if (i == 1 .and. j == 1) cycle
               waves = [i - 1, nint(wave_number(j - 1, n(2), .false.))]
               call sum_aliases(bodies, waves, n_cells, period, sums)
               self%re(j, i) = real(sums(1), dp)/gain
               self%im(j, i) = aimag(sums(1))/gain
               if (.not. has_second) cycle
               self%second(j, i) = real(sums(2), dp)/gain
               inverse = 1/(gain*(sums(1) + sums(2)))
               self%inverse_re(j, i) = real(inverse, dp)
               self%inverse_im(j, i) = aimag(inverse)
            end do
         end do
         ! the mean is taken back as the longest waves are
         if (has_second) self%inverse_re(1, 1) = minval(self%inverse_re, mask=self%inverse_re > 0)
      end associate
   end subroutine new_flash_cells

   !> Temperature over flux of a wave on cells, in the solid and in the body [m^2 K/W]; the latter 0 where it takes no heat.
   pure subroutine sum_aliases(bodies, waves, n_cells, period, sums)
      type(heated_bodies_t), intent(in) :: bodies
      !> Waves in a period along x and y.
      integer, intent(in) :: waves(2)
      integer, intent(in) :: n_cells(2)
      real(dp), intent(in) :: period(2)
      complex(dp), intent(out) :: sums(2)
      complex(dp) :: of_wave(2)
      real(dp) :: share(2), k(2)
      integer :: m1, m2, last(2), first(2)
      logical :: is_middle(2), is_own(2)

      last = merge(aliases_of_map, 0, n_cells > 1)
      if (n_cells(2) == 1) last(1) = aliases_of_line
      ! a wave of two cells is an alias of its opposite: both have their aliases in common
      is_middle = 2*abs(waves) == n_cells
      first = -last - merge(1, 0, is_middle .and. n_cells > 1)
      sums = 0
      do m2 = first(2), last(2)
         share(2) = share_of(waves(2), m2, n_cells(2))
         if (.not. share(2) > 0) cycle
         do m1 = first(1), last(1)
            share(1) = share_of(waves(1), m1, n_cells(1))
            if (.not. share(1) > 0) cycle
            k = two_pi*(waves + [m1, m2]*n_cells)/period
            call get_wave(bodies, k, of_wave)
            sums = sums + product(share)*of_wave
            ! beyond the last ones, on the axes of the wave itself
            is_own = [m1, m2] == 0 .or. (is_middle .and. [m1, m2] == -1)
            if (waves(1) /= 0 .and. is_own(2) .and. any(m1 == [first(1), last(1)])) sums = sums &
               & + product(share)*rest_of(bodies, k, 1, period/n_cells)*of_wave
            if (waves(2) /= 0 .and. is_own(1) .and. any(m2 == [first(2), last(2)])) sums = sums &
               & + product(share)*rest_of(bodies, k, 2, period/n_cells)*of_wave
         end do
      end do
      ! the two waves of two cells are one real wave
      if (any(is_middle) .and. all(is_middle .or. waves == 0)) sums = real(sums, dp)
   end subroutine sum_aliases

   !> sinc^2 of an alias.
   pure real(dp) function share_of(wave, alias, n) result(share)
      !> Waves in a period, and number of the alias.
      integer, intent(in) :: wave, alias
      !> Cells in a period.
      integer, intent(in) :: n

      share = 1
      if (n == 1 .or. (wave == 0 .and. alias == 0)) return
      share = 0
      if (wave /= 0) share = (sin(pi*wave/n)/(pi*(wave + real(alias, dp)*n)/n))**2
   end function share_of

   !> Terms beyond the last alias on a side, over its own: they fall with a power between 5/2 and 3.
   pure real(dp) function rest_of(bodies, k, axis, lengths)
      type(heated_bodies_t), intent(in) :: bodies
      !> Wave vector of the alias [1/m].
      real(dp), intent(in) :: k(2)
      !> 1 for x, 2 for y.
      integer, intent(in) :: axis
      !> Lengths of a cell [m].
      real(dp), intent(in) :: lengths(2)
      real(dp) :: power
      complex(dp) :: s_squared

      associate (along => bodies%velocity/bodies%diffusivity)
         s_squared = cmplx(sum(k**2), -dot_product(k, along), dp)
         power = 2 + real(cmplx(2*k(axis)**2, -k(axis)*along(axis), dp)/(2*s_squared), dp)
      end associate
      associate (last => abs(k(axis))*lengths(axis)/two_pi)
         rest_of = last/(power - 1)*(last/(last + 0.5_dp))**(power - 1)
      end associate
   end function rest_of

   !> Temperature over flux of a wave.
   pure subroutine get_wave(bodies, k, of_wave)
      type(heated_bodies_t), intent(in) :: bodies
      !> Wave vector [1/m], not 0.
      real(dp), intent(in) :: k(2)
      !> Of the solid and of the body [m^2 K/W].
      complex(dp), intent(out) :: of_wave(2)
      complex(dp) :: s

      s = sqrt(cmplx(sum(k**2), -dot_product(k, bodies%velocity)/bodies%diffusivity, dp))
      of_wave(1) = 1/(bodies%conductivity*s)
      if (bodies%thickness > 0) then
         if (real(s, dp)*bodies%thickness < deep) of_wave(1) = of_wave(1)*tanh(s*bodies%thickness)
      end if
      of_wave(2) = 0
      if (bodies%second_conductivity > 0) of_wave(2) = 1/(bodies%second_conductivity*norm2(k))
   end subroutine get_wave

   !> By how much heat in each cell of contact raises the mean flash temperature of the contact.
   subroutine get_weights(self, is_contact, weights, is_converged)
      class(flash_cells_t), intent(inout) :: self
      !> Where the surfaces touch, in one cell at least; shape `(nx, ny)`.
      logical, intent(in) :: is_contact(:, :)
      !> Receives the rise over the heat [m^2 K/W]; 0 in gaps; shape `(nx, ny)`.
      real(dp), intent(out) :: weights(:, :)
      !> Was the partition of the heat found?
      logical, intent(out) :: is_converged
      real(dp), allocatable :: of_contact(:, :)

      is_converged = .true.
      self%is_contact = is_contact
      allocate (of_contact(size(weights, 1), size(weights, 2)))
      of_contact(:, :) = merge(1.0_dp/count(is_contact), 0.0_dp, is_contact)
      call self%apply_solid(of_contact, weights, .true.)
      if (allocated(self%second)) then
         if (all(is_contact)) then
            weights(:, :) = 0
            return
         end if
         call self%solve_partition(weights, .true., of_contact, is_converged)
         call self%filter%apply(self%second, of_contact, weights)
      end if
      where (.not. is_contact) weights = 0
   end subroutine get_weights

   !> Flash temperature of the surface of the solid.
   subroutine get_temperature(self, is_contact, heat, temperature, share, is_converged)
      class(flash_cells_t), intent(inout) :: self
      !> Where the surfaces touch; shape `(nx, ny)`.
      logical, intent(in) :: is_contact(:, :)
      !> Heat of both bodies, 0 in gaps [W/m^2]; shape `(nx, ny)`.
      real(dp), intent(in) :: heat(:, :)
      !> Receives the rise [K]; shape `(nx, ny)`.
      real(dp), intent(out) :: temperature(:, :)
      !> Share of the heat that goes into the solid [-]; NaN in full contact with a second body, where nothing tells it.
      real(dp), intent(out) :: share
      !> Was the partition of the heat found?
      logical, intent(out) :: is_converged
      real(dp), allocatable :: into_solid(:, :), of_both(:, :)

      share = 1
      is_converged = .true.
      if (.not. allocated(self%second)) then
         call self%apply_solid(heat, temperature, .false.)
         return
      end if
      self%is_contact = is_contact
      allocate (into_solid(size(heat, 1), size(heat, 2)), of_both(size(heat, 1), size(heat, 2)))
      call self%filter%apply(self%second, heat, of_both)
      if (all(is_contact)) then
         share = not_a_number()
         ! each wave by itself
         call self%filter%apply(self%inverse_re, of_both, into_solid, imaginary=self%inverse_im)
      else
         call self%solve_partition(of_both, .false., into_solid, is_converged)
         share = sum(into_solid)/sum(heat)
      end if
      call self%apply_solid(into_solid, temperature, .false.)
   end subroutine get_temperature

   !> Temperature of a flux into the solid.
   subroutine apply_solid(self, flux, temperature, is_transposed)
      class(flash_cells_t), intent(inout) :: self
      real(dp), intent(in) :: flux(:, :)
      real(dp), intent(out) :: temperature(:, :)
      !> Does the body move the other way?
      logical, intent(in) :: is_transposed

      if (is_transposed) then
         call self%filter%apply(self%re, flux, temperature, imaginary=-self%im)
      else
         call self%filter%apply(self%re, flux, temperature, imaginary=self%im)
      end if
   end subroutine apply_solid

   !> The flux in contact under which the temperatures of both bodies have a given sum there.
   subroutine solve_partition(self, temperature, is_transposed, flux, is_converged)
      class(flash_cells_t), intent(inout) :: self
      !> The sum; shape `(nx, ny)`.
      real(dp), intent(in) :: temperature(:, :)
      !> Does the body move the other way?
      logical, intent(in) :: is_transposed
      !> Receives the flux, 0 in gaps; shape `(nx, ny)`.
      real(dp), intent(out) :: flux(:, :)
      logical, intent(out) :: is_converged
      real(dp), allocatable :: x(:)

      self%is_transposed = is_transposed
      allocate (x(count(self%is_contact)))
      call solve_by_products(self, pack(temperature, self%is_contact), tolerance, x, self%n_products, is_converged)
      call take_back(self, x, flux)
   end subroutine solve_partition

   !> What stands for the inverse of the matrix: that of all cells in contact.
   subroutine take_back(self, x, flux)
      class(flash_cells_t), intent(inout) :: self
      !> Values in the cells of contact.
      real(dp), intent(in) :: x(:)
      !> Receives the flux, 0 in gaps; shape `(nx, ny)`.
      real(dp), intent(out) :: flux(:, :)
      real(dp), allocatable :: field(:, :)

      allocate (field(size(flux, 1), size(flux, 2)))
      field(:, :) = unpack(x, self%is_contact, 0.0_dp)
      call self%filter%apply(self%inverse_re, field, flux, imaginary=merge(-1, 1, self%is_transposed)*self%inverse_im)
      where (.not. self%is_contact) flux = 0
   end subroutine take_back

   !> Sum of both temperatures in contact, of a flux that is taken back before; see `linear_map_t`.
   subroutine multiply(self, x, product)
      class(flash_cells_t), intent(inout) :: self
      !> Values in the cells of contact; shape `(n)`.
      real(dp), intent(in) :: x(:)
      real(dp), intent(out) :: product(:)
      real(dp), allocatable :: flux(:, :), temperature(:, :)

      allocate (flux(size(self%is_contact, 1), size(self%is_contact, 2)))
      allocate (temperature, mold=flux)
      call take_back(self, x, flux)
      call self%filter%apply(self%re + self%second, flux, temperature, imaginary=merge(-1, 1, self%is_transposed)*self%im)
      product = pack(temperature, self%is_contact)
   end subroutine multiply

end module adfric_periodic_flash_cells
