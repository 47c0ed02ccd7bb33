! SPDX-License-Identifier: GPL-3.0-or-later
!> `&data`: where measured points are, and what they are.
module adfric_input_fit_data_group
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: join_words, show_number, show_text, to_lower
   use adfric_base_unset, only: is_set, unset
   use adfric_base_words, only: get_word
   use adfric_fit_problem, only: data_set_t, loss_gauss, n_nuisances, nuisance_names, nuisance_tilt
   use adfric_input_text_table, only: text_table_t
   use adfric_input_fit_values, only: reader_t, new_reader
   use adfric_input_namelist_file, only: namelist_file_t
   use adfric_input_suggestion, only: did_you_mean
   use adfric_input_vocabulary, only: find_variable, is_number, list_numbers
   use adfric_describe_model, only: model_t
   use adfric_describe_table, only: result_t, variable_t
   use adfric_system_files, only: kind_of_path, path_free
   implicit none (type, external)
   private
   public :: data_group_t, read_data_group

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
   subroutine read_data_group(file, group, rows, model, self, problems)
      type(namelist_file_t), intent(in) :: file
      integer, intent(in) :: group
      type(variable_t), intent(in) :: rows(:)
      class(model_t), intent(in) :: model
      type(data_group_t), intent(out) :: self
      type(problems_t), intent(inout) :: problems
      integer :: k, n_before

      n_before = problems%count()
      call new_reader(self%reader, file, group, rows, problems)
      call self%reader%read_text(file, 'file', self%file, problems)
      call self%reader%report_missing(file, 'file', problems)
      if (allocated(self%file)) call find_table(file, self)
      if (allocated(self%file) .and. .not. allocated(self%table)) call look_beside(file%path, self%file)
      call read_abscissa(file, model, self, problems)
      call read_ordinate(file, model, self, problems)
      call read_columns(file, self, problems)
      call read_errors(file, self, problems)
      call read_range(file, self, problems)
      call read_loss(file, self, problems)
      do k = 1, n_nuisances
         self%is_nuisance_given(k) = self%reader%has(file, get_word(nuisance_names, k))
         call self%reader%read_number(file, get_word(nuisance_names, k), self%data_set%nuisance(k), problems)
      end do
      call check_tilt(file, model, self, problems)
      self%is_whole = allocated(self%file) .and. self%data_set%abscissa > 0 .and. self%data_set%ordinate > 0 &
         .and. problems%count() == n_before
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
   subroutine check_tilt(file, model, self, problems)
      type(namelist_file_t), intent(in) :: file
      class(model_t), intent(in) :: model
      type(data_group_t), intent(in) :: self
      type(problems_t), intent(inout) :: problems

      if (.not. self%is_nuisance_given(nuisance_tilt) .or. self%data_set%abscissa == 0 .or. self%data_set%ordinate == 0) return
      if (model%results(self%data_set%ordinate)%name == 'load' .and. model%variables(self%data_set%abscissa)%name /= 'load') return
      call self%reader%report(file, 'tilt', 'has no effect on '//model%results(self%data_set%ordinate)%name//' against '// &
         model%variables(self%data_set%abscissa)%name//', allowed: with the ordinate load', problems)
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
   subroutine read_abscissa(file, model, self, problems)
      type(namelist_file_t), intent(in) :: file
      class(model_t), intent(in) :: model
      !> Receives the index of the variable; 0 if it is none.
      type(data_group_t), intent(inout) :: self
      type(problems_t), intent(inout) :: problems
      character(:), allocatable :: name, flaw
      integer :: position

      call self%reader%read_text(file, 'abscissa', name, problems)
      call self%reader%report_missing(file, 'abscissa', problems)
      if (.not. allocated(name)) return
      call find_variable(model, to_lower(name), list_numbers(model), position, flaw)
      if (position > 0) then
         if (.not. is_number(model%variables(position))) then
            flaw = 'not a number, given '''//show_text(name)//''', allowed: '//join_words(list_numbers(model), ', ')
            position = 0
         end if
      end if
      if (position == 0) call self%reader%report(file, 'abscissa', flaw, problems)
      self%data_set%abscissa = position
   end subroutine read_abscissa

   !> Find the ordinate among the results of the model.
   subroutine read_ordinate(file, model, self, problems)
      type(namelist_file_t), intent(in) :: file
      class(model_t), intent(in) :: model
      !> Receives the index of the result; 0 if it is none.
      type(data_group_t), intent(inout) :: self
      type(problems_t), intent(inout) :: problems
      character(:), allocatable :: name, known
      integer :: i

      call self%reader%read_text(file, 'ordinate', name, problems)
      call self%reader%report_missing(file, 'ordinate', problems)
      if (.not. allocated(name)) return
      known = ''
      do i = 1, size(model%results)
         if (model%results(i)%is_hidden) cycle
         if (is_smooth(model%results(i))) known = known//' '//model%results(i)%name
         if (model%results(i)%name == to_lower(name)) self%data_set%ordinate = i
      end do
      if (self%data_set%ordinate == 0) then
         call self%reader%report(file, 'ordinate', 'unknown result of the model, given '''//show_text(name)//''', allowed: ' &
            //join_words(known, ', ')//did_you_mean(name, known), problems)
      else if (.not. is_smooth(model%results(self%data_set%ordinate))) then
         call self%reader%report(file, 'ordinate', 'a state, or what is found by counting, has no derivative and cannot be ' &
            //'fitted, given '''//show_text(name)//''', allowed: '//join_words(known, ', '), problems)
         self%data_set%ordinate = 0
      end if
   end subroutine read_ordinate

   !> Does a result vary smoothly with the variables?
   pure logical function is_smooth(result)
      type(result_t), intent(in) :: result

      is_smooth = result%n_states() == 0 .and. .not. (result%is_counted .or. result%is_hidden)
   end function is_smooth

   !> Read the names of the columns.
   subroutine read_columns(file, self, problems)
      type(namelist_file_t), intent(in) :: file
      type(data_group_t), intent(inout) :: self
      type(problems_t), intent(inout) :: problems

      call self%reader%read_text(file, 'abscissa_column', self%abscissa_column, problems)
      call self%reader%read_text(file, 'ordinate_column', self%ordinate_column, problems)
      call self%reader%read_text(file, 'sigma_column', self%sigma_column, problems)
      call self%reader%read_text(file, 'abscissa_sigma_column', self%abscissa_sigma_column, problems)
      call self%reader%read_text(file, 'branch_column', self%branch_column, problems)
      call self%reader%read_text(file, 'segment_column', self%segment_column, problems)
   end subroutine read_columns

   !> Read the standard errors; at most one of each is given.
   subroutine read_errors(file, self, problems)
      type(namelist_file_t), intent(in) :: file
      type(data_group_t), intent(inout) :: self
      type(problems_t), intent(inout) :: problems

      call self%reader%read_number(file, 'sigma', self%sigma, problems)
      call self%reader%read_number(file, 'relative_sigma', self%relative_sigma, problems)
      call self%reader%read_number(file, 'abscissa_sigma', self%abscissa_sigma, problems)
      if (self%reader%has(file, 'sigma') .and. self%reader%has(file, 'relative_sigma')) call self%reader%report(file, &
         'relative_sigma', 'contradicts sigma, given both, allowed: one of them', problems)
      if (is_named(self%sigma_column) .and. (is_set(self%sigma) .or. is_set(self%relative_sigma))) &
         call self%reader%report(file, 'sigma_column', 'contradicts the standard error that is given beside, allowed: one of ' &
         //'them', problems)
      if (is_named(self%abscissa_sigma_column) .and. is_set(self%abscissa_sigma)) call self%reader%report(file, &
         'abscissa_sigma_column', 'contradicts abscissa_sigma, given both, allowed: one of them', problems)
   end subroutine read_errors

   !> Is a column wanted by its name?
   pure logical function is_named(column)
      !> Name of the column; not allocated, or empty: none is.
      character(:), allocatable, intent(in) :: column

      is_named = .false.
      if (allocated(column)) is_named = len(column) > 0
   end function is_named

   !> Read the ends of the abscissa.
   subroutine read_range(file, self, problems)
      type(namelist_file_t), intent(in) :: file
      type(data_group_t), intent(inout) :: self
      type(problems_t), intent(inout) :: problems

      call self%reader%read_number(file, 'from', self%from, problems)
      call self%reader%read_number(file, 'to', self%to, problems)
      if (.not. (is_set(self%from) .and. is_set(self%to))) return
      if (self%from < self%to) return
      call self%reader%report(file, 'to', 'no range, given from = '//show_number(self%from)//' and to = '//show_number(self%to) &
         //', allowed: from < to', problems)
   end subroutine read_range

   !> Read what a residual costs.
   subroutine read_loss(file, self, problems)
      type(namelist_file_t), intent(in) :: file
      !> Receives the loss and its width.
      type(data_group_t), intent(inout) :: self
      type(problems_t), intent(inout) :: problems

      call self%reader%read_whole(file, 'loss', self%data_set%loss, problems)
      call self%reader%read_number(file, 'loss_width', self%data_set%loss_width, problems)
      if (self%data_set%loss == loss_gauss .and. is_set(self%data_set%loss_width)) call self%reader%report(file, 'loss_width', &
         'has no meaning with loss = ''gauss''', problems)
   end subroutine read_loss

end module adfric_input_fit_data_group
