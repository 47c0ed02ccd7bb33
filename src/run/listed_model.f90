! SPDX-License-Identifier: GPL-3.0-or-later
!> A model some of whose lists vary: members of lists that are free in a fit, and histories that each `&data` has of its own. Its
!> variables are those of the inner model, then one for each member, then the number of the `&data`.
!>
!> Lists belong to a model and not to a point, so each block is solved by a copy that has the lists of its values. All points of a
!> block have the same ones, as in a fit.
module adfric_run_listed_model
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: show_count
   use adfric_base_unset, only: unset
   use adfric_base_watch, only: watch_t
   use adfric_describe_model, only: model_t
   use adfric_describe_table, only: kind_real, result_t, variable_t
   use adfric_run_wrapped_model, only: wrapped_model_t
   implicit none (type, external)
   private
   public :: list_with_members_t, own_history_t, let_lists_vary

   !> A list of the input, of which members are free.
   type :: list_with_members_t
      !> Index of the variable.
      integer :: variable = 0
      !> Its numbers in SI units.
      real(dp), allocatable :: numbers(:)
      !> Which members are free, and the indices of their variables in the listed model.
      integer, allocatable :: members(:), slots(:)
   end type list_with_members_t

   !> The history of a `&data`; not allocated: that of the scene.
   type :: own_history_t
      !> Times [s], and what is prescribed at them [m or N].
      real(dp), allocatable :: times(:), prescribed(:)
      !> Index of the variable that is prescribed.
      integer :: variable = 0
   end type own_history_t

   !> A model with lists that vary.
   type, extends(wrapped_model_t) :: listed_model_t
      !> The lists.
      type(list_with_members_t), allocatable :: lists(:)
      !> The histories, one for each `&data`.
      type(own_history_t), allocatable :: histories(:)
      !> Variables of the inner model, and indices of the times of a history and of the number of the `&data`; 0: none.
      integer :: n_inner = 0, times = 0, number = 0
      !> What is copied: the inner model, without texts where it does not need them.
      class(model_t), allocatable :: lean
   contains
      procedure :: take_dataset
      procedure :: check_values
      procedure :: solve_block
      procedure :: solve_with_slopes
      procedure :: measure
      procedure :: velocity_of_heat
      procedure :: unit_of
      procedure :: describe_results
      procedure :: obey
   end type listed_model_t

contains

   !> Let lists of a model vary.
   subroutine let_lists_vary(model, lists, histories)
      !> In: the model. Out: a model around it.
      class(model_t), allocatable, intent(inout) :: model
      !> The lists with free members; receives the indices of their variables.
      type(list_with_members_t), intent(inout) :: lists(:)
      !> The histories, one for each `&data`; not allocated times: that of the scene.
      type(own_history_t), intent(in) :: histories(:)
      type(listed_model_t), allocatable :: listed
      type(variable_t), allocatable :: rows(:)
      integer :: i, k, n

      allocate (listed)
      call listed%wrap(model)
      listed%results = listed%inner%results
      n = size(listed%inner%variables)
      listed%n_inner = n
      listed%times = listed%inner%index_of('history', 'times')
      do i = 1, size(lists)
         n = n + size(lists(i)%members)
      end do
      allocate (rows(n + 1))
      rows(:listed%n_inner) = listed%inner%variables
      n = listed%n_inner
      do i = 1, size(lists)
         allocate (lists(i)%slots(size(lists(i)%members)))
         do k = 1, size(lists(i)%members)
            n = n + 1
            rows(n) = listed%inner%variables(lists(i)%variable)
            rows(n)%name = rows(n)%name//'_'//show_count(lists(i)%members(k))
            rows(n)%kind = kind_real
            rows(n)%is_list = .false.
            rows(n)%default = unset
            lists(i)%slots(k) = n
         end do
      end do
      n = n + 1
      rows(n) = listed%inner%variables(1)
      rows(n)%group = 'history'
      rows(n)%name = 'data'
      rows(n)%kind = kind_real
      rows(n)%unit = '-'
      rows(n)%meaning = 'number of the &data with its history'
      rows(n)%is_hidden = .true.
      listed%number = n
      call move_alloc(rows, listed%variables)
      listed%lists = lists
      listed%histories = histories
      allocate (listed%lean, source=listed%inner)
      if (listed%lean%name == 'indenter_time') call strip(listed%lean)
      call move_alloc(listed, model)
   end subroutine let_lists_vary

   !> Take texts off a model that is copied often, and does not need them to be solved.
   recursive subroutine strip(model)
      class(model_t), intent(inout) :: model
      integer :: n

      n = size(model%variables)
      deallocate (model%variables)
      allocate (model%variables(n))
      n = size(model%results)
      deallocate (model%results)
      allocate (model%results(n))
      n = size(model%profiles)
      deallocate (model%profiles)
      allocate (model%profiles(n))
      select type (model)
      class is (wrapped_model_t)
         call strip(model%inner)
      end select
   end subroutine strip

   !> A copy of the inner model with the lists of these values.
   subroutine get_copy(self, values, copy)
      class(listed_model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives the copy.
      class(model_t), allocatable, intent(out) :: copy
      type(problems_t) :: unused
      real(dp), allocatable :: numbers(:)
      integer :: i, number

      allocate (copy, source=self%lean)
      allocate (numbers(0))
      do i = 1, size(self%lists)
         numbers = self%lists(i)%numbers
         numbers(self%lists(i)%members) = values(self%lists(i)%slots)
         call copy%take_dataset(self%lists(i)%variable, reshape(numbers, [size(numbers), 1]), unused)
      end do
      number = nint(values(self%number))
      if (.not. allocated(self%histories(number)%times)) return
      associate (history => self%histories(number))
         call copy%take_dataset(self%times, reshape(history%times, [size(history%times), 1]), unused)
         call copy%take_dataset(history%variable, reshape(history%prescribed, [size(history%prescribed), 1]), unused)
      end associate
   end subroutine get_copy

   !> See `model_t`: a list that all points have, until another one replaces it.
   subroutine take_dataset(self, index, values, problems)
      class(listed_model_t), intent(inout) :: self
      integer, intent(in) :: index
      real(dp), intent(in) :: values(:, :)
      type(problems_t), intent(inout) :: problems

      call self%inner%take_dataset(index, values, problems)
      call self%lean%take_dataset(index, values, problems)
   end subroutine take_dataset

   !> See `model_t`: the input has been checked before.
   subroutine check_values(self, values, is_swept, problems)
      class(listed_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      logical, intent(in) :: is_swept(:)
      type(problems_t), intent(inout) :: problems

      call self%inner%check_values(values(:self%n_inner), is_swept(:self%n_inner), problems)
   end subroutine check_values

   !> See `model_t`.
   subroutine solve_block(self, values, results, error_estimate, status, counts)
      class(listed_model_t), intent(in) :: self
      real(dp), intent(in), contiguous :: values(:, :)
      real(dp), intent(out) :: results(:, :), error_estimate(:)
      integer, intent(out) :: status(:)
      real(dp), intent(out) :: counts(:)
      class(model_t), allocatable :: copy

      call get_copy(self, values(:, 1), copy)
      call copy%solve_block(values(:self%n_inner, :), results, error_estimate, status, counts)
   end subroutine solve_block

   !> See `model_t`: a member of a list is one of the inner model's.
   subroutine solve_with_slopes(self, values, x, of, by, members, y, y_by, is_known, error_estimate, is_there)
      class(listed_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:), x(:)
      integer, intent(in) :: of, by(:), members(:)
      real(dp), intent(out) :: y(:), y_by(:, :)
      logical, intent(out) :: is_known(:)
      real(dp), intent(out) :: error_estimate
      logical, intent(out) :: is_there
      class(model_t), allocatable :: copy
      integer :: inner_by(size(by)), inner_members(size(by)), i, k, at

      inner_by = by
      inner_members = members
      do i = 1, size(self%lists)
         do k = 1, size(by)
            at = findloc(self%lists(i)%slots, by(k), 1)
            if (at == 0) cycle
            inner_by(k) = self%lists(i)%variable
            inner_members(k) = self%lists(i)%members(at)
         end do
      end do
      call get_copy(self, values, copy)
      call copy%solve_with_slopes(values(:self%n_inner), x, of, inner_by, inner_members, y, y_by, is_known, error_estimate, &
         & is_there)
   end subroutine solve_with_slopes

   !> See `model_t`.
   subroutine measure(self, values, results, measures)
      class(listed_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:), results(:)
      real(dp), intent(inout) :: measures(:)

      call self%inner%measure(values(:self%n_inner), results, measures)
   end subroutine measure

   !> See `model_t`: with the lists of these values.
   real(dp) function velocity_of_heat(self, values) result(velocity)
      class(listed_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      class(model_t), allocatable :: copy

      call get_copy(self, values, copy)
      velocity = copy%velocity_of_heat(values(:self%n_inner))
   end function velocity_of_heat

   !> See `model_t`: a member has the unit of its list.
   function unit_of(self, values, index) result(unit)
      class(listed_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      integer, intent(in) :: index
      character(:), allocatable :: unit

      unit = self%variables(index)%unit
      if (index <= self%n_inner) unit = self%inner%unit_of(values(:self%n_inner), index)
   end function unit_of

   !> See `model_t`.
   function describe_results(self, values) result(results)
      class(listed_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(result_t), allocatable :: results(:)

      allocate (results, source=self%inner%describe_results(values(:self%n_inner)))
   end function describe_results

   !> See `model_t`.
   subroutine obey(self, watch)
      class(listed_model_t), intent(inout) :: self
      class(watch_t), pointer, intent(in) :: watch

      self%watch => watch
      call self%inner%obey(watch)
      call self%lean%obey(watch)
   end subroutine obey

end module adfric_run_listed_model
