! SPDX-License-Identifier: GPL-3.0-or-later
!> Fits of the reference sets, with what is known of their answers.
module fit_cases
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: unset
   use adfric_fit_problem
   use adfric_round_model, only: indenter_model_t, new_indenter_model
   use adfric_describe_model, only: model_t
   use adfric_round_sphere_model, only: sphere_model_t, new_sphere_model
   use adfric_round_sphere_variables, only: units_si, state_sliding, sphere_input, out => sphere_output
   use adfric_foundation_model, only: wavy_model_t, new_wavy_model
   use reference_table, only: table_t, read_table
   implicit none (type, external)
   private
   public :: theory_position
   public :: new_reference_fit, new_sphere_values, answer, has_answer, reference_name, add_free, add_sphere_data, models_t, &
      & new_models

   !> The models that fits point to.
   type :: models_t
      type(sphere_model_t) :: sphere
      type(wavy_model_t) :: wavy
      type(indenter_model_t) :: indenter
   end type models_t

contains

   !> Make the models.
   subroutine new_models(models)
      type(models_t), intent(out) :: models

      call new_sphere_model(models%sphere)
      call new_wavy_model(models%wavy)
      call new_indenter_model(models%indenter)
   end subroutine new_models

   !> Values of a sphere without anything measured.
   subroutine new_sphere_values(models, values)
      type(models_t), intent(in) :: models
      real(dp), allocatable, intent(out) :: values(:)

      values = models%sphere%variables%default
      values(sphere_input%units) = units_si
      values(sphere_input%state) = state_sliding
   end subroutine new_sphere_values

   !> The fit of a reference set, and the table of its answers.
   subroutine new_reference_fit(models, name, number, fit, answers, is_there)
      type(models_t), intent(in), target :: models
      character(*), intent(in) :: name
      !> Number of the fit in the set, from 1.
      integer, intent(in) :: number
      type(fit_t), intent(out) :: fit
      type(table_t), intent(out) :: answers
      !> Has the set a fit of this number?
      logical, intent(out) :: is_there
      character(:), allocatable :: kind
      real(dp) :: value
      integer :: k

      call read_table(answers, 'fit/'//name//'_answers')
      if (answers%n_rows == 0) error stop 'fit_cases: there is no such set'
      kind = word_of(answers, number, 'kind')
      is_there = len(kind) > 0
      if (.not. is_there) return
      if (kind == 'velocity') then
         fit%model => models%wavy
         fit%base = models%wavy%variables%default
         fit%base(fit%model%index_of('surface', 'kind')) = 1
         fit%base(fit%model%index_of('operating', 'load')) = 12
      else
         fit%model => models%sphere
         call new_sphere_values(models, fit%base)
         fit%base(sphere_input%theory) = theory_position(models, theory_of(answers, number))
      end if
      allocate (fit%frees(0), fit%data_sets(0), fit%events(0), fit%theories(0))
      allocate (fit%levels, source=[0.6827_dp, 0.95_dp])
      fit%derived = ''
      call add_data(fit, name, kind, answers, number)
      do k = 1, answers%n_rows
         if (nint(answers%number(k, 'fit')) /= number) cycle
         value = answers%number(k, 'value')
         select case (answers%text(k, 'quantity'))
         case ('free')
            call add_reference_free(fit, answers, number, answers%text(k, 'first'), value > 0)
         case ('fixed')
            call set_fixed(fit, answers%text(k, 'first'), value)
         case ('event')
            fit%events = [fit%events, event_t(1, event_pull_off_load, value, answer(answers, number, 'event_sigma', &
               & 'pull_off_load'))]
         case ('loss')
            fit%data_sets%loss = position_of_loss(answers%text(k, 'first'))
            fit%data_sets%loss_width = value
         end select
      end do
   end subroutine new_reference_fit

   !> Number of a loss.
   pure integer function position_of_loss(name) result(position)
      character(*), intent(in) :: name

      position = loss_gauss
      if (name == 'huber') position = loss_huber
      if (name == 'soft_l1') position = loss_soft_l1
      if (name == 'cauchy') position = loss_cauchy
   end function position_of_loss

   !> Position of a theory among the choices of the sphere.
   integer function theory_position(models, name) result(position)
      type(models_t), intent(in) :: models
      character(*), intent(in) :: name
      character(:), allocatable :: choices

      choices = models%sphere%variables(sphere_input%theory)%choices
      choices = choices(:index(choices//' ', name//' ') - 1)
      position = 1 + count([(choices(position:position) == ' ', position=1, len(choices))])
   end function theory_position

   !> Theory of a fit.
   function theory_of(answers, number) result(theory)
      type(table_t), intent(in) :: answers
      integer, intent(in) :: number
      character(:), allocatable :: theory
      integer :: k

      theory = ''
      do k = 1, answers%n_rows
         if (nint(answers%number(k, 'fit')) == number .and. answers%text(k, 'quantity') == 'kind') theory = answers%text(k, &
            & 'second')
      end do
   end function theory_of

   !> First word of a quantity.
   function word_of(answers, number, quantity) result(word)
      type(table_t), intent(in) :: answers
      integer, intent(in) :: number
      character(*), intent(in) :: quantity
      character(:), allocatable :: word
      integer :: k

      word = ''
      do k = 1, answers%n_rows
         if (nint(answers%number(k, 'fit')) == number .and. answers%text(k, 'quantity') == quantity) word = answers%text(k, 'first')
      end do
   end function word_of

   !> Is there such an answer?
   logical function has_answer(answers, number, quantity, first, second)
      type(table_t), intent(in) :: answers
      integer, intent(in) :: number
      character(*), intent(in) :: quantity
      character(*), intent(in), optional :: first, second

      has_answer = row_of(answers, number, quantity, first, second) > 0
   end function has_answer

   !> Row of an answer; 0: there is none.
   integer function row_of(answers, number, quantity, first, second) result(row)
      type(table_t), intent(in) :: answers
      integer, intent(in) :: number
      character(*), intent(in) :: quantity
      character(*), intent(in), optional :: first, second
      integer :: k

      row = 0
      do k = 1, answers%n_rows
         if (nint(answers%number(k, 'fit')) /= number .or. answers%text(k, 'quantity') /= quantity) cycle
         if (present(first)) then
            if (answers%text(k, 'first') /= first) cycle
         end if
         if (present(second)) then
            if (answers%text(k, 'second') /= second) cycle
         end if
         row = k
         return
      end do
   end function row_of

   !> An answer; one that no test expects if there is none.
   real(dp) function answer(answers, number, quantity, first, second)
      type(table_t), intent(in) :: answers
      integer, intent(in) :: number
      character(*), intent(in) :: quantity
      character(*), intent(in), optional :: first, second
      integer :: k

      answer = -1.0e99_dp
      k = row_of(answers, number, quantity, first, second)
      if (k > 0) answer = answers%number(k, 'value')
   end function answer

   !> Name of a free variable in the reference.
   function reference_name(name) result(other)
      character(*), intent(in) :: name
      character(:), allocatable :: other

      other = name
      if (name == 'retardation_ratio') other = 'retardation_excess'
   end function reference_name

   !> Give a value to what is not free.
   subroutine set_fixed(fit, name, value)
      type(fit_t), intent(inout) :: fit
      character(*), intent(in) :: name
      real(dp), intent(in) :: value
      integer :: k

      if (name == 'spring_stiffness') then
         do k = 1, size(fit%data_sets)
            fit%data_sets(k)%nuisance(nuisance_spring_stiffness) = value
         end do
      else if (name == 'retardation_excess') then
         fit%base(fit%model%index_of('foundation', 'retardation_ratio')) = 1 + value
      else
         fit%base(position_of(fit%model, name)) = value
      end if
   end subroutine set_fixed

   !> Position of a variable by its name alone, the first one of that name.
   integer function position_of(model, name)
      class(model_t), intent(in) :: model
      character(*), intent(in) :: name

      do position_of = 1, size(model%variables)
         if (model%variables(position_of)%name == name) return
      end do
      error stop 'fit_cases: no such variable'
   end function position_of

   !> Free a variable with the bounds and the prior of the reference.
   subroutine add_reference_free(fit, answers, number, name, is_log)
      type(fit_t), intent(inout) :: fit
      type(table_t), intent(in) :: answers
      integer, intent(in) :: number
      character(*), intent(in) :: name
      logical, intent(in) :: is_log
      real(dp) :: low, high
      integer :: n

      low = answer(answers, number, 'lower', name)
      high = answer(answers, number, 'upper', name)
      if (name == 'retardation_excess') then
         call add_free(fit, 'retardation_ratio', is_log, 1 + low, 1 + high)
      else
         call add_free(fit, name, is_log, low, high)
      end if
      n = size(fit%frees)
      if (has_answer(answers, number, 'prior', name)) then
         fit%frees(n)%prior = answer(answers, number, 'prior', name)
         fit%frees(n)%prior_sigma = answer(answers, number, 'prior_sigma', name)
      end if
      if (fit%model%name == 'wavy_sliding') fit%frees(n)%start = answer(answers, number, 'start', name)
   end subroutine add_reference_free

   !> Free a variable of the model, or a nuisance of the first data set.
   subroutine add_free(fit, name, is_log, minimum, maximum)
      type(fit_t), intent(inout) :: fit
      character(*), intent(in) :: name
      logical, intent(in) :: is_log
      real(dp), intent(in) :: minimum, maximum
      type(free_t) :: free
      type(free_t), allocatable :: frees(:)
      integer :: n

      free%name = name
      free%unit = '-'
      free%is_log = is_log
      free%minimum = minimum
      free%maximum = maximum
      select case (name)
      case ('load_offset')
         free%nuisance = nuisance_load_offset
      case ('friction_offset')
         free%nuisance = nuisance_friction_offset
      case ('contact_point')
         free%nuisance = nuisance_contact_point
      case ('lateral_gain')
         free%nuisance = nuisance_lateral_gain
      case ('spring_stiffness')
         free%nuisance = nuisance_spring_stiffness
      case ('tilt')
         free%nuisance = nuisance_tilt
      case default
         free%variable = position_of(fit%model, name)
         free%unit = fit%model%variables(free%variable)%unit
      end select
      if (free%nuisance > 0) free%data_set = 1
      n = 0
      if (allocated(fit%frees)) n = size(fit%frees)
      allocate (frees(n + 1))
      if (n > 0) frees(:n) = fit%frees
      frees(n + 1) = free
      call move_alloc(frees, fit%frees)
   end subroutine add_free

   !> The data of a set.
   subroutine add_data(fit, name, kind, answers, number)
      type(fit_t), intent(inout) :: fit
      character(*), intent(in) :: name, kind
      type(table_t), intent(in) :: answers
      integer, intent(in) :: number
      type(table_t) :: table
      type(data_set_t) :: data
      logical :: has_sigma, has_load_errors

      call read_table(table, 'fit/'//name)
      if (table%n_rows == 0) error stop 'fit_cases: there are no data'
      has_sigma = .not. answer(answers, number, 'unknown_sigma') > 0
      has_load_errors = answer(answers, number, 'load_errors') > 0
      select case (kind)
      case ('velocity')
         call take_columns(table, 'velocity', 'friction_force', has_sigma, .false., data)
         data%abscissa = fit%model%index_of('operating', 'velocity')
         data%ordinate = 3
      case ('force_distance')
         call take_columns(table, 'position', 'load', has_sigma, .false., data)
         data%abscissa = sphere_input%approach
         data%ordinate = out%load
      case ('area')
         call take_columns(table, 'load', 'contact_area', has_sigma, .false., data)
         data%abscissa = sphere_input%load
         data%ordinate = out%contact_area
      case default
         call take_columns(table, 'load', 'friction_force', has_sigma, has_load_errors, data)
         data%abscissa = sphere_input%load
         data%ordinate = out%friction_force
      end select
      fit%data_sets = [data]
      if (kind /= 'joint') return
      call read_table(table, 'fit/'//name//'_area')
      call take_columns(table, 'load', 'contact_area', has_sigma, .false., data)
      data%ordinate = out%friction_area
      fit%data_sets = [fit%data_sets, data]
   end subroutine add_data

   !> Columns of a table as a data set.
   subroutine take_columns(table, abscissa, ordinate, has_sigma, has_load_errors, data)
      type(table_t), intent(in) :: table
      character(*), intent(in) :: abscissa, ordinate
      logical, intent(in) :: has_sigma, has_load_errors
      type(data_set_t), intent(inout) :: data
      integer :: k

      data%x = [(table%number(k, abscissa), k=1, table%n_rows)]
      data%y = [(table%number(k, ordinate), k=1, table%n_rows)]
      if (has_sigma) data%sigma = [(column(table, k, 'sigma'), k=1, table%n_rows)]
      if (has_load_errors) data%x_sigma = [(table%number(k, 'sigma_load'), k=1, table%n_rows)]
      if (any(table%header == 'contact')) then
         data%is_contact = [(table%number(k, 'contact') > 0.5_dp, k=1, table%n_rows)]
         data%segment = [(nint(table%number(k, 'segment')), k=1, table%n_rows)]
      end if
   end subroutine take_columns

   !> A number of the column of exactly this name.
   real(dp) function column(table, row, name)
      type(table_t), intent(in) :: table
      integer, intent(in) :: row
      character(*), intent(in) :: name
      integer :: k

      column = -1.0e99_dp
      do k = 1, size(table%header)
         if (table%header(k) == name) read (table%cells(k, row), *) column
      end do
   end function column

   !> Add points of a sphere: friction against load, or another pair.
   subroutine add_sphere_data(fit, abscissa, ordinate, x, y, sigma)
      type(fit_t), intent(inout) :: fit
      integer, intent(in) :: abscissa, ordinate
      real(dp), intent(in) :: x(:), y(:)
      !> One standard error for all; `unset`: not known.
      real(dp), intent(in) :: sigma
      type(data_set_t) :: data

      data%abscissa = abscissa
      data%ordinate = ordinate
      data%x = x
      data%y = y
      if (sigma < unset) allocate (data%sigma(size(x)), source=sigma)
      if (allocated(fit%data_sets)) then
         fit%data_sets = [fit%data_sets, data]
      else
         fit%data_sets = [data]
      end if
   end subroutine add_sphere_data

end module fit_cases
