! Adhesion on cells: the shares of cells and their energy, and contacts under a load on both branches against exact waves, a solver
! without transforms, and what theorems say.
module periodic_adhesion
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_periodic_adhesive_solver, only: periodic_adhesion_t, solve_adhesive_load
   use adfric_periodic_cohesion, only: cohesion_t, new_cohesion
   use adfric_periodic_elastic_kernel, only: elastic_kernel_t
   use adfric_periodic_solver, only: periodic_solver_t, periodic_solution_t, new_periodic_solver, contact_solved, &
      & contact_out_of_range
   use dense_adhesion, only: solve_dense_adhesion
   use reference_table, only: table_t, read_table
   use trial_surfaces, only: rough_surface
   use funit
   implicit none (type, external)

   real(dp), parameter :: pi = 3.14159265358979323846264338328_dp, tolerance = 1.0e-10_dp

contains

   !> A solver for a period of 1 along x.
   subroutine make_solver(solver, n_cells, is_quarter)
      type(periodic_solver_t), intent(out) :: solver
      integer, intent(in) :: n_cells(2)
      logical, intent(in) :: is_quarter
      type(error_t), allocatable :: error

      call new_periodic_solver(solver, elastic_kernel_t(), n_cells, [1.0_dp, 1.0_dp], is_quarter, error)
#line 29 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertFalse(allocated(error), &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 29) )
  if (anyExceptions()) return
#line 30 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
   end subroutine make_solver

   !> Solve under a load, with stress and range of the adhesion.
   subroutine solve(solver, shape, load, stress, range, is_adhered, solution)
      type(periodic_solver_t), intent(inout) :: solver
      real(dp), intent(in) :: shape(:, :), load, stress, range
      logical, intent(in) :: is_adhered
      type(periodic_solution_t), intent(out) :: solution
      type(error_t), allocatable :: error

      call solve_adhesive_load(solver, shape, load, periodic_adhesion_t(stress=stress, range=range, is_adhered=is_adhered), &
         & tolerance, solution, error)
#line 42 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertFalse(allocated(error), &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 42) )
  if (anyExceptions()) return
#line 43 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
   end subroutine solve

   !> 1 - cos 2 pi x on a line, less its least value, which is received.
   subroutine make_line(n, shape, lowest)
      integer, intent(in) :: n
      real(dp), allocatable, intent(out) :: shape(:, :)
      real(dp), intent(out) :: lowest
      integer :: i

      allocate (shape(n, 1))
      shape(:, 1) = [(1 - cos(2*pi*(i - 0.5_dp)/n), i=1, n)]
      lowest = minval(shape)
      shape(:, :) = shape - lowest
   end subroutine make_line

   !> 2 - cos 2 pi x - cos 2 pi y in a quarter of n x n cells, less its least value, which is received.
   subroutine make_bisine(n, shape, lowest)
      integer, intent(in) :: n
      real(dp), allocatable, intent(out) :: shape(:, :)
      real(dp), intent(out) :: lowest
      integer :: i, j

      allocate (shape(n/2, n/2))
      do j = 1, n/2
         shape(:, j) = [(2 - cos(2*pi*(i - 0.5_dp)/n) - cos(2*pi*(j - 0.5_dp)/n), i=1, n/2)]
      end do
      lowest = minval(shape)
      shape(:, :) = shape - lowest
   end subroutine make_bisine

   ! Of a plane the shares are lengths cut from triangles; all within, none within; and on a line as on the cells beside it.
   !@test
   subroutine test_shares()
      type(cohesion_t) :: law, line
      real(dp) :: gap(8, 5), low
      integer :: i

      call new_cohesion(law, 2.0_dp, 0.3_dp, .false.)
      gap = 0.3_dp
      call law%set_share(gap)
#line 83 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(1.0_dp, minval(law%share), tolerance=1.0e-15_dp, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 83) )
  if (anyExceptions()) return
#line 84 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
#line 84 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(-2*0.0_dp, law%energy_of(gap), tolerance=1.0e-16_dp, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 84) )
  if (anyExceptions()) return
#line 85 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
      gap = 0
#line 86 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(-2*0.3_dp, law%energy_of(gap), tolerance=1.0e-13_dp, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 86) )
  if (anyExceptions()) return
#line 87 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
      gap = nearest(0.3_dp, 1.0_dp)
      call law%set_share(gap)
#line 89 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(0.0_dp, maxval(law%share), tolerance=0.0_dp, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 89) )
  if (anyExceptions()) return
#line 90 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
#line 90 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(0.0_dp, law%energy_of(gap), tolerance=0.0_dp, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 90) )
  if (anyExceptions()) return
#line 91 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
      ! a ridge along y: 0.1 a cell on both sides of cell 4; 0.3 is reached in the middle of cells 1 and 7
      do i = 1, 8
         gap(i, :) = 0.1_dp*abs(i - 4)
      end do
      call law%set_share(gap)
#line 96 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(1.0_dp, law%share(4, 3), tolerance=1.0e-14_dp, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 96) )
  if (anyExceptions()) return
#line 97 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
#line 97 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(0.5_dp, law%share(1, 2), tolerance=1.0e-14_dp, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 97) )
  if (anyExceptions()) return
#line 98 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
#line 98 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(0.5_dp, law%share(7, 5), tolerance=1.0e-14_dp, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 98) )
  if (anyExceptions()) return
#line 99 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
#line 99 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(6.0_dp, sum(law%share(:, 1)), tolerance=1.0e-14_dp, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 99) )
  if (anyExceptions()) return
#line 100 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
      ! half a cell less
      low = 0.25_dp
      call new_cohesion(line, 2.0_dp, low, .false.)
      call line%set_share(gap(:, :1))
#line 104 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(5.0_dp, sum(line%share), tolerance=1.0e-14_dp, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 104) )
  if (anyExceptions()) return
#line 105 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
#line 105 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(0.125_dp, line%share(1, 1), tolerance=1.0e-14_dp, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 105) )
  if (anyExceptions()) return
#line 106 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
      call new_cohesion(law, 2.0_dp, low, .false.)
      call law%set_share(gap)
#line 108 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(line%share(:, 1), law%share(:, 4), tolerance=1.0e-14_dp, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 108) )
  if (anyExceptions()) return
#line 109 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
#line 109 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(line%energy_of(gap(:, :1)), law%energy_of(gap), tolerance=1.0e-15_dp, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 109) )
  if (anyExceptions()) return
#line 110 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
   end subroutine test_shares

   ! The shares are the derivative of the energy, and the slopes that of the shares; both are symmetric.
   !@test
   subroutine test_derivatives()
      real(dp), parameter :: step = 1.0e-5_dp
      type(cohesion_t) :: law
      real(dp), allocatable :: gap(:, :), other(:, :), lost(:, :), share(:, :), change(:, :)
      real(dp) :: product, found
      integer :: k

      do k = 1, 4
         gap = rough_surface(12, merge(1, 9, k == 3), k)
         gap = gap - minval(gap)
         change = 0.1_dp*maxval(gap)*rough_surface(12, merge(1, 9, k == 3), 11)
         call new_cohesion(law, 3.0_dp, 0.4_dp*maxval(gap), k == 4)
         call law%follow(gap)
#line 127 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertTrue(law%is_linear, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 127) )
  if (anyExceptions()) return
#line 128 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
#line 128 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertGreaterThan(law%n_triangles, 0, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 128) )
  if (anyExceptions()) return
#line 129 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
         found = (law%energy_of(gap + step*change) - law%energy_of(gap - step*change))/(2*step)
#line 130 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(3*sum(law%share*change)/size(gap), found, tolerance=1.0e-8_dp*3, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 130) )
  if (anyExceptions()) return
#line 131 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
         allocate (lost, mold=gap)
         lost = 0
         call law%subtract_slope(change, lost, product)
#line 134 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(-sum(lost*change), product, tolerance=1.0e-13_dp*abs(product), &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 134) )
  if (anyExceptions()) return
#line 135 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
         call law%set_share(gap + step*change)
         share = law%share
         call law%set_share(gap - step*change)
         other = 3*(share - law%share)/(2*step)
#line 139 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(other, lost, tolerance=2.0e-3_dp*maxval(abs(lost)), &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 139) )
  if (anyExceptions()) return
#line 140 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
         deallocate (lost)
      end do
   end subroutine test_derivatives

   ! A quarter between mirrors has the shares and the energy of the whole; a band has the changes of all cells.
   !@test
   subroutine test_mirror()
      integer, parameter :: n = 8
      type(cohesion_t) :: part, whole
      real(dp), allocatable :: gap(:, :), all(:, :), low(:, :), before(:, :), behind(:, :), share(:, :)

      gap = rough_surface(n, n, 3)
      gap = gap - minval(gap)
      allocate (all(2*n, 2*n))
      all(:n, :n) = gap
      all(n + 1:, :n) = gap(n:1:-1, :)
      all(:, n + 1:) = all(:, n:1:-1)
      call new_cohesion(part, 1.0_dp, 0.5_dp*maxval(gap), .true.)
      call new_cohesion(whole, 1.0_dp, 0.5_dp*maxval(gap), .false.)
      call part%set_share(gap)
      call whole%set_share(all)
#line 161 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(whole%share(:n, :n), part%share, tolerance=1.0e-14_dp, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 161) )
  if (anyExceptions()) return
#line 162 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
#line 162 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(whole%energy_of(all), part%energy_of(gap), tolerance=1.0e-14_dp, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 162) )
  if (anyExceptions()) return
#line 163 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
      low = 0.7_dp*all
      call whole%set_band(low, all)
      allocate (before, behind, mold=all)
      call whole%get_band_share(all, before)
      call whole%get_band_share(low, behind)
      share = whole%share
      call whole%set_share(low)
#line 170 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(whole%share - share, behind - before, tolerance=1.0e-14_dp, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 170) )
  if (anyExceptions()) return
#line 171 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
#line 171 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertTrue(all_between(behind - before), &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 171) )
  if (anyExceptions()) return
#line 172 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
   end subroutine test_mirror

   !> Shares that a smaller gap makes larger, by 1 at most.
   logical function all_between(change)
      real(dp), intent(in) :: change(:, :)

      all_between = all(change >= -1.0e-14_dp .and. change <= 1 + 1.0e-14_dp) .and. maxval(change) > 0
   end function all_between

   ! Lines of a few cells on both branches, at loads from pull-off to full contact, against the solver that only goes rounds.
   !@test
   subroutine test_dense()
      real(dp), parameter :: loads(*) = [-0.15_dp, -0.06_dp, -0.02_dp, -0.005_dp, 0.0_dp, 0.01_dp, 0.05_dp, 0.1_dp, 0.25_dp, &
         & 0.6_dp]
      type(periodic_solver_t) :: solver
      type(periodic_solution_t) :: solution
      real(dp), allocatable :: shape(:, :), gap(:), share(:)
      real(dp) :: stress, range
      logical :: has_contact, is_adhered
      integer :: n, i, k, branch, n_contacts, n_branches
      real(dp) :: means(2)

      n_contacts = 0
      n_branches = 0
      do n = 9, 24, 3
         do k = 1, 4
            shape = line_of(n, k)
            shape = 0.15_dp*shape/maxval(shape)
            call make_solver(solver, [n, 1], .false.)
            stress = 0.2_dp*k
            range = 0.01_dp*(1 + modulo(n/3, 4))
            allocate (gap(n), share(n))
            do i = 1, size(loads)
               means = -1
               do branch = 1, 2
                  is_adhered = branch == 1
                  if (.not. (is_adhered .or. loads(i) > 0)) cycle
                  call solve(solver, shape, loads(i), stress, range, is_adhered, solution)
                  call solve_dense_adhesion(shape(:, 1), stress, range, loads(i), is_adhered, gap, share, has_contact)
#line 211 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(merge(contact_solved, contact_out_of_range, has_contact), solution%status, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 211) )
  if (anyExceptions()) return
#line 212 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
                  if (.not. has_contact) cycle
#line 213 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(gap, solution%gap(:, 1), tolerance=1.0e-7_dp*maxval(shape), &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 213) )
  if (anyExceptions()) return
#line 214 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
#line 214 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(share, solution%share(:, 1), tolerance=1.0e-6_dp, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 214) )
  if (anyExceptions()) return
#line 215 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
                  n_contacts = n_contacts + 1
                  means(branch) = sum(gap)/n
               end do
               if (minval(means) > 0 .and. abs(means(2) - means(1)) > 1.0e-3_dp*maxval(shape)) n_branches = n_branches + 1
            end do
            deallocate (gap, share)
         end do
      end do
#line 223 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertGreaterThan(n_contacts, 200, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 223) )
  if (anyExceptions()) return
#line 224 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
#line 224 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertGreaterThan(n_branches, 5, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 224) )
  if (anyExceptions()) return
#line 225 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
   end subroutine test_dense

   !> A rough line.
   function line_of(n, seed) result(shape)
      integer, intent(in) :: n, seed
      real(dp), allocatable :: shape(:, :)

      shape = rough_surface(n, 1, seed)
      shape = shape - minval(shape)
   end function line_of

   ! The exact wave: penetration and place of the edges on both branches, with errors that fall with the square of the
   ! cells, and the widths of the zones. Loads next to a jump belong to the cells' side of it.
   !@test
   subroutine test_wave()
      type(table_t) :: table, jumps
      type(periodic_solver_t) :: solver
      type(periodic_solution_t) :: solution
      real(dp), allocatable :: shape(:, :)
      real(dp) :: lowest, zone, errors(2)
      integer :: k, n, step, n_compared(2)
      character(:), allocatable :: label

      call read_table(table, 'adh_dugdale_wave_1d_load')
      call read_table(jumps, 'adh_dugdale_wave_1d_events')
      errors = 0
      n_compared = 0
      do step = 1, 2
         n = 256*step
         call make_line(n, shape, lowest)
         call make_solver(solver, [n, 1], .false.)
         do k = 1, table%n_rows
            ! a dozen cells in the zone on the coarser grid: (pi/4) range/stress
            zone = table%number(k, 'range')/(4*table%number(k, 'stress'))
            if (zone*256 < 12) cycle
            label = table%label(k)
            if (is_near_jump(table, k, jumps)) cycle
            call solve(solver, shape, pi*table%number(k, 'mean_pressure'), pi*table%number(k, 'stress'), &
               & table%number(k, 'range'), table%text(k, 'branch') == 'adhered', solution)
            if (nint(table%number(k, 'status')) /= 0) then
#line 265 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(contact_out_of_range, solution%status, message=label, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 265) )
  if (anyExceptions()) return
#line 266 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
               cycle
            end if
#line 268 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(contact_solved, solution%status, message=label, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 268) )
  if (anyExceptions()) return
#line 269 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
            n_compared(step) = n_compared(step) + 1
            associate (found => solution%penetration + lowest, exact => table%number(k, 'penetration'))
#line 271 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(exact, found, tolerance=merge(1.0e-3_dp, 2.5e-4_dp, step == 1), message=label, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 271) )
  if (anyExceptions()) return
#line 272 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
               errors(step) = errors(step) + abs(found - exact)
            end associate
            associate (wide => 2*table%number(k, 'cohesive_half_width'))
#line 275 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(wide, sum(solution%share)/n, tolerance=2.0_dp/n, message=label, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 275) )
  if (anyExceptions()) return
#line 276 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
            end associate
         end do
      end do
#line 279 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertGreaterThan(n_compared(1), 60, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 279) )
  if (anyExceptions()) return
#line 280 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
#line 280 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertLessThan(errors(2), errors(1)/2.5_dp, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 280) )
  if (anyExceptions()) return
#line 281 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
   end subroutine test_wave

   !> Is a load within 0.002 p* of the end of saturation?
   logical function is_near_jump(table, row, jumps)
      type(table_t), intent(in) :: table, jumps
      integer, intent(in) :: row
      integer :: k

      is_near_jump = .false.
      do k = 1, jumps%n_rows
         if (jumps%text(k, 'event') /= 'saturation_ends') cycle
         if (abs(jumps%number(k, 'alpha') - table%number(row, 'alpha')) > 0) cycle
         if (abs(jumps%number(k, 'range') - table%number(row, 'range')) > 0) cycle
         is_near_jump = abs(jumps%number(k, 'mean_pressure') - table%number(row, 'mean_pressure')) < 2.0e-3_dp
         return
      end do
   end function is_near_jump

   ! The wave in two directions, within what the table is uncertain by.
   !@test
   subroutine test_bisine()
      integer, parameter :: n = 128
      type(table_t) :: table
      type(periodic_solver_t) :: solver
      type(periodic_solution_t) :: solution
      real(dp), allocatable :: shape(:, :)
      real(dp) :: lowest
      character(:), allocatable :: branch, label
      integer :: k, i

      call read_table(table, 'adh_bisine_dugdale')
      call make_bisine(n, shape, lowest)
      call make_solver(solver, [n/2, n/2], .true.)
      do k = 1, table%n_rows
         branch = table%text(k, 'branch')
         label = table%label(k)
         do i = 1, 2
            if (branch == merge('approach', 'adhered ', i == 1)) cycle
            call solve(solver, shape, 2*pi*table%number(k, 'mean_pressure'), 2*pi*table%number(k, 'stress'), &
               & table%number(k, 'range'), i == 1, solution)
#line 321 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(contact_solved, solution%status, message=label, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 321) )
  if (anyExceptions()) return
#line 322 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
            associate (found => solution%area%corrected, doubt => table%number(k, 'area_uncertainty') + solution%area%error)
#line 323 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(table%number(k, 'contact_area'), found, tolerance=doubt, message=label, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 323) )
  if (anyExceptions()) return
#line 324 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
            end associate
            associate (found => solution%penetration + lowest, doubt => table%number(k, 'penetration_uncertainty'))
#line 326 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(table%number(k, 'penetration'), found, tolerance=2*doubt + 1.0e-3_dp, message=label, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 326) )
  if (anyExceptions()) return
#line 327 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
            end associate
         end do
      end do
   end subroutine test_bisine

   ! Saturated contact is that without adhesion under more load; a range above all gaps breaks at the stress; no stress is none.
   !@test
   subroutine test_saturated()
      integer, parameter :: n = 32
      real(dp), parameter :: stress = 0.5_dp
      type(periodic_solver_t) :: solver
      type(periodic_solution_t) :: solution, elastic
      type(error_t), allocatable :: error
      real(dp), allocatable :: shape(:, :)
      real(dp) :: load

      shape = 0.2_dp*rough_surface(n, n, 5)
      shape = shape - minval(shape)
      call make_solver(solver, [n, n], .false.)
      load = -0.4_dp
      call solve(solver, shape, load, stress, 1.1_dp*maxval(shape), .true., solution)
      call solver%solve_load(shape, load + stress, tolerance, elastic, error)
#line 349 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(contact_solved, solution%status, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 349) )
  if (anyExceptions()) return
#line 350 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
#line 350 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(elastic%gap, solution%gap, tolerance=1.0e-9_dp*maxval(shape), &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 350) )
  if (anyExceptions()) return
#line 351 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
#line 351 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(elastic%pressure - stress, solution%pressure, tolerance=1.0e-9_dp*maxval(elastic%pressure), &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 351) )
  if (anyExceptions()) return
#line 352 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
#line 352 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(load, sum(solution%pressure)/size(shape), tolerance=1.0e-12_dp, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 352) )
  if (anyExceptions()) return
#line 353 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
      call solve(solver, shape, -1.001_dp*stress, stress, 1.1_dp*maxval(shape), .true., solution)
#line 354 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(contact_out_of_range, solution%status, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 354) )
  if (anyExceptions()) return
#line 355 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
      call solve(solver, shape, -0.999_dp*stress, stress, 1.1_dp*maxval(shape), .true., solution)
#line 356 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(contact_solved, solution%status, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 356) )
  if (anyExceptions()) return
#line 357 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
      call solve(solver, shape, 0.3_dp, 1.0e-9_dp, 0.1_dp*maxval(shape), .true., solution)
      call solver%solve_load(shape, 0.3_dp, tolerance, elastic, error)
#line 359 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(elastic%gap, solution%gap, tolerance=1.0e-7_dp*maxval(shape), &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 359) )
  if (anyExceptions()) return
#line 360 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
   end subroutine test_saturated

   ! Least adhered below most adhered in every cell, both more adhered under more load, and what a turn leaves between them; the
   ! pressure keeps the law in every cell and carries the load.
   !@test
   subroutine test_branches()
      integer, parameter :: n = 32
      real(dp), parameter :: loads(*) = [0.002_dp, 0.01_dp, 0.03_dp, 0.08_dp, 0.2_dp], slack = 1.0e-6_dp, turn = 0.06_dp
      type(periodic_solver_t) :: solver
      type(periodic_solution_t) :: low, high, low_before, high_before, turned
      type(periodic_adhesion_t) :: adhesion
      type(error_t), allocatable :: error
      real(dp), allocatable :: shape(:, :)
      real(dp) :: stress, range
      integer :: i, seed, n_different

      n_different = 0
      do seed = 1, 6
         shape = 0.1_dp*rough_surface(n, n, seed)
         shape = shape - minval(shape)
         stress = 0.1_dp*seed
         range = 0.03_dp*maxval(shape)
         call make_solver(solver, [n, n], .false.)
         do i = 1, size(loads)
            call solve(solver, shape, loads(i), stress, range, .false., low)
            call solve(solver, shape, loads(i), stress, range, .true., high)
#line 386 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual([contact_solved, contact_solved], [low%status, high%status], &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 386) )
  if (anyExceptions()) return
#line 387 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
#line 387 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertTrue(all(low%share <= high%share + slack), &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 387) )
  if (anyExceptions()) return
#line 388 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
#line 388 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertTrue(all(low%gap >= high%gap - slack*maxval(shape)), &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 388) )
  if (anyExceptions()) return
#line 389 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
            if (maxval(high%share - low%share) > 0.1_dp) n_different = n_different + 1
            call check_law(low, shape, loads(i), stress, range)
            call check_law(high, shape, loads(i), stress, range)
            if (i > 1) then
#line 393 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertTrue(all(low_before%share <= low%share + slack), &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 393) )
  if (anyExceptions()) return
#line 394 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
#line 394 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertTrue(all(high_before%share <= high%share + slack), &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 394) )
  if (anyExceptions()) return
#line 395 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
            end if
            adhesion = periodic_adhesion_t(stress, range, .true., .true., turn)
            call solve_adhesive_load(solver, shape, loads(i), adhesion, tolerance, turned, error)
#line 398 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(contact_solved, turned%status, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 398) )
  if (anyExceptions()) return
#line 399 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
#line 399 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertTrue(all(low%share <= turned%share + slack .and. turned%share <= high%share + slack), &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 399) )
  if (anyExceptions()) return
#line 400 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
            if (loads(i) >= turn) then
#line 401 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(low%gap, turned%gap, tolerance=1.0e-7_dp*maxval(shape), &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 401) )
  if (anyExceptions()) return
#line 402 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
            end if
            low_before = low
            high_before = high
         end do
      end do
#line 407 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertGreaterThan(n_different, 2, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 407) )
  if (anyExceptions()) return
#line 408 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
   end subroutine test_branches

   !> Contact presses with more than -stress, apart there is the tension of the share, the shares are those of the gap, and the
   !> load is carried.
   subroutine check_law(solution, shape, load, stress, range)
      type(periodic_solution_t), intent(in) :: solution
      real(dp), intent(in) :: shape(:, :), load, stress, range
      type(cohesion_t) :: law
      real(dp) :: scale

      scale = tolerance*(maxval(solution%pressure) + stress)
#line 419 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertLessThanOrEqual(solution%residual, tolerance, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 419) )
  if (anyExceptions()) return
#line 420 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
#line 420 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertTrue(all(solution%gap >= 0 .and. solution%pressure >= -stress*solution%share - scale), &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 420) )
  if (anyExceptions()) return
#line 421 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
      associate (apart => merge(solution%pressure + stress*solution%share, 0.0_dp, solution%gap > tolerance*maxval(shape)))
#line 422 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(0.0_dp, maxval(abs(apart)), tolerance=2*scale, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 422) )
  if (anyExceptions()) return
#line 423 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
      end associate
      call new_cohesion(law, stress, range, .false.)
      call law%set_share(solution%gap)
#line 426 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(law%share, solution%share, tolerance=1.0e-6_dp, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 426) )
  if (anyExceptions()) return
#line 427 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
#line 427 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(load, sum(solution%pressure)/size(shape), tolerance=1.0e-11_dp, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 427) )
  if (anyExceptions()) return
#line 428 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
   end subroutine check_law

   ! Along a branch the energy changes by load times penetration.
   !@test
   subroutine test_energy()
      integer, parameter :: n = 512, n_steps = 80
      type(periodic_solver_t) :: solver
      type(periodic_solution_t) :: solution
      real(dp), allocatable :: shape(:, :)
      real(dp) :: lowest, loads(0:n_steps), penetrations(0:n_steps), energies(0:n_steps), work
      integer :: k

      call make_line(n, shape, lowest)
      call make_solver(solver, [n, 1], .false.)
      do k = 0, n_steps
         loads(k) = pi*(-0.05_dp + 0.3_dp*k/n_steps)
         call solve(solver, shape, loads(k), pi*0.3_dp, 0.3_dp, .true., solution)
#line 445 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertEqual(contact_solved, solution%status, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 445) )
  if (anyExceptions()) return
#line 446 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
         penetrations(k) = solution%penetration
         energies(k) = solution%elastic_energy + solution%adhesion_energy
      end do
      work = sum((loads(1:) + loads(:n_steps - 1))/2*(penetrations(1:) - penetrations(:n_steps - 1)))
#line 450 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertGreaterThan(work, 0.1_dp, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 450) )
  if (anyExceptions()) return
#line 451 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
#line 451 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertRelativelyEqual(work, energies(n_steps) - energies(0), tolerance=1.5e-4_dp, &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 451) )
  if (anyExceptions()) return
#line 452 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
   end subroutine test_energy

   ! A solver that has solved other loads gives the same digits.
   !@test
   subroutine test_order()
      integer, parameter :: n = 32
      type(periodic_solver_t) :: solver, fresh
      type(periodic_solution_t) :: solution, again
      real(dp), allocatable :: shape(:, :)

      shape = 0.1_dp*rough_surface(n, n, 4)
      shape = shape - minval(shape)
      call make_solver(fresh, [n, n], .false.)
      call solve(fresh, shape, 0.03_dp, 0.2_dp, 0.02_dp, .true., solution)
      call make_solver(solver, [n, n], .false.)
      call solve(solver, shape, 0.5_dp, 0.1_dp, 0.05_dp, .false., again)
      call solve(solver, shape, -3.0_dp, 0.2_dp, 0.02_dp, .true., again)
      call solve(solver, shape, 0.03_dp, 0.2_dp, 0.02_dp, .true., again)
#line 470 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertTrue(all(.not. abs(solution%gap - again%gap) > 0), &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 470) )
  if (anyExceptions()) return
#line 471 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
#line 471 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
  call assertTrue(all(.not. abs(solution%pressure - again%pressure) > 0), &
 & location=SourceLocation( &
 & 'periodic_adhesion.pf', &
 & 471) )
  if (anyExceptions()) return
#line 472 "/work/wt/penetration/tests/periodic/periodic_adhesion.pf"
   end subroutine test_order

end module periodic_adhesion

module Wrapperiodic_adhesion
   use FUnit
   use periodic_adhesion
   implicit none
   private

contains


end module Wrapperiodic_adhesion

function periodic_adhesion_suite() result(suite)
   use FUnit
   use periodic_adhesion
   use Wrapperiodic_adhesion
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('periodic_adhesion_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_shares', &
      test_shares))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_derivatives', &
      test_derivatives))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_mirror', &
      test_mirror))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_dense', &
      test_dense))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_wave', &
      test_wave))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_bisine', &
      test_bisine))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_saturated', &
      test_saturated))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_branches', &
      test_branches))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_energy', &
      test_energy))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_order', &
      test_order))
   call suite%addTest(t)


end function periodic_adhesion_suite

