! SPDX-License-Identifier: GPL-3.0-or-later
!> Waves and random surfaces that adhere while they slide over a viscoelastic half-space: pairs of transforms of both branches, beside
!> those of the same load without adhesion. Before them waves and cylinders without cells: time of all states at a velocity, and of
!> one more load there, for 1 to 30 relaxation times over up to six decades.
!>
!>     sliding_adhesion [TABLE.csv [LARGEST [CURVES.csv]]]
!>
!> Maps of 64 x 64 up to LARGEST x LARGEST cells (256 if absent): waves along x and y, and a random surface with waves down to eight
!> cells. The solid has one relaxation time, kg/k0 = 10. Pressures are in units of the pressure of full contact at rest. A pair of
!> transforms is one application of the stiffness; coarser grids count by their cells.
program sliding_adhesion
   use, intrinsic :: iso_fortran_env, only: output_unit
   use adfric_base_constants, only: two_pi
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_solid_prony, only: prony_t, new_prony
   use adfric_periodic_adhesive_solver, only: periodic_adhesion_t, solve_adhesive_load
   use adfric_periodic_elastic_kernel, only: elastic_kernel_t
   use adfric_periodic_sliding_kernel, only: sliding_kernel_t, new_sliding_kernel
   use adfric_plane_adhesive_sliding_branch, only: branch_adhered, find_branches, slide_branches_t, slide_state_t, state_of_load
   use adfric_plane_adhesive_sliding_zones, only: adhesive_slide_t, set_compliances
   use adfric_plane_sliding_solid, only: new_sliding_solid
   use adfric_periodic_solver, only: periodic_solver_t, periodic_solution_t, new_periodic_solver
   use adfric_system_clock, only: wall_clock
   use measure, only: print_heading, text_argument, integer_argument, open_table
   use rough_shapes, only: make_surface
   implicit none (type, external)

   real(dp), parameter :: tolerance = 1.0e-8_dp, velocities(*) = [0.1_dp, 0.3_dp, 1.0_dp, 3.0_dp], loads(*) = [0.1_dp, 1.0_dp]
   !> Tension over the pressure of full contact at rest, and range over half the height.
   real(dp), parameter :: part_of_pressure = 0.3_dp, part_of_height = 0.3_dp
   real(dp), allocatable :: shape(:, :)
   integer :: table, n, i, j

   call report_curves()
   call print_heading('adhesion while sliding over a viscoelastic half-space')
   table = open_table(text_argument(1, 'sliding_adhesion.csv'), &
      & 'case,cells,velocity,load,branch,status,area,pairs,pairs_without,ms,ms_without,friction,friction_without')
   print '(a6, a6, a9, a7, a9, a7, a9, 2a9, 2a10, 2a12)', 'case', 'cells', 'k V t', 'load', 'branch', 'state', 'area', 'pairs', &
      & 'without', 'ms', 'without', 'friction', 'without'
   n = 64
   do while (n <= integer_argument(2, 256))
      if (allocated(shape)) deallocate (shape)
      allocate (shape(n, n))
      do j = 1, n
         do i = 1, n
            shape(i, j) = (2 - cos(two_pi*(i - 0.5_dp)/n) - cos(two_pi*(j - 0.5_dp)/n))/4
         end do
      end do
      call report_surface('wave', shape)
      call make_surface(n, 0.8_dp, n/8, shape)
      call report_surface('rough', shape)
      n = 2*n
   end do
   close (table)

contains

   !> Waves and cylinders without cells.
   subroutine report_curves()
      integer, parameter :: numbers(*) = [1, 3, 6, 15, 30]
      type(prony_t) :: prony
      real(dp), allocatable :: times(:)
      integer :: k, c, v

      call print_heading('waves and cylinders without cells: all states at a velocity')
      ! without it gfortran 12 takes its bounds for unset
      allocate (times(0))
      table = open_table(text_argument(3, 'sliding_curves.csv'), 'case,arms,velocity,points,ms_curve,ms_state,pull_off')
      print '(a9, a6, 3a9, a9, a16)', 'case', 'arms', 'V t', 'points', 'ms', 'a load', 'pull-off'
      do c = 1, 2
         do k = 1, size(numbers)
            associate (n => numbers(k))
               times = [(10.0_dp**(-(n - v)*min(1.0_dp, 6.0_dp/max(n - 1, 1))), v=1, n)]
               call new_prony(prony, 1.0_dp, 9*times**(-0.4_dp)/sum(times**(-0.4_dp)), times)
               do v = 1, 2
                  call report_curve(c == 1, prony, merge(0.3_dp, 30.0_dp, v == 1))
               end do
            end associate
         end do
      end do
      close (table)
   end subroutine report_curves

   !> A line of a curve: the shortest of some times.
   subroutine report_curve(is_wave, prony, velocity)
      logical, intent(in) :: is_wave
      type(prony_t), intent(in) :: prony
      !> Times the longest relaxation time, in 1/k or, of a cylinder, in (R^2 w/E0)^(1/3).
      real(dp), intent(in) :: velocity
      integer, parameter :: n_times = 3
      type(adhesive_slide_t) :: slide
      type(slide_branches_t) :: branches
      type(slide_state_t) :: state
      real(dp) :: start, of_curve, of_state
      integer :: i
      logical :: is_found

      slide%is_wave = is_wave
      slide%stress = merge(0.5_dp, 2.0_dp, is_wave)
      slide%range = merge(0.05_dp, 0.5_dp, is_wave)
      call new_sliding_solid(slide%solid, prony, velocity)
      call set_compliances(slide)
      of_curve = huge(1.0_dp)
      of_state = huge(1.0_dp)
      do i = 1, n_times
         start = wall_clock()
         call find_branches(slide, branches, is_found, 10.0_dp)
         if (.not. is_found .or. .not. branches%is_complete) error stop 'no curve'
         of_curve = min(of_curve, 1000*(wall_clock() - start))
         start = wall_clock()
         call state_of_load(branches, 0.1_dp, branch_adhered, state, is_found)
         if (.not. is_found) error stop 'no state'
         of_state = min(of_state, 1000*(wall_clock() - start))
      end do
      print '(a9, i6, es9.1, i9, 2f9.1, f16.10)', merge('wave    ', 'cylinder', is_wave), size(prony%times), velocity, &
         & size(branches%curve%points), of_curve, of_state, branches%pull_off_load
      write (table, '(2a, i0, ",", es12.5, ",", i0, 2(",", f0.3), ",", es16.9)') trim(merge('wave    ', 'cylinder', is_wave)), &
         & ',', size(prony%times), velocity, size(branches%curve%points), of_curve, of_state, branches%pull_off_load
      flush (output_unit)
   end subroutine report_curve

   !> All velocities, loads and branches.
   subroutine report_surface(name, shape)
      character(*), intent(in) :: name
      real(dp), intent(in), contiguous :: shape(:, :)
      type(periodic_solver_t) :: at_rest, solver
      type(periodic_solution_t) :: full, without, found
      type(periodic_adhesion_t) :: law
      type(sliding_kernel_t) :: kernel
      type(prony_t) :: prony
      type(error_t), allocatable :: error
      real(dp) :: start, time_without
      integer :: k, l, b

      call new_prony(prony, 1.0_dp, [9.0_dp], [1.0_dp])
      call new_periodic_solver(at_rest, elastic_kernel_t(), [size(shape, 1), size(shape, 2)], [1.0_dp, 1.0_dp], .false., error)
      if (allocated(error)) error stop 'no solver'
      call at_rest%solve_load(shape, huge(1.0_dp)**0.25_dp, tolerance, full, error)
      if (allocated(error)) error stop 'no solution'
      law%stress = part_of_pressure*full%full_pressure
      law%range = part_of_height*(maxval(shape) - minval(shape))/4
      do k = 1, size(velocities)
         call new_sliding_kernel(kernel, elastic_kernel_t(), prony, velocities(k)/two_pi, [1, 0])
         call new_periodic_solver(solver, kernel, [size(shape, 1), size(shape, 2)], [1.0_dp, 1.0_dp], .false., error)
         if (allocated(error)) error stop 'no solver'
         do l = 1, size(loads)
            start = wall_clock()
            call solver%solve_load(shape, loads(l)*full%full_pressure, tolerance, without, error)
            if (allocated(error)) error stop 'no solution'
            time_without = 1000*(wall_clock() - start)
            do b = 1, 2
               law%is_adhered = b == 1
               start = wall_clock()
               call solve_adhesive_load(solver, shape, loads(l)*full%full_pressure, law, tolerance, found, error)
               if (allocated(error)) error stop 'no solution'
               call report(name, size(shape, 1), velocities(k), loads(l), merge('adhered', 'loading', b == 1), found, &
                  & without, 1000*(wall_clock() - start), time_without)
            end do
         end do
      end do
   end subroutine report_surface

   !> A line of a point.
   subroutine report(name, n_cells, velocity, load, branch, found, without, time, time_without)
      character(*), intent(in) :: name, branch
      integer, intent(in) :: n_cells
      real(dp), intent(in) :: velocity, load
      !> Solutions with adhesion and without.
      type(periodic_solution_t), intent(in) :: found, without
      !> Their times [ms].
      real(dp), intent(in) :: time, time_without

      print '(a6, i6, f9.2, f7.2, a9, i7, f9.4, 2f9.1, 2f10.2, 2es12.4)', name, n_cells, velocity, load, branch, found%status, &
         & found%area%cells, found%n_pairs, without%n_pairs, time, time_without, found%friction%loss(1), without%friction%loss(1)
      write (table, '(2a, i0, 2(",", es12.5), 3a, i0, ",", es12.5, 4(",", f0.3), 2(",", es16.9))') name, ',', n_cells, velocity, &
         & load, ',', branch, ',', found%status, found%area%cells, found%n_pairs, without%n_pairs, time, time_without, &
         & found%friction%loss(1), without%friction%loss(1)
      flush (output_unit)
   end subroutine report

end program sliding_adhesion
