! SPDX-License-Identifier: GPL-3.0-or-later
!> What a solved simulation gives back beside its results at all points: one number, and what a fit has beside.
module adfric_api_numbers
   use adfric_api_results, only: find_result
   use adfric_base_error, only: error_t
   use adfric_base_kinds, only: dp
   use adfric_base_text, only: to_lower
   use adfric_base_words, only: count_words
   use adfric_describe_model, only: model_t
   use adfric_describe_table, only: extra_t
   use adfric_run_memory_sink, only: memory_sink_t
   implicit none (type, external)
   private
   public :: find_number, find_extra

contains

   !> A result of the first point.
   subroutine find_number(model, found, name, value, error)
      !> The model, whose table of results is searched.
      class(model_t), intent(in) :: model
      !> What was found.
      type(memory_sink_t), intent(in) :: found
      !> Name of the result.
      character(*), intent(in) :: name
      !> Receives its value; of a state its number.
      real(dp), intent(out) :: value
      !> Allocated if there is no such result.
      type(error_t), allocatable, intent(out) :: error
      real(dp), allocatable :: values(:)
      integer :: i

      ! one name after the other, since a list of all takes longer
      do i = 1, size(model%results)
         if (model%results(i)%name /= name) cycle
         value = found%results(1, i)
         return
      end do
      call find_result(model, found, name, values, error)
      if (.not. allocated(error)) value = values(1)
   end subroutine find_number

   !> What a solved fit has beside its results; words are numbered from 1.
   subroutine find_extra(model, name, values)
      !> The model, solved.
      class(model_t), intent(in) :: model
      !> Name of what is wanted.
      character(*), intent(in) :: name
      !> Receives its values, the last dimension fastest; not allocated if there is nothing of that name.
      real(dp), allocatable, intent(out) :: values(:)
      type(extra_t), allocatable :: extras(:)
      integer :: i, k

      call model%get_extras(extras)
      do i = 1, size(extras)
         if (extras(i)%name /= to_lower(trim(adjustl(name)))) cycle
         if (allocated(extras(i)%words)) then
            values = [(real(k, dp), k=1, count_words(extras(i)%words))]
         else
            values = extras(i)%values
         end if
      end do
   end subroutine find_extra

end module adfric_api_numbers
