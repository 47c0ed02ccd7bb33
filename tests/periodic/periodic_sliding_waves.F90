! The engine under a sliding wave: exact contacts and layers of the tables on their own cells, order of the error, ends of the
! velocity, the ways a body can go, and the energy.
module periodic_sliding_waves
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_material_prony, only: prony_t, new_prony
   use adfric_periodic_elastic_kernel, only: elastic_kernel_t
   use adfric_periodic_kernel, only: kernel_t
   use adfric_periodic_layer_kernel, only: layer_kernel_t
   use adfric_periodic_sliding_kernel, only: sliding_kernel_t, new_sliding_kernel
   use adfric_periodic_solver, only: periodic_solver_t, periodic_solution_t, new_periodic_solver, contact_solved
   use reference_table, only: table_t, read_table
   use trial_surfaces, only: rough_surface
   use funit
   implicit none (type, external)

   real(dp), parameter :: two_pi = 6.283185307179586476925286766559_dp, tolerance = 1.0e-10_dp
   !> Of maps and their means, that two solutions of this tolerance share.
   real(dp), parameter :: equal_maps = 1.0e-8_dp

contains

   !> A solver for a solid of relaxed modulus 1, periods in any unit.
   subroutine make_solver(solver, solid, moduli, times, velocity, steps, n_cells, period)
      type(periodic_solver_t), intent(out) :: solver
      class(kernel_t), intent(in) :: solid
      real(dp), intent(in) :: moduli(:), times(:), velocity, period(2)
      integer, intent(in) :: steps(2), n_cells(2)
      type(sliding_kernel_t) :: kernel
      type(prony_t) :: prony
      type(error_t), allocatable :: error

      call new_prony(prony, 1.0_dp, moduli, times)
      call new_sliding_kernel(kernel, solid, prony, velocity, steps)
      call new_periodic_solver(solver, kernel, n_cells, period, .false., error)
#line 36 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
  call assertFalse(allocated(error), &
 & location=SourceLocation( &
 & 'periodic_sliding_waves.pf', &
 & 36) )
  if (anyExceptions()) return
#line 37 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
   end subroutine make_solver

   !> 1 - cos x of n cells a period of 2 pi, less its least value; and that value.
   subroutine make_wave(n, shape, lowest)
      integer, intent(in) :: n
      real(dp), allocatable, intent(out) :: shape(:, :)
      real(dp), intent(out) :: lowest
      integer :: i

      allocate (shape(n, 1))
      shape(:, 1) = [(1 - cos(two_pi*(i - 0.5_dp)/n), i=1, n)]
      lowest = minval(shape)
      shape(:, :) = shape - lowest
   end subroutine make_wave

   !> Solved, and a contact: no tension, no overlap, nothing pressed where the surfaces are apart, the load carried.
   subroutine check_contact(solution, shape)
      type(periodic_solution_t), intent(in) :: solution
      real(dp), intent(in) :: shape(:, :)

#line 57 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
  call assertEqual(contact_solved, solution%status, &
 & location=SourceLocation( &
 & 'periodic_sliding_waves.pf', &
 & 57) )
  if (anyExceptions()) return
#line 58 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
#line 58 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
  call assertLessThanOrEqual(solution%residual, tolerance, &
 & location=SourceLocation( &
 & 'periodic_sliding_waves.pf', &
 & 58) )
  if (anyExceptions()) return
#line 59 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
#line 59 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
  call assertTrue(all(solution%pressure >= 0 .and. solution%gap >= 0), &
 & location=SourceLocation( &
 & 'periodic_sliding_waves.pf', &
 & 59) )
  if (anyExceptions()) return
#line 60 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
      associate (scales => maxval(solution%pressure)*maxval(shape))
#line 61 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
  call assertLessThanOrEqual(maxval(solution%pressure*solution%gap), tolerance*scales, &
 & location=SourceLocation( &
 & 'periodic_sliding_waves.pf', &
 & 61) )
  if (anyExceptions()) return
#line 62 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
      end associate
#line 63 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
  call assertRelativelyEqual(solution%mean_pressure, sum(solution%pressure)/size(shape), tolerance=1.0e-12_dp, &
 & location=SourceLocation( &
 & 'periodic_sliding_waves.pf', &
 & 63) )
  if (anyExceptions()) return
#line 64 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
   end subroutine check_contact

   !> The median of some numbers.
   real(dp) function median_of(numbers) result(median)
      real(dp), intent(in) :: numbers(:)
      integer :: i

      do i = 1, size(numbers)
         median = numbers(i)
         if (count(numbers < median) <= size(numbers)/2 .and. count(numbers > median) <= size(numbers)/2) exit
      end do
   end function median_of

   !> Solve all partial contacts of the exact table under load and at the penetration of the table, on n cells.
   subroutine solve_table(n, errors)
      integer, intent(in) :: n
      !> Relative errors of the friction from the pressure; shape `(n_contacts)`.
      real(dp), allocatable, intent(out) :: errors(:)
      type(table_t) :: table
      type(periodic_solver_t) :: solver
      type(periodic_solution_t) :: solution, back
      type(error_t), allocatable :: error
      real(dp), allocatable :: shape(:, :)
      real(dp) :: lowest, square, load, friction, penetration, lost, cells
      integer :: k

      call read_table(table, 'visco_wave_sls')
      call make_wave(n, shape, lowest)
      square = (two_pi/n)**2
      allocate (errors(0))
      ! Edges are found within a part of a cell, where pressure and gap begin from 0: what that does is of the second order,
      ! over the width of the contact. The factors are what was measured, on 512 to 2048 cells, and a little more.
      do k = 1, table%n_rows
         if (table%text(k, 'regime') /= 'partial') cycle
         call make_solver(solver, elastic_kernel_t(), [table%number(k, 'r') - 1], [1.0_dp], table%number(k, 'a'), [1, 0], &
            & [n, 1], [two_pi, two_pi])
         ! p0* is half the relaxed modulus
         load = table%number(k, 'p_over_p0star')/2
         friction = table%number(k, 'friction_over_E0k2D2')
         penetration = table%number(k, 'penetration_over_D')
         call solver%solve_load(shape, load, tolerance, solution, error)
         call check_contact(solution, shape)
         cells = square/(two_pi*table%number(k, 'area_fraction'))
#line 107 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
  call assertEqual(friction, solution%friction%direct(1), tolerance=12*cells*load, message=table%label(k), &
 & location=SourceLocation( &
 & 'periodic_sliding_waves.pf', &
 & 107) )
  if (anyExceptions()) return
#line 108 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
#line 108 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
  call assertEqual(penetration, solution%penetration + lowest, tolerance=3*square, message=table%label(k), &
 & location=SourceLocation( &
 & 'periodic_sliding_waves.pf', &
 & 108) )
  if (anyExceptions()) return
#line 109 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
         errors = [errors, abs(solution%friction%direct(1)/friction - 1)]
         ! power: what the pressure does and what is lost
         lost = solution%friction%loss(1)
#line 112 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
  call assertGreaterThan(lost, 0.0_dp, &
 & location=SourceLocation( &
 & 'periodic_sliding_waves.pf', &
 & 112) )
  if (anyExceptions()) return
#line 113 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
#line 113 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
  call assertEqual(lost, solution%friction%direct(1), tolerance=8*cells*load, message=table%label(k), &
 & location=SourceLocation( &
 & 'periodic_sliding_waves.pf', &
 & 113) )
  if (anyExceptions()) return
#line 114 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
         call solver%solve_penetration(shape, penetration - lowest, tolerance, back, error)
         call check_contact(back, shape)
#line 116 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
  call assertEqual(penetration - lowest, back%penetration, tolerance=1.0e-9_dp, &
 & location=SourceLocation( &
 & 'periodic_sliding_waves.pf', &
 & 116) )
  if (anyExceptions()) return
#line 117 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
#line 117 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
  call assertRelativelyEqual(load, back%mean_pressure, tolerance=25*cells, message=table%label(k), &
 & location=SourceLocation( &
 & 'periodic_sliding_waves.pf', &
 & 117) )
  if (anyExceptions()) return
#line 118 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
         call solver%solve_penetration(shape, solution%penetration, tolerance, back, error)
#line 119 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
  call assertRelativelyEqual(load, back%mean_pressure, tolerance=equal_maps, message=table%label(k), &
 & location=SourceLocation( &
 & 'periodic_sliding_waves.pf', &
 & 119) )
  if (anyExceptions()) return
#line 120 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
         associate (largest => maxval(solution%pressure))
#line 121 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
  call assertEqual(solution%pressure, back%pressure, tolerance=1.0e-7_dp*largest, message=table%label(k), &
 & location=SourceLocation( &
 & 'periodic_sliding_waves.pf', &
 & 121) )
  if (anyExceptions()) return
#line 122 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
         end associate
      end do
   end subroutine solve_table

   ! Half the cells, a quarter of the error: in the middle of the contacts, since places of edges in their cells scatter.
   !@test
   subroutine test_table()
      real(dp), allocatable :: coarse(:), fine(:)
      real(dp) :: ratio

      call solve_table(512, coarse)
      call solve_table(1024, fine)
#line 134 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
  call assertEqual(118, size(fine), &
 & location=SourceLocation( &
 & 'periodic_sliding_waves.pf', &
 & 134) )
  if (anyExceptions()) return
#line 135 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
#line 135 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
  call assertLessThan(median_of(fine), 3.0e-4_dp, &
 & location=SourceLocation( &
 & 'periodic_sliding_waves.pf', &
 & 135) )
  if (anyExceptions()) return
#line 136 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
      ratio = median_of(coarse)/median_of(fine)
#line 137 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
  call assertGreaterThan(ratio, 3.0_dp, &
 & location=SourceLocation( &
 & 'periodic_sliding_waves.pf', &
 & 137) )
  if (anyExceptions()) return
#line 138 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
#line 138 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
  call assertLessThan(ratio, 6.0_dp, &
 & location=SourceLocation( &
 & 'periodic_sliding_waves.pf', &
 & 138) )
  if (anyExceptions()) return
#line 139 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
   end subroutine test_table

   ! Layers on the cells of the table, which has the wave's own modulus and not that of chains of straight lines: both differ from
   ! the limit by the second order of the cells, and so from each other. The table has 8 digits.
   !@test
   subroutine test_layers()
      real(dp), parameter :: height = 2, digits = 2.0e-8_dp
      type(table_t) :: table
      type(periodic_solver_t) :: solver
      type(periodic_solution_t) :: solution, back
      type(layer_kernel_t) :: layer
      type(error_t), allocatable :: error
      real(dp), allocatable :: shape(:, :)
      real(dp) :: lowest, square, scale, penetration
      integer :: k, n

      call read_table(table, 'visco_layer_to_gm')
#line 156 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
  call assertEqual(30, table%n_rows, &
 & location=SourceLocation( &
 & 'periodic_sliding_waves.pf', &
 & 156) )
  if (anyExceptions()) return
#line 157 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
      do k = 1, table%n_rows
         n = nint(table%number(k, 'cells'))
         call make_wave(n, shape, lowest)
         square = (two_pi/n)**2
         layer = layer_kernel_t(table%number(k, 'kH'), table%text(k, 'base') == 'bonded', table%number(k, 'nu'))
         scale = height/(layer%mean_compliance()*two_pi)
         call make_solver(solver, layer, [9.0_dp], [1.0_dp], table%number(k, 'u'), [1, 0], [n, 1], [two_pi, two_pi])
         call solver%solve_load(shape, table%number(k, 'P_K_over_h')*scale, tolerance, solution, error)
         call check_contact(solution, shape)
         associate (found => solution%friction%direct(1)/(scale*height), lost => solution%friction%loss(1)/(scale*height))
#line 167 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
  call assertRelativelyEqual(table%number(k, 'T_layer_direct'), found, tolerance=square + digits, message=table%label(k), &
 & location=SourceLocation( &
 & 'periodic_sliding_waves.pf', &
 & 167) )
  if (anyExceptions()) return
#line 168 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
#line 168 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
  call assertRelativelyEqual(table%number(k, 'T_layer_loss'), lost, tolerance=2*square + digits, message=table%label(k), &
 & location=SourceLocation( &
 & 'periodic_sliding_waves.pf', &
 & 168) )
  if (anyExceptions()) return
#line 169 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
         end associate
         penetration = table%number(k, 'D_over_h_strip')*(1 + table%number(k, 'D_rel_diff'))*height
         associate (found => solution%penetration + lowest)
#line 172 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
  call assertRelativelyEqual(penetration, found, tolerance=square + digits, message=table%label(k), &
 & location=SourceLocation( &
 & 'periodic_sliding_waves.pf', &
 & 172) )
  if (anyExceptions()) return
#line 173 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
         end associate
         call solver%solve_penetration(shape, solution%penetration, tolerance, back, error)
         call check_contact(back, shape)
#line 176 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
  call assertRelativelyEqual(solution%mean_pressure, back%mean_pressure, tolerance=equal_maps, message=table%label(k), &
 & location=SourceLocation( &
 & 'periodic_sliding_waves.pf', &
 & 176) )
  if (anyExceptions()) return
#line 177 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
         associate (largest => maxval(solution%pressure))
#line 178 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
  call assertEqual(solution%pressure, back%pressure, tolerance=equal_maps*largest, message=table%label(k), &
 & location=SourceLocation( &
 & 'periodic_sliding_waves.pf', &
 & 178) )
  if (anyExceptions()) return
#line 179 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
         end associate
      end do
   end subroutine test_layers

   ! Very slow and very fast the solid is elastic, with the relaxed and with the instantaneous modulus, as a layer too. On the way
   ! there the loss is proportional to the velocity, and to 1 over it.
   !@test
   subroutine test_ends()
      call check_ends(elastic_kernel_t(), 1.0e-10_dp, 1)
      call check_ends(elastic_kernel_t(), 1.0e10_dp, 9)
      call check_ends(layer_kernel_t(0.02_dp, .true., 0.45_dp), 1.0e-10_dp, 1)
      call check_ends(layer_kernel_t(0.02_dp, .true., 0.45_dp), 1.0e10_dp, 9)
   end subroutine test_ends

   !> A rough line on a solid of two arms, at a velocity at which its modulus is a given one.
   subroutine check_ends(solid, velocity, modulus)
      class(kernel_t), intent(in) :: solid
      real(dp), intent(in) :: velocity
      integer, intent(in) :: modulus
      integer, parameter :: n = 64
      real(dp), parameter :: moduli(*) = [3.0_dp, 5.0_dp], times(*) = [1.0_dp, 0.1_dp], period(2) = [1.0_dp, 1.0_dp], load = 0.2_dp
      type(periodic_solver_t) :: solver
      type(periodic_solution_t) :: solution, twice, elastic
      type(error_t), allocatable :: error
      real(dp) :: shape(n, 1)

      shape(:, :1) = rough_line(n)
      call new_periodic_solver(solver, solid, [n, 1], period, .false., error)
#line 207 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
  call assertFalse(allocated(error), &
 & location=SourceLocation( &
 & 'periodic_sliding_waves.pf', &
 & 207) )
  if (anyExceptions()) return
#line 208 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
      call solver%solve_load(shape, load/modulus, tolerance, elastic, error)
      call check_contact(elastic, shape)
#line 210 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
  call assertGreaterThan(elastic%area%cells, 0.03_dp, &
 & location=SourceLocation( &
 & 'periodic_sliding_waves.pf', &
 & 210) )
  if (anyExceptions()) return
#line 211 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
#line 211 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
  call assertLessThan(elastic%area%cells, 0.9_dp, &
 & location=SourceLocation( &
 & 'periodic_sliding_waves.pf', &
 & 211) )
  if (anyExceptions()) return
#line 212 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
      call make_solver(solver, solid, moduli, times, velocity, [1, 0], [n, 1], period)
      call solver%solve_load(shape, load, tolerance, solution, error)
      call check_contact(solution, shape)
      associate (largest => maxval(solution%pressure))
#line 216 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
  call assertEqual(modulus*elastic%pressure, solution%pressure, tolerance=equal_maps*largest, &
 & location=SourceLocation( &
 & 'periodic_sliding_waves.pf', &
 & 216) )
  if (anyExceptions()) return
#line 217 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
      end associate
#line 218 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
  call assertEqual(elastic%gap, solution%gap, tolerance=equal_maps*maxval(shape), &
 & location=SourceLocation( &
 & 'periodic_sliding_waves.pf', &
 & 218) )
  if (anyExceptions()) return
#line 219 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
      call make_solver(solver, solid, moduli, times, 2*velocity, [1, 0], [n, 1], period)
      call solver%solve_load(shape, load, tolerance, twice, error)
      associate (ratio => twice%friction%loss(1)/solution%friction%loss(1))
#line 222 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
  call assertRelativelyEqual(merge(2.0_dp, 0.5_dp, modulus == 1), ratio, tolerance=1.0e-6_dp, &
 & location=SourceLocation( &
 & 'periodic_sliding_waves.pf', &
 & 222) )
  if (anyExceptions()) return
#line 223 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
      end associate
   end subroutine check_ends

   !> A line with waves of several lengths.
   function rough_line(n) result(shape)
      integer, intent(in) :: n
      real(dp) :: shape(n, 1)
      integer :: i, k

      shape = 0
      do k = 1, 5
         shape(:, 1) = shape(:, 1) + [(0.2_dp*cos(two_pi*k*(i - 0.5_dp)/n + k**2)/k**2, i=1, n)]
      end do
      shape = shape - minval(shape)
   end function rough_line

   !> The same contact seen in a mirror or turned: its maps and both forms of its friction.
   subroutine check_seen(solution, other, pressure, gap, direct, loss)
      type(periodic_solution_t), intent(in) :: solution, other
      !> Maps of `other` as they are seen there, and friction of `solution` as it would be.
      real(dp), intent(in) :: pressure(:, :), gap(:, :), direct(2), loss(2)

#line 245 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
  call assertEqual(contact_solved, other%status, &
 & location=SourceLocation( &
 & 'periodic_sliding_waves.pf', &
 & 245) )
  if (anyExceptions()) return
#line 246 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
#line 246 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
  call assertEqual(solution%pressure, pressure, tolerance=equal_maps*maxval(pressure), &
 & location=SourceLocation( &
 & 'periodic_sliding_waves.pf', &
 & 246) )
  if (anyExceptions()) return
#line 247 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
#line 247 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
  call assertEqual(solution%gap, gap, tolerance=equal_maps*maxval(gap), &
 & location=SourceLocation( &
 & 'periodic_sliding_waves.pf', &
 & 247) )
  if (anyExceptions()) return
#line 248 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
#line 248 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
  call assertEqual(direct, other%friction%direct, tolerance=equal_maps*maxval(pressure), &
 & location=SourceLocation( &
 & 'periodic_sliding_waves.pf', &
 & 248) )
  if (anyExceptions()) return
#line 249 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
#line 249 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
  call assertEqual(loss, other%friction%loss, tolerance=equal_maps*maxval(pressure), &
 & location=SourceLocation( &
 & 'periodic_sliding_waves.pf', &
 & 249) )
  if (anyExceptions()) return
#line 250 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
   end subroutine check_seen

   !> A rough surface, and what is seen of it in mirrors.
   subroutine check_mirrors(solid, steps, n, period)
      class(kernel_t), intent(in) :: solid
      integer, intent(in) :: steps(2), n(2)
      real(dp), intent(in) :: period(2)
      real(dp), parameter :: moduli(*) = [3.0_dp, 20.0_dp], times(*) = [1.0_dp, 0.1_dp], velocity = 0.4_dp, load = 0.3_dp
      type(periodic_solver_t) :: solver
      type(periodic_solution_t) :: one, other
      type(error_t), allocatable :: error
      real(dp) :: shape(n(1), n(2))

      shape = rough_surface(n(1), n(2), 7)
      call make_solver(solver, solid, moduli, times, velocity, steps, n, period)
      call solver%solve_load(shape, load, tolerance, one, error)
      call check_contact(one, shape)
      associate (direct => one%friction%direct, loss => one%friction%loss)
         call make_solver(solver, solid, moduli, times, velocity, steps*[-1, 1], n, period)
         call solver%solve_load(shape(n(1):1:-1, :), load, tolerance, other, error)
         call check_seen(one, other, other%pressure(n(1):1:-1, :), other%gap(n(1):1:-1, :), direct*[-1, 1], loss*[-1, 1])
         call make_solver(solver, solid, moduli, times, velocity, steps*[1, -1], n, period)
         call solver%solve_load(shape(:, n(2):1:-1), load, tolerance, other, error)
         call check_seen(one, other, other%pressure(:, n(2):1:-1), other%gap(:, n(2):1:-1), direct*[1, -1], loss*[1, -1])
         call make_solver(solver, solid, moduli, times, velocity, steps([2, 1]), n([2, 1]), period([2, 1]))
         call solver%solve_load(transpose(shape), load, tolerance, other, error)
         call check_seen(one, other, transpose(other%pressure), transpose(other%gap), direct([2, 1]), loss([2, 1]))
      end associate
      ! what slides the other way over the same surface is another contact
      call make_solver(solver, solid, moduli, times, velocity, -steps, n, period)
      call solver%solve_load(shape, load, tolerance, other, error)
#line 281 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
  call assertGreaterThan(maxval(abs(one%pressure - other%pressure)), 0.01_dp*maxval(one%pressure), &
 & location=SourceLocation( &
 & 'periodic_sliding_waves.pf', &
 & 281) )
  if (anyExceptions()) return
#line 282 "/work/wt/penetration/tests/periodic/periodic_sliding_waves.pf"
   end subroutine check_mirrors

   !@test
   subroutine test_mirrors()
      call check_mirrors(elastic_kernel_t(), [1, 0], [20, 12], [1.0_dp, 0.7_dp])
      call check_mirrors(elastic_kernel_t(), [1, 0], [21, 13], [1.0_dp, 0.7_dp])
      call check_mirrors(layer_kernel_t(0.1_dp, .true., 0.4_dp), [0, -1], [20, 13], [1.0_dp, 0.7_dp])
      call check_mirrors(elastic_kernel_t(), [1, 1], [20, 12], [1.0_dp, 0.6_dp])
      call check_mirrors(layer_kernel_t(0.1_dp), [-1, 1], [15, 16], [1.5_dp, 1.6_dp])
   end subroutine test_mirrors

end module periodic_sliding_waves

module Wrapperiodic_sliding_waves
   use FUnit
   use periodic_sliding_waves
   implicit none
   private

contains


end module Wrapperiodic_sliding_waves

function periodic_sliding_waves_suite() result(suite)
   use FUnit
   use periodic_sliding_waves
   use Wrapperiodic_sliding_waves
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('periodic_sliding_waves_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_table', &
      test_table))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_layers', &
      test_layers))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_ends', &
      test_ends))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_mirrors', &
      test_mirrors))
   call suite%addTest(t)


end function periodic_sliding_waves_suite

