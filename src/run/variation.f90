! SPDX-License-Identifier: GPL-3.0-or-later
!> What a run wants to know of its results beside them: how they change with variables, and how the errors of variables make them
!> uncertain. Rows of results for it.
module adfric_run_variation
   use adfric_base_kinds, only: dp
   use adfric_base_text, only: show_count
   use adfric_base_units, only: quotient_unit
   use adfric_base_words, only: has_word
   use adfric_describe_table, only: result_t, variable_t
   implicit none (type, external)
   private
   public :: variation_t, uncertainty_t, new_rows, n_statistics

   !> Results of the samples of a point for each result.
   integer, parameter :: n_statistics = 5
   character(*), parameter :: statistic_endings(n_statistics) = [character(10) :: '_mean', '_deviation', '_low', '_median', '_high']
   character(*), parameter :: statistic_meanings(n_statistics) = [character(36) :: 'mean of the samples', &
      & 'standard deviation of the samples', 'quantile 0.025 of the samples', 'median of the samples', &
      & 'quantile 0.975 of the samples']

   !> The standard error of a variable: the root of the sum of the squares of both parts.
   type :: uncertainty_t
      !> Index of the variable in the model's table, from 1.
      integer :: variable = 0
      !> Absolute part, in the SI unit of the variable.
      real(dp) :: error = 0
      !> Relative part [-].
      real(dp) :: relative_error = 0
   end type uncertainty_t

   !> What is wanted.
   type :: variation_t
      !> Indices of the variables by which the results are differentiated.
      integer, allocatable :: derivatives(:)
      !> Variables that have an error.
      type(uncertainty_t), allocatable :: uncertain(:)
      !> Number of samples of each point; 0: none.
      integer :: n_samples = 0
      !> Which sample of all.
      integer :: seed = 1
   contains
      procedure :: is_wanted
      procedure :: describe
   end type variation_t

contains

   !> Is anything wanted?
   pure logical function is_wanted(self)
      class(variation_t), intent(in) :: self

      is_wanted = .false.
      if (allocated(self%derivatives)) is_wanted = size(self%derivatives) > 0
      if (allocated(self%uncertain)) is_wanted = is_wanted .or. size(self%uncertain) > 0
   end function is_wanted

   !> Rows of the results that come behind those of the model: for each variable the derivatives of all numbers among them, then the
   !> errors, then the statistics of the samples, and the share of samples that are solved.
   subroutine new_rows(wanted, variables, units, numbers, taken, rows)
      type(variation_t), intent(in) :: wanted
      type(variable_t), intent(in) :: variables(:)
      !> Unit of each variable by which the results are differentiated.
      type(result_t), intent(in) :: units(:)
      type(result_t), intent(in) :: numbers(:)
      !> Names of all results of the model, separated by a blank. One that has `NAME_error` gets `NAME_standard_error` beside it.
      character(*), intent(in) :: taken
      type(result_t), allocatable, intent(out) :: rows(:)
      character(:), allocatable :: name
      integer :: i, k, n

      n = size(numbers)*(size(wanted%derivatives) + merge(1, 0, size(wanted%uncertain) > 0)) &
         & + merge(size(numbers)*n_statistics + 1, 0, wanted%n_samples > 0)
      allocate (rows(n))
      n = 0
      do k = 1, size(wanted%derivatives)
         name = name_of(variables, wanted%derivatives(k))
         do i = 1, size(numbers)
            call put_row(rows, n, numbers(i)%name//'_by_'//name, quotient_unit(numbers(i)%unit, units(k)%unit), &
               & 'derivative of '//numbers(i)%name//' by '//name)
         end do
      end do
      if (size(wanted%uncertain) > 0) then
         do i = 1, size(numbers)
            name = numbers(i)%name//'_error'
            if (has_word(taken, name)) name = numbers(i)%name//'_standard_error'
            call put_row(rows, n, name, numbers(i)%unit, 'standard error of '//numbers(i)%name)
         end do
      end if
      if (wanted%n_samples == 0) return
      do i = 1, size(numbers)
         do k = 1, n_statistics
            call put_row(rows, n, numbers(i)%name//trim(statistic_endings(k)), numbers(i)%unit, &
               & numbers(i)%name//', '//trim(statistic_meanings(k)))
         end do
      end do
      call put_row(rows, n, 'sampled_fraction', '-', 'share of the samples of a point that are solved')
   end subroutine new_rows

   !> Set the next row.
   subroutine put_row(rows, n, name, unit, long_name)
      type(result_t), intent(inout) :: rows(:)
      !> Number of rows that are set; it grows by one.
      integer, intent(inout) :: n
      !> Name, unit and meaning of the result.
      character(*), intent(in) :: name, unit, long_name

      n = n + 1
      rows(n)%name = name
      rows(n)%unit = unit
      rows(n)%long_name = long_name
      rows(n)%flag_meanings = ''
   end subroutine put_row

   !> Name of a variable, with its group where others share it.
   function name_of(variables, index) result(name)
      type(variable_t), intent(in) :: variables(:)
      !> Index of the variable, from 1.
      integer, intent(in) :: index
      character(:), allocatable :: name
      integer :: i, n_same

      n_same = 0
      do i = 1, size(variables)
         if (variables(i)%name == variables(index)%name) n_same = n_same + 1
      end do
      name = variables(index)%name
      if (n_same > 1) name = variables(index)%group//'_'//name
   end function name_of

   !> What is wanted, in words, for a check: nothing if nothing is.
   function describe(self, variables) result(text)
      class(variation_t), intent(in) :: self
      !> Table of the variables of the model.
      type(variable_t), intent(in) :: variables(:)
      character(:), allocatable :: text
      integer :: k

      text = ''
      do k = 1, size(self%derivatives)
         if (k == 1) text = text//'derivatives by '
         if (k > 1) text = text//', '
         text = text//name_of(variables, self%derivatives(k))
      end do
      do k = 1, size(self%uncertain)
         if (k == 1 .and. len(text) > 0) text = text//'; '
         if (k == 1) text = text//'errors from those of '
         if (k > 1) text = text//', '
         text = text//name_of(variables, self%uncertain(k)%variable)
      end do
      if (self%n_samples > 0) text = text//', '//show_count(self%n_samples)//' samples of each point'
   end function describe

end module adfric_run_variation
