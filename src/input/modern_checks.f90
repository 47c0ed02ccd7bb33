! SPDX-License-Identifier: GPL-3.0-or-later
!> What an input that names a model says and a scene cannot.
module adfric_input_modern_checks
   use adfric_base_text, only: strip
   use adfric_base_words, only: has_word
   use adfric_input_literal, only: convert
   use adfric_input_modern_values, only: are_numbers, index_of_assigned, is_converted, names_in_scene, swept_variable
   use adfric_input_reading, only: reading_t
   use adfric_describe_model, only: model_t
   use adfric_run_converted_model, only: converted_model_t
   implicit none (type, external)
   private
   public :: count_samples, check_ordinates, check_rest

contains

   !> Tell a solver that converts spacings how many samples the heights have.
   subroutine count_samples(counts, r, new)
      !> Number of samples along x and y; 0 where it is not known.
      integer, intent(in) :: counts(2)
      type(reading_t), intent(in) :: r
      !> The solver, in the language of scenes.
      class(model_t), intent(inout) :: new
      integer :: group

      select type (new)
      class is (converted_model_t)
         new%scene_values%n_x = counts(1)
         new%scene_values%n_y = counts(2)
      end select
      group = r%file%find_group('surface')
      if (counts(1) > 0 .or. group == 0) return
      if (r%file%find_assignment(group, 'spacing') > 0) call r%report(group, 'spacing', &
         'is a length of all samples in a scene, and their number is not known; put the file of the heights in its at')
   end subroutine count_samples

   !> What cannot be written as a scene is said: variables that it does not have, columns of tables by the names of the model, and
   !> numbers of converted variables but for those of sweeps.
   subroutine check_rest(r, old, new, is_left_out)
      type(reading_t), intent(in) :: r
      class(model_t), intent(in) :: old, new
      !> Is the assignment left out? Shape `(n_assignments)`.
      logical, intent(in) :: is_left_out(:)
      character(:), allocatable :: group, name, words
      integer :: i, at

      group = ''
      name = ''
      words = ''
      do i = 1, size(r%file%assignments)
         group = trim(r%file%groups(r%file%assignments(i)%group)%name)
         name = trim(r%file%assignments(i)%name)
         at = index_of_assigned(r%file, i, old)
         if (at > 0) then
            if (new%variables(at)%is_hidden .and. .not. is_left_out(i)) call r%report(r%file%assignments(i)%group, name, &
               'has no place in this scene, or another variable has it; write the scene by hand')
         else if (group == 'cases' .and. name == 'variables') then
            words = names_in_scene(strip(r%file%value_of(i)), old, new)
            if (words /= strip(r%file%value_of(i))) call r%report(r%file%assignments(i)%group, name, 'are '//words &
               //' in a scene; rename the columns of the table first')
         else if (has_word('uncertain free', group) .and. name == 'variable') then
            if (is_converted(new, swept_variable(r%file, r%file%assignments(i)%group, old))) &
               call r%report(r%file%assignments(i)%group, name, 'is counted otherwise in a scene; write this group by hand')
         else if (has_word('sweep range', group) .and. has_word('from to values', name)) then
            if (is_converted(new, swept_variable(r%file, r%file%assignments(i)%group, old)) &
               .and. .not. are_numbers(strip(r%file%value_of(i)))) call r%report(r%file%assignments(i)%group, name, &
               'are counted otherwise in a scene; write them as plain numbers')
         end if
      end do
   end subroutine check_rest

   !> Data of what a scene counts over the nominal area have to be divided by it first.
   subroutine check_ordinates(r, old, new)
      type(reading_t), intent(in) :: r
      class(model_t), intent(in) :: old, new
      character(:), allocatable :: word, flaw
      integer :: i, k

      select type (new)
      class is (converted_model_t)
         do i = 1, size(r%file%assignments)
            if (r%file%assignments(i)%name /= 'ordinate') cycle
            call convert(strip(r%file%value_of(i)), word, flaw)
            if (len(flaw) > 0) cycle
            do k = 1, size(old%results)
               if (old%results(k)%name == word .and. new%is_of_period(k)) call r%report(r%file%assignments(i)%group, 'ordinate', &
                  'is '//new%results(k)%name//' over the nominal area ['//new%results(k)%unit &
                  //'] in a scene; divide the data by the size of a period first')
            end do
         end do
      end select
   end subroutine check_ordinates

end module adfric_input_modern_checks
