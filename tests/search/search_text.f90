! SPDX-License-Identifier: GPL-3.0-or-later
!> A drawn case as an input that `adfric run` repeats, to every digit.
module search_text
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: is_set
   use adfric_base_words, only: get_word
   use adfric_describe_model, only: model_t
   use adfric_describe_table, only: variable_t, kind_real, kind_integer, kind_logical, kind_choice, kind_dataset
   use adfric_describe_word_sets, only: show_words
   use search_data, only: data_text
   use search_draw, only: drawn_case_t
   implicit none (type, external)
   private
   public :: input_of

   character(*), parameter :: newline = achar(10)

contains

   !> The whole input; the points are those of one sweep.
   function input_of(model, drawn) result(text)
      class(model_t), intent(in) :: model
      type(drawn_case_t), intent(in) :: drawn
      character(:), allocatable :: text
      character(:), allocatable :: group, list
      integer :: k

      text = '&job model = '''//model%name//''' /'//newline
      group = ''
      do k = 1, size(model%variables)
         associate (v => model%variables(k))
            if (k == drawn%swept .or. .not. is_set(drawn%values(k, 1))) cycle
            if (.not. abs(drawn%values(k, 1) - v%default) > 0) cycle
            if (v%group /= group) then
               if (len(group) > 0) text = text//'/'//newline
               text = text//'&'//v%group//newline
               group = v%group
            end if
            text = text//'  '//v%name//' = '//value_text(v, drawn%values(k, 1))//newline
         end associate
      end do
      if (len(group) > 0) text = text//'/'//newline
      associate (v => model%variables(drawn%swept))
         list = ''
         do k = 1, size(drawn%values, 2)
            list = list//' '//value_text(v, drawn%values(drawn%swept, k))
         end do
         text = text//data_text(model, drawn%data)
         text = text//'&sweep variable = '''//v%group//'%'//v%name//''', values ='//list//' /'//newline
      end associate
   end function input_of

   function value_text(v, value) result(text)
      type(variable_t), intent(in) :: v
      real(dp), intent(in) :: value
      character(:), allocatable :: text
      character(32) :: buffer

      select case (v%kind)
      case (kind_choice)
         if (v%takes_several) then
            text = show_words(v%choices, value, '''', ', ')
         else
            text = ''''//get_word(v%choices, nint(value))//''''
         end if
      case (kind_dataset)
         ! its values stand in comments
         text = '''drawn.h5:/'//v%name//''''
      case (kind_logical)
         text = merge('.true. ', '.false.', value > 0)
      case (kind_integer)
         write (buffer, '(i0)') nint(value)
         text = trim(buffer)
      case default
         write (buffer, '(es24.16e3)') value
         text = trim(adjustl(buffer))
      end select
   end function value_text

end module search_text
