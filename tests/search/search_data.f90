! SPDX-License-Identifier: GPL-3.0-or-later
!> Random datasets for models that take them from files.
module search_data
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_base_problems, only: problems_t
   use adfric_base_words, only: get_word
   use adfric_describe_model, only: model_t
   use adfric_describe_table, only: variable_t, kind_dataset
   use random_dice, only: dice_t
   use search_units, only: dimensions_of
   implicit none (type, external)
   private
   public :: drawn_data_t, draw_data, give_data, rescale_data, data_text

   !> Numbers of values along a dimension: that halve and that do not.
   integer, parameter :: counts(*) = [4, 5, 8, 12, 16, 17, 32]
   !> Shares of lines among surfaces, of datasets far from 0, and how far [their size].
   real(dp), parameter :: share_of_lines = 0.3_dp, share_far = 0.2_dp, how_far = 1.0e3_dp
   character(*), parameter :: newline = achar(10)

   !> A dataset.
   type :: drawn_data_t
      !> Position of its variable.
      integer :: position = 0
      !> Shape `(nx, ny)`.
      real(dp), allocatable :: values(:, :)
   end type drawn_data_t

contains

   !> Draw a dataset for each variable that can have one, and give them to the model.
   subroutine draw_data(model, dice, logarithm, list, is_taken)
      class(model_t), intent(inout) :: model
      type(dice_t), intent(inout) :: dice
      !> Decimal logarithms of Pa, m and s that fit together.
      real(dp), intent(in) :: logarithm(:)
      type(drawn_data_t), allocatable, intent(out) :: list(:)
      !> Does the model accept all of them?
      logical, intent(out) :: is_taken
      integer :: j, k, n, which, n_x, n_y, left_out
      logical :: is_line

      ! a map is that of the cells of given heights
      left_out = 0
      if (model%index_of('surface', 'heights') == 0) left_out = model%index_of('adhesion', 'work_map')
      allocate (list(count(model%variables%kind == kind_dataset) - merge(1, 0, left_out > 0)))
      ! lists that belong together have as many values
      call dice%choose(size(counts), which)
      n_x = counts(which)
      n = 0
      do k = 1, size(model%variables)
         associate (v => model%variables(k))
            if (v%kind /= kind_dataset .or. k == left_out) cycle
            n = n + 1
            list(n)%position = k
            n_y = 1
            call dice%happens(share_of_lines, is_line)
            call dice%choose(size(counts), which)
            if (v%largest_rank > 1 .and. .not. is_line) n_y = counts(which)
            if (v%n_columns() > 0) n_y = v%n_columns()
            if (v%name == 'work_map') then
               allocate (list(n)%values, mold=list(1)%values)
            else
               allocate (list(n)%values(min(n_x, v%most_count), n_y))
            end if
            if (v%name == 'tension_table') then
               call draw_law(dice, list(n)%values)
            else
               call draw_shape(v, dice, list(n)%values)
            end if
            if (.not. v%lower < 0) list(n)%values = abs(list(n)%values)
            if (v%lower > 0 .or. (v%lower_open .and. .not. v%lower < 0)) list(n)%values = list(n)%values + 1
            do j = 1, size(list(n)%values, 2)
               list(n)%values(:, j) = list(n)%values(:, j) &
                  *10.0_dp**max(-60.0_dp, min(60.0_dp, dot_product(logarithm, dimensions_of(unit_of_column(v, j)))))
            end do
         end associate
      end do
      call give_data(model, list, is_taken)
      ! an input is refused beyond the range of a list
      do n = 1, size(list)
         associate (v => model%variables(list(n)%position))
            if (any(list(n)%values < v%lower .or. list(n)%values > v%upper)) is_taken = .false.
         end associate
      end do
   end subroutine draw_data

   !> Values of a size of 1.
   subroutine draw_shape(v, dice, values)
      type(variable_t), intent(in) :: v
      type(dice_t), intent(inout) :: dice
      real(dp), intent(out) :: values(:, :)
      integer :: i, j, kind, number
      logical :: is_far

      call dice%choose(5, kind)
      if (v%name == 'positions') kind = 0
      do j = 1, size(values, 2)
         do i = 1, size(values, 1)
            select case (kind)
            case (0)
               call dice%decades(-2.0_dp, 0.0_dp, values(i, j))
            case (1)
               call dice%between(0.0_dp, 1.0_dp, values(i, j))
            case (2)
               ! one value apart from the others
               values(i, j) = merge(1.0_dp, 0.0_dp, i == 2 .and. j == 1)
            case (3)
               values(i, j) = cos(two_pi*(i - 0.5_dp)/size(values, 1)) + cos(two_pi*(j - 0.5_dp)/size(values, 2))
            case (4)
               ! few different values
               call dice%choose(3, number)
               values(i, j) = number
            case default
               ! a jump where the period ends
               values(i, j) = i + 0.1_dp*j
            end select
         end do
      end do
      if (kind == 0) then
         ! rising, in steps that differ
         do i = 2, size(values, 1)
            values(i, :) = values(i, :) + values(i - 1, :)
         end do
      end if
      call dice%happens(share_far, is_far)
      if (is_far) values = values + how_far
   end subroutine draw_shape

   !> A law of attraction: gaps that rise from 0, and tensions that fall to 0.
   subroutine draw_law(dice, values)
      type(dice_t), intent(inout) :: dice
      !> Receives gaps and tensions; shape `(n, 2)`.
      real(dp), intent(out) :: values(:, :)
      real(dp) :: steps(2)
      integer :: i, n

      n = size(values, 1)
      values = 0
      do i = 2, n
         call dice%decades(-2.0_dp, 0.0_dp, steps(1))
         call dice%decades(-2.0_dp, 0.0_dp, steps(2))
         values(i, 1) = values(i - 1, 1) + steps(1)
         values(n + 1 - i, 2) = values(n + 2 - i, 2) + steps(2)
      end do
   end subroutine draw_law

   !> Give datasets to a model.
   subroutine give_data(model, list, is_taken)
      class(model_t), intent(inout) :: model
      type(drawn_data_t), intent(in) :: list(:)
      !> Does the model accept all of them?
      logical, intent(out) :: is_taken
      type(problems_t) :: problems
      integer :: k

      do k = 1, size(list)
         call model%take_dataset(list(k)%position, list(k)%values, problems)
      end do
      is_taken = problems%count() == 0
   end subroutine give_data

   !> The same in other units.
   subroutine rescale_data(model, powers, list)
      class(model_t), intent(in) :: model
      !> Of two, for Pa, m, s.
      real(dp), intent(in) :: powers(:)
      type(drawn_data_t), intent(inout) :: list(:)
      integer :: j, k

      do k = 1, size(list)
         do j = 1, size(list(k)%values, 2)
            list(k)%values(:, j) = list(k)%values(:, j) &
               *2.0_dp**dot_product(powers, dimensions_of(unit_of_column(model%variables(list(k)%position), j)))
         end do
      end do
   end subroutine rescale_data

   !> Unit of the values that stand side by side in a dataset.
   function unit_of_column(v, j) result(unit)
      type(variable_t), intent(in) :: v
      !> Position of the column, from 1; it counts where the variable names a group alone.
      integer, intent(in) :: j
      character(:), allocatable :: unit

      unit = v%unit
      if (v%n_columns() > 0) unit = get_word(v%column_units, j)
   end function unit_of_column

   !> What stands in the datasets, as comments of an input.
   function data_text(model, list) result(text)
      class(model_t), intent(in) :: model
      type(drawn_data_t), intent(in) :: list(:)
      character(:), allocatable :: text
      character(32) :: buffer
      integer :: k, i, j

      text = ''
      do k = 1, size(list)
         associate (values => list(k)%values)
            do j = 1, size(values, 2)
               text = text//'! '//model%variables(list(k)%position)%name//':'
               do i = 1, size(values, 1)
                  write (buffer, '(es24.16e3)') values(i, j)
                  text = text//' '//trim(adjustl(buffer))
               end do
               text = text//newline
            end do
         end associate
      end do
   end function data_text

end module search_data
