! SPDX-License-Identifier: GPL-3.0-or-later
!> Helpers of the input's tests: an input is written as one text with `|` for the end of a line.
module reading
   use adfric_base_error, only: error_t
   use adfric_base_problems, only: problems_t
   use adfric_input_namelist_file, only: namelist_file_t
   use adfric_input_run, only: run_input_t, read_job, read_case
   use trial_model, only: trial_model_t, new_trial_model
   implicit none (type, external)
   private
   public :: read_text, all_problems, has, says, job_and_surface

   !> The lines that most tests begin with.
   character(*), parameter :: job_and_surface = '&job model = ''trial'' /|&surface period = 1e-3 /|'
   !> File that the tests write.
   character(*), parameter :: scratch = 'adfric_test_input.nml'

contains

   !> Read an input with the trial model.
   subroutine read_text(text, run, problems)
      !> `|` ends a line.
      character(*), intent(in) :: text
      type(run_input_t), intent(out) :: run
      type(problems_t), intent(out) :: problems
      type(namelist_file_t) :: file
      type(trial_model_t) :: model
      type(error_t), allocatable :: error

      call write_file(text)
      call read_job(scratch, 'trial other', file, run, problems, error)
      call delete_file()
      if (allocated(error)) error stop 'the scratch file cannot be read'
      if (run%model_name /= 'trial') return
      call new_trial_model(model)
      allocate (run%model, source=model)
      call read_case(file, run, problems)
   end subroutine read_text

   !> All problems of an input, one after the other, each preceded and followed by a line end.
   function all_problems(text) result(lines)
      character(*), intent(in) :: text
      character(:), allocatable :: lines
      type(run_input_t) :: run
      type(problems_t) :: problems
      integer :: i

      call read_text(text, run, problems)
      lines = new_line('a')
      do i = 1, problems%count()
         lines = lines//problems%line_of(i, 'f.nml')//new_line('a')
      end do
   end function all_problems

   !> Does a text contain another?
   logical function has(text, part)
      character(*), intent(in) :: text, part

      has = index(text, part) > 0
   end function has

   !> Is this the only problem of an input? It begins so, contains this, and ends so.
   logical function says(text, start, part, line)
      character(*), intent(in) :: text
      !> Group and variable as they are printed.
      character(*), intent(in) :: start
      character(*), intent(in) :: part
      !> Line of the file.
      character(*), intent(in) :: line
      character(:), allocatable :: lines

      lines = all_problems(text)
      says = index(lines, new_line('a')//'f.nml: '//start//': ') == 1
      says = says .and. index(lines, part) > 0
      says = says .and. index(lines, '(line '//line//')'//new_line('a')) == len(lines) - len('(line '//line//')')
      says = says .and. index(lines(2:), new_line('a')) == len(lines) - 1
      if (.not. says) print '(a)', 'given: '//text, 'problems:'//lines
   end function says

   !> Write the scratch file.
   subroutine write_file(text)
      character(*), intent(in) :: text
      character(len(text)) :: lines
      integer :: unit, i

      lines = text
      do i = 1, len(text)
         if (text(i:i) == '|') lines(i:i) = new_line('a')
      end do
      open (newunit=unit, file=scratch, access='stream', form='unformatted', status='replace', action='write')
      write (unit) lines
      close (unit)
   end subroutine write_file

   !> Delete the scratch file.
   subroutine delete_file()
      integer :: unit

      open (newunit=unit, file=scratch, status='old')
      close (unit, status='delete')
   end subroutine delete_file

end module reading
