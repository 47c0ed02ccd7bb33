! SPDX-License-Identifier: GPL-3.0-or-later
!> What the results file of a single fit has of each data set: the points, what the fit makes of them, and the best curve.
module adfric_fit_data_extras
   use adfric_base_kinds, only: dp
   use adfric_fit_extra_list, only: extra_list_t
   use adfric_fit_names, only: name_of_other, suffix_of
   use adfric_fit_parts, only: has_others
   use adfric_fit_problem, only: fit_t, data_set_t
   use adfric_fit_solution, only: solution_t, data_solution_t
   use adfric_describe_table, only: result_t
   implicit none (type, external)
   private
   public :: get_data_extras, get_units

contains

   !> Add the datasets of all data sets.
   subroutine get_data_extras(fit, solution, list)
      type(fit_t), intent(in) :: fit
      type(solution_t), intent(in) :: solution
      type(extra_list_t), intent(inout) :: list
      integer :: i

      do i = 1, size(fit%data_sets)
         call add_points(fit, fit%data_sets(i), suffix_of(fit, i), list)
         if (.not. allocated(solution%data_sets)) cycle
         if (size(solution%data_sets) < i) cycle
         call add_found(fit, fit%data_sets(i), solution%data_sets(i), suffix_of(fit, i), list)
      end do
   end subroutine get_data_extras

   !> The points as they were measured.
   subroutine add_points(fit, data_set, suffix, list)
      type(fit_t), intent(in) :: fit
      type(data_set_t), intent(in) :: data_set
      !> What stands behind the names of its datasets.
      character(*), intent(in) :: suffix
      type(extra_list_t), intent(inout) :: list
      character(:), allocatable :: x_unit, y_unit, point
      integer :: i

      point = 'point'//suffix
      call get_units(fit, data_set, x_unit, y_unit)
      call list%add_numbers(point, 'measured point', size(data_set%x))
      call list%add('abscissa'//suffix, x_unit, fit%model%variables(data_set%abscissa)%name, point, data_set%x)
      call list%add('ordinate'//suffix, y_unit, fit%model%results(data_set%ordinate)%name, point, data_set%y)
      if (allocated(data_set%sigma)) call list%add('sigma'//suffix, y_unit, 'standard error of the ordinate', point, data_set%sigma)
      if (allocated(data_set%x_sigma)) call list%add('abscissa_sigma'//suffix, x_unit, 'standard error of the abscissa', point, &
         data_set%x_sigma)
      if (has_others(data_set)) then
         do i = 1, size(data_set%others)
            call list%add('point_'//name_of_other(fit, data_set, i)//suffix, fit%model%unit_of(fit%base, data_set%others(i)), &
               fit%model%variables(data_set%others(i))%name//' of the point', point, data_set%at(i, :))
         end do
      end if
      if (allocated(data_set%is_contact)) call list%add('branch'//suffix, '-', 'branch of the point', point, &
         merge(1.0_dp, 0.0_dp, data_set%is_contact), flag_meanings='free contact')
      if (allocated(data_set%segment)) call list%add('segment'//suffix, '-', 'segment of the point', point, &
         [(real(data_set%segment(i), dp), i=1, size(data_set%segment))])
      if (allocated(data_set%is_used)) call list%add('used'//suffix, '-', 'is the point used', point, &
         merge(1.0_dp, 0.0_dp, data_set%is_used), flag_meanings='false true')
   end subroutine add_points

   !> What the fit makes of the points.
   subroutine add_found(fit, data_set, found, suffix, list)
      type(fit_t), intent(in) :: fit
      type(data_set_t), intent(in) :: data_set
      type(data_solution_t), intent(in) :: found
      character(*), intent(in) :: suffix
      type(extra_list_t), intent(inout) :: list
      character(:), allocatable :: x_unit, y_unit, curve
      integer :: i

      call get_units(fit, data_set, x_unit, y_unit)
      if (allocated(found%fitted)) call list%add('fitted'//suffix, y_unit, 'the model at the measured points', 'point'//suffix, &
         found%fitted)
      if (allocated(found%residual)) call list%add('residual'//suffix, '-', 'residuals in standard errors', 'point'//suffix, &
         found%residual)
      if (allocated(found%is_contact)) call list%add('branch'//suffix, '-', 'branch, found from the jump of the load', &
         'point'//suffix, merge(1.0_dp, 0.0_dp, found%is_contact), flag_meanings='free contact')
      if (.not. allocated(found%curve_x)) return
      curve = 'curve_x'//suffix
      if (allocated(found%curve_at)) then
         ! several curves, one behind the other: their abscissas are no scale
         curve = 'curve_point'//suffix
         call list%add_numbers(curve, 'point of a curve', size(found%curve_x))
         call list%add('curve_x'//suffix, x_unit, fit%model%variables(data_set%abscissa)%name, curve, found%curve_x)
         do i = 1, size(data_set%others)
            call list%add('curve_'//name_of_other(fit, data_set, i)//suffix, fit%model%unit_of(fit%base, data_set%others(i)), &
               fit%model%variables(data_set%others(i))%name//' of the curve', curve, found%curve_at(i, :))
         end do
      else
         call list%add_scale(curve, x_unit, fit%model%variables(data_set%abscissa)%name, found%curve_x)
      end if
      call list%add('curve'//suffix, y_unit, 'the best curve', curve, found%curve)
      if (allocated(found%second_curve)) call list%add('second_curve'//suffix, y_unit, 'the curve of the second minimum', curve, &
         found%second_curve)
      call list%add('band_low'//suffix, y_unit, 'lower end of the band of 95 % by the linear rule', curve, found%band_low)
      call list%add('band_high'//suffix, y_unit, 'upper end of the band of 95 % by the linear rule', curve, found%band_high)
   end subroutine add_found

   !> Units of abscissa and ordinate.
   subroutine get_units(fit, data_set, x_unit, y_unit)
      type(fit_t), intent(in) :: fit
      type(data_set_t), intent(in) :: data_set
      !> Receive the SI units.
      character(:), allocatable, intent(out) :: x_unit, y_unit
      type(result_t), allocatable :: results(:)

      x_unit = fit%model%unit_of(fit%base, data_set%abscissa)
      allocate (results, source=fit%model%describe_results(fit%base))
      y_unit = results(data_set%ordinate)%unit
   end subroutine get_units

end module adfric_fit_data_extras
