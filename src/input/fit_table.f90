! SPDX-License-Identifier: GPL-3.0-or-later
!> The points of a `&data` group from a table of text.
module adfric_input_fit_table
   use adfric_base_error, only: error_t
   use adfric_base_kinds, only: dp
   use adfric_base_text, only: show_text
   use adfric_input_fit_data_group, only: data_group_t
   use adfric_input_fit_points, only: columns_t, find_flaw, find_outside
   use adfric_base_unset, only: is_set
   use adfric_input_text_table, only: text_table_t, open_text_table
   use adfric_describe_model, only: model_t
   implicit none (type, external)
   private
   public :: read_table_columns, is_wanted

contains

   !> Read the columns of a table.
   subroutine read_table_columns(group, model, columns, form, variable, flaw)
      !> The `&data` group.
      class(data_group_t), intent(in) :: group
      class(model_t), intent(in) :: model
      !> Receives the columns in SI units.
      type(columns_t), intent(out) :: columns
      !> Receives how the table was read, and the columns with their units, in words.
      character(:), allocatable, intent(out) :: form
      !> Variable of the group that a flaw is one of.
      character(:), allocatable, intent(out) :: variable
      character(:), allocatable, intent(out) :: flaw
      type(text_table_t) :: table
      type(error_t), allocatable :: error

      flaw = ''
      variable = 'file'
      if (allocated(group%table)) then
         table = group%table
      else
         call open_text_table(table, group%file, error)
      end if
      if (allocated(error)) then
         flaw = error%message
         form = ''
         return
      end if
      form = table%describe()//';'
      call take(table, group%abscissa_column, model%variables(group%data_set%abscissa)%name, .true., group%x_unit, columns%x, &
         'abscissa_column', form, variable, flaw)
      call take(table, group%ordinate_column, model%results(group%data_set%ordinate)%name, .true., group%y_unit, columns%y, &
         'ordinate_column', form, variable, flaw)
      if (.not. (is_set(group%sigma) .or. is_set(group%relative_sigma))) call take(table, group%sigma_column, 'sigma', .false., &
         group%y_unit, columns%sigma, 'sigma_column', form, variable, flaw)
      call take(table, group%abscissa_sigma_column, '', .false., group%x_unit, columns%x_sigma, 'abscissa_sigma_column', form, &
         variable, flaw)
      call take(table, group%branch_column, 'branch', .false., '-', columns%branch, 'branch_column', form, variable, flaw)
      if (.not. (allocated(group%branch_column) .or. allocated(columns%branch))) call take(table, group%branch_column, 'contact', &
         .false., '-', columns%branch, 'branch_column', form, variable, flaw)
      call take(table, group%segment_column, 'segment', .false., '-', columns%segment, 'segment_column', form, variable, flaw)
      call take_others(table, group, columns, form, variable, flaw)
      if (len(flaw) > 0) return
      variable = 'file'
      call find_flaw(columns, flaw)
      if (len(flaw) == 0) call find_outside(group, model, columns, flaw)
      if (len(flaw) > 0) flaw = group%file//': '//flaw
   end subroutine read_table_columns

   !> Take the columns of further variables.
   subroutine take_others(table, group, columns, form, variable, flaw)
      type(text_table_t), intent(in) :: table
      class(data_group_t), intent(in) :: group
      !> Receives the values; shape `(n_others, n)`.
      type(columns_t), intent(inout) :: columns
      character(:), allocatable, intent(inout) :: form, variable, flaw
      character(:), allocatable :: name
      real(dp), allocatable :: values(:)
      integer :: k

      if (len(flaw) > 0 .or. size(group%others) == 0) return
      allocate (columns%at(size(group%others), size(columns%x)), source=0.0_dp)
      do k = 1, size(group%others)
         name = group%others(k)%name
         call take(table, name, '', .true., group%others(k)%unit, values, 'variables', form, variable, flaw)
         if (len(flaw) > 0) return
         columns%at(k, :) = values
      end do
   end subroutine take_others

   !> Take a column: that of the name that is given, else that of its usual name if it is there.
   subroutine take(table, given, usual, is_needed, unit, values, of_variable, form, variable, flaw)
      type(text_table_t), intent(in) :: table
      !> Name that is given; not allocated if none is, empty if no column is wanted.
      character(:), allocatable, intent(in) :: given
      !> Usual name of the column; empty if it has none.
      character(*), intent(in) :: usual
      logical, intent(in) :: is_needed
      !> SI unit that is wanted.
      character(*), intent(in) :: unit
      !> Receives the values; not allocated if there is no column.
      real(dp), allocatable, intent(inout) :: values(:)
      !> Variable of the group that names the column.
      character(*), intent(in) :: of_variable
      !> Receives the column and its unit behind those before, in words.
      character(:), allocatable, intent(inout) :: form
      !> Receives that variable, if something is wrong.
      character(:), allocatable, intent(inout) :: variable
      !> What is wrong; nothing is done if something is wrong already.
      character(:), allocatable, intent(inout) :: flaw
      type(error_t), allocatable :: error
      character(:), allocatable :: name

      if (len(flaw) > 0) return
      if (.not. is_wanted(given, is_needed, len(usual) > 0 .and. table%has_column(usual))) return
      name = usual
      if (allocated(given)) then
         if (len(given) > 0) name = given
      end if
      call table%take_column(name, unit, values, error)
      if (allocated(error)) then
         variable = of_variable
         flaw = error%message
         return
      end if
      if (form(len(form):) /= ';') form = form//','
      form = form//' '//show_text(name)
      if (len(table%unit_of(name)) > 0) form = form//' in '//show_text(table%unit_of(name))
   end subroutine take

   !> Is a column wanted: by its name, because it is needed, or because it is there?
   pure logical function is_wanted(given, is_needed, is_there)
      character(:), allocatable, intent(in) :: given
      logical, intent(in) :: is_needed
      !> Is there a column of the usual name?
      logical, intent(in) :: is_there

      is_wanted = is_needed .or. (is_there .and. .not. allocated(given))
      if (allocated(given)) is_wanted = is_wanted .or. len(given) > 0
   end function is_wanted

end module adfric_input_fit_table
