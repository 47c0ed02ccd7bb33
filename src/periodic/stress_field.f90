! SPDX-License-Identifier: GPL-3.0-or-later
!> Stresses in an elastic half-space below a periodic pressure p and shear stress q, by transforms. Tension is positive, z is depth, and
!> q is the stress that the face exerts on the solid along one axis.
!>
!> A wave of the wave number k along the unit vector (c, s) of the surface makes plane strain with p and with the part of q along it, and
!> shear out of that plane with the part of q across it. With e = exp(-k z) and axes 1 along the wave, 2 across it, 3 down
!> (K. L. Johnson, Contact Mechanics, 1985, sections 2.2 and 13.2, for a wave of p):
!>
!>     of p:              s_11 = -(1 - k z) e,   s_22 = -2 nu e,    s_33 = -(1 + k z) e,  s_13 = i k z e
!>     of q along it:     s_11 = i (2 - k z) e,  s_22 = 2 i nu e,   s_33 = i k z e,       s_13 = -(1 - k z) e
!>     of q across it:    s_12 = i e,  s_23 = -e
!>
!> The mean of p presses a solid that is fixed sideways: s_33 = -1 and s_11 = s_22 = -nu/(1 - nu), without strain along the surface. The
!> mean of q is s_13 = -1.
!>
!> The field is that of the waves that the cells can tell, so that at the surface s_33 = -p in their middles.
module adfric_periodic_stress_field
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_base_error, only: error_t, file_failure, set_error
   use adfric_numerics_spectral_filter, only: new_spectral_filter, spectral_filter_t
   use adfric_periodic_operator, only: wave_number
   implicit none (type, external)
   private
   public :: stress_field_t, new_stress_field, n_stresses, xx, yy, zz, xy, xz, yz

   !> Components of the stress, and their number.
   integer, parameter :: xx = 1, yy = 2, zz = 3, xy = 4, xz = 5, yz = 6, n_stresses = yz

   !> The half-space below a map of the pressure.
   type :: stress_field_t
      private
      !> Transforms of a whole period.
      type(spectral_filter_t) :: filter
      !> Numbers of waves per length along x and along y.
      real(dp), allocatable :: n_x(:), n_y(:)
      !> Is the wave the shortest one along x, or along y?
      logical, allocatable :: is_short_x(:), is_short_y(:)
      !> Poisson's ratio nu [-].
      real(dp) :: poisson_ratio = 0
      !> Pressure of a whole period, and shear stress; the latter not allocated: none.
      real(dp), allocatable :: pressure(:, :), shear(:, :)
      !> 1: the shear stress is along x; 2: along y.
      integer :: axis = 1
   contains
      procedure :: get_stresses
      procedure :: n_cells
   end type stress_field_t

contains

   !> The half-space below a map; an error means that there is no memory.
   subroutine new_stress_field(self, pressure, period, is_quarter, poisson_ratio, error, shear, axis)
      !> The new half-space.
      type(stress_field_t), intent(out) :: self
      !> Pressure in the middles of the cells, in any unit; shape `(nx, ny)`, ny = 1 if it does not vary along y.
      real(dp), intent(in) :: pressure(:, :)
      !> Periods along x and y; depths are in the same unit.
      real(dp), intent(in) :: period(2)
      !> Are the cells a quarter of the period, about whose ends the pressure is even?
      logical, intent(in) :: is_quarter
      !> Poisson's ratio nu [-].
      real(dp), intent(in) :: poisson_ratio
      !> Not allocated if all went well.
      type(error_t), allocatable, intent(out) :: error
      !> Shear stress on the solid, in the unit and with the shape and the symmetry of the pressure; not present: none.
      real(dp), intent(in), optional :: shear(:, :)
      !> Axis of the shear stress, 1 or 2; not present: x.
      integer, intent(in), optional :: axis
      integer :: i, n(2), failure

      n = shape(pressure)*merge(2, 1, is_quarter)
      call new_spectral_filter(self%filter, n(1), n(2), .false., .false., error)
      if (allocated(error)) return
      allocate (self%pressure(n(1), n(2)), stat=failure)
      if (failure == 0 .and. present(shear)) allocate (self%shear(n(1), n(2)), stat=failure)
      if (failure /= 0) then
         call set_error(error, file_failure, 'there is no memory for the stresses of so many cells')
         return
      end if
      call unfold(pressure, self%pressure)
      if (present(shear)) call unfold(shear, self%shear)
      if (present(axis)) self%axis = axis
      self%poisson_ratio = poisson_ratio
      associate (n_modes => self%filter%n_modes)
         self%n_x = [((i - 1)/period(1), i=1, n_modes(1))]
         self%n_y = [(wave_number(i - 1, n(2), .false.)/period(2), i=1, n_modes(2))]
         self%is_short_x = [(2*(i - 1) == n(1), i=1, n_modes(1))]
         self%is_short_y = [(2*(i - 1) == n(2), i=1, n_modes(2))]
      end associate
   end subroutine new_stress_field

   !> A whole period of a map that may be a quarter of it.
   pure subroutine unfold(map, whole)
      real(dp), intent(in) :: map(:, :)
      !> Receives the map, and behind it its mirror images where it is larger.
      real(dp), intent(out) :: whole(:, :)

      associate (n => shape(map), m => shape(whole))
         whole(:n(1), :n(2)) = map
         if (m(1) > n(1)) whole(n(1) + 1:, :n(2)) = map(n(1):1:-1, :)
         if (m(2) > n(2)) whole(:, n(2) + 1:) = whole(:, n(2):1:-1)
      end associate
   end subroutine unfold

   !> Number of cells of a whole period, along x and y.
   pure function n_cells(self)
      class(stress_field_t), intent(in) :: self
      integer :: n_cells(2)

      n_cells = shape(self%pressure)
   end function n_cells

   !> All stresses at a depth, below the middles of the cells.
   subroutine get_stresses(self, depth, stress)
      class(stress_field_t), intent(inout) :: self
      !> z >= 0 in the unit of the periods; at `huge` only the means remain.
      real(dp), intent(in) :: depth
      !> Receives the stresses, in the order of `xx` to `yz`, in the unit of the pressure; shape `(nx, ny, n_stresses)` of a whole period.
      real(dp), intent(out), contiguous :: stress(:, :, :)
      real(dp), allocatable :: real_part(:, :), imaginary(:, :), of_shear(:, :)
      integer :: k

      allocate (real_part(self%filter%n_modes(2), self%filter%n_modes(1)))
      allocate (imaginary, mold=real_part)
      if (allocated(self%shear)) allocate (of_shear, mold=self%shear)
      do k = 1, n_stresses
         call set_symbol(self, k, depth, .false., real_part, imaginary)
         call self%filter%apply(real_part, self%pressure, stress(:, :, k), imaginary=imaginary)
         if (.not. allocated(of_shear)) cycle
         call set_symbol(self, k, depth, .true., real_part, imaginary)
         call self%filter%apply(real_part, self%shear, of_shear, imaginary=imaginary)
         stress(:, :, k) = stress(:, :, k) + of_shear
      end do
   end subroutine get_stresses

   !> The stress of each wave of 1 of the pressure, or of the shear stress.
   subroutine set_symbol(self, component, depth, is_shear, real_part, imaginary)
      class(stress_field_t), intent(in) :: self
      !> Component of the stress, such as `xx`.
      integer, intent(in) :: component
      !> z >= 0.
      real(dp), intent(in) :: depth
      logical, intent(in) :: is_shear
      !> Receive both parts of the factors of the filter; shape `(n_modes(2), n_modes(1))`.
      real(dp), intent(out) :: real_part(:, :), imaginary(:, :)
      complex(dp) :: factor
      integer :: axis, i, j

      axis = merge(self%axis, 0, is_shear)
      do i = 1, size(real_part, 2)
         do j = 1, size(real_part, 1)
            associate (x => self%n_x(i), y => self%n_y(j), nu => self%poisson_ratio)
               factor = stress_of_wave(component, [x, y], depth, nu, axis)
               ! of the shortest waves cells do not tell the sign of the wave number: both have half
               if (self%is_short_x(i)) factor = (factor + stress_of_wave(component, [-x, y], depth, nu, axis))/2
               if (self%is_short_y(j)) then
                  if (self%is_short_x(i)) then
                     factor = (factor + (stress_of_wave(component, [x, -y], depth, nu, axis) &
                        & + stress_of_wave(component, [-x, -y], depth, nu, axis))/2)/2
                  else
                     factor = (factor + stress_of_wave(component, [x, -y], depth, nu, axis))/2
                  end if
               end if
            end associate
            real_part(j, i) = real(factor, dp)/self%filter%gain
            imaginary(j, i) = aimag(factor)/self%filter%gain
         end do
      end do
   end subroutine set_symbol

   !> Stress at a depth of a wave of 1 at the surface.
   pure complex(dp) function stress_of_wave(component, n, depth, nu, axis) result(stress)
      integer, intent(in) :: component
      !> Numbers of waves per length along x and y.
      real(dp), intent(in) :: n(2)
      real(dp), intent(in) :: depth
      !> Poisson's ratio.
      real(dp), intent(in) :: nu
      !> 0: of the pressure; 1: of the shear stress along x; 2: of that along y.
      integer, intent(in) :: axis
      complex(dp), parameter :: i = (0.0_dp, 1.0_dp)
      !> Beyond this the exponential is below any number that is not round-off.
      real(dp), parameter :: decayed = 700
      complex(dp) :: s11, s22, s33, s12, s13, s23
      real(dp) :: c, s, kz, e, along, across

      if (.not. any(abs(n) > 0)) then
         stress = mean_stress(component, nu, axis)
         return
      end if
      stress = 0
      if (depth > decayed/(two_pi*norm2(n))) return
      kz = two_pi*norm2(n)*depth
      e = exp(-kz)
      c = n(1)/norm2(n)
      s = n(2)/norm2(n)
      if (axis == 0) then
         s11 = -(1 - kz)*e
         s22 = -2*nu*e
         s33 = -(1 + kz)*e
         s13 = i*kz*e
         s12 = 0
         s23 = 0
      else
         along = merge(c, s, axis == 1)
         across = merge(-s, c, axis == 1)
         s11 = i*(2 - kz)*e*along
         s22 = 2*i*nu*e*along
         s33 = i*kz*e*along
         s13 = -(1 - kz)*e*along
         s12 = i*e*across
         s23 = -e*across
      end if
      select case (component)
      case (xx)
         stress = c**2*s11 + s**2*s22 - 2*c*s*s12
      case (yy)
         stress = s**2*s11 + c**2*s22 + 2*c*s*s12
      case (zz)
         stress = s33
      case (xy)
         stress = c*s*(s11 - s22) + (c**2 - s**2)*s12
      case (xz)
         stress = c*s13 - s*s23
      case (yz)
         stress = s*s13 + c*s23
      end select
   end function stress_of_wave

   !> Stress of a mean of 1.
   pure complex(dp) function mean_stress(component, nu, axis) result(stress)
      integer, intent(in) :: component
      !> Poisson's ratio.
      real(dp), intent(in) :: nu
      !> 0: of the pressure; 1: of the shear stress along x; 2: of that along y.
      integer, intent(in) :: axis

      stress = 0
      if (axis == 0) then
         if (component == zz) stress = -1
         if (component == xx .or. component == yy) stress = -nu/(1 - nu)
      else if (component == merge(xz, yz, axis == 1)) then
         stress = -1
      end if
   end function mean_stress

end module adfric_periodic_stress_field
