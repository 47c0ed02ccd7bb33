! SPDX-License-Identifier: GPL-3.0-or-later
!> Steady sliding over a viscoelastic layer: transforms and time of one load against thickness and velocity.
!>
!>     sliding_layers [TABLE.csv [LARGEST]]
!>
!> Lines of 1024 cells and maps of 128 x 128 up to LARGEST x LARGEST cells (256 if absent), random with waves down to eight cells,
!> under loads that leave parts open. The layer slips on its base or is bonded to it with nu = 0.3; thickness 0 means a half-space.
!> The rubber has 13 relaxation times in 12 decades, kg/k0 = 770. A pair of transforms is one application of the stiffness; coarser
!> grids count by their cells.
program sliding_layers
   use, intrinsic :: iso_fortran_env, only: output_unit
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_solid_prony, only: prony_t, new_prony
   use adfric_periodic_elastic_kernel, only: elastic_kernel_t
   use adfric_periodic_kernel, only: kernel_t
   use adfric_periodic_layer_kernel, only: layer_kernel_t
   use adfric_periodic_sliding_kernel, only: sliding_kernel_t, new_sliding_kernel
   use adfric_periodic_solver, only: periodic_solver_t, periodic_solution_t, new_periodic_solver
   use adfric_system_clock, only: wall_clock
   use measure, only: print_heading, text_argument, integer_argument, open_table
   use rough_shapes, only: make_surface
   implicit none (type, external)

   integer, parameter :: line_cells = 1024
   real(dp), parameter :: tolerance = 1.0e-8_dp, thicknesses(*) = [0.0_dp, 0.1_dp, 0.01_dp, 0.001_dp]
   real(dp), parameter :: velocities(*) = [0.0_dp, 1.0e-6_dp, 1.0e-2_dp, 1.0_dp, 1.0e2_dp, 1.0e4_dp, 1.0e6_dp, 1.0e10_dp]
   real(dp), parameter :: loads(*) = [0.03_dp, 0.1_dp, 0.4_dp]
   real(dp), allocatable :: shape(:, :), square(:, :)
   integer :: table, n

   call print_heading('steady sliding over a viscoelastic layer')
   table = open_table(text_argument(1, 'sliding_layers.csv'), &
      & 'case,cells,base,thickness,velocity,load,area,pairs,steps,ms,status,residual,friction')
   print '(a6, a6, a13, a10, a10, a7, a8, a9, a7, a10, a7, a10)', 'case', 'cells', 'base', 'thickness', 'velocity', 'load', &
      & 'area', 'pairs', 'steps', 'ms', 'state', 'residual'
   call make_surface(line_cells, 0.8_dp, line_cells/8, square)
   allocate (shape(line_cells, 1), source=square(:, :1) - minval(square(:, 1)))
   call report_surface('line', shape)
   n = 128
   do while (n <= integer_argument(2, 256))
      call make_surface(n, 0.8_dp, n/8, square)
      call report_surface('map', square)
      n = 2*n
   end do
   close (table)

contains

   !> All layers, spectra, velocities and loads.
   subroutine report_surface(name, shape)
      character(*), intent(in) :: name
      real(dp), intent(in), contiguous :: shape(:, :)
      type(layer_kernel_t) :: layer
      type(prony_t) :: prony
      integer :: i, k

      call new_prony(prony, 1.0_dp, [(2.0_dp**(i/2.0_dp)*8.55_dp, i=0, 12)], [(10.0_dp**(-i), i=0, 12)])
      do k = 1, size(thicknesses)
         if (thicknesses(k) > 0) then
            layer = layer_kernel_t(thicknesses(k), .false., 0.5_dp)
            call report_solid(name, shape, 'slips', layer, thicknesses(k), prony)
            layer = layer_kernel_t(thicknesses(k), .true., 0.3_dp)
            call report_solid(name, shape, 'bonded', layer, thicknesses(k), prony)
         else
            call report_solid(name, shape, 'half-space', elastic_kernel_t(), 0.0_dp, prony)
         end if
      end do
   end subroutine report_surface

   !> One layer.
   subroutine report_solid(name, shape, base, solid, thickness, prony)
      character(*), intent(in) :: name, base
      real(dp), intent(in), contiguous :: shape(:, :)
      class(kernel_t), intent(in) :: solid
      real(dp), intent(in) :: thickness
      type(prony_t), intent(in) :: prony
      type(sliding_kernel_t) :: kernel
      type(periodic_solver_t) :: solver
      type(periodic_solution_t) :: full, s
      type(error_t), allocatable :: error
      real(dp) :: start
      integer :: k, l

      do k = 1, size(velocities)
         call new_sliding_kernel(kernel, solid, prony, velocities(k), [1, 0])
         call new_periodic_solver(solver, kernel, [size(shape, 1), size(shape, 2)], [1.0_dp, 1.0_dp], .false., error)
         if (allocated(error)) error stop 'no solver'
         call solver%solve_load(shape, huge(1.0_dp)**0.25_dp, tolerance, full, error)
         if (allocated(error)) error stop 'no solution'
         do l = 1, size(loads)
            start = wall_clock()
            call solver%solve_load(shape, loads(l)*full%full_pressure, tolerance, s, error)
            if (allocated(error)) error stop 'no solution'
            start = 1000*(wall_clock() - start)
            print '(a6, i6, a13, f10.4, es10.1, f7.3, f8.4, f9.1, i7, f10.2, i7, es10.1)', name, size(shape, 1), base, &
               & thickness, velocities(k), loads(l), s%area%cells, s%n_pairs, s%n_iterations, start, s%status, s%residual
            write (table, '(2a, i0, 3a, 4(es12.5, ","), f0.2, ",", i0, ",", f0.3, ",", i0, ",", es9.2, ",", es16.9)') name, ',', &
               & size(shape, 1), ',', base, ',', thickness, velocities(k), loads(l), s%area%cells, s%n_pairs, &
               & s%n_iterations, start, s%status, s%residual, s%friction%loss(1)
            flush (output_unit)
         end do
      end do
   end subroutine report_solid

end program sliding_layers
