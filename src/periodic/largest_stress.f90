! SPDX-License-Identifier: GPL-3.0-or-later
!> The largest von Mises stress and the largest shear stress below a map of the pressure, over all depths, in the middles of the cells.
!>
!> Samples in s = ln z are enough, for the stress varies there no faster than the pressure allows. A stress is the sum over all points of
!> the surface of the pressure times the stress G of a point load (Boussinesq). G is homogeneous: of degree -2 in all lengths together.
!> So the integral of |d^2 G/ds^2| over the surface is one number for all depths. A constant pressure makes a stress that does not vary
!> with z, so it may be subtracted. With N one of both measures, which are seminorms of the stress, and D = (max p - min p)/2,
!>
!>     integral of N(d^2 G/ds^2) <= C:  C = 5.317 of von Mises at nu = 1/2, 7.527 at nu = -1; 2.929 and 4.236 of the shear stress,
!>
!> and between, since N is convex, at most what is on the straight line. A shear stress q has its own C, from the stress of a tangential
!> point load (Cerruti), and both bounds add up to B = C_p D_p + C_q D_q. Where N is largest, at s0, let l be the linear form with
!> l(stress) = N there and l <= N everywhere. Then l has its largest value there, too, without a slope, and
!>
!>     N(s) >= N(s0) - B (s - s0)^2/2.
!>
!> So between two samples at the distance h the largest value is at most the larger one of both plus B h^2/8. Intervals whose bound is
!> not above the largest sample are done; the others are halved. The samples begin at the surface and at half a cell, and end at two
!> periods, beyond which only the mean remains.
module adfric_periodic_largest_stress
   use adfric_base_kinds, only: dp
   use adfric_periodic_stress_field, only: stress_field_t, n_stresses, xx, yy, zz, xy, xz, yz
   implicit none (type, external)
   private
   public :: largest_stress_t, find_largest_stress, largest_at_depth, von_mises_of, shear_of

   !> Number of the measures, and their indices: von Mises stress, largest shear stress.
   integer, parameter, public :: n_measures = 2, of_von_mises = 1, of_shear = 2

   !> The largest stresses.
   type :: largest_stress_t
      !> The von Mises stress and the largest shear stress, in the unit of the pressure.
      real(dp) :: stress(n_measures) = 0
      !> Their depths, in the unit of the periods; `huge`: that of the mean stress far below.
      real(dp) :: depth(n_measures) = 0
      !> Indices of the cells, along x and y.
      integer :: cell(2, n_measures) = 1
      !> What the search may have missed of each, over the largest one found [-].
      real(dp) :: error(n_measures) = 0
   end type largest_stress_t

   !> The largest stresses at one depth.
   type :: stressed_level_t
      !> The depth, and the largest stress of each measure.
      real(dp) :: depth = 0, stress(n_measures) = 0
      !> Indices of the cells, along x and y.
      integer :: cell(2, n_measures) = 1
   end type stressed_level_t

   !> C of both measures, at nu = 1/2 and at nu = -1 [-], rounded up (`test_constants` integrates them).
   real(dp), parameter, public :: of_pressure(n_measures, 2) = reshape([5.317_dp, 2.929_dp, 7.527_dp, 4.236_dp], [n_measures, 2])
   !> The same of a shear stress.
   real(dp), parameter, public :: of_traction(n_measures, 2) = reshape([4.45_dp, 2.48_dp, 5.97_dp, 3.33_dp], [n_measures, 2])
   !> Distance of the first samples in ln z, and most of all samples.
   real(dp), parameter :: first_step = 0.2_dp
   integer, parameter :: most_levels = 2000
   !> What may be missed, over the largest stress; intervals in ln z that are short enough, whatever their bound.
   real(dp), parameter :: tolerance = 1.0e-5_dp, shortest_step = 1.0e-4_dp
   !> Stresses of cells that differ by less are equal: which of them is named does not depend on round-off.
   real(dp), parameter :: equal = 1.0e-9_dp
   !> Depth of the last sample, in periods.
   real(dp), parameter :: last_depth = 2

contains

   !> Find the largest stresses over all depths.
   subroutine find_largest_stress(field, period, pressure, poisson_ratio, part, stress, found, shear)
      !> The half-space below the pressure.
      type(stress_field_t), intent(inout) :: field
      !> Periods along x and y.
      real(dp), intent(in) :: period(2)
      !> The pressure; of any shape, for its least and largest value alone.
      real(dp), intent(in) :: pressure(:, :)
      !> Poisson's ratio [-].
      real(dp), intent(in) :: poisson_ratio
      !> Cells along x and y, from the first ones, among which the largest stress is sought.
      integer, intent(in) :: part(2)
      !> Workspace for the stresses; shape `(nx, ny, n_stresses)` of a whole period.
      real(dp), intent(inout), contiguous :: stress(:, :, :)
      type(largest_stress_t), intent(out) :: found
      !> Shear stress of the field, for its least and largest value alone; not present: none.
      real(dp), intent(in), optional :: shear(:, :)
      type(stressed_level_t), allocatable :: levels(:)
      type(stressed_level_t) :: surface, below
      real(dp) :: factor(n_measures), first
      integer :: k, n

      associate (n_cells => field%n_cells())
         first = minval(period/n_cells, mask=n_cells > 1)/2
      end associate
      factor = bound_factor(of_pressure, poisson_ratio)*(maxval(pressure) - minval(pressure))/2
      if (present(shear)) factor = factor + bound_factor(of_traction, poisson_ratio)*(maxval(shear) - minval(shear))/2
      call set_level(field, 0.0_dp, part, stress, surface)
      call set_level(field, huge(first), part, stress, below)
      n = ceiling(log(last_depth*longest_of(period, field%n_cells())/first)/first_step)
      allocate (levels(n + 1))
      do k = 1, n + 1
         call set_level(field, first*exp((k - 1)*first_step), part, stress, levels(k))
      end do
      call take(found, surface)
      do k = 1, size(levels)
         call take(found, levels(k))
      end do
      call take(found, below)
      call refine(field, part, factor, stress, levels, found)
   end subroutine find_largest_stress

   !> The longest period along which the pressure varies.
   pure real(dp) function longest_of(period, n_cells)
      real(dp), intent(in) :: period(2)
      integer, intent(in) :: n_cells(2)

      longest_of = maxval(period, mask=n_cells > 1)
   end function longest_of

   !> The largest stresses at one depth.
   subroutine largest_at_depth(field, depth, part, stress, found)
      !> The half-space below the pressure.
      type(stress_field_t), intent(inout) :: field
      !> The depth, in the unit of the periods.
      real(dp), intent(in) :: depth
      !> Cells along x and y, from the first ones, among which the largest stress is sought.
      integer, intent(in) :: part(2)
      !> Workspace for the stresses; shape `(nx, ny, n_stresses)` of a whole period.
      real(dp), intent(inout), contiguous :: stress(:, :, :)
      type(largest_stress_t), intent(out) :: found
      type(stressed_level_t) :: level

      call set_level(field, depth, part, stress, level)
      call take(found, level)
   end subroutine largest_at_depth

   !> Halve intervals between depths until none can have a larger stress.
   subroutine refine(field, part, factor, stress, levels, found)
      type(stress_field_t), intent(inout) :: field
      integer, intent(in) :: part(2)
      !> B of both measures.
      real(dp), intent(in) :: factor(n_measures)
      !> Workspace for the stresses.
      real(dp), intent(inout), contiguous :: stress(:, :, :)
      !> In: the first samples, from the surface down. Out: all.
      type(stressed_level_t), allocatable, intent(inout) :: levels(:)
      !> In: the largest of the first samples. Out: of all, with the error.
      type(largest_stress_t), intent(inout) :: found
      type(stressed_level_t), allocatable :: finer(:)
      real(dp) :: bound(n_measures)
      integer :: k, n
      logical :: is_done

      do
         is_done = .true.
         allocate (finer(2*size(levels)))
         n = 1
         finer(1) = levels(1)
         found%error = 0
         do k = 2, size(levels)
            bound = bound_between(levels(k - 1), levels(k), factor)
            if (any(bound > (1 + tolerance)*found%stress) .and. size(levels) < most_levels &
               & .and. levels(k)%depth > (1 + shortest_step)*levels(k - 1)%depth) then
               is_done = .false.
               n = n + 1
               call set_level(field, sqrt(levels(k - 1)%depth)*sqrt(levels(k)%depth), part, stress, finer(n))
               call take(found, finer(n))
            else
               where (found%stress > 0) found%error = max(found%error, bound/found%stress - 1)
            end if
            n = n + 1
            finer(n) = levels(k)
         end do
         deallocate (levels)
         allocate (levels, source=finer(:n))
         deallocate (finer)
         if (is_done) exit
      end do
   end subroutine refine

   !> What no stress between two depths exceeds.
   pure function bound_between(upper, lower, factor) result(bound)
      type(stressed_level_t), intent(in) :: upper, lower
      !> B of both measures.
      real(dp), intent(in) :: factor(n_measures)
      real(dp) :: bound(n_measures)

      bound = max(upper%stress, lower%stress) + factor*log(lower%depth/upper%depth)**2/8
   end function bound_between

   !> C of both measures.
   pure function bound_factor(ends, poisson_ratio) result(factor)
      !> C at nu = 1/2 and at nu = -1.
      real(dp), intent(in) :: ends(n_measures, 2)
      real(dp), intent(in) :: poisson_ratio
      real(dp) :: factor(n_measures)

      factor = ends(:, 1) + (0.5_dp - poisson_ratio)/1.5_dp*(ends(:, 2) - ends(:, 1))
   end function bound_factor

   !> Keep a level where it has more; of equal ones the first.
   pure subroutine take(found, level)
      type(largest_stress_t), intent(inout) :: found
      type(stressed_level_t), intent(in) :: level
      integer :: k

      do k = 1, n_measures
         if (.not. level%stress(k) > (1 + equal)*found%stress(k)) cycle
         found%stress(k) = level%stress(k)
         found%depth(k) = level%depth
         found%cell(:, k) = level%cell(:, k)
      end do
   end subroutine take

   !> The largest stresses at a depth.
   subroutine set_level(field, depth, part, stress, level)
      type(stress_field_t), intent(inout) :: field
      real(dp), intent(in) :: depth
      integer, intent(in) :: part(2)
      !> Workspace for the stresses.
      real(dp), intent(inout), contiguous :: stress(:, :, :)
      type(stressed_level_t), intent(out) :: level
      real(dp), allocatable :: measures(:, :, :)
      integer :: i, j, k

      call field%get_stresses(depth, stress)
      level%depth = depth
      allocate (measures(part(1), part(2), n_measures))
      !$omp parallel do if(size(measures) > 2**16) default(none) shared(measures, stress, part) private(i, j)
      do j = 1, part(2)
         do i = 1, part(1)
            measures(i, j, of_von_mises) = von_mises_of(stress(i, j, :))
            measures(i, j, of_shear) = shear_of(stress(i, j, :))
         end do
      end do
      !$omp end parallel do
      do k = 1, n_measures
         level%stress(k) = maxval(measures(:, :, k))
         level%cell(:, k) = first_of(measures(:, :, k), (1 - equal)*level%stress(k))
      end do
   end subroutine set_level

   !> The first cell, row by row, that has a value.
   pure function first_of(map, least) result(cell)
      real(dp), intent(in) :: map(:, :)
      real(dp), intent(in) :: least
      integer :: cell(2)
      integer :: j

      cell = 1
      do j = 1, size(map, 2)
         if (.not. any(map(:, j) >= least)) cycle
         cell = [findloc(map(:, j) >= least, .true., 1), j]
         return
      end do
   end function first_of

   !> Von Mises stress of a stress.
   pure real(dp) function von_mises_of(stress) result(value)
      !> The stress, in the order of `xx` to `yz`.
      real(dp), intent(in) :: stress(n_stresses)

      value = sqrt(3*second_invariant(stress))
   end function von_mises_of

   !> J2 of a stress: half the sum of the squares of its deviator.
   pure real(dp) function second_invariant(stress) result(value)
      real(dp), intent(in) :: stress(n_stresses)

      associate (s => stress)
         value = ((s(xx) - s(yy))**2 + (s(yy) - s(zz))**2 + (s(zz) - s(xx))**2)/6 + s(xy)**2 + s(xz)**2 + s(yz)**2
      end associate
   end function second_invariant

   !> Largest shear stress: half the difference of the largest and the least principal stress, by the angle of the deviator.
   pure real(dp) function shear_of(stress) result(value)
      !> The stress, in the order of `xx` to `yz`.
      real(dp), intent(in) :: stress(n_stresses)
      real(dp), parameter :: third = acos(-1.0_dp)/3
      real(dp) :: d(3), j2, determinant, unit

      j2 = second_invariant(stress)
      value = 0
      if (.not. j2 > 0) return
      unit = sqrt(j2/3)
      d = (stress([xx, yy, zz]) - sum(stress([xx, yy, zz]))/3)/unit
      associate (a => stress(xy)/unit, b => stress(xz)/unit, c => stress(yz)/unit)
         determinant = d(1)*(d(2)*d(3) - c**2) - a*(a*d(3) - b*c) + b*(a*c - b*d(2))
      end associate
      value = sqrt(j2)*sin(acos(min(max(determinant/2, -1.0_dp), 1.0_dp))/3 + third)
   end function shear_of

end module adfric_periodic_largest_stress
