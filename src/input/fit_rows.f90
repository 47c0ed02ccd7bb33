! SPDX-License-Identifier: GPL-3.0-or-later
!> The groups that an input of `adfric fit` has beside those of its model: `&data`, `&event`, `&free` and `&fit`.
module adfric_input_fit_rows
   use adfric_base_kinds, only: dp
   use adfric_fit_problem, only: event_names, interval_names, loss_names
   use adfric_describe_rows, only: above_zero, any_number, choice, whole_number
   use adfric_describe_table, only: variable_t, kind_text
   implicit none (type, external)
   private
   public :: get_fit_rows, find_fit_row, list_fit_names, fit_groups, scale_names, curves_names

   !> The groups.
   character(*), parameter :: fit_groups = 'data event free fit'
   !> Number of rows of all groups.
   integer, parameter :: n_rows = 46
   !> How a variable is fitted, and what the curves of a stack are.
   character(*), parameter :: scale_names = 'log linear', curves_names = 'each together', &
      & residuals_names = 'none all'

contains

   !> All rows, group by group.
   function get_fit_rows() result(rows)
      type(variable_t), allocatable :: rows(:)

      allocate (rows(n_rows))
      rows(:17) = rows_of_data()
      rows(18:25) = rows_of_nuisances()
      rows(26:29) = rows_of_event()
      rows(30:36) = rows_of_free()
      rows(37:) = rows_of_fit()
   end function get_fit_rows

   !> The rows of `&data` that say where the points are and what they are.
   function rows_of_data() result(rows)
      type(variable_t), allocatable :: rows(:)

      allocate (rows(17))
      rows(1) = text_row('data', 'file', 'table ''FILE.csv'', or ''FILE.h5:/DATASET'' with the ordinate of one curve or of a stack')
      rows(2) = text_row('data', 'abscissa', 'variable of the model that was varied, such as ''load''')
      rows(3) = text_row('data', 'ordinate', 'result of the model that was measured, such as ''friction_force''')
      rows(4) = text_row('data', 'abscissa_column', 'column, or dataset, of the abscissa; default: its name')
      rows(5) = text_row('data', 'ordinate_column', 'column of the ordinate; default: its name')
      rows(6) = text_row('data', 'sigma_column', 'standard errors of the ordinate; default: ''sigma'' if there; '''': none')
      rows(7) = text_row('data', 'abscissa_sigma_column', 'standard errors of the abscissa; default: none')
      rows(8) = text_row('data', 'branch_column', '1 in contact, 0 free; default: ''branch'' or ''contact'' if there; '''': none')
      rows(9) = text_row('data', 'segment_column', 'whole numbers of the parts of a measurement; default: ''segment'' if there')
      rows(10) = above_zero('data', 'sigma', 'unit of the ordinate', 'one standard error for all points')
      rows(11) = above_zero('data', 'relative_sigma', '-', 'standard error as a part of each measured ordinate')
      rows(12) = above_zero('data', 'abscissa_sigma', 'unit of the abscissa', 'one standard error of all abscissas')
      rows(13) = any_number('data', 'from', 'unit of the abscissa', 'points below are left out')
      rows(14) = any_number('data', 'to', 'unit of the abscissa', 'points above are left out')
      rows(15) = choice(group='data', name='loss', meaning='what a residual costs', choices=loss_names, default='gauss')
      rows(16) = text_row('data', 'variables', 'further variables with a value for each point, such as ''temperature''')
      rows(16)%is_list = .true.
      rows(17) = text_row('data', 'variable_columns', 'their columns, in the same order; default: their names')
      rows(17)%is_list = .true.
   end function rows_of_data

   !> The rows of `&data` that say what belongs to the measurement and not to the model.
   function rows_of_nuisances() result(rows)
      type(variable_t), allocatable :: rows(:)

      allocate (rows(8))
      rows(1) = above_zero('data', 'loss_width', '-', 'width of the loss in standard errors; default 1.345, 1 or 2.385')
      rows(2) = any_number('data', 'load_offset', 'N', 'zero of the load', default=0.0_dp)
      rows(3) = any_number('data', 'friction_offset', 'unit of the ordinate', 'zero of the ordinate', default=0.0_dp)
      rows(4) = any_number('data', 'contact_point', 'm', 'zero of the approach', default=0.0_dp)
      rows(5) = any_number('data', 'lateral_gain', '-', 'factor between the model and the ordinate', default=1.0_dp)
      rows(6) = above_zero('data', 'spring_stiffness', 'N/m', 'spring k: the abscissa is the place of its base, approach + load/k')
      rows(7) = any_number('data', 'tilt', 'N/m', 'slope of the base line, load per abscissa as measured', default=0.0_dp)
      rows(8) = any_number('data', 'drift_rate', 'm/s', 'of a history in time: drift towards the sample, which adds drift_rate '// &
         'times the time to approaches', default=0.0_dp)
   end function rows_of_nuisances

   !> The rows of `&event`.
   function rows_of_event() result(rows)
      type(variable_t), allocatable :: rows(:)

      allocate (rows(4))
      rows(1) = whole_number(group='event', name='data', meaning='number of the &data whose zeros shift it', default=1, lower=1, &
         upper=1000)
      rows(2) = choice(group='event', name='kind', meaning='what was measured', choices=event_names)
      rows(3) = any_number('event', 'value', 'N or m', 'measured value')
      rows(4) = above_zero('event', 'sigma', 'N or m', 'its standard error')
   end function rows_of_event

   !> The rows of `&free`.
   function rows_of_free() result(rows)
      type(variable_t), allocatable :: rows(:)

      allocate (rows(7))
      rows(1) = text_row('free', 'variable', '''NAME'' or ''GROUP%NAME'' of the model, or ''data[N]%NAME'' of a measurement')
      rows(2) = any_number('free', 'start', 'its unit', 'where the search starts; default: from the data')
      rows(3) = any_number('free', 'minimum', 'its unit', 'least value; default: 0.01 for lambda, else that of the variable')
      rows(4) = any_number('free', 'maximum', 'its unit', 'largest value; default: 100 for lambda, else that of the variable')
      rows(5) = choice(group='free', name='scale', meaning='is ln v fitted, or v; default: log where v is positive', &
         choices=scale_names)
      rows(6) = any_number('free', 'prior', 'its unit', 'what is known beforehand')
      rows(7) = above_zero('free', 'prior_sigma', '- (log) or its unit', 'standard error of the prior; relative on the scale log')
   end function rows_of_free

   !> The rows of `&fit`.
   function rows_of_fit() result(rows)
      type(variable_t), allocatable :: rows(:)

      allocate (rows(10))
      rows(1) = choice(group='fit', name='intervals', meaning='how intervals are found', choices=interval_names, &
         default='covariance')
      rows(2) = any_number('fit', 'levels', '-', 'levels of the intervals, one or more; default 0.6827, 0.95', lower=0.0_dp, &
         upper=1.0_dp)
      rows(2)%lower_open = .true.
      rows(2)%upper_open = .true.
      rows(3) = whole_number(group='fit', name='starts', meaning='starts of the search; 0: as many as the variables ask for', &
         default=0, lower=0, upper=1000)
      rows(4) = text_row('fit', 'theories', 'theories of the model that are compared')
      rows(4)%is_list = .true.
      rows(5) = text_row('fit', 'derived', 'derived quantities that are wanted; default: all')
      rows(5)%is_list = .true.
      rows(6) = choice(group='fit', name='curves', meaning='is each curve of a stack a fit, or are all together one', &
         choices=curves_names, default='each')
      rows(7) = any_number('fit', 'relative_tolerance', '-', 'relative decrease of S that ends the search', default=1.0e-10_dp, &
         lower=1.0e-15_dp, upper=1.0e-2_dp)
      rows(8) = whole_number(group='fit', name='refits', meaning='refits of the bootstrap', default=1000, lower=20, upper=1000000)
      rows(9) = whole_number(group='fit', name='seed', meaning='seed of the noise of the bootstrap', default=1, lower=0, &
         upper=huge(1))
      rows(10) = choice(group='fit', name='residuals', meaning='of a stack with one &data: are the points of each curve written', &
         choices=residuals_names, default='none')
   end function rows_of_fit

   !> A row of a text.
   function text_row(group, name, meaning) result(row)
      !> Group of the variable, without `&`.
      character(*), intent(in) :: group
      character(*), intent(in) :: name
      !> What it is, for `adfric help`.
      character(*), intent(in) :: meaning
      type(variable_t) :: row

      row = any_number(group, name, '', meaning)
      row%kind = kind_text
   end function text_row

   !> Index of a row; 0 if there is none.
   pure integer function find_fit_row(rows, group, name)
      type(variable_t), intent(in) :: rows(:)
      character(*), intent(in) :: group, name

      do find_fit_row = size(rows), 1, -1
         if (rows(find_fit_row)%group == group .and. rows(find_fit_row)%name == name) return
      end do
   end function find_fit_row

   !> Names of the variables of a group, separated by a blank.
   pure function list_fit_names(rows, group) result(names)
      !> All rows.
      type(variable_t), intent(in) :: rows(:)
      !> Group of the variables, without `&`.
      character(*), intent(in) :: group
      character(:), allocatable :: names
      integer :: i

      names = ''
      do i = 1, size(rows)
         if (rows(i)%group == group) names = names//' '//rows(i)%name
      end do
   end function list_fit_names

end module adfric_input_fit_rows
