! SPDX-License-Identifier: GPL-3.0-or-later
!> The command line: `adfric COMMAND ARGUMENT ... OPTION ...`.
module adfric_command_line
   use adfric_base_error, only: error_t, set_error, input_failure
   use adfric_base_printable, only: shell_word
   use adfric_input_suggestion, only: did_you_mean
   use adfric_run_blocks, only: part_t
   implicit none (type, external)
   private
   public :: command_t, argument_t, get_arguments, parse_arguments
   public :: known_commands

   !> What the program can do.
   character(*), parameter :: known_commands = 'run fit merge check modernise help'
   !> Options of all commands.
   character(*), parameter :: known_options = '--output --force --resume --shard --virtual --quiet --output-name --help --version'

   !> A word of the command line.
   type :: argument_t
      !> The word as the user wrote it.
      character(:), allocatable :: text
   end type argument_t

   !> What the user wants.
   type :: command_t
      !> 'run', 'fit', 'merge', 'check', 'modernise', 'help' or 'version'.
      character(:), allocatable :: name
      !> Name of the input (run, fit, check and modernise), of the results file (merge) or topic (help); empty if there is none.
      character(:), allocatable :: subject
      !> Names of the parts (merge).
      type(argument_t), allocatable :: others(:)
      !> Name of the results file; empty if the input says it.
      character(:), allocatable :: output
      !> May an existing results file be overwritten?
      logical :: overwrite = .false.
      !> Go on with a run that was stopped?
      logical :: resumes = .false.
      !> Which part of the run is solved.
      type(part_t) :: part
      !> Refer to the parts instead of copying them?
      logical :: is_virtual = .false.
      !> Show nothing but errors?
      logical :: is_quiet = .false.
      !> Show the name of the results file and nothing else?
      logical :: names_output = .false.
   end type command_t

contains

   !> The words after the name of the program.
   function get_arguments() result(arguments)
      type(argument_t), allocatable :: arguments(:)
      integer :: i, length

      allocate (arguments(command_argument_count()))
      do i = 1, size(arguments)
         call get_command_argument(i, length=length)
         allocate (character(length) :: arguments(i)%text)
         if (length > 0) call get_command_argument(i, arguments(i)%text)
      end do
   end function get_arguments

   !> Understand a command line.
   subroutine parse_arguments(arguments, command, error)
      !> The words after the name of the program.
      type(argument_t), intent(in) :: arguments(:)
      !> Receives what the user asks for; only to be used if there is no error.
      type(command_t), intent(out) :: command
      !> Not allocated if all went well.
      type(error_t), allocatable, intent(out) :: error
      integer :: i, n_others
      logical :: are_names

      command%name = ''
      command%subject = ''
      command%output = ''
      allocate (command%others(size(arguments)))
      n_others = 0
      are_names = .false.
      i = 0
      do while (i < size(arguments))
         i = i + 1
         if (arguments(i)%text == '--' .and. .not. are_names) then
            ! what follows are names, with dashes or without
            are_names = .true.
         else if (is_option(arguments(i)%text) .and. .not. are_names) then
            call parse_option(arguments, i, command, error)
         else
            call parse_word(arguments(i)%text, command, n_others, error)
         end if
         if (allocated(error)) return
         if (command%name == 'version') return
      end do
      command%others = command%others(:n_others)
      call check_complete(command, error)
   end subroutine parse_arguments

   !> Is it an option? A single `-` is not.
   pure logical function is_option(text)
      !> A word of the command line.
      character(*), intent(in) :: text

      is_option = len(text) > 1 .and. index(text, '-') == 1
   end function is_option

   !> Understand an option, and its value behind a = or in the next word.
   subroutine parse_option(arguments, i, command, error)
      type(argument_t), intent(in) :: arguments(:)
      !> In: index of the option among the words. Out: index of its value, if that is the next word.
      integer, intent(inout) :: i
      type(command_t), intent(inout) :: command
      type(error_t), allocatable, intent(out) :: error
      character(:), allocatable :: name, value
      integer :: equals

      name = arguments(i)%text
      value = ''
      equals = index(name, '=')
      if (index(' --output= --shard= ', ' '//name(:max(equals, 1))//' ') > 0) then
         value = name(equals + 1:)
         name = name(:equals - 1)
      else if ((name == '--output' .or. name == '--shard') .and. i < size(arguments)) then
         i = i + 1
         value = arguments(i)%text
      end if
      select case (name)
      case ('--output')
         call set_output(value, command, error)
      case ('--shard')
         call set_part(value, command, error)
      case ('--force')
         command%overwrite = .true.
      case ('--resume')
         command%resumes = .true.
      case ('--virtual')
         command%is_virtual = .true.
      case ('--quiet')
         command%is_quiet = .true.
      case ('--output-name')
         command%names_output = .true.
      case ('--help', '-h')
         if (command%name /= 'help') command%subject = command%name
         command%name = 'help'
      case ('--version')
         command%name = 'version'
      case default
         call set_error(error, input_failure, 'adfric: unknown option, given '//name//', allowed: ' &
            //known_options//say_meant(name))
      end select
   end subroutine parse_option

   !> What may be meant by an unknown option: another one, or a file.
   pure function say_meant(name) result(text)
      !> The option that is not known, with its dashes.
      character(*), intent(in) :: name
      character(:), allocatable :: text

      text = did_you_mean(name, known_options)
      if (len(text) == 0) text = say_file(name)
   end function say_meant

   !> How to write the name of a file that is taken for an option; empty if it is not.
   pure function say_file(name) result(text)
      !> A word of the command line that may be the name of a file.
      character(*), intent(in) :: name
      character(:), allocatable :: text

      text = ''
      if (is_option(name)) text = '; a file of this name is written '//shell_word(name)
   end function say_file

   !> Set the name of the results file.
   subroutine set_output(text, command, error)
      !> Value of the option `--output`; empty if there is none.
      character(*), intent(in) :: text
      type(command_t), intent(inout) :: command
      type(error_t), allocatable, intent(out) :: error

      if (len_trim(text) == 0 .or. is_option(text)) then
         call set_error(error, input_failure, 'adfric: --output: the name of a file is missing, given ''' &
            //text//''''//say_file(text))
      else if (len(command%output) > 0) then
         call set_error(error, input_failure, 'adfric: --output: given twice, '//command%output//' and '//text)
      else
         command%output = text
      end if
   end subroutine set_output

   !> Set which part of the run is solved.
   subroutine set_part(text, command, error)
      !> Value of the option `--shard`, such as 3/16; empty if there is none.
      character(*), intent(in) :: text
      type(command_t), intent(inout) :: command
      type(error_t), allocatable, intent(out) :: error
      character(*), parameter :: digits = '0123456789'
      !> Digits that an integer surely holds.
      integer, parameter :: most_digits = 9
      integer :: slash, number, of

      slash = index(text, '/')
      number = 0
      of = 0
      if (slash > 1 .and. slash <= most_digits + 1 .and. len(text) > slash .and. len(text) <= slash + most_digits) then
         if (verify(text(:slash - 1)//text(slash + 1:), digits) == 0) then
            read (text(:slash - 1), *) number
            read (text(slash + 1:), *) of
         end if
      end if
      if (number < 1 .or. number > of) then
         call set_error(error, input_failure, 'adfric: --shard: no part of a run, given '''//text &
            //''', allowed: I/N with 1 <= I <= N, such as 3/16')
      else
         command%part = part_t(number, of, .true.)
      end if
   end subroutine set_part

   !> Understand a word that is no option: the command, or what it is about.
   subroutine parse_word(text, command, n_others, error)
      !> A word that is no option.
      character(*), intent(in) :: text
      type(command_t), intent(inout) :: command
      !> Number of names of parts so far, which only `merge` has.
      integer, intent(inout) :: n_others
      type(error_t), allocatable, intent(out) :: error

      if (len(command%name) == 0) then
         if (index(' '//known_commands//' ', ' '//text//' ') > 0 .and. len_trim(text) > 0) then
            command%name = text
         else
            call set_error(error, input_failure, 'adfric: unknown command, given '''//text//''', allowed: ' &
               //known_commands//did_you_mean(text, known_commands))
         end if
      else if (len_trim(text) == 0 .and. command%name /= 'help') then
         ! passed over, the next name would take its place, and the results that of a part
         call set_error(error, input_failure, 'adfric: '//command%name//': the name of a file is missing, given '''//text//'''')
      else if (len(command%subject) == 0) then
         command%subject = text
      else if (command%name == 'merge') then
         n_others = n_others + 1
         command%others(n_others)%text = text
      else if (command%name /= 'help') then
         ! A call for help counts wherever it stands: adfric run --help INPUT.nml.
         call set_error(error, input_failure, 'adfric: '//command%name//': one input is allowed, given ' &
            //command%subject//' and '//text)
      end if
   end subroutine parse_word

   !> Is everything there that the command needs, and nothing else?
   subroutine check_complete(command, error)
      !> What the user asks for, as far as the words say it.
      type(command_t), intent(in) :: command
      type(error_t), allocatable, intent(out) :: error

      if (len(command%name) == 0) then
         call set_error(error, input_failure, 'adfric: no command given, allowed: '//known_commands &
            //'; adfric --help says more')
      else if (command%name == 'merge' .and. size(command%others) == 0) then
         call set_error(error, input_failure, 'adfric: merge: no parts given, needed: adfric merge OUT.h5 PART.h5 ...')
      else if (command%name /= 'help' .and. len(command%subject) == 0) then
         call set_error(error, input_failure, 'adfric: '//command%name &
            //': no input given, needed: adfric '//command%name//' INPUT.nml')
      else
         call check_option('--output', len(command%output) > 0, 'run and fit', command, error)
         call check_option('--resume', command%resumes, 'run and fit', command, error)
         call check_option('--shard', .not. command%part%is_whole(), 'run and fit', command, error)
         call check_option('--virtual', command%is_virtual, 'merge', command, error)
         call check_option('--output-name', command%names_output, 'check', command, error)
         call check_option('--force', command%overwrite, 'run, fit and merge', command, error)
      end if
   end subroutine check_complete

   !> Does an option belong to the command?
   subroutine check_option(option, is_given, owners, command, error)
      !> Name of the option, with its dashes.
      character(*), intent(in) :: option
      logical, intent(in) :: is_given
      !> Names of the commands that have the option.
      character(*), intent(in) :: owners
      !> What the user asks for, with the name of the command.
      type(command_t), intent(in) :: command
      !> Receives an error if the option is out of index; one that is there already is kept.
      type(error_t), allocatable, intent(inout) :: error

      if (.not. is_given .or. allocated(error) .or. index(owners, command%name) > 0) return
      call set_error(error, input_failure, 'adfric: '//command%name//': '//option//' is an option of '//owners//' alone')
   end subroutine check_option

end module adfric_command_line
