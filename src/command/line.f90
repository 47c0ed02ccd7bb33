!> The command line: `adfric COMMAND ARGUMENT ... OPTION ...`.
module adfric_command_line
   use adfric_base_error, only: error_t, set_error, input_failure
   use adfric_input_suggestion, only: did_you_mean
   implicit none (type, external)
   private
   public :: command_t, argument_t, get_arguments, parse_arguments
   public :: known_commands, known_options

   !> What the program can do.
   character(*), parameter :: known_commands = 'run check help'
   !> Options of all commands.
   character(*), parameter :: known_options = '--output --force --quiet --help --version'

   !> A word of the command line.
   type :: argument_t
      character(:), allocatable :: text
   end type argument_t

   !> What the user wants.
   type :: command_t
      !> 'run', 'check', 'help' or 'version'.
      character(:), allocatable :: name
      !> Name of the input (run and check) or topic (help); empty if there is none.
      character(:), allocatable :: subject
      !> Name of the results file; empty if the input says it.
      character(:), allocatable :: output
      !> May an existing results file be overwritten?
      logical :: overwrite = .false.
      !> Show nothing but errors?
      logical :: is_quiet = .false.
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
      type(argument_t), intent(in) :: arguments(:)
      type(command_t), intent(out) :: command
      type(error_t), allocatable, intent(out) :: error
      integer :: i

      command%name = ''
      command%subject = ''
      command%output = ''
      i = 0
      do while (i < size(arguments))
         i = i + 1
         if (is_option(arguments(i)%text)) then
            call parse_option(arguments, i, command, error)
         else
            call parse_word(arguments(i)%text, command, error)
         end if
         if (allocated(error)) return
         if (command%name == 'version') return
      end do
      call check_complete(command, error)
   end subroutine parse_arguments

   !> Is it an option? A single `-` is not.
   pure logical function is_option(text)
      character(*), intent(in) :: text

      is_option = len(text) > 1 .and. index(text, '-') == 1
   end function is_option

   !> Understand an option, and its value in the next word.
   subroutine parse_option(arguments, i, command, error)
      type(argument_t), intent(in) :: arguments(:)
      !> Place of the option; moved on to its value.
      integer, intent(inout) :: i
      type(command_t), intent(inout) :: command
      type(error_t), allocatable, intent(out) :: error
      character(*), parameter :: output_is = '--output='

      associate (text => arguments(i)%text)
         if (index(text, output_is) == 1) then
            call set_output(text(len(output_is) + 1:), command, error)
            return
         end if
         select case (text)
         case ('--output')
            i = i + 1
            if (i > size(arguments)) then
               call set_error(error, input_failure, 'adfric: --output: the name of a file is missing')
            else
               call set_output(arguments(i)%text, command, error)
            end if
         case ('--force')
            command%overwrite = .true.
         case ('--quiet')
            command%is_quiet = .true.
         case ('--help', '-h')
            if (command%name /= 'help') command%subject = command%name
            command%name = 'help'
         case ('--version')
            command%name = 'version'
         case default
            call set_error(error, input_failure, 'adfric: unknown option, given '//text//', allowed: ' &
               //known_options//did_you_mean(text, known_options))
         end select
      end associate
   end subroutine parse_option

   !> Set the name of the results file.
   subroutine set_output(text, command, error)
      character(*), intent(in) :: text
      type(command_t), intent(inout) :: command
      type(error_t), allocatable, intent(out) :: error

      if (len_trim(text) == 0 .or. is_option(text)) then
         call set_error(error, input_failure, 'adfric: --output: the name of a file is missing, given ''' &
            //text//'''')
      else if (len(command%output) > 0) then
         call set_error(error, input_failure, 'adfric: --output: given twice, '//command%output//' and '//text)
      else
         command%output = text
      end if
   end subroutine set_output

   !> Understand a word that is no option: the command, or what it is about.
   subroutine parse_word(text, command, error)
      character(*), intent(in) :: text
      type(command_t), intent(inout) :: command
      type(error_t), allocatable, intent(out) :: error

      if (len(command%name) == 0) then
         if (index(' '//known_commands//' ', ' '//text//' ') > 0 .and. len_trim(text) > 0) then
            command%name = text
         else
            call set_error(error, input_failure, 'adfric: unknown command, given '''//text//''', allowed: ' &
               //known_commands//did_you_mean(text, known_commands))
         end if
      else if (len(command%subject) == 0) then
         command%subject = text
      else if (command%name /= 'help') then
         ! A call for help counts wherever it stands: adfric run --help INPUT.nml.
         call set_error(error, input_failure, 'adfric: '//command%name//': one input is allowed, given ' &
            //command%subject//' and '//text)
      end if
   end subroutine parse_word

   !> Is everything there that the command needs, and nothing else?
   subroutine check_complete(command, error)
      type(command_t), intent(in) :: command
      type(error_t), allocatable, intent(out) :: error

      if (len(command%name) == 0) then
         call set_error(error, input_failure, 'adfric: no command given, allowed: '//known_commands &
            //'; adfric --help says more')
      else if (command%name /= 'help' .and. len(command%subject) == 0) then
         call set_error(error, input_failure, 'adfric: '//command%name &
            //': no input given, needed: adfric '//command%name//' INPUT.nml')
      else if (command%name /= 'run' .and. len(command%output) > 0) then
         call set_error(error, input_failure, 'adfric: '//command%name//': --output is an option of run alone')
      else if (command%name /= 'run' .and. command%overwrite) then
         call set_error(error, input_failure, 'adfric: '//command%name//': --force is an option of run alone')
      end if
   end subroutine check_complete

end module adfric_command_line
