! SPDX-License-Identifier: GPL-3.0-or-later
!> `&data`: where measured points are, and what they are.
module adfric_input_fit_data_group
   use adfric_base_kinds, only: dp
   use adfric_base_text, only: join_words, show_count, show_number, show_text, to_lower
   use adfric_base_unset, only: is_set, unset
   use adfric_base_words, only: count_words, get_word
   use adfric_fit_problem, only: data_set_t, loss_gauss, n_nuisances, nuisance_names, nuisance_tilt
   use adfric_input_reading, only: reading_t
   use adfric_input_text_table, only: text_table_t
   use adfric_input_fit_values, only: reader_t, new_reader
   use adfric_input_namelist_file, only: namelist_file_t
   use adfric_input_suggestion, only: did_you_mean
   use adfric_input_vocabulary, only: find_variable, is_number, list_numbers
   use adfric_describe_of_fits, only: is_abscissa_of_fits, is_ordinate_of_fits
   use adfric_describe_table, only: result_t, variable_t
   use adfric_system_files, only: kind_of_path, path_free
   implicit none (type, external)
   private
   public :: data_group_t, other_column_t, read_data_group, is_history

   !> The column of a further variable.
   type :: other_column_t
      !> Its name, and the SI unit of the variable.
      character(:), allocatable :: name, unit
   end type other_column_t

   !> A group.
   type :: data_group_t
      !> Its values, for messages.
      type(reader_t) :: reader
      !> Name of the file, with that of a dataset within it or without; not allocated if it is wrong.
      character(:), allocatable :: file
      !> The table of that name, where somebody has it in memory.
      type(text_table_t), allocatable :: table
      !> Names of the columns; not allocated where none is given, empty where none is wanted.
      character(:), allocatable :: abscissa_column, ordinate_column, sigma_column, abscissa_sigma_column, branch_column, &
         segment_column
      !> Columns of the further variables, in the order of `data_set%others`; of size 0 where there are none.
      type(other_column_t), allocatable :: others(:)
      !> Standard errors of all points; not set where none is given.
      real(dp) :: sigma = unset, relative_sigma = unset, abscissa_sigma = unset
      !> Ends of the abscissa; not set where none is given.
      real(dp) :: from = unset, to = unset
      !> What the points are, without them: abscissa, ordinate, loss and nuisances.
      type(data_set_t) :: data_set
      !> SI units of abscissa and ordinate.
      character(:), allocatable :: x_unit, y_unit
      !> Which nuisances are given.
      logical :: is_nuisance_given(n_nuisances) = .false.
      !> Is everything known that is needed to read the points?
      logical :: is_whole = .false.
   end type data_group_t

contains

   !> Read a group.
   subroutine read_data_group(r, group, rows, self)
      type(reading_t), intent(in) :: r
      integer, intent(in) :: group
      type(variable_t), intent(in) :: rows(:)
      type(data_group_t), intent(out) :: self
      integer :: k, n_before

      n_before = r%problems%count()
      call new_reader(self%reader, r, group, rows)
      call self%reader%read_text(r, 'file', self%file)
      call self%reader%report_missing(r, 'file')
      if (allocated(self%file)) call find_table(r%file, self)
      if (allocated(self%file) .and. .not. allocated(self%table)) call look_beside(r%file%path, self%file)
      call read_abscissa(r, self)
      call read_ordinate(r, self)
      call read_others(r, self)
      call read_columns(r, self)
      call read_errors(r, self)
      call read_range(r, self)
      call read_loss(r, self)
      do k = 1, n_nuisances
         self%is_nuisance_given(k) = self%reader%has(r%file, get_word(nuisance_names, k))
         call self%reader%read_number(r, get_word(nuisance_names, k), self%data_set%nuisance(k))
      end do
      call check_tilt(r, self)
      self%is_whole = allocated(self%file) .and. self%data_set%abscissa > 0 .and. self%data_set%ordinate > 0 &
         .and. r%problems%count() == n_before
   end subroutine read_data_group

   !> Find the table in memory that the group names, if it names one.
   subroutine find_table(file, self)
      type(namelist_file_t), intent(in) :: file
      type(data_group_t), intent(inout) :: self
      integer :: k

      if (.not. allocated(file%tables)) return
      do k = 1, size(file%tables)
         if (file%tables(k)%path == self%file) self%table = file%tables(k)
      end do
   end subroutine find_table

   !> A tilt belongs to a load over another abscissa.
   subroutine check_tilt(r, self)
      type(reading_t), intent(in) :: r
      type(data_group_t), intent(in) :: self

      if (.not. self%is_nuisance_given(nuisance_tilt) .or. self%data_set%abscissa == 0 .or. self%data_set%ordinate == 0) return
      if (r%model%results(self%data_set%ordinate)%name == 'load' .and. r%model%variables(self%data_set%abscissa)%name /= 'load') &
         return
      call self%reader%report(r, 'tilt', 'has no effect on '//r%model%results(self%data_set%ordinate)%name//' against ' &
         //r%model%variables(self%data_set%abscissa)%name//', allowed: with the ordinate load')
   end subroutine check_tilt

   !> A file that is not found from here may stand beside the input.
   subroutine look_beside(input, name)
      !> Name of the input; empty if there is none.
      character(*), intent(in) :: input
      !> In: the name as it is given. Out: the name by which the file is found, if it is found beside the input alone.
      character(:), allocatable, intent(inout) :: name
      character(:), allocatable :: bare, beside
      integer :: slash

      bare = name
      if (index(name, ':/', back=.true.) > 1) bare = name(:index(name, ':/', back=.true.) - 1)
      slash = index(input, '/', back=.true.)
      if (slash == 0 .or. index(bare, '/') == 1) return
      if (kind_of_path(bare) /= path_free) return
      beside = input(:slash)//bare
      if (kind_of_path(beside) /= path_free) name = input(:slash)//name
   end subroutine look_beside

   !> Find the abscissa among the variables of the model.
   subroutine read_abscissa(r, self)
      type(reading_t), intent(in) :: r
      !> Receives the index of the variable; 0 if it is none.
      type(data_group_t), intent(inout) :: self
      character(:), allocatable :: name, flaw, of_fits
      integer :: position

      call self%reader%read_text(r, 'abscissa', name)
      call self%reader%report_missing(r, 'abscissa')
      if (.not. allocated(name)) return
      call find_of_fits(r, to_lower(name), position, of_fits)
      if (position == 0) then
         call find_variable(r%model, to_lower(name), list_numbers(r%model)//of_fits, position, flaw)
      else
         flaw = ''
      end if
      if (position > 0) then
         if (.not. is_number(r%model%variables(position))) then
            flaw = 'not a number, given '''//show_text(name)//''', allowed: '//join_words(list_numbers(r%model), ', ')
            position = 0
         end if
      end if
      if (position == 0) call self%reader%report(r, 'abscissa', flaw)
      self%data_set%abscissa = position
   end subroutine read_abscissa

   !> Find an abscissa that fits alone have.
   subroutine find_of_fits(r, name, position, names)
      type(reading_t), intent(in) :: r
      !> Name of the abscissa, in small letters.
      character(*), intent(in) :: name
      !> Receives the index of the variable; 0 if it is none.
      integer, intent(out) :: position
      !> Receives the names of all of them, with a blank before each.
      character(:), allocatable, intent(out) :: names
      integer :: i

      position = 0
      names = ''
      do i = 1, size(r%model%variables)
         if (.not. is_abscissa_of_fits(r%model%variables(i))) cycle
         names = names//' '//r%model%variables(i)%name
         if (r%model%variables(i)%name == name) position = i
      end do
   end subroutine find_of_fits

   !> Find the further variables that have a value for each point, and their columns.
   subroutine read_others(r, self)
      type(reading_t), intent(in) :: r
      !> Receives their indices and the names of their columns.
      type(data_group_t), intent(inout) :: self
      character(:), allocatable :: names, columns, flaw
      integer :: k, position

      allocate (self%data_set%others(0))
      call self%reader%read_texts(r, 'variables', names)
      call self%reader%read_texts(r, 'variable_columns', columns)
      if (len(columns) > 0 .and. count_words(columns) /= count_words(names)) call self%reader%report(r, 'variable_columns', &
         'given '//show_count(count_words(columns))//' for '//show_count(count_words(names))//' variables, allowed: one for each')
      do k = 1, count_words(names)
         call find_other(r, self, to_lower(get_word(names, k)), position, flaw)
         if (len(flaw) > 0) then
            call self%reader%report(r, 'variables', flaw)
            r%input%is_broken = .true.
         else
            self%data_set%others = [self%data_set%others, position]
         end if
      end do
      allocate (self%others(size(self%data_set%others)))
      do k = 1, size(self%others)
         self%others(k)%name = r%model%variables(self%data_set%others(k))%name
         if (count_words(columns) >= k) self%others(k)%name = get_word(columns, k)
      end do
   end subroutine read_others

   !> Find a further variable: a number of the model that stands nowhere else.
   subroutine find_other(r, self, name, position, flaw)
      type(reading_t), intent(in) :: r
      !> The group with its abscissa, and the further variables before this one.
      type(data_group_t), intent(in) :: self
      !> Name of the variable, in small letters.
      character(*), intent(in) :: name
      !> Receives the index of the variable; 0 if it is none.
      integer, intent(out) :: position
      !> Receives what is wrong; empty if nothing is.
      character(:), allocatable, intent(out) :: flaw

      call find_variable(r%model, name, list_numbers(r%model), position, flaw)
      if (position == 0) return
      associate (row => r%model%variables(position))
         if (is_history(row) .and. .not. r%input%is_given(position) .and. .not. any(self%data_set%others == position)) return
         if (.not. is_number(row) .and. .not. is_history(row)) then
            flaw = 'not a number, given '''//show_text(name)//''', allowed: '//join_words(list_numbers(r%model), ', ')
         else if (position == self%data_set%abscissa) then
            flaw = row%name//' is the abscissa, allowed: other variables'
         else if (any(self%data_set%others == position)) then
            flaw = row%name//' is named twice, allowed: once'
         else if (r%input%is_given(position)) then
            flaw = row%name//' is given twice, here and in &'//row%group//' in line '//show_count(r%input%line(position))// &
               ', allowed: one of them'
         end if
      end associate
   end subroutine find_other

   !> Is a variable a list of what a history prescribes, over the abscissa time?
   pure logical function is_history(row)
      type(variable_t), intent(in) :: row

      is_history = row%is_list .and. row%group == 'history' .and. row%name /= 'times'
   end function is_history

   !> Find the ordinate among the results of the model.
   subroutine read_ordinate(r, self)
      type(reading_t), intent(in) :: r
      !> Receives the index of the result; 0 if it is none.
      type(data_group_t), intent(inout) :: self
      character(:), allocatable :: name, known
      integer :: i

      call self%reader%read_text(r, 'ordinate', name)
      call self%reader%report_missing(r, 'ordinate')
      if (.not. allocated(name)) return
      known = ''
      do i = 1, size(r%model%results)
         if (.not. is_there(r%model%results(i))) cycle
         if (is_smooth(r%model%results(i))) known = known//' '//r%model%results(i)%name
         if (r%model%results(i)%name == to_lower(name)) self%data_set%ordinate = i
      end do
      if (self%data_set%ordinate == 0) then
         call self%reader%report(r, 'ordinate', 'unknown result of the model, given '''//show_text(name)//''', allowed: ' &
            //join_words(known, ', ')//did_you_mean(name, known))
      else if (.not. is_smooth(r%model%results(self%data_set%ordinate))) then
         call self%reader%report(r, 'ordinate', 'a state, or what is found by counting, has no derivative and cannot be ' &
            //'fitted, given '''//show_text(name)//''', allowed: '//join_words(known, ', '))
         self%data_set%ordinate = 0
      end if

   contains

      !> Is it a result of a run, or over an abscissa of fits one of these?
      logical function is_there(result)
         type(result_t), intent(in) :: result

         is_there = .not. result%is_hidden
         if (self%data_set%abscissa == 0) return
         if (is_abscissa_of_fits(r%model%variables(self%data_set%abscissa))) is_there = is_ordinate_of_fits(result)
      end function is_there

   end subroutine read_ordinate

   !> Does a result vary smoothly with the variables?
   pure logical function is_smooth(result)
      type(result_t), intent(in) :: result

      is_smooth = result%n_states() == 0 .and. .not. result%is_counted
      if (is_smooth) is_smooth = .not. result%is_hidden .or. is_ordinate_of_fits(result)
   end function is_smooth

   !> Read the names of the columns.
   subroutine read_columns(r, self)
      type(reading_t), intent(in) :: r
      type(data_group_t), intent(inout) :: self

      call self%reader%read_text(r, 'abscissa_column', self%abscissa_column)
      call self%reader%read_text(r, 'ordinate_column', self%ordinate_column)
      call self%reader%read_text(r, 'sigma_column', self%sigma_column)
      call self%reader%read_text(r, 'abscissa_sigma_column', self%abscissa_sigma_column)
      call self%reader%read_text(r, 'branch_column', self%branch_column)
      call self%reader%read_text(r, 'segment_column', self%segment_column)
   end subroutine read_columns

   !> Read the standard errors; at most one of each is given.
   subroutine read_errors(r, self)
      type(reading_t), intent(in) :: r
      type(data_group_t), intent(inout) :: self

      call self%reader%read_number(r, 'sigma', self%sigma)
      call self%reader%read_number(r, 'relative_sigma', self%relative_sigma)
      call self%reader%read_number(r, 'abscissa_sigma', self%abscissa_sigma)
      if (self%reader%has(r%file, 'sigma') .and. self%reader%has(r%file, 'relative_sigma')) call self%reader%report(r, &
         'relative_sigma', 'contradicts sigma, given both, allowed: one of them')
      if (is_named(self%sigma_column) .and. (is_set(self%sigma) .or. is_set(self%relative_sigma))) call self%reader%report(r, &
         'sigma_column', 'contradicts the standard error that is given beside, allowed: one of ' //'them')
      if (is_named(self%abscissa_sigma_column) .and. is_set(self%abscissa_sigma)) call self%reader%report(r, &
         'abscissa_sigma_column', 'contradicts abscissa_sigma, given both, allowed: one of them')
   end subroutine read_errors

   !> Is a column wanted by its name?
   pure logical function is_named(column)
      !> Name of the column; not allocated, or empty: none is.
      character(:), allocatable, intent(in) :: column

      is_named = .false.
      if (allocated(column)) is_named = len(column) > 0
   end function is_named

   !> Read the ends of the abscissa.
   subroutine read_range(r, self)
      type(reading_t), intent(in) :: r
      type(data_group_t), intent(inout) :: self

      call self%reader%read_number(r, 'from', self%from)
      call self%reader%read_number(r, 'to', self%to)
      if (.not. (is_set(self%from) .and. is_set(self%to))) return
      if (self%from < self%to) return
      call self%reader%report(r, 'to', 'no range, given from = '//show_number(self%from)//' and to = '//show_number(self%to) &
         //', allowed: from < to')
   end subroutine read_range

   !> Read what a residual costs.
   subroutine read_loss(r, self)
      type(reading_t), intent(in) :: r
      !> Receives the loss and its width.
      type(data_group_t), intent(inout) :: self

      call self%reader%read_whole(r, 'loss', self%data_set%loss)
      call self%reader%read_number(r, 'loss_width', self%data_set%loss_width)
      if (self%data_set%loss == loss_gauss .and. is_set(self%data_set%loss_width)) call self%reader%report(r, 'loss_width', &
         'has no meaning with loss = ''gauss''')
   end subroutine read_loss

end module adfric_input_fit_data_group
