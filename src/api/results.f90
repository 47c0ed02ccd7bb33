! SPDX-License-Identifier: GPL-3.0-or-later
!> What a solved simulation gives back by name.
module adfric_api_results
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use adfric_base_error, only: error_t, input_failure, set_error
   use adfric_base_kinds, only: dp, i8
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: join_words, name_length, show_count, show_text, to_lower
   use adfric_base_words, only: count_words, get_word
   use adfric_input_case, only: case_t
   use adfric_input_suggestion, only: did_you_mean
   use adfric_input_vocabulary, only: full_name
   use adfric_describe_model, only: model_t
   use adfric_describe_table, only: extra_t, kind_choice, profile_t, profile_axis_t, result_t, results_of_every_run
   use adfric_run_memory_sink, only: memory_sink_t
   implicit none (type, external)
   private
   public :: find_result, find_axis, find_profile, describe_name, list_of, refuse

   !> `call find_result(model, found, name, values, error)`, by the type of the values.
   interface find_result
      module procedure find_real_result
      module procedure find_states
   end interface find_result

   !> What there are lists of.
   character(*), parameter :: lists = 'variables results profiles axes extras'

contains

   !> A result of every point.
   subroutine find_real_result(model, found, name, values, error)
      !> The model, whose table of results is searched.
      class(model_t), intent(in) :: model
      !> What was found.
      type(memory_sink_t), intent(in) :: found
      !> Name of the result.
      character(*), intent(in) :: name
      !> Receives the values; shape `(n_points)`.
      real(dp), allocatable, intent(out) :: values(:)
      !> Allocated if there is no such result.
      type(error_t), allocatable, intent(out) :: error
      integer :: index

      select case (plain(name))
      case ('error_estimate')
         values = found%error_estimate
      case ('status')
         values = real(found%status, dp)
      case default
         index = index_in(names_of(model, 'results'), name)
         if (index > 0) then
            values = found%results(:, index)
         else
            call refuse(name, 'result', names_of(model, 'results')//' '//model%profile_axes, error)
         end if
      end select
   end subroutine find_real_result

   !> A result of every point that is one of several states.
   subroutine find_states(model, found, name, values, error)
      class(model_t), intent(in) :: model
      type(memory_sink_t), intent(in) :: found
      character(*), intent(in) :: name
      !> Receives the numbers of the states, -1 where there is none; shape `(n_points)`.
      integer, allocatable, intent(out) :: values(:)
      !> Allocated if there is no such result, or it has no states.
      type(error_t), allocatable, intent(out) :: error
      character(:), allocatable :: with_states
      integer :: i, index

      if (plain(name) == 'status') then
         values = found%status
         return
      end if
      index = index_in(names_of(model, 'results'), name)
      ! the error estimate stands behind those of the table
      if (index > size(model%results)) index = 0
      if (index > 0) then
         if (model%results(index)%n_states() == 0) index = 0
      end if
      if (index > 0) then
         allocate (values(size(found%status)), source=-1)
         do i = 1, size(values)
            if (ieee_is_finite(found%results(i, index))) values(i) = nint(found%results(i, index))
         end do
      else
         with_states = 'status'
         do i = 1, size(model%results)
            if (model%results(i)%n_states() > 0) with_states = with_states//' '//model%results(i)%name
         end do
         call refuse(name, 'result with states', with_states, error)
      end if
   end subroutine find_states

   !> Index of an axis of the profiles; 0 if there is none of that name.
   integer function find_axis(model, name) result(axis)
      !> The model, whose axes are searched.
      class(model_t), intent(in) :: model
      !> Name of the axis.
      character(*), intent(in) :: name

      axis = index_in(names_of(model, 'axes'), name)
   end function find_axis

   !> A profile of a point.
   subroutine find_profile(model, found, name, point, values, error)
      !> The model, whose table of profiles is searched.
      class(model_t), intent(in) :: model
      !> What was found.
      type(memory_sink_t), intent(in) :: found
      !> Name of the profile.
      character(*), intent(in) :: name
      !> Number of the point, from 1.
      integer(i8), intent(in) :: point
      !> Receives the profile; shape `(n_last_axis, n_first_axis)`.
      real(dp), allocatable, intent(out) :: values(:, :)
      !> Allocated if there is no such profile or point, or profiles were not asked for.
      type(error_t), allocatable, intent(out) :: error
      integer :: index

      index = index_in(names_of(model, 'profiles'), name)
      if (index == 0) then
         call refuse(name, 'profile', names_of(model, 'profiles'), error)
      else if (size(found%profiles) == 0) then
         call set_error(error, input_failure, '&output profiles: is .false., needed for a profile: .true.')
      else if (index > size(found%profiles, 3)) then
         call refuse(name, 'profile of this case', first_words(names_of(model, 'profiles'), size(found%profiles, 3)), error)
      else if (point < 1 .or. point > size(found%status, kind=i8)) then
         call set_error(error, input_failure, 'there is no point '//show_count(point)//', allowed: 1 to '// &
            & show_count(size(found%status, kind=i8)))
      else
         values = found%profiles(:, :, index, point)
      end if
   end subroutine find_profile

   !> What a result, a profile, an axis or a variable is.
   subroutine describe_name(model, input, name, unit, long_name, words, error)
      !> The model, whose tables are searched.
      class(model_t), intent(in) :: model
      !> Values of the variables; units may depend on them.
      type(case_t), intent(in) :: input
      !> Name of the result, profile, axis or variable.
      character(*), intent(in) :: name
      !> Receives the unit.
      character(:), allocatable, intent(out) :: unit
      !> Receives a few words.
      character(:), allocatable, intent(out) :: long_name
      !> Receives the states or words, separated by a blank; empty if there are none.
      character(:), allocatable, intent(out) :: words
      !> Allocated if there is no such name.
      type(error_t), allocatable, intent(out) :: error
      type(profile_t), allocatable :: profiles(:)
      type(problems_t) :: problems
      logical :: is_complete
      integer :: index

      ! units that depend on values that are missing are those of the table
      call model%check_values(input%values, input%is_swept, problems)
      is_complete = problems%count() == 0
      words = ''
      index = index_in(names_of(model, 'results'), name)
      if (index > 0) then
         call describe_result(model, input, index, is_complete, unit, long_name, words)
      else if (index_in(names_of(model, 'profiles'), name) > 0) then
         allocate (profiles, source=model%profiles)
         index = index_in(names_of(model, 'profiles'), name)
         if (index > model%count_profiles(input%values)) is_complete = .false.
         if (is_complete) profiles = model%describe_profiles(input%values)
         unit = profiles(index)%unit
         long_name = profiles(index)%long_name
      else if (find_axis(model, name) > 0) then
         call describe_axis(model, input, find_axis(model, name), is_complete, unit, long_name)
      else
         index = index_in(names_of(model, 'variables'), name)
         if (index == 0) call refuse(name, 'name', names_of(model, 'results')//' '//names_of(model, 'profiles')//' '// &
            & names_of(model, 'axes')//' '//names_of(model, 'variables'), error)
         if (index == 0) return
         unit = model%variables(index)%unit
         if (is_complete) unit = model%unit_of(input%values, index)
         long_name = model%variables(index)%meaning
         if (model%variables(index)%kind == kind_choice) words = model%variables(index)%choices
      end if
   end subroutine describe_name

   !> What a result is.
   subroutine describe_result(model, input, index, is_complete, unit, long_name, states)
      !> The model, which describes its results.
      class(model_t), intent(in) :: model
      type(case_t), intent(in) :: input
      !> Index of the result, from 1; those that every model has stand behind the others.
      integer, intent(in) :: index
      !> Do the values describe a case, on which units may depend?
      logical, intent(in) :: is_complete
      character(:), allocatable, intent(out) :: unit, long_name
      !> Receives the names of the states, separated by a blank; empty if there are none.
      character(:), allocatable, intent(out) :: states
      type(result_t), allocatable :: results(:)
      type(result_t) :: found

      if (index > size(model%results)) then
         allocate (results, source=results_of_every_run())
         found = results(index - size(model%results))
      else if (is_complete) then
         allocate (results, source=model%describe_results(input%values))
         found = results(index)
      else
         found = model%results(index)
      end if
      unit = found%unit
      long_name = found%long_name
      states = ''
      if (allocated(found%flag_meanings)) states = found%flag_meanings
   end subroutine describe_result

   !> What an axis is.
   subroutine describe_axis(model, input, axis, is_complete, unit, long_name)
      class(model_t), intent(in) :: model
      type(case_t), intent(in) :: input
      !> Index of the axis, from 1.
      integer, intent(in) :: axis
      logical, intent(in) :: is_complete
      !> Receives the unit; empty if the values are needed for it.
      character(:), allocatable, intent(out) :: unit
      character(:), allocatable, intent(out) :: long_name
      type(profile_axis_t), allocatable :: axes(:)

      unit = ''
      long_name = 'coordinate '//get_word(model%profile_axes, axis)//' of the profiles'
      if (.not. is_complete) return
      call model%get_profile_axes(input%values, axes)
      if (axis > size(axes)) return
      unit = axes(axis)%unit
      long_name = axes(axis)%long_name
   end subroutine describe_axis

   !> A list of names.
   subroutine list_of(model, input, what, names, error)
      !> The model, whose tables have the names.
      class(model_t), intent(in) :: model
      !> Values of the variables; a case may have fewer profiles than the table.
      type(case_t), intent(in) :: input
      !> One of `lists`.
      character(*), intent(in) :: what
      !> Receives the names.
      character(name_length), allocatable, intent(out) :: names(:)
      !> Allocated if there is no such list.
      type(error_t), allocatable, intent(out) :: error
      character(:), allocatable :: words
      integer :: i

      if (index_in(lists, what) == 0) then
         call refuse(what, 'list', lists, error)
         return
      end if
      words = names_of(model, plain(what))
      if (plain(what) == 'profiles') words = first_words(words, model%count_profiles(input%values))
      allocate (names(count_words(words)))
      do i = 1, size(names)
         names(i) = get_word(words, i)
      end do
   end subroutine list_of

   !> Names of what a model has, separated by a blank.
   function names_of(model, what) result(words)
      class(model_t), intent(in) :: model
      character(*), intent(in) :: what
      character(:), allocatable :: words
      type(extra_t), allocatable :: extras(:)
      integer :: i

      words = ''
      select case (what)
      case ('variables')
         do i = 1, size(model%variables)
            words = words//' '//full_name(model, i)
         end do
      case ('results')
         do i = 1, size(model%results)
            words = words//' '//model%results(i)%name
         end do
         words = words//' error_estimate status'
      case ('profiles')
         do i = 1, size(model%profiles)
            words = words//' '//model%profiles(i)%name
         end do
      case ('extras')
         call model%get_extras(extras)
         do i = 1, size(extras)
            words = words//' '//extras(i)%name
         end do
      case default
         words = model%profile_axes
      end select
   end function names_of

   !> The first words of a list.
   pure function first_words(words, n) result(first)
      character(*), intent(in) :: words
      !> How many are wanted.
      integer, intent(in) :: n
      character(:), allocatable :: first
      integer :: i

      first = ''
      do i = 1, n
         first = first//' '//get_word(words, i)
      end do
   end function first_words

   !> Index of a name in a list; 0 if it is not there. Capitals, and blanks at its end, do not count.
   pure integer function index_in(words, name) result(index)
      !> Names, separated by a blank.
      character(*), intent(in) :: words
      !> The name that is looked for.
      character(*), intent(in) :: name

      do index = count_words(words), 1, -1
         if (get_word(words, index) == plain(name)) return
      end do
   end function index_in

   !> A name as the tables have it.
   pure function plain(name)
      !> The name, with any capitals.
      character(*), intent(in) :: name
      character(:), allocatable :: plain

      plain = to_lower(trim(adjustl(name)))
   end function plain

   !> Say that there is no such name.
   pure subroutine refuse(name, what, allowed, error)
      !> The name that is not known.
      character(*), intent(in) :: name
      !> What it should have named.
      character(*), intent(in) :: what
      !> Names that are known, separated by a blank.
      character(*), intent(in) :: allowed
      !> Receives the error.
      type(error_t), allocatable, intent(out) :: error

      call set_error(error, input_failure, 'unknown '//what//', given '''//show_text(trim(name))//''', allowed: '// &
         & join_words(allowed, ', ')//did_you_mean(trim(name), allowed))
   end subroutine refuse

end module adfric_api_results
