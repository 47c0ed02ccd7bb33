! SPDX-License-Identifier: GPL-3.0-or-later
!> What an input says of a history in time: lists of times and of approaches, loads or positions of a base, or a path with a name.
!> Rows of both, what they may not say, and the legs that they mean. The file is long by its rows and by what they may not say.
module adfric_round_timed_history
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_base_counting, only: counting
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: show_count, show_number
   use adfric_base_unset, only: is_set, unset
   use adfric_base_words, only: get_word
   use adfric_describe_check, only: checks_t, refuse_swept
   use adfric_describe_rows, only: any_number, choice, list_row, positive, whole_number
   use adfric_describe_table, only: variable_t
   use adfric_describe_time_list, only: check_length, check_times
   use adfric_round_timed_path, only: timed_control_t, timed_leg_t
   implicit none (type, external)
   private
   public :: timed_lists_t, set_history_rows, check_history, doubt_noise, doubt_turns, doubt_swing, get_legs, steps_of_leg
   public :: largest_prescribed, n_given_legs
   public :: adheres, has_power_law, pressing_alone, pressing_under, top_row

   !> Variables in the order of their rows; a component is the index of its row.
   type :: timed_input_t
      !> Indices of the rows.
      integer :: times = 0, approaches = 0, loads = 0, base_approaches = 0, path = 0, largest_approach = 0, &
         & largest_base_approach = 0, approach_rate = 0, retraction_rate = 0, largest_load = 0, loading_rate = 0, &
         & unloading_rate = 0, dwell_time = 0, cycles = 0, oscillation_amplitude = 0, frequency = 0, machine_stiffness = 0, &
         & relative_tolerance = 0, steps_per_leg = 0, time = 0, contact_point = 0, drift_rate = 0, smoothing = 0, &
         & power_law_modulus = 0, power_law_exponent = 0, trigger_load = 0
   end type timed_input_t
   type(timed_input_t), parameter, public :: timed_input = transfer(counting, timed_input_t())
   integer, parameter, public :: n_timed_rows = storage_size(timed_input)/storage_size(1)

   !> Indices of the words of `path`.
   integer, parameter, public :: path_ramp = 1, path_triangle = 2, path_sine = 3
   !> Most entries of a list.
   integer, parameter :: most_times = 10000000
   !> Steps that are written of each leg of a path with a name.
   integer, parameter :: steps_of_path = 50

   !> The numbers of the lists, in SI units; not allocated where they are not given.
   type :: timed_lists_t
      !> Times [s].
      real(dp), allocatable :: times(:)
      !> Approaches [m], loads [N] and positions of the base [m].
      real(dp), allocatable :: approaches(:), loads(:), base_approaches(:)
   end type timed_lists_t

contains

   !> The rows.
   subroutine set_history_rows(v)
      !> Receives the rows; shape `(n_timed_rows)`.
      type(variable_t), intent(out) :: v(:)
      character(*), parameter :: group = 'history'

      associate (in => timed_input)
         v(in%times) = list_row(group=group, name='times', unit='s', &
            & meaning='times at which what is prescribed is given; between them it is straight, and where two are equal it jumps', &
            & most_count=most_times, least_count=2)
         v(in%approaches) = list_row(group=group, name='approaches', unit='m', meaning='approaches at these times; below 0 out '// &
            & 'of contact', most_count=most_times, least_count=2)
         v(in%loads) = list_row(group=group, name='loads', unit='N', meaning='loads at these times', most_count=most_times, &
            & least_count=2, lower=0.0_dp)
         v(in%base_approaches) = list_row(group=group, name='base_approaches', unit='m', meaning='approaches at these times of '// &
            & 'the base of a spring, approach + load/machine_stiffness', most_count=most_times, least_count=2)
         v(in%path) = choice(group=group, name='path', meaning='instead of lists: press and dwell, the same and retract, or '// &
            & 'oscillate after the dwell', choices='ramp triangle sine')
         v(in%largest_approach) = positive(group=group, name='largest_approach', unit='m', &
            & meaning='approach at the end of pressing')
         v(in%largest_base_approach) = positive(group=group, name='largest_base_approach', unit='m', meaning='approach of the '// &
            & 'base of a spring at the end of pressing')
         v(in%approach_rate) = positive(group=group, name='approach_rate', unit='m/s', meaning='speed of pressing')
         v(in%retraction_rate) = positive(group=group, name='retraction_rate', unit='m/s', &
            & meaning='speed of retraction; if not given that of pressing')
         v(in%largest_load) = positive(group=group, name='largest_load', unit='N', meaning='load at the end of loading')
         v(in%loading_rate) = positive(group=group, name='loading_rate', unit='N/s', meaning='load per time while loading')
         v(in%unloading_rate) = positive(group=group, name='unloading_rate', unit='N/s', meaning='load per time while '// &
            & 'unloading; if not given that of loading')
         v(in%dwell_time) = any_number(group=group, name='dwell_time', unit='s', &
            & meaning='time of rest between pressing and what follows; none if not given', lower=0.0_dp)
         v(in%cycles) = whole_number(group=group, name='cycles', meaning='times that a triangle is gone through, or periods of '// &
            & 'a sine', default=1, lower=1, upper=100000)
         v(in%oscillation_amplitude) = positive(group=group, name='oscillation_amplitude', unit='m', meaning='amplitude of the '// &
            & 'sine: half of what it moves')
         v(in%frequency) = positive(group=group, name='frequency', unit='Hz', meaning='periods of the sine per second')
         v(in%machine_stiffness) = positive(group='operating', name='machine_stiffness', unit='N/m', meaning='k of the spring '// &
            & '(a cantilever, a machine) between the indenter and its base')
         v(in%relative_tolerance) = any_number(group='numerics', name='relative_tolerance', unit='-', &
            & meaning='largest error of approach and load, over the largest ones', default=1.0e-9_dp, lower=1.0e-12_dp, &
            & upper=1.0e-3_dp)
         v(in%steps_per_leg) = whole_number(group='output', name='steps_per_leg', meaning='steps that are written of each '// &
            & 'straight leg; if not given 1 of lists and '//show_count(steps_of_path)//' of a path with a name', default=0, &
            & lower=0, upper=1000000)
         v(in%time) = any_number(group=group, name='time', unit='s', meaning='abscissa of fits alone: time at which load, '// &
            & 'approach and radius of contact are the ordinates')
         v(in%time)%is_hidden = .true.
         v(in%contact_point) = any_number(group=group, name='contact_point', unit='m', &
            & meaning='zero of approaches: what is prescribed where the surface that nobody has touched is met', default=0.0_dp)
         v(in%drift_rate) = any_number(group=group, name='drift_rate', unit='m/s', &
            & meaning='drift towards the sample, which adds drift_rate times the time to approaches', default=0.0_dp)
         v(in%smoothing) = positive(group=group, name='smoothing', unit='m or N', &
            & meaning='noise of a list: fewer straight legs, which differ from no value by more, take its place')
         v(in%power_law_modulus) = positive(group='material', name='power_law_modulus', unit='Pa', &
            & meaning='contact modulus E(t) of a power law a second after a step; in place of modulus and arms')
         v(in%power_law_exponent) = any_number(group='material', name='power_law_exponent', unit='-', &
            & meaning='exponent alpha of a power law, E(t) = power_law_modulus (t/1 s)^(-alpha)', lower=0.01_dp, upper=0.95_dp)
         v(in%trigger_load) = positive(group=group, name='trigger_load', unit='N', meaning='load at which pressing at a given '// &
            & 'speed ends; that of the base of a spring, if there is one')
      end associate
   end subroutine set_history_rows

   !> Add to `problems` what is missing or contradictory.
   subroutine check_history(c, first, lists, is_swept, problems)
      !> Checks of the model, whose table has the rows from `first` on.
      type(checks_t), intent(in) :: c
      !> Index before that of the first row.
      integer, intent(in) :: first
      type(timed_lists_t), intent(in) :: lists
      !> Is the variable swept? Shape `(n_variables)`.
      logical, intent(in) :: is_swept(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      integer :: before

      before = problems%count()
      associate (in => timed_input)
         ! all points have the same steps
         call refuse_swept(c%variables, is_swept, first + [in%path, in%cycles, in%steps_per_leg], problems)
         if (c%has(first + in%path)) then
            call check_path(c, first)
         else
            call c%refuse(first + [in%largest_approach, in%largest_base_approach, in%approach_rate, in%retraction_rate, &
               & in%largest_load, in%loading_rate, in%unloading_rate, in%dwell_time, in%oscillation_amplitude, in%frequency, &
               & in%trigger_load], &
               & 'has no meaning without path')
            call c%add(first + in%times, 'is missing [s]; give it, or a path', .not. c%has(first + in%times))
            if (c%has_any(first + [in%approaches, in%loads, in%base_approaches])) then
               call c%need_one(first + [in%approaches, in%loads, in%base_approaches], .true.)
            else
               call c%add(first + in%approaches, 'is missing; one of approaches, loads or base_approaches is '// &
                  & 'needed, or a path', .true.)
            end if
            call c%add(first + in%cycles, 'has no meaning without path', c%values(first + in%cycles) > 1)
            if (problems%count() == before) call check_lists(c, first, lists, is_swept, problems)
         end if
         if (c%has(first + in%loads) .or. c%has(first + in%largest_load)) then
            call refuse_shift(c, first + in%contact_point, is_swept)
            call refuse_shift(c, first + in%drift_rate, is_swept)
         end if
         call c%add(first + in%machine_stiffness, 'is missing [N/m]; the approach of a base needs it', &
            & has_base(c, first) .and. .not. c%has(first + in%machine_stiffness))
         call c%add(first + in%machine_stiffness, 'has no meaning without the approach of a base', &
            & .not. has_base(c, first) .and. c%has(first + in%machine_stiffness))
         if (has_power_law(c%values(first + 1:)) .and. problems%count() == before) call check_power_law(c, first, lists, is_swept)
      end associate
   end subroutine check_history

   !> Is the solid a power law?
   pure logical function has_power_law(values)
      !> Values of the rows; shape `(n_timed_rows)`.
      real(dp), intent(in) :: values(:)

      has_power_law = any(is_set(values([timed_input%power_law_modulus, timed_input%power_law_exponent])))
   end function has_power_law

   !> A power law has both numbers, no relaxed state, and no load right after a jump of the approach.
   subroutine check_power_law(c, first, lists, is_swept)
      type(checks_t), intent(in) :: c
      integer, intent(in) :: first
      type(timed_lists_t), intent(in) :: lists
      logical, intent(in) :: is_swept(:)
      type(timed_control_t) :: control
      type(timed_leg_t), allocatable :: legs(:)
      real(dp) :: values(n_timed_rows)
      integer :: n_before

      associate (in => timed_input)
         call c%need(first + [in%power_law_modulus, in%power_law_exponent], .true.)
         call c%add(first + in%power_law_modulus, 'has no meaning with adhesion, whose theory needs a relaxed modulus, and '// &
            & 'that of a power law is 0', adheres(c%variables, first))
         values = c%values(first + 1:first + n_timed_rows)
         ! a path up to a load has no end yet
         if (is_set(values(in%trigger_load))) values = pressing_alone(values, 1.0_dp)
         ! a zero or a drift that varies has no value yet
         where (is_swept(first + [in%contact_point, in%drift_rate])) values([in%contact_point, in%drift_rate]) = 0
         call get_legs(values, lists, 1.0_dp, 1.0_dp, 0.0_dp, control, legs, n_before)
         call c%add(first + merge(in%approaches, in%largest_approach, is_set(values(in%approaches))), &
            & 'jumps, and the load of a power law is infinite then; give a short leg in its place', &
            & .not. abs(control%by_load) > 0 .and. any(abs(legs%end - legs%begin) > 0 .and. .not. legs%span > 0))
      end associate
   end subroutine check_power_law

   !> A load has no zero of the approach.
   subroutine refuse_shift(c, row, is_swept)
      type(checks_t), intent(in) :: c
      !> Index of the variable that shifts approaches.
      integer, intent(in) :: row
      logical, intent(in) :: is_swept(:)

      call c%add(row, 'has no meaning with loads', is_swept(row) .or. abs(c%values(row)) > 0)
   end subroutine refuse_shift

   !> Is the approach of a base prescribed?
   pure logical function has_base(c, first)
      type(checks_t), intent(in) :: c
      integer, intent(in) :: first

      has_base = c%has(first + timed_input%base_approaches) .or. c%has(first + timed_input%largest_base_approach) .or. &
         & c%has(first + timed_input%trigger_load) .and. c%has(first + timed_input%machine_stiffness)
   end function has_base

   !> A path with a name.
   subroutine check_path(c, first)
      type(checks_t), intent(in) :: c
      integer, intent(in) :: first
      character(:), allocatable :: word
      logical :: by_load, oscillates

      associate (in => timed_input)
         word = get_word(c%variables(first + in%path)%choices, nint(c%values(first + in%path)))
         call c%refuse(first + [in%times, in%approaches, in%loads, in%base_approaches], 'stands beside path; give lists or a path')
         call c%refuse([first + in%smoothing], 'has no meaning with path, which has no noise')
         call c%need_one(first + [in%largest_approach, in%largest_base_approach, in%largest_load, in%trigger_load], .true.)
         call c%add(first + in%cycles, 'stands beside trigger_load, and each cycle would turn elsewhere; give a list', &
            & c%has(first + in%trigger_load) .and. nint(c%values(first + in%path)) == path_triangle .and. &
            & c%values(first + in%cycles) > 1)
         call c%add(first + in%time, 'cannot be fitted over with trigger_load; give largest_approach', &
            & c%has(first + in%trigger_load) .and. c%has(first + in%time))
         by_load = c%has(first + in%largest_load)
         oscillates = nint(c%values(first + in%path)) == path_sine
         call c%add(first + in%drift_rate, 'stands beside path = ''sine'', whose moduli are those without drift', &
            & oscillates .and. abs(c%values(first + in%drift_rate)) > 0)
         call c%need([first + in%approach_rate], .not. by_load)
         call c%need([first + in%loading_rate], by_load)
         if (by_load) then
            call c%refuse(first + [in%approach_rate, in%retraction_rate], 'has no meaning with largest_load; give loading_rate '// &
               & 'and unloading_rate')
         else
            call c%refuse(first + [in%loading_rate, in%unloading_rate], 'has no meaning without largest_load')
         end if
         call c%need(first + [in%oscillation_amplitude, in%frequency], oscillates)
         call c%add(first + in%path, 'is ''sine'' with a load; give largest_approach or largest_base_approach', &
            & oscillates .and. by_load)
         if (.not. oscillates) call c%refuse(first + [in%oscillation_amplitude, in%frequency], 'has no meaning for path = '''// &
            & word//'''')
         call c%add(first + in%cycles, 'has no meaning for path = ''ramp''', c%values(first + in%cycles) > 1 &
            & .and. nint(c%values(first + in%path)) == path_ramp)
         call c%add(first + in%oscillation_amplitude, 'is above what is pressed before; contact would be lost in each period', &
            & oscillates .and. c%has(first + in%oscillation_amplitude) &
            & .and. largest_pressed(c, first) < c%values(first + in%oscillation_amplitude))
         if (nint(c%values(first + in%path)) /= path_triangle) call c%refuse(first + [in%retraction_rate, in%unloading_rate], &
            & 'has no meaning for path = '''//word//'''')
      end associate
   end subroutine check_path

   !> Approach at the end of pressing; enormous where it is not given.
   pure real(dp) function largest_pressed(c, first) result(pressed)
      type(checks_t), intent(in) :: c
      integer, intent(in) :: first

      pressed = huge(1.0_dp)
      associate (in => timed_input)
         if (c%has(first + in%largest_approach)) pressed = c%values(first + in%largest_approach)
         if (c%has(first + in%largest_base_approach)) pressed = c%values(first + in%largest_base_approach)
      end associate
   end function largest_pressed

   !> Lists of one length, times that rise, and something that presses.
   subroutine check_lists(c, first, lists, is_swept, problems)
      type(checks_t), intent(in) :: c
      integer, intent(in) :: first
      type(timed_lists_t), intent(in) :: lists
      logical, intent(in) :: is_swept(:)
      type(problems_t), intent(inout) :: problems
      real(dp), allocatable :: prescribed(:)
      integer :: row

      associate (in => timed_input, times => lists%times)
         row = given_list(c%values(first + 1:))
         allocate (prescribed, source=list_of(lists, row))
         associate (v => c%variables(first + row))
            call check_length(v, size(prescribed), size(times), problems)
            if (size(prescribed) /= size(times)) return
            if (.not. any(is_swept(first + [in%contact_point, in%drift_rate]))) prescribed = prescribed + &
               & shift_of(c%values(first + 1:), times)
            if (.not. (maxval(prescribed) > 0 .or. adheres(c%variables, first))) call problems%add(v%group, v%name, &
               & 'never presses: no value is above '// &
               & trim(merge('contact_point', '0            ', abs(c%values(first + in%contact_point)) > 0)))
         end associate
         call check_times(times, problems)
         associate (steps => times(2:) - times(:size(times) - 1))
            call c%add(first + in%smoothing, 'stands beside a jump, two equal times; leave one of them out', &
               & c%has(first + in%smoothing) .and. any(.not. abs(steps) > 0) .and. all(steps >= 0))
         end associate
      end associate
   end subroutine check_lists

   !> Does the solver of these rows have adhesion? Then loads may pull, and a history need not press.
   pure logical function adheres(variables, first)
      !> Table of the solver.
      type(variable_t), intent(in) :: variables(:)
      !> Index before the first row of the history.
      integer, intent(in) :: first

      adheres = variables(first + timed_input%loads)%lower < 0
   end function adheres

   !> A line where a list turns so often that it has noise; else nothing.
   pure function doubt_noise(values, lists) result(text)
      !> Values of the rows, which have been checked; shape `(n_timed_rows)`.
      real(dp), intent(in) :: values(:)
      type(timed_lists_t), intent(in) :: lists
      character(:), allocatable :: text

      text = ''
      if (.not. (is_set(values(timed_input%path)) .or. is_set(values(timed_input%smoothing)))) &
         & text = doubt_turns(list_of(lists, given_list(values)))
   end function doubt_noise

   !> A line where a history turns so often that it has noise; else nothing.
   pure function doubt_turns(list) result(text)
      !> What is prescribed, in the order of the times.
      real(dp), intent(in) :: list(:)
      character(:), allocatable :: text
      integer, parameter :: most_turns = 50
      real(dp) :: last
      integer :: k, n

      text = ''
      n = 0
      last = 0
      do k = 2, size(list)
         if (.not. abs(list(k) - list(k - 1)) > 0) cycle
         if ((list(k) - list(k - 1))*last < 0) n = n + 1
         last = sign(1.0_dp, list(k) - list(k - 1))
      end do
      if (n > most_turns) text = 'the list of the history turns '//show_count(n)//' times, and each turn is an unloading or a '// &
         & 'loading, also one of noise, which takes long; history%smoothing, about five standard deviations of the noise, '// &
         & 'draws straight legs through it'//new_line('a')
   end function doubt_turns

   !> A line where an oscillation is no small one, whose edge swings; else nothing.
   pure function doubt_swing(values) result(text)
      !> Values of the rows, which have been checked; shape `(n_timed_rows)`.
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text
      !> Amplitude over the approach: the moduli lack about as much, and more where the solid has relaxed far.
      real(dp), parameter :: small = 0.05_dp
      real(dp) :: pressed

      text = ''
      if (.not. is_set(values(timed_input%oscillation_amplitude))) return
      pressed = values(top_row(values))
      if (.not. is_set(pressed)) return
      associate (part => values(timed_input%oscillation_amplitude)/pressed)
         if (part > small) text = 'history%oscillation_amplitude is '//show_count(nint(100*min(part, 1.0_dp)))// &
            & ' % of the approach: the edge swings, and the moduli differ from those of the solid in proportion; half of it '// &
            & 'shows by how much'//new_line('a')
      end associate
   end function doubt_swing

   !> What zero and drift add to an approach at a time [m]; nothing to a load.
   elemental real(dp) function shift_at(contact_point, drift_rate, time) result(shift)
      !> Zero [m], drift [m/s] and time [s].
      real(dp), intent(in) :: contact_point, drift_rate, time

      shift = drift_rate*time - contact_point
   end function shift_at

   !> What zero and drift add at these times [m].
   pure function shift_of(values, times) result(shift)
      !> Values of the rows; shape `(n_timed_rows)`.
      real(dp), intent(in) :: values(:)
      !> Times [s].
      real(dp), intent(in) :: times(:)
      real(dp) :: shift(size(times))

      shift = shift_at(values(timed_input%contact_point), values(timed_input%drift_rate), times)
   end function shift_of

   !> The row of the list that is given.
   pure integer function given_list(values) result(row)
      !> Values of the rows; shape `(n_timed_rows)`.
      real(dp), intent(in) :: values(:)

      row = timed_input%loads
      if (is_set(values(timed_input%approaches))) row = timed_input%approaches
      if (is_set(values(timed_input%base_approaches))) row = timed_input%base_approaches
   end function given_list

   !> The numbers of a list.
   pure function list_of(lists, row) result(numbers)
      type(timed_lists_t), intent(in) :: lists
      integer, intent(in) :: row
      real(dp), allocatable :: numbers(:)

      if (row == timed_input%approaches) then
         numbers = lists%approaches
      else if (row == timed_input%loads) then
         numbers = lists%loads
      else
         numbers = lists%base_approaches
      end if
   end function list_of

   !> Number of legs that are written.
   pure integer function n_given_legs(values, lists) result(n)
      !> Values of the rows; shape `(n_timed_rows)`.
      real(dp), intent(in) :: values(:)
      type(timed_lists_t), intent(in) :: lists

      if (.not. is_set(values(timed_input%path))) then
         n = size(lists%times) - 1
      else
         n = 1
         if (is_set(values(timed_input%dwell_time))) n = 2
         if (nint(values(timed_input%path)) == path_triangle) n = (n + 1)*nint(values(timed_input%cycles))
         if (nint(values(timed_input%path)) == path_sine) n = n + nint(values(timed_input%cycles))
      end if
   end function n_given_legs

   !> The row of the approach at the end of pressing.
   pure integer function top_row(values) result(row)
      !> Values of the rows; shape `(n_timed_rows)`.
      real(dp), intent(in) :: values(:)

      row = merge(timed_input%largest_base_approach, timed_input%largest_approach, &
         & is_set(values(timed_input%machine_stiffness)))
   end function top_row

   !> The same values with nothing but pressing, up to an approach.
   pure function pressing_alone(values, top) result(own)
      !> Values of the rows; shape `(n_timed_rows)`.
      real(dp), intent(in) :: values(:)
      !> The approach [m].
      real(dp), intent(in) :: top
      real(dp) :: own(size(values))

      associate (in => timed_input)
         own = values
         own([in%trigger_load, in%dwell_time, in%retraction_rate, in%oscillation_amplitude, in%frequency]) = unset
         own(in%path) = path_ramp
         own(in%cycles) = 1
         own(top_row(values)) = top
      end associate
   end function pressing_alone

   !> The same values with a path of the load that ends pressing.
   pure function pressing_under(values) result(own)
      !> Values of the rows; shape `(n_timed_rows)`.
      real(dp), intent(in) :: values(:)
      real(dp) :: own(size(values))

      associate (in => timed_input)
         own = pressing_alone(values, unset)
         own([in%largest_approach, in%largest_base_approach, in%machine_stiffness, in%approach_rate]) = unset
         own([in%largest_load, in%loading_rate]) = values(in%trigger_load)
         own([in%contact_point, in%drift_rate]) = 0
      end associate
   end function pressing_under

   !> Steps that are written of each leg.
   pure integer function steps_of_leg(values) result(n)
      !> Values of the rows; shape `(n_timed_rows)`.
      real(dp), intent(in) :: values(:)

      n = nint(values(timed_input%steps_per_leg))
      if (n == 0) n = merge(steps_of_path, 1, is_set(values(timed_input%path)))
   end function steps_of_leg

   !> The largest of what is prescribed [m or N].
   pure real(dp) function largest_prescribed(values, lists) result(largest)
      !> Values of the rows; shape `(n_timed_rows)`.
      real(dp), intent(in) :: values(:)
      type(timed_lists_t), intent(in) :: lists

      associate (in => timed_input)
         if (.not. is_set(values(in%path))) then
            largest = maxval(list_of(lists, given_list(values)) + shift_of(values, lists%times))
         else if (is_set(values(in%largest_load))) then
            largest = values(in%largest_load)
         else
            largest = values(merge(in%largest_approach, in%largest_base_approach, is_set(values(in%largest_approach))))
            largest = largest + shift_at(values(in%contact_point), values(in%drift_rate), largest/values(in%approach_rate))
            if (nint(values(in%path)) == path_sine) largest = largest + values(in%oscillation_amplitude)
         end if
      end associate
   end function largest_prescribed

   !> The legs in units of a contact, and what they prescribe.
   pure subroutine get_legs(values, lists, approach_unit, force_unit, range, control, legs, n_before)
      !> Values of the rows; shape `(n_timed_rows)`.
      real(dp), intent(in) :: values(:)
      type(timed_lists_t), intent(in) :: lists
      !> Units of approaches [m] and loads [N].
      real(dp), intent(in) :: approach_unit, force_unit
      !> Range of adhesion, from whose distance on a path with a name begins, in units of approach; 0 without.
      real(dp), intent(in) :: range
      !> Receives what is prescribed.
      type(timed_control_t), intent(out) :: control
      !> Receives the legs, the first of which may be a jump from no contact to what is prescribed first.
      type(timed_leg_t), allocatable, intent(out) :: legs(:)
      !> Receives the number of such jumps, 0 or 1.
      integer, intent(out) :: n_before
      real(dp), allocatable :: prescribed(:)
      real(dp) :: unit
      integer :: row, k

      associate (in => timed_input)
         unit = approach_unit
         if (is_set(values(in%loads)) .or. is_set(values(in%largest_load))) then
            control = timed_control_t(by_approach=0.0_dp, by_load=1.0_dp)
            unit = force_unit
         else if (is_set(values(in%machine_stiffness))) then
            control%by_load = force_unit/(values(in%machine_stiffness)*approach_unit)
         end if
         if (is_set(values(in%path))) then
            call get_path(values, unit, -range*control%by_approach, legs)
            legs%begin = legs%begin + shift_of(values, legs%clock)/unit
            legs%end = legs%end + shift_of(values, legs%clock + legs%span)/unit
            n_before = merge(1, 0, legs(1)%begin > 0)
            if (n_before == 1) legs = [timed_leg_t(begin=0.0_dp, end=legs(1)%begin), legs]
            return
         end if
         row = given_list(values)
         prescribed = (list_of(lists, row) + shift_of(values, lists%times))/unit
         n_before = merge(1, 0, prescribed(1) > 0)
         allocate (legs(size(prescribed) - 1 + n_before))
         if (n_before == 1) legs(1) = timed_leg_t(clock=0.0_dp, span=0.0_dp, begin=0.0_dp, end=prescribed(1))
         do k = 2, size(prescribed)
            legs(k - 1 + n_before) = timed_leg_t(clock=lists%times(k - 1) - lists%times(1), &
               & span=lists%times(k) - lists%times(k - 1), begin=prescribed(k - 1), end=prescribed(k))
         end do
      end associate
   end subroutine get_legs

   !> The legs of a path with a name.
   pure subroutine get_path(values, unit, apart, legs)
      real(dp), intent(in) :: values(:)
      !> Unit of what is prescribed, and where the path begins in it, <= 0.
      real(dp), intent(in) :: unit, apart
      type(timed_leg_t), allocatable, intent(out) :: legs(:)
      type(timed_lists_t) :: none
      real(dp) :: top, pressing, retracting, period
      integer :: n, cycle

      associate (in => timed_input)
         allocate (legs(n_given_legs(values, none)))
         if (is_set(values(in%largest_load))) then
            top = values(in%largest_load)/unit
            pressing = top/(values(in%loading_rate)/unit)
            retracting = pressing
            if (is_set(values(in%unloading_rate))) retracting = top/(values(in%unloading_rate)/unit)
         else
            top = values(merge(in%largest_approach, in%largest_base_approach, is_set(values(in%largest_approach))))/unit
            pressing = (top - apart)/(values(in%approach_rate)/unit)
            retracting = pressing
            if (is_set(values(in%retraction_rate))) retracting = (top - apart)/(values(in%retraction_rate)/unit)
         end if
         n = 0
         do cycle = 1, merge(nint(values(in%cycles)), 1, nint(values(in%path)) == path_triangle)
            call add_leg(legs, n, apart, top, pressing)
            if (is_set(values(in%dwell_time))) call add_leg(legs, n, top, top, values(in%dwell_time))
            if (nint(values(in%path)) == path_triangle) call add_leg(legs, n, top, apart, retracting)
         end do
         if (nint(values(in%path)) /= path_sine) return
         period = 1/values(in%frequency)
         do cycle = 1, nint(values(in%cycles))
            call add_leg(legs, n, top, top, period)
            legs(n)%amplitude = values(in%oscillation_amplitude)/unit
            legs(n)%frequency = two_pi*values(in%frequency)
         end do
      end associate
   end subroutine get_path

   !> Add a straight leg.
   pure subroutine add_leg(legs, n, begin, end, span)
      !> All legs.
      type(timed_leg_t), intent(inout) :: legs(:)
      !> Number of those that are there.
      integer, intent(inout) :: n
      !> What is prescribed at its ends, and its length in time.
      real(dp), intent(in) :: begin, end, span

      n = n + 1
      legs(n) = timed_leg_t(begin=begin, end=end, span=span)
      if (n > 1) legs(n)%clock = legs(n - 1)%clock + legs(n - 1)%span
   end subroutine add_leg

end module adfric_round_timed_history
