! SPDX-License-Identifier: GPL-3.0-or-later
!> Cases of the tables of cosine sums.
module stepping_tables
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_shape_height_line, only: height_line_t, new_cosine_line
   use adfric_foundation_stepping_equilibrium, only: stepping_surface_t
   use stepping_cases, only: stepping_case_t, begin_rows, add_row, set_law
   use reference_table, only: table_t, read_table
   use unit_strips, only: edge_continuous, edge_instantaneous
   implicit none (type, external)
   private
   public :: case_of, get_shape, get_material, get_law, make_map

contains

   !> The case of a row.
   subroutine case_of(table, row, shape, material, trial)
      type(table_t), intent(in) :: table
      integer, intent(in) :: row
      character(*), intent(in) :: shape, material
      type(stepping_case_t), intent(out) :: trial

      call get_shape(shape, trial%amplitudes, trial%phases)
      call get_material(material, trial%stiffness, trial%times)
      call get_law(table, row, trial)
   end subroutine case_of

   !> Amplitudes and phases by name.
   subroutine get_shape(name, amplitudes, phases)
      character(*), intent(in) :: name
      real(dp), allocatable, intent(out) :: amplitudes(:), phases(:)
      type(table_t) :: table
      integer :: i

      call read_table(table, 'prof_shapes')
      allocate (amplitudes(0), phases(0))
      do i = 1, table%n_rows
         if (table%text(i, 'profile') /= name) cycle
         amplitudes = [amplitudes, table%number(i, 'a')]
         phases = [phases, table%number(i, 'phi')]
      end do
   end subroutine get_shape

   !> Arms by name.
   subroutine get_material(name, stiffness, times)
      character(*), intent(in) :: name
      real(dp), allocatable, intent(out) :: stiffness(:), times(:)
      type(table_t) :: table
      integer :: i

      call read_table(table, 'prof_materials')
      allocate (stiffness(0), times(0))
      do i = 1, table%n_rows
         if (table%text(i, 'material') /= name) cycle
         stiffness = [stiffness, table%number(i, 'k')]
         times = [times, table%number(i, 'tau')]
      end do
   end subroutine get_material

   !> Adhesion, edge rule and branch of a row.
   subroutine get_law(table, row, trial)
      type(table_t), intent(in) :: table
      integer, intent(in) :: row
      type(stepping_case_t), intent(inout) :: trial
      type(table_t) :: laws
      integer :: i

      call read_table(laws, 'prof_adhesions')
      do i = 1, laws%n_rows
         if (laws%text(i, 'adhesion') /= table%text(row, 'adhesion')) cycle
         trial%stress = laws%number(i, 'p0')
         trial%range = laws%number(i, 'd0')
      end do
      trial%edge = merge(edge_continuous, edge_instantaneous, table%text(row, 'edge') == 'continuous')
      trial%is_approach = table%text(row, 'branch') == 'approach'
   end subroutine get_law

   !> The map in a number of strips, for the spectrum and the law of a case.
   subroutine make_map(trial, n_strips, highest, surface)
      type(stepping_case_t), intent(in) :: trial
      integer, intent(in) :: n_strips
      !> The highest position of the map.
      real(dp), intent(in) :: highest
      type(stepping_surface_t), intent(out) :: surface
      type(table_t) :: modes
      type(height_line_t) :: line
      real(dp) :: mean
      complex(dp), allocatable :: waves(:)
      integer :: j

      call read_table(modes, 'prof_map_modes')
      call begin_rows(surface, n_strips)
      do j = 1, n_strips
         call get_strip(modes, (j - 0.5_dp)/n_strips, mean, waves)
         call new_cosine_line(line, abs(waves), atan2(aimag(waves), real(waves)))
         line%coefficients(0, :) = line%coefficients(0, :) + mean
         call add_row(surface, j, line, trial%stiffness, trial%times, highest)
      end do
      call set_law(surface, trial)
   end subroutine make_map

   !> Mean height and complex amplitudes of the map along x at one y.
   subroutine get_strip(modes, y, mean, waves)
      type(table_t), intent(in) :: modes
      real(dp), intent(in) :: y
      real(dp), intent(out) :: mean
      complex(dp), allocatable, intent(out) :: waves(:)
      real(dp) :: angle
      integer :: i, n

      allocate (waves(nint(maxval([(modes%number(i, 'n'), i=1, modes%n_rows)]))))
      waves = 0
      mean = 0
      do i = 1, modes%n_rows
         n = nint(modes%number(i, 'n'))
         angle = two_pi*modes%number(i, 'm')*y + modes%number(i, 'phi')
         if (n == 0) then
            mean = mean + modes%number(i, 'a')*cos(angle)
         else
            waves(n) = waves(n) + modes%number(i, 'a')*cmplx(cos(angle), sin(angle), dp)
         end if
      end do
   end subroutine get_strip

end module stepping_tables
