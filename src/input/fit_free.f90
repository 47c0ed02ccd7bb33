! SPDX-License-Identifier: GPL-3.0-or-later
!> `&free`: which variables of the model, or of a measurement, the data shall give.
module adfric_input_fit_free
   use adfric_base_kinds, only: dp
   use adfric_base_text, only: join_words, show_count, show_number, show_text, to_lower
   use adfric_base_unset, only: is_set, unset
   use adfric_base_words, only: get_word
   use adfric_fit_problem, only: free_t, nuisance_load_offset, nuisance_contact_point, nuisance_lateral_gain, &
      nuisance_spring_stiffness, nuisance_tilt, nuisance_drift_rate, nuisance_names, n_nuisances
   use adfric_input_case, only: case_t, mark_meant
   use adfric_input_fit_data_group, only: data_group_t
   use adfric_input_fit_values, only: reader_t, new_reader
   use adfric_input_reading, only: reading_t
   use adfric_input_suggestion, only: did_you_mean
   use adfric_input_variable, only: find_outlier
   use adfric_input_vocabulary, only: find_variable, full_name, list_numbers
   use adfric_describe_model, only: model_t
   use adfric_describe_plausible_range, only: find_plausible_range
   use adfric_describe_table, only: kind_real, variable_t
   implicit none (type, external)
   private
   public :: read_frees, hold_variable, check_members

   !> Indices of the words of `scale`.
   integer, parameter :: scale_log = 1
   !> Most free variables.
   integer, parameter :: most_frees = 10
   !> Most digits of the number of a member, and two.
   integer, parameter :: most_digits = 8
   !> What stands before the nuisances of a data set.
   character(*), parameter :: data_prefix = 'data'

contains

   !> Read every group. One that cannot be used is left out; there is a problem then.
   subroutine read_frees(r, rows, groups, frees, readers)
      type(reading_t), intent(in) :: r
      type(variable_t), intent(in) :: rows(:)
      !> The `&data` groups.
      type(data_group_t), intent(in) :: groups(:)
      type(free_t), allocatable, intent(out) :: frees(:)
      type(reader_t), allocatable, intent(out) :: readers(:)
      type(free_t) :: free
      type(reader_t) :: reader
      integer :: i, n, n_before

      allocate (frees(count(r%file%groups%name == 'free')), readers(count(r%file%groups%name == 'free')))
      n = 0
      do i = 1, size(r%file%groups)
         if (r%file%groups(i)%name /= 'free') cycle
         if (r%problems%is_enough()) exit
         n_before = r%problems%count()
         call new_reader(reader, r, i, rows)
         free = free_t()
         call find_free(r, reader, groups, free)
         if (allocated(free%name)) call read_numbers_of(r, reader, free)
         if (.not. allocated(free%name) .or. r%problems%count() > n_before) cycle
         if (any(is_same(frees(:n), free))) then
            call reader%report(r, 'variable', free%name//' is free twice, allowed: once')
            cycle
         end if
         n = n + 1
         frees(n) = free
         readers(n) = reader
      end do
      frees = frees(:n)
      readers = readers(:n)
      if (n > most_frees) call r%problems%add('free', '', 'too many free variables, given '//show_count(n)//', allowed: at most ' &
         //show_count(most_frees))
   end subroutine read_frees

   !> Are two free variables the same?
   elemental logical function is_same(one, other)
      type(free_t), intent(in) :: one, other

      is_same = one%variable == other%variable .and. one%data_set == other%data_set .and. one%nuisance == other%nuisance &
         .and. one%list == other%list .and. one%member == other%member
   end function is_same

   !> Find what is free; its name is not allocated if nothing can be.
   subroutine find_free(r, reader, groups, free)
      type(reading_t), intent(in) :: r
      type(reader_t), intent(in) :: reader
      type(data_group_t), intent(in) :: groups(:)
      !> Receives the index of the variable, or the nuisance and its data set, the name and the unit.
      type(free_t), intent(inout) :: free
      character(:), allocatable :: name, flaw

      call reader%read_text(r, 'variable', name)
      call reader%report_missing(r, 'variable')
      if (.not. allocated(name)) then
         r%input%is_broken = .true.
         return
      end if
      name = to_lower(name)
      if (is_nuisance_name(r%model, name)) then
         call find_nuisance(name, groups, free, flaw)
      else if (index(name, '(') > 0) then
         call find_member(r, name, free, flaw)
      else
         call find_variable(r%model, name, list_numbers(r%model)//' data%'//join_words(nuisance_names, ' data%'), free%variable, &
            flaw)
         if (free%variable == 0) then
            if (index(flaw, 'did you mean') == 0) flaw = flaw//did_you_mean(name, nuisance_names)
            call mark_meant(r%model, '', name(index(name, '%') + 1:), r%input)
         else
            call check_variable(r%model, groups, free%variable, r%input, flaw)
         end if
      end if
      if (len(flaw) > 0) then
         call reader%report(r, 'variable', flaw)
      else if (free%variable > 0) then
         free%name = full_name(r%model, free%variable)
         free%unit = r%model%unit_of(r%input%values, free%variable)
         free%is_log = r%model%variables(free%variable)%lower >= 0
         call hold_variable(r%model, free%variable, r%input)
      end if
   end subroutine find_free

   !> Find a member of a list by `solid%moduli(2)`; the list gives the start.
   subroutine find_member(r, name, free, flaw)
      type(reading_t), intent(in) :: r
      !> Name of the list, in small letters, with the member in parentheses.
      character(*), intent(in) :: name
      !> Receives list, member, name, unit and scale.
      type(free_t), intent(inout) :: free
      character(:), allocatable, intent(out) :: flaw
      integer :: open, last, status

      open = index(name, '(')
      last = len_trim(name)
      call find_variable(r%model, name(:open - 1), list_numbers(r%model), free%list, flaw)
      if (free%list == 0) return
      status = 1
      if (name(last:last) == ')' .and. last > open + 1 .and. last < open + most_digits) then
         if (verify(name(open + 1:last - 1), '0123456789') == 0) read (name(open + 1:last - 1), *, iostat=status) free%member
      end if
      associate (row => r%model%variables(free%list))
         if (.not. row%is_list) then
            flaw = row%name//' is no list, given '''//show_text(name)//''', allowed: '//row%name
         else if (status /= 0 .or. free%member < 1) then
            flaw = 'no member of a list, given '''//show_text(name)//''', allowed: '//row%name//'(1), '//row%name//'(2) and so on'
         else if (.not. r%input%is_given(free%list)) then
            flaw = row%name//' is not given; of a list that is given, where the search starts, a member may be free'
         else if (row%name == 'times' .or. row%unit == '') then
            flaw = row%name//' is no quantity that data give, given '''//show_text(name)//''''
         end if
         if (len(flaw) > 0) return
         free%name = row%group//'%'//row%name//'('//show_count(free%member)//')'
         free%unit = row%unit
         free%is_log = row%lower >= 0
      end associate
   end subroutine find_member

   !> Is there such a member, and is it above 0 where its logarithm is fitted? It starts where it is given.
   subroutine check_members(r, frees, readers)
      type(reading_t), intent(in) :: r
      !> The free variables; members receive their start.
      type(free_t), intent(inout) :: frees(:)
      !> Their groups.
      type(reader_t), intent(in) :: readers(:)
      integer :: i

      do i = 1, size(frees)
         if (frees(i)%list == 0) cycle
         associate (row => r%model%variables(frees(i)%list), data => r%input%datasets(frees(i)%list))
            if (.not. allocated(data%numbers)) cycle
            if (frees(i)%member > size(data%numbers)) then
               call readers(i)%report(r, 'variable', row%name//' has '//show_count(size(data%numbers))//' values, given ' &
                  //show_count(frees(i)%member)//', allowed: 1 to '//show_count(size(data%numbers)))
            else if (.not. is_set(frees(i)%start)) then
               frees(i)%start = data%numbers(frees(i)%member)
               if (frees(i)%is_log .and. .not. frees(i)%start > 0) call readers(i)%report(r, 'variable', frees(i)%name &
                  //' starts at 0, and its logarithm is fitted, needed: a number > 0 in the list, or start')
            end if
         end associate
      end do
   end subroutine check_members

   !> Is it the name of a nuisance?
   pure logical function is_nuisance_name(model, name)
      !> The model, which may have a variable of the name.
      class(model_t), intent(in) :: model
      !> The name, in small letters.
      character(*), intent(in) :: name
      integer :: k

      is_nuisance_name = index(name, data_prefix//'%') == 1 .or. index(name, data_prefix//'[') == 1
      if (is_nuisance_name) return
      do k = 1, size(model%variables)
         ! what shifts a history belongs to the measurement
         if (model%variables(k)%name == name .and. model%variables(k)%group /= 'history') return
      end do
      do k = 1, n_nuisances
         is_nuisance_name = is_nuisance_name .or. get_word(nuisance_names, k) == name
      end do
   end function is_nuisance_name

   !> Find a nuisance by `data[2]%load_offset`; without a number that of the only data set.
   subroutine find_nuisance(name, groups, free, flaw)
      character(*), intent(in) :: name
      type(data_group_t), intent(in) :: groups(:)
      type(free_t), intent(inout) :: free
      character(:), allocatable, intent(out) :: flaw
      character(:), allocatable :: bare
      integer :: percent, status, k

      flaw = ''
      percent = index(name, '%')
      bare = name(percent + 1:)
      do k = 1, n_nuisances
         if (get_word(nuisance_names, k) == bare) free%nuisance = k
      end do
      free%data_set = 1
      status = 0
      if (index(name, '[') > 0) then
         status = 1
         if (percent > 7) then
            if (name(percent - 1:percent - 1) == ']' .and. verify(name(6:percent - 2), '0123456789') == 0 .and. percent < 15) &
               read (name(6:percent - 2), *, iostat=status) free%data_set
         end if
      end if
      if (status /= 0 .or. free%data_set < 1 .or. free%data_set > size(groups)) then
         flaw = 'no &data of this number, given '''//show_text(name)//''', allowed: data[1] to data['//show_count(size(groups))//']'
      else if (free%nuisance == 0) then
         flaw = 'unknown variable of a measurement, given '''//show_text(name)//''', allowed: '//join_words(nuisance_names, ', ') &
            //did_you_mean(bare, nuisance_names)
      else if (index(name, '[') == 0 .and. size(groups) > 1) then
         flaw = 'of which &data, given '''//show_text(name)//''', allowed: data[1]%'//bare//' to data['//show_count(size(groups)) &
            //']%'//bare
      else
         call check_nuisance(groups(free%data_set), free, flaw)
      end if
      if (len(flaw) > 0) return
      free%name = data_prefix//'['//show_count(free%data_set)//']%'//bare
      if (size(groups) == 1) free%name = bare
   end subroutine find_nuisance

   !> Has a nuisance a meaning for its data set, and is it not given? Sets its unit and scale.
   subroutine check_nuisance(group, free, flaw)
      !> The `&data` group.
      type(data_group_t), intent(in) :: group
      !> The nuisance, which receives its unit and scale.
      type(free_t), intent(inout) :: free
      !> What is wrong; empty if nothing is wrong.
      character(:), allocatable, intent(out) :: flaw

      flaw = ''
      select case (free%nuisance)
      case (nuisance_load_offset)
         free%unit = 'N'
      case (nuisance_contact_point)
         free%unit = 'm'
      case (nuisance_drift_rate)
         free%unit = 'm/s'
      case default
         ! that of an offset of the ordinate is known later
         free%unit = '-'
      case (nuisance_spring_stiffness, nuisance_tilt)
         free%unit = 'N/m'
      end select
      free%is_log = any(free%nuisance == [nuisance_lateral_gain, nuisance_spring_stiffness])
      if (group%is_nuisance_given(free%nuisance)) flaw = get_word(nuisance_names, free%nuisance)//' is given twice, here and in ' &
         //'&data, allowed: one of them'
   end subroutine check_nuisance

   !> A variable of the model is given in one index, and is no abscissa.
   subroutine check_variable(model, groups, variable, input, flaw)
      class(model_t), intent(in) :: model
      type(data_group_t), intent(in) :: groups(:)
      !> Index of the variable in the model's table.
      integer, intent(in) :: variable
      type(case_t), intent(in) :: input
      !> What is wrong; empty if nothing is wrong.
      character(:), allocatable, intent(inout) :: flaw
      integer :: i

      associate (row => model%variables(variable))
         if (row%kind /= kind_real) then
            flaw = 'no real number, it cannot be fitted, given '''//row%name//''''
         else if (row%has_steps) then
            flaw = 'it has some values alone, it cannot be fitted, given '''//row%name//''''
         else if (input%is_given(variable)) then
            flaw = row%name//' is given twice, here and in &'//row%group//' in line '//show_count(input%line(variable))// &
               ', allowed: one of them'
         end if
         do i = 1, size(groups)
            if (groups(i)%data_set%abscissa == variable) flaw = row%name//' is the abscissa of &data['//show_count(i)// &
               '], it cannot be free'
            if (any(groups(i)%data_set%others == variable)) flaw = row%name//' is a column of &data['//show_count(i)// &
               '], it cannot be free'
         end do
      end associate
   end subroutine check_variable

   !> A value for what is free, of the usual size, so that the model can be asked what it thinks of the rest.
   subroutine hold_variable(model, variable, input)
      class(model_t), intent(in) :: model
      integer, intent(in) :: variable
      !> Receives the value, and that it varies.
      type(case_t), intent(inout) :: input
      real(dp) :: lower, upper

      associate (row => model%variables(variable), value => input%values(variable))
         call find_plausible_range(row, model%unit_of(input%values, variable), lower, upper)
         value = 1
         if (lower > 0 .and. upper < huge(upper)) value = sqrt(lower)*sqrt(upper)
         if (value < row%lower .or. value > row%upper) then
            value = row%upper
            if (is_set(row%lower) .and. abs(row%lower) < unset .and. abs(row%upper) < unset) value = (row%lower + row%upper)/2
         end if
         input%is_swept(variable) = .true.
      end associate
   end subroutine hold_variable

   !> Read start, bounds, scale and prior.
   subroutine read_numbers_of(r, reader, free)
      type(reading_t), intent(in) :: r
      type(reader_t), intent(in) :: reader
      type(free_t), intent(inout) :: free
      integer :: scale

      call reader%read_number(r, 'start', free%start)
      call reader%read_number(r, 'minimum', free%minimum)
      call reader%read_number(r, 'maximum', free%maximum)
      call reader%read_number(r, 'prior', free%prior)
      call reader%read_number(r, 'prior_sigma', free%prior_sigma)
      if (reader%has(r%file, 'scale')) then
         call reader%read_whole(r, 'scale', scale)
         if (free%is_log .or. scale /= scale_log) then
            free%is_log = scale == scale_log
         else
            call reader%report(r, 'scale', free%name//' may be negative, given ''log'', allowed: ''linear''')
         end if
      end if
      call check_size(r, reader, free, 'start', free%start)
      call check_size(r, reader, free, 'minimum', free%minimum)
      call check_size(r, reader, free, 'maximum', free%maximum)
      call check_size(r, reader, free, 'prior', free%prior)
      call check_order(r, reader, free)
      if (is_set(free%prior) .neqv. is_set(free%prior_sigma)) call reader%report(r, trim(merge('prior_sigma', 'prior      ', &
         is_set(free%prior))), 'not given, needed: prior and prior_sigma together')
   end subroutine read_numbers_of

   !> Is a value one that the variable may have?
   subroutine check_size(r, reader, free, name, value)
      type(reading_t), intent(in) :: r
      type(reader_t), intent(in) :: reader
      type(free_t), intent(in) :: free
      !> Name of the value in the group.
      character(*), intent(in) :: name
      !> The value, or `unset`.
      real(dp), intent(in) :: value
      character(:), allocatable :: flaw
      integer :: first

      if (.not. is_set(value)) return
      flaw = ''
      if (free%variable > 0) call find_outlier([value], r%model%variables(free%variable), first, flaw)
      if (len(flaw) > 0) flaw = 'out of range, given '//show_number(value)//flaw(index(flaw, ', allowed'):)
      if (len(flaw) == 0 .and. free%is_log .and. .not. value > 0) flaw = 'out of range, given '//show_number(value)// &
         ', allowed: a number > 0, since its logarithm is fitted'
      if (len(flaw) > 0) call reader%report(r, name, flaw)
   end subroutine check_size

   !> Do minimum, start and maximum rise?
   subroutine check_order(r, reader, free)
      type(reading_t), intent(in) :: r
      type(reader_t), intent(in) :: reader
      type(free_t), intent(in) :: free

      if (is_set(free%minimum) .and. is_set(free%maximum)) then
         if (.not. free%minimum < free%maximum) call reader%report(r, 'maximum', 'no range, given minimum = ' &
            //show_number(free%minimum)//' and maximum = '//show_number(free%maximum)//', allowed: minimum < maximum')
      end if
      if (.not. is_set(free%start)) return
      if (is_set(free%minimum)) then
         if (free%start < free%minimum) call reader%report(r, 'start', 'below the minimum, given '//show_number(free%start) &
            //', allowed: a number >= '//show_number(free%minimum))
      end if
      if (is_set(free%maximum)) then
         if (free%start > free%maximum) call reader%report(r, 'start', 'above the maximum, given '//show_number(free%start) &
            //', allowed: a number <= '//show_number(free%maximum))
      end if
   end subroutine check_order

end module adfric_input_fit_free
