! SPDX-License-Identifier: GPL-3.0-or-later
!> Bodies that end, on an elastic half-space that goes on: time and steps of a load against the error of closed forms. See
!> bench/README.md.
!>
!> free_surface [TABLE.csv [LARGEST [FOLDER]]]
!>
!> FOLDER receives the gaps of the rough patches, raw numbers, for `free_public`.
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
   table = open_table(text_argument(1, 'free_surface.csv'), &
      & 'body,cells,ms,steps,error,estimate,area_error,area_estimate,answer')
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
      real(dp), allocatable :: shape(:, :)
      logical, allocatable :: is_body(:, :)
      real(dp) :: seconds, exact, area, errors(2)
      integer :: i, j

      nobody => null()
      allocate (shape(n, n), is_body(n, n))
      is_body = .true.
      if (name == 'rough') then
         block
            real(dp), allocatable :: heights(:, :)
            call make_surface(n, hurst, min(most_waves, n/4), heights)
            shape = rough_height*heights
         end block
         call write_heights(n, shape - minval(shape))
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
      call report(name, n, seconds, found, merge(0.0_dp, minval(shape), name == 'rough'), errors)
   end subroutine solve

   !> Write the gaps of a rough patch where a folder was given.
   subroutine write_heights(n, gaps)
      integer, intent(in) :: n
      real(dp), intent(in) :: gaps(:, :)
      character(:), allocatable :: folder
      character(20) :: cells
      integer :: file

      allocate (folder, source=text_argument(3, ''))
      if (len(folder) == 0) return
      write (cells, '(i0)') n
      open (newunit=file, file=folder//'/rough_'//trim(cells)//'.bin', access='stream', form='unformatted', action='write', &
         & status='replace')
      write (file) gaps
      close (file)
   end subroutine write_heights

   !> Print and write a line; errors that are not known are left empty.
   subroutine report(name, n, seconds, found, highest, errors)
      character(*), intent(in) :: name
      integer, intent(in) :: n
      real(dp), intent(in) :: seconds
      type(free_solution_t), intent(in) :: found
      !> Gap of the highest cell before touch, from which the approach does not count.
      real(dp), intent(in) :: highest
      !> Relative errors of the approach, or of the load of the punch, and of the area.
      real(dp), intent(in) :: errors(2)
      real(dp) :: estimates(2)

      estimates(1) = merge(found%load_error/found%load, found%approach_error/found%approach, name == 'punch')
      estimates(2) = relative_error_of(found%area)
      print '(a8, i7, f10.1, i7, 4es11.1)', name, n, 1000*seconds, found%n_iterations, errors(1), estimates(1), &
         & errors(2), estimates(2)
      write (table, '(a, ",", i0, ",", f0.2, ",", i0, 4(",", es9.2), ",", es23.15)') name, n, 1000*seconds, found%n_iterations, &
         & errors(1), min(estimates(1), 1.0_dp), errors(2), min(estimates(2), 1.0_dp), &
         & merge(found%load, found%approach + highest, name == 'punch')
   end subroutine report

end program free_surface
