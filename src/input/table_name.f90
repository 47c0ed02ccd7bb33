! SPDX-License-Identifier: GPL-3.0-or-later
!> Names of tables of text, and of their columns: `FILE.csv` and `FILE.csv:COLUMN`.
module adfric_input_table_name
   use adfric_base_text, only: to_lower
   use adfric_base_words, only: has_word
   implicit none (type, external)
   private
   public :: is_table_name, find_column_name

   !> How names of tables end.
   character(*), parameter :: endings = '.csv .tsv .txt .dat .asc'

contains

   !> Is it the name of a table?
   pure logical function is_table_name(name)
      !> Name of a file.
      character(*), intent(in) :: name
      integer :: dot

      dot = index(name, '.', back=.true.)
      is_table_name = .false.
      if (dot > 1) is_table_name = has_word(endings, to_lower(name(dot:)))
   end function is_table_name

   !> Position of the colon between a table and its column; 0 if there is none.
   pure integer function find_column_name(name) result(colon)
      !> Name of a table with that of a column, or of something else.
      character(*), intent(in) :: name

      do colon = 2, len(name)
         if (name(colon:colon) /= ':') cycle
         if (is_table_name(name(:colon - 1))) return
      end do
      colon = 0
   end function find_column_name

end module adfric_input_table_name
