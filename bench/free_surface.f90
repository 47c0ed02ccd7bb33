! SPDX-License-Identifier: GPL-3.0-or-later
!> Bodies that end, on an elastic half-space that goes on: time and steps of a load against the error of closed forms. See
!> bench/README.md.
!>
!> free_surface [TABLE.csv [LARGEST]]
program free_surface
   use adfric_base_error, only: error_t
   use adfric_base_kinds, only: dp
   use adfric_base_watch, only: watch_t
   use adfric_periodic_area, only: relative_error_of
   use adfric_periodic_free_solver, only: free_solution_t, free_solver_t, new_free_solver, solve_free
   use adfric_system_clock, only: wall_clock
   use measure, only: print_heading, text_argument, integer_argument, open_table
   use rough_shapes, only: make_surface
   implicit none (type, external)

   real(dp), parameter :: pi = 3.14159265358979323846264338328_dp, tolerance = 1.0e-7_dp
   !> Radius of the contact of smooth bodies over the length of the map, radius of the sphere, slope of the cone, approach of the punch.
   real(dp), parameter :: contact = 0.3_dp, radius = 2, slope = 0.1_dp, depth = 0.01_dp
   !> Hurst exponent, number of waves, height, and load over E* of the rough patch.
   real(dp), parameter :: hurst = 0.8_dp, rough_height = 0.005_dp, rough_load = 0.005_dp
   integer, parameter :: most_waves = 64, fewest = 32
   character(*), parameter :: bodies(*) = [character(8) :: 'sphere', 'cone', 'line', 'punch', 'rough']
   integer :: table, k, n

   call print_heading('Bodies that end, on a half-space')
   table = open_table(text_argument(1, 'free_surface.csv'), 'body,cells,ms,steps,error,estimate,area_error,area_estimate')
   print '(a8, a7, a10, a7, 4a11)', 'body', 'cells', 'ms', 'steps', 'error', 'estimate', 'area', 'estimate'
   do k = 1, size(bodies)
      n = fewest
      do while (n <= integer_argument(2, 1024))
         call solve(trim(bodies(k)), n)
         n = 2*n
      end do
   end do
   close (table)

contains

   !> Solve a body on cells, and print and write a line.
   subroutine solve(name, n)
      character(*), intent(in) :: name
      !> Cells along x and y.
      integer, intent(in) :: n
      type(free_solver_t) :: solver
      type(free_solution_t) :: found
      type(error_t), allocatable :: error
      class(watch_t), pointer :: nobody
      real(dp) :: shape(n, n), seconds, exact, area, errors(2)
      logical :: is_body(n, n)
      integer :: i, j

      nobody => null()
      is_body = .true.
      if (name == 'rough') then
         block
            real(dp), allocatable :: heights(:, :)
            call make_surface(n, hurst, min(most_waves, n/4), heights)
            shape = rough_height*heights
         end block
      else
         do j = 1, n
            do i = 1, n
               associate (x => (i - 0.5_dp)/n - 0.5_dp, y => (j - 0.5_dp)/n - 0.5_dp)
                  select case (name)
                  case ('sphere')
                     shape(i, j) = (x**2 + y**2)/(2*radius)
                  case ('cone')
                     shape(i, j) = slope*sqrt(x**2 + y**2)
                  case ('line')
                     shape(i, j) = x**2/(2*radius)
                  case default
                     shape(i, j) = 0
                     is_body(i, j) = x**2 + y**2 <= contact**2
                  end select
               end associate
            end do
         end do
      end if
      call new_free_solver(solver, [n, n], [1.0_dp, 1.0_dp], [.false., name == 'line'], nobody, error)
      if (allocated(error)) error stop 'no solver'
      seconds = wall_clock()
      select case (name)
      case ('sphere')
         exact = contact**2/radius
         area = pi*contact**2
         call solve_free(solver, shape - minval(shape), is_body, .true., 4*contact**3/(3*radius), tolerance, found)
      case ('cone')
         exact = pi*slope*contact/2
         area = pi*contact**2
         call solve_free(solver, shape - minval(shape), is_body, .true., pi*slope*contact**2/2, tolerance, found)
      case ('line')
         ! the displacement of a line load is 0 at the length of the map across
         exact = contact**2/(2*radius)*(log(2/contact) + 0.5_dp)
         area = 2*contact
         call solve_free(solver, shape - minval(shape), is_body, .true., pi*contact**2/(4*radius), tolerance, found)
      case ('punch')
         exact = 2*contact*depth
         area = pi*contact**2
         call solve_free(solver, shape, is_body, .false., depth, tolerance, found)
      case default
         exact = 0
         area = 0
         call solve_free(solver, shape - minval(shape), is_body, .true., rough_load, tolerance, found)
      end select
      seconds = wall_clock() - seconds
      if (.not. found%is_converged) error stop 'a contact was not found'
      errors = 0
      if (name == 'punch') then
         errors(1) = abs(found%load/exact - 1)
      else if (exact > 0) then
         ! approaches count from touch of the highest cell
         errors(1) = abs((found%approach + minval(shape))/exact - 1)
      end if
      if (area > 0) errors(2) = abs(found%area%corrected/area - 1)
      call report(name, n, seconds, found, errors)
   end subroutine solve

   !> Print and write a line; errors that are not known are left empty.
   subroutine report(name, n, seconds, found, errors)
      character(*), intent(in) :: name
      integer, intent(in) :: n
      real(dp), intent(in) :: seconds
      type(free_solution_t), intent(in) :: found
      !> Relative errors of the approach, or of the load of the punch, and of the area.
      real(dp), intent(in) :: errors(2)
      real(dp) :: estimates(2)

      estimates(1) = merge(found%load_error/found%load, found%approach_error/found%approach, name == 'punch')
      estimates(2) = relative_error_of(found%area)
      print '(a8, i7, f10.1, i7, 4es11.1)', name, n, 1000*seconds, found%n_iterations, errors(1), estimates(1), &
         & errors(2), estimates(2)
      write (table, '(a, ",", i0, ",", f0.2, ",", i0, 4(",", es9.2))') name, n, 1000*seconds, found%n_iterations, errors(1), &
         & min(estimates(1), 1.0_dp), errors(2), min(estimates(2), 1.0_dp)
   end subroutine report

end program free_surface
