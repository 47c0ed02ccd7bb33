!> Values of the model `wavy_sliding` as an input would give them.
module wavy_cases
   use adfric_base_kinds, only: dp
   use adfric_base_model, only: attribute_t
   use adfric_base_problems, only: problems_t
   use adfric_wavy_model, only: wavy_model_t, new_wavy_model
   use adfric_wavy_variables
   implicit none (type, external)
   private
   public :: new_values, set_value, find_problems, solve_values, solve_point

contains

   !> A 2-D wave with adhesion of finite range at a given penetration.
   subroutine new_values(model, values)
      type(wavy_model_t), intent(out) :: model
      real(dp), allocatable, intent(out) :: values(:)

      call new_wavy_model(model)
      values = model%variables%default
      values(v_kind) = 1
      values(v_period) = 1.0e-2_dp
      values(v_height) = 1.0e-4_dp
      values(v_stiffness) = 1.0e8_dp
      values(v_relaxation_time) = 1.0e-3_dp
      values(v_retardation_ratio) = 10
      values(v_stress) = 2.0e3_dp
      values(v_range) = 1.0e-5_dp
      values(v_velocity) = 0.5_dp
      values(v_penetration) = 4.0e-5_dp
   end subroutine new_values

   !> Set a variable by its name; an unknown name ends the program.
   subroutine set_value(model, values, group, name, value)
      type(wavy_model_t), intent(in) :: model
      real(dp), intent(inout) :: values(:)
      character(*), intent(in) :: group, name
      real(dp), intent(in) :: value
      integer :: place

      place = model%index_of(group, name)
      if (place == 0) error stop 'wavy_cases: no such variable'
      values(place) = value
   end subroutine set_value

   !> What the model finds wrong, a line for each problem.
   function find_problems(model, values, swept) result(text)
      type(wavy_model_t), intent(in) :: model
      real(dp), intent(in) :: values(:)
      !> Place of a swept variable.
      integer, intent(in), optional :: swept
      character(:), allocatable :: text
      type(problems_t) :: problems
      logical :: is_swept(size(values))
      integer :: k

      is_swept = .false.
      if (present(swept)) is_swept(swept) = .true.
      call model%check_values(values, is_swept, problems)
      text = ''
      do k = 1, problems%count()
         text = text//problems%line_of(k, 'case')//new_line('a')
      end do
   end function find_problems

   !> Solve points as one block.
   subroutine solve_values(model, values, results, error_estimate, status)
      type(wavy_model_t), intent(in) :: model
      !> Shape `(n_variables, n_points)`.
      real(dp), intent(in) :: values(:, :)
      !> Shape `(n_results, n_points)`.
      real(dp), allocatable, intent(out) :: results(:, :)
      real(dp), allocatable, intent(out) :: error_estimate(:)
      integer, allocatable, intent(out) :: status(:)
      type(attribute_t), allocatable :: attributes(:)
      integer :: n

      n = size(values, 2)
      allocate (results(n_wavy_results, n), error_estimate(n), status(n))
      call model%solve_block(values, results, error_estimate, status, attributes)
   end subroutine solve_values

   !> Solve one point alone.
   subroutine solve_point(model, values, results, error_estimate, status)
      type(wavy_model_t), intent(in) :: model
      real(dp), intent(in) :: values(:)
      real(dp), intent(out) :: results(n_wavy_results)
      real(dp), intent(out) :: error_estimate
      integer, intent(out) :: status
      real(dp), allocatable :: all_results(:, :), errors(:)
      integer, allocatable :: states(:)

      call solve_values(model, spread(values, 2, 1), all_results, errors, states)
      results = all_results(:, 1)
      error_estimate = errors(1)
      status = states(1)
   end subroutine solve_point

end module wavy_cases
