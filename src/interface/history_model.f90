! SPDX-License-Identifier: GPL-3.0-or-later
!> What models of bodies that go through a path of normal and tangential loading with Coulomb's friction share: all but the bodies. What
!> each step leaves is a profile along the axis `step`.
module adfric_interface_history_model
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_solid_contact_modulus, only: derive_contact_modulus, has_contact_modulus, has_poisson_ratio
   use adfric_interface_history_path, only: history_path_t, n_path_profiles, n_path_rows, p_approach, p_contact, &
      & p_friction_loss, p_load, p_stick, p_tangential_displacement, p_tangential_force, path_approaches, &
      & path_coefficient, path_loads, path_tangential_displacements, path_tangential_forces, set_path_profiles, &
      & set_path_rows, out => path_output
   use adfric_interface_normal_contact, only: by_displacement, by_force, find_position, normal_contact_t, normal_state_t
   use adfric_interface_tangential_history, only: history_t, start_history
   use adfric_describe_check, only: require
   use adfric_describe_derived, only: derived_t
   use adfric_describe_pointwise, only: point_state_t
   use adfric_describe_status, only: status_solved, status_no_equilibrium, status_not_converged
   use adfric_describe_stepwise, only: steps_t, stepwise_model_t
   use adfric_describe_table, only: profile_t, variable_t
   implicit none (type, external)
   private
   public :: history_model_t, history_units_t, solve_path

   !> What reduced forces, approaches and lengths in the plane are in.
   type :: history_units_t
      !> Force [N], approach [m] and length in the plane [m].
      real(dp) :: force = 1, approach = 1, length = 1
      !> m, the ratio of the tangential to the normal compliance.
      real(dp) :: compliance_ratio = 1
   end type history_units_t

   !> A model with a path. Its rows are those of the bodies, and behind these the ones of the path.
   type, abstract, extends(stepwise_model_t) :: history_model_t
      !> The path.
      type(history_path_t) :: path
      !> Number of the rows of the bodies.
      integer :: n_bodies = 0
      !> First and last index of the rows of the contact modulus.
      integer :: solids(2) = 0
   contains
      procedure :: set_history_tables
      procedure :: largest_of
      procedure :: take_dataset
      procedure :: check_values
      procedure :: count_steps
      procedure :: describe_doubts
      procedure :: solve_point
      procedure :: derive_quantities
      procedure(check_bodies_i), deferred :: check_bodies
      procedure(find_contacts_i), deferred :: find_contacts
   end type history_model_t

   abstract interface

      !> Add to `problems` what is wrong with the bodies; friction and path are checked elsewhere.
      subroutine check_bodies_i(self, values, problems)
         import :: history_model_t, dp, problems_t
         implicit none (type, external)
         !> The model; its tables give the variables their names.
         class(history_model_t), intent(in) :: self
         !> Values of the variables; shape `(n_variables)`.
         real(dp), intent(in) :: values(:)
         !> Receives what is wrong with the input; nothing is removed.
         type(problems_t), intent(inout) :: problems
      end subroutine check_bodies_i

      !> The bodies under all loads, in units of the path.
      subroutine find_contacts_i(self, values, contacts, units, is_possible)
         import :: history_model_t, dp, normal_contact_t, history_units_t
         implicit none (type, external)
         !> The model with its path.
         class(history_model_t), intent(in) :: self
         !> Values of the variables; shape `(n_variables)`.
         real(dp), intent(in) :: values(:)
         !> Receives the contacts, reduced; not allocated where they are not possible.
         class(normal_contact_t), allocatable, intent(out) :: contacts
         !> Receives their units.
         type(history_units_t), intent(out) :: units
         !> Are the largest contact of the path and its units within the numbers?
         logical, intent(out) :: is_possible
      end subroutine find_contacts_i

   end interface

contains

   !> Set the tables of the model, but for its name and its summary; results of its own follow those of the path.
   subroutine set_history_tables(self, bodies, solids, contact, stick)
      class(history_model_t), intent(inout) :: self
      !> Rows of the bodies.
      type(variable_t), intent(in) :: bodies(:)
      !> First and last index of the rows of the contact modulus among these.
      integer, intent(in) :: solids(2)
      !> Rows of the size of the contact, and of what sticks.
      type(profile_t), intent(in) :: contact, stick

      self%references = 'R. D. Mindlin, H. Deresiewicz, J. Appl. Mech. 20 (1953) 327; J. Jaeger, Arch. Appl. Mech. 63 (1993) 402'
      self%n_bodies = size(bodies)
      self%solids = solids
      allocate (self%variables(self%n_bodies + n_path_rows))
      self%variables(:self%n_bodies) = bodies
      call set_path_rows(self%variables(self%n_bodies + 1:))
      allocate (self%profiles(n_path_profiles))
      call set_path_profiles(contact, stick, self%profiles)
      self%profile_axes = 'step'
      allocate (self%counts(0))
   end subroutine set_history_tables

   !> Largest load or approach of the path; below 0 where it is not given.
   pure real(dp) function largest_of(self, values, list) result(largest)
      class(history_model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> `path_loads` or `path_approaches`.
      integer, intent(in) :: list

      largest = -1
      if (is_set(values(self%n_bodies + list))) largest = maxval(self%path%lists(list)%values)
   end function largest_of

   !> See `model_t`.
   subroutine take_dataset(self, index, values, problems)
      class(history_model_t), intent(inout) :: self
      !> Index of the list in `variables`.
      integer, intent(in) :: index
      !> Its numbers; shape `(n_steps, 1)`.
      real(dp), intent(in) :: values(:, :)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      self%path%lists(index - self%n_bodies)%values = values(:, 1)
      associate (unused => problems)
      end associate
   end subroutine take_dataset

   !> See `model_t`.
   subroutine check_values(self, values, is_swept, problems)
      class(history_model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Is the variable swept? Shape `(n_variables)`.
      logical, intent(in) :: is_swept(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      class(normal_contact_t), allocatable :: contacts
      type(history_units_t) :: units
      integer :: before
      logical :: is_possible

      associate (unused => is_swept)
      end associate
      before = problems%count()
      call self%check_bodies(values, problems)
      associate (n => self%n_bodies, moduli => values(self%solids(1):self%solids(2)))
         call require(self%variables, values, [n + path_coefficient], problems)
         if (has_contact_modulus(moduli) .and. .not. has_poisson_ratio(moduli)) &
            & call problems%add('solid', 'poisson_ratio', 'is missing [-]; the tangential displacement needs it')
         call self%path%check(self%variables(n + 1:), values(n + 1:), problems)
         if (problems%count() > before) return
         call self%find_contacts(values, contacts, units, is_possible)
         if (is_possible) return
         associate (v => self%variables(n + merge(path_loads, path_approaches, is_set(values(n + path_loads)))))
            call problems%add(v%group, v%name, 'lead to numbers above 1e308 or below 1e-308 with these bodies')
         end associate
      end associate
   end subroutine check_values

   !> See `stepwise_model_t`.
   pure integer function count_steps(self, values)
      class(history_model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      count_steps = self%path%count_steps()
      associate (unused => values)
      end associate
   end function count_steps

   !> See `model_t`: a force that no friction holds.
   function describe_doubts(self, values) result(text)
      class(history_model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text

      text = self%path%warn_of_sliding(values(self%n_bodies + 1:))
   end function describe_doubts

   !> See `pointwise_model_t`.
   subroutine solve_point(self, values, state, results, error_estimate, status, counts)
      class(history_model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives the steps, for the profiles; nothing is taken from the point before.
      class(point_state_t), allocatable, intent(inout) :: state
      !> In: all NaN. Out: results of the point, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Relative error of the energy that friction takes, and at least round-off.
      real(dp), intent(out) :: error_estimate
      !> One of `status_...`.
      integer, intent(out) :: status
      !> This model counts nothing; size 0.
      real(dp), intent(inout) :: counts(:)

      call solve_path(self, values, state, results, error_estimate, status)
      associate (unused_counts => counts)
      end associate
   end subroutine solve_point

   !> Solve one point; results of the model's own are left as they are.
   subroutine solve_path(self, values, state, results, error_estimate, status)
      class(history_model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives the steps, for the profiles; nothing is taken from the point before.
      class(point_state_t), allocatable, intent(inout) :: state
      !> Receives the results of the path; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Relative error of the energy that friction takes, and at least round-off.
      real(dp), intent(out) :: error_estimate
      !> One of `status_...`.
      integer, intent(out) :: status
      class(normal_contact_t), allocatable :: contacts
      type(steps_t), allocatable :: found
      type(history_units_t) :: units
      type(history_t) :: history
      logical :: is_possible

      error_estimate = 0
      status = status_no_equilibrium
      call self%find_contacts(values, contacts, units, is_possible)
      if (.not. is_possible) return
      allocate (found)
      call follow_path(self%path, values(self%n_bodies + 1:), contacts, units, history, found%steps, status)
      if (status /= status_solved) return
      results(out%total_loss) = found%steps(size(found%steps, 1), p_friction_loss)
      results(out%largest_force) = maxval(abs(found%steps(:, p_tangential_force)))
      results(out%largest_displacement) = maxval(abs(found%steps(:, p_tangential_displacement)))
      error_estimate = 16*epsilon(1.0_dp)
      if (results(out%total_loss) > 0) error_estimate = max(error_estimate, history%loss_error/history%loss)
      call move_alloc(found, state)
   end subroutine solve_path

   !> Go through the path.
   pure subroutine follow_path(path, values, contacts, units, history, steps, status)
      type(history_path_t), intent(in) :: path
      !> Values of its rows; shape `(n_path_rows)`.
      real(dp), intent(in) :: values(:)
      class(normal_contact_t), intent(in) :: contacts
      type(history_units_t), intent(in) :: units
      type(history_t), intent(out) :: history
      !> Receives what each step leaves, in SI units; shape `(n_steps, n_path_profiles)`.
      real(dp), allocatable, intent(out) :: steps(:, :)
      !> Receives one of `status_...`.
      integer, intent(out) :: status
      type(normal_state_t) :: next
      integer :: along, kind, k
      logical :: is_converged, is_possible

      along = merge(by_force, by_displacement, is_set(values(path_loads)))
      kind = merge(by_force, by_displacement, is_set(values(path_tangential_forces)))
      associate (normal => path%lists(merge(path_loads, path_approaches, along == by_force))%values, &
         & tangential => path%lists(merge(path_tangential_forces, path_tangential_displacements, kind == by_force))%values, &
         & unit_of => [units%force, units%approach], mu => values(path_coefficient), compliance => units%compliance_ratio)
         allocate (steps(size(normal), n_path_profiles))
         call start_history(history)
         status = status_solved
         do k = 1, size(normal)
            is_converged = .true.
            call find_position(contacts, along, normal(k)/unit_of(along), next, is_converged)
            if (.not. normal(k) > 0 .and. along == by_displacement) next%approach = normal(k)/unit_of(along)
            call history%advance(contacts, next, kind, tangential(k) &
               & /(mu*unit_of(kind)*merge(compliance, 1.0_dp, kind == by_displacement)), is_possible)
            if (.not. is_possible) status = status_no_equilibrium
            if (.not. (is_converged .and. history%is_converged)) status = status_not_converged
            if (status /= status_solved) return
            call show_step(history, mu, units, steps(k, :))
            ! what is given is kept to the last digit
            steps(k, merge(p_load, p_approach, along == by_force)) = normal(k)
            steps(k, merge(p_tangential_force, p_tangential_displacement, kind == by_force)) = tangential(k)
         end do
      end associate
   end subroutine follow_path

   !> What a step leaves, in SI units.
   pure subroutine show_step(history, mu, units, step)
      type(history_t), intent(in) :: history
      !> Coefficient of friction.
      real(dp), intent(in) :: mu
      type(history_units_t), intent(in) :: units
      !> Receives the numbers; shape `(n_path_profiles)`.
      real(dp), intent(out) :: step(:)

      associate (compliance => units%compliance_ratio)
         step(p_load) = history%normal%load*units%force
         step(p_approach) = history%normal%approach*units%approach
         step(p_tangential_force) = mu*history%force*units%force
         step(p_tangential_displacement) = mu*compliance*history%displacement*units%approach
         step(p_contact) = history%normal%radius*units%length
         step(p_stick) = history%stick_radius()*units%length
         ! nothing but round-off is nothing
         step(p_friction_loss) = 0
         if (history%loss > history%loss_error) step(p_friction_loss) = mu**2*compliance*history%loss*(units%force*units%approach)
      end associate
   end subroutine show_step

   !> See `model_t`.
   function derive_quantities(self, values) result(derived)
      class(history_model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      type(derived_t), allocatable :: derived(:)

      associate (first => self%solids(1), last => self%solids(2))
         derived = derive_contact_modulus(self%variables(first:last), values(first:last))
      end associate
   end function derive_quantities

end module adfric_interface_history_model
