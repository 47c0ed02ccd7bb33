! SPDX-License-Identifier: GPL-3.0-or-later
!> A hard case through the program: namelist in, results file out, with one thread and with three.
module hard_run
   use adfric_base_kinds, only: dp, i8
   use adfric_command_case, only: open_case
   use adfric_command_outcome, only: outcome_t
   use adfric_input_run, only: run_input_t
   use counting_sink, only: n_different_bits
   use random_dice, only: dice_t, new_dice
   use read_back, only: results_reader_t, open_results
   use search_draw, only: drawn_case_t
   use search_rules, only: answer_t, answer_case, find_fault
   use shell, only: run_command, write_input
   implicit none (type, external)
   private
   public :: hard_run_t, run_hard_case, run_hard_text, path_of_case, find_cases

   !> A case that takes longer hangs [s]; the slowest build is fifty times slower than Release.
   character(*), parameter :: longest = '120'
   character(*), parameter :: input_file = 'hard_case.nml'
   !> Results files with one thread and with three.
   character(*), parameter :: output_files(2) = ['hard_case_1.h5', 'hard_case_3.h5']
   character(*), parameter :: threads(2) = ['1', '3']

   !> What the program made of a case.
   type :: hard_run_t
      !> What the input describes, with the model.
      type(run_input_t) :: input
      !> Shape `(n_points)`, the last sweep fastest.
      integer, allocatable :: status(:)
      real(dp), allocatable :: error_estimate(:)
      !> Shape `(n_points, n_results)`; enumerated states as numbers.
      real(dp), allocatable :: results(:, :)
      !> What is wrong; empty if nothing is.
      character(:), allocatable :: fault
   contains
      procedure :: of
      procedure :: swept
   end type hard_run_t

contains

   !> Run a case of the folder of cases by its name.
   subroutine run_hard_case(name, run)
      character(*), intent(in) :: name
      type(hard_run_t), intent(out) :: run

      call run_hard_file(path_of_case(name), run)
   end subroutine run_hard_case

   !> Run an input that a test makes up.
   subroutine run_hard_text(text, run)
      character(*), intent(in) :: text
      type(hard_run_t), intent(out) :: run

      call write_input(input_file, text)
      call run_hard_file(input_file, run)
   end subroutine run_hard_text

   !> Where a case stands.
   function path_of_case(name) result(path)
      character(*), intent(in) :: name
      character(:), allocatable :: path
      character(1000) :: folder
      integer :: length

      call get_environment_variable('ADFRIC_SOURCE', folder, length)
      path = folder(:length)//'/tests/hard/cases/'//name//'.nml'
   end function path_of_case

   !> Names of all cases, separated by blanks.
   function find_cases() result(names)
      character(:), allocatable :: names
      character(:), allocatable :: errors
      integer :: status, i

      call run_command('for f in '//path_of_case('*')//'; do basename $f .nml; done', status, names, errors)
      do i = 1, len(names)
         if (names(i:i) == achar(10)) names(i:i) = ' '
      end do
   end function find_cases

   !> Run an input with one thread and with three, and read the results.
   subroutine run_hard_file(path, run)
      character(*), intent(in) :: path
      type(hard_run_t), intent(inout) :: run
      type(outcome_t) :: outcome
      type(hard_run_t) :: other

      run%fault = ''
      call open_case(path, run%input, outcome)
      if (outcome%exit_status /= 0) then
         run%fault = 'refused: '//outcome%errors
         return
      end if
      call solve(path, 1, run)
      if (len(run%fault) > 0) return
      other%input = run%input
      other%fault = ''
      call solve(path, 2, other)
      run%fault = other%fault
      if (len(run%fault) > 0) return
      if (any(run%status /= other%status) .or. sum(n_different_bits(run%results, other%results)) > 0) &
         & run%fault = 'the results depend on the number of threads'
      if (len(run%fault) == 0) call judge_by_rules(run)
   end subroutine run_hard_file

   !> Run the program once.
   subroutine solve(path, which, run)
      character(*), intent(in) :: path
      !> Position in `threads`.
      integer, intent(in) :: which
      type(hard_run_t), intent(inout) :: run
      character(:), allocatable :: output, errors
      type(results_reader_t) :: file
      integer :: status, k

      call run_command('OMP_NUM_THREADS='//threads(which)//' timeout '//longest//' "$ADFRIC_PROGRAM" run --force --quiet '''// &
         & path//''' --output '//output_files(which), status, output, errors)
      if (status > 1 .or. len(errors) > 0) run%fault = 'ended with '//number(status)//' (124: no end) '//errors
      if (len(run%fault) > 0) return
      call open_results(file, output_files(which))
      run%status = file%states('status')
      run%error_estimate = file%reals('error_estimate')
      allocate (run%results(size(run%status), size(run%input%model%results)))
      do k = 1, size(run%input%model%results)
         associate (r => run%input%model%results(k))
            if (r%n_states() > 0) then
               run%results(:, k) = file%states(r%name)
            else if (size(file%reals(r%name)) == size(run%status)) then
               run%results(:, k) = file%reals(r%name)
            else
               ! it is swept, and stands once for each value
               call spread_swept(run, r%name, run%results(:, k))
            end if
         end associate
      end do
      call file%close()
      if (any(run%status > 1) .neqv. status == 1) run%fault = 'the exit status '//number(status)//' is not that of the points'
   end subroutine solve

   !> Values of a swept variable at every point.
   subroutine spread_swept(run, name, values)
      type(hard_run_t), intent(in) :: run
      character(*), intent(in) :: name
      real(dp), intent(out) :: values(:)
      real(dp) :: all_values(size(run%input%plan%base), size(values))
      integer :: k

      call run%input%plan%get_values(1_i8, all_values)
      do k = 1, size(all_values, 1)
         if (run%input%model%variables(k)%name == name) values = all_values(k, :)
      end do
   end subroutine spread_swept

   !> The rules of the random search, line by line of the last sweep.
   subroutine judge_by_rules(run)
      type(hard_run_t), intent(inout) :: run
      type(drawn_case_t) :: drawn
      type(answer_t) :: answer
      type(dice_t) :: dice
      integer :: n, line
      integer, parameter :: seed = 5

      call new_dice(dice, seed)
      n = 1
      drawn%swept = 1
      drawn%is_hard = .true.
      associate (axes => run%input%plan%axes)
         if (size(axes) > 0) n = size(axes(size(axes))%values, 2)
         if (size(axes) > 0) drawn%swept = axes(size(axes))%variables(1)
      end associate
      ! no hard case has datasets
      allocate (drawn%values(size(run%input%plan%base), n), drawn%data(0))
      do line = 1, size(run%status)/n
         call run%input%plan%get_values(int(n*(line - 1) + 1, i8), drawn%values)
         call answer_case(run%input%model, drawn, answer)
         call find_fault(run%input%model, drawn, answer, dice, run%fault)
         if (len(run%fault) > 0) run%fault = 'line '//number(line)//' of the last sweep, '//run%fault
         if (len(run%fault) > 0) return
      end do
   end subroutine judge_by_rules

   !> A result at every point.
   function of(self, name) result(values)
      class(hard_run_t), intent(in) :: self
      character(*), intent(in) :: name
      real(dp) :: values(size(self%status))
      integer :: k

      do k = 1, size(self%input%model%results)
         if (self%input%model%results(k)%name /= name) cycle
         values = self%results(:, k)
         return
      end do
      error stop 'hard_run: no such result'
   end function of

   !> The values of a sweep, the first being 1.
   function swept(self, which) result(values)
      class(hard_run_t), intent(in) :: self
      integer, intent(in) :: which
      real(dp), allocatable :: values(:)

      values = self%input%plan%axes(which)%values(1, :)
   end function swept

   function number(n) result(text)
      integer, intent(in) :: n
      character(:), allocatable :: text
      character(12) :: buffer

      write (buffer, '(i0)') n
      text = trim(buffer)
   end function number

end module hard_run
