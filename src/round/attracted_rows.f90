! SPDX-License-Identifier: GPL-3.0-or-later
!> Rows of the model `attracted_indenter`, and the values that the model `indenter` would have. The first rows are those of `indenter`.
module adfric_round_attracted_rows
   use adfric_base_kinds, only: dp
   use adfric_base_counting, only: counting
   use adfric_base_unset, only: is_set, unset
   use adfric_describe_rows, only: any_number, result_row
   use adfric_describe_table, only: result_t, variable_t
   use adfric_interface_attraction, only: attraction_of_table, attraction_of_two, attraction_t, law_table, law_words
   use adfric_interface_attraction_rows, only: law_row, table_row
   use adfric_round_indenter_states, only: plain_indenter
   use adfric_round_variables, only: choose_auto, get_indenter_results, get_indenter_variables, indenter_input, &
      & indenter_output, n_indenter_variables
   implicit none (type, external)
   private
   public :: get_attracted_variables, get_attracted_results, values_of_indenter

   !> Last row that is the same as that of `indenter`: lambda.
   integer, parameter :: n_same = indenter_input%lambda
   !> Variables behind those; a component is the index of its row, less `n_same`.
   type :: attracted_input_t
      !> Indices of the rows.
      integer :: law = 0, tension_table = 0, load = 0, approach = 0, contact_radius = 0, base_approach = 0, machine_stiffness = 0, &
         & branch = 0, profiles = 0, n_r = 0, r_max = 0, relative_tolerance = 0
   end type attracted_input_t
   type(attracted_input_t), parameter, public :: attracted_input = transfer(counting, attracted_input_t())
   integer, parameter, public :: before_attracted = n_same, &
      & n_attracted_variables = n_same + storage_size(attracted_input)/storage_size(1)

   !> Results; a component is the index of its row.
   type :: attracted_output_t
      !> Indices of the rows.
      integer :: load = 0, approach = 0, contact_radius = 0, contact_area = 0, mean_pressure = 0, contact_stiffness = 0, &
         & elastic_energy = 0, pull_off_load = 0, pull_off_approach = 0, jump_outward_load = 0, jump_outward_approach = 0, &
         & stable = 0, adhesion_radius = 0, base_approach = 0, adhesion_energy = 0, central_gap = 0, pull_off_excess = 0
   end type attracted_output_t
   type(attracted_output_t), parameter, public :: attracted_output = transfer(counting, attracted_output_t())
   integer, parameter, public :: n_attracted_results = storage_size(attracted_output)/storage_size(1)
   !> Rows of the results of `indenter` that come first here.
   integer, parameter, public :: same_results(*) = [indenter_output%load, indenter_output%approach, &
      & indenter_output%contact_radius, indenter_output%contact_area, indenter_output%mean_pressure, &
      & indenter_output%contact_stiffness, indenter_output%elastic_energy, indenter_output%pull_off_load, &
      & indenter_output%pull_off_approach, indenter_output%jump_outward_load, indenter_output%jump_outward_approach, &
      & indenter_output%stable, indenter_output%adhesion_radius, indenter_output%base_approach]

contains

   !> The variables.
   function get_attracted_variables() result(v)
      type(variable_t), allocatable :: v(:)
      type(variable_t), allocatable :: indenter(:)

      allocate (indenter, source=get_indenter_variables())
      allocate (v(n_attracted_variables))
      v(:n_same) = indenter(:n_same)
      v(indenter_input%adhesion_stress)%meaning = 'largest tension of the law of attraction'
      v(indenter_input%adhesion_range)%meaning = 'length of the law of attraction'
      v(indenter_input%lambda)%meaning = 'Maugis''s parameter of r^n with the largest tension of the law, instead of the '// &
         & 'stress; of a cone, a paraboloid or a power'
      associate (own => v(n_same + 1:), in => attracted_input)
         own(in%law) = law_row(law_words)
         own(in%tension_table) = table_row()
         own(in%load:in%contact_radius) = indenter(indenter_input%load:indenter_input%contact_radius)
         own(in%base_approach:in%machine_stiffness) = indenter(indenter_input%base_approach:indenter_input%machine_stiffness)
         own(in%branch) = indenter(indenter_input%branch)
         own(in%profiles:in%r_max) = indenter(indenter_input%profiles:indenter_input%r_max)
         own(in%relative_tolerance) = any_number(group='numerics', name='relative_tolerance', unit='-', default=1.0e-3_dp, &
            & lower=1.0e-6_dp, upper=1.0e-2_dp, meaning='largest error of load, approach and pull-off over their sizes, '// &
            & 'as grids tell')
      end associate
   end function get_attracted_variables

   !> The results.
   function get_attracted_results() result(r)
      type(result_t), allocatable :: r(:)
      type(result_t), allocatable :: indenter(:)

      allocate (indenter, source=get_indenter_results())
      allocate (r(n_attracted_results))
      r(:size(same_results)) = indenter(same_results)
      associate (out => attracted_output)
         r(out%contact_radius)%long_name = 'radius a of contact; where the law has no wall, of largest tension'
         r(out%adhesion_radius)%long_name = 'radius up to which the gap is at most the range of the law'
         r(out%adhesion_energy) = result_row(name='adhesion_energy', unit='J', long_name='energy of the attraction, below 0')
         r(out%central_gap) = result_row(name='central_gap', unit='m', long_name='gap on the axis; 0 in contact, below 0 where '// &
            & 'a law without a wall pushes')
         r(out%pull_off_excess) = result_row(name='pull_off_excess', unit='-', long_name='pull-off load beyond that of '// &
            & 'Dugdale''s law with the same work of adhesion and largest tension, over the latter')
      end associate
   end function get_attracted_results

   !> The values that the model `indenter` would have: with the same work and largest tension.
   pure function values_of_indenter(values, table) result(indenter)
      !> Values of the variables; shape `(n_attracted_variables)`.
      real(dp), intent(in) :: values(:)
      !> Gaps and tensions of a table; shape `(n, 2)`; not allocated without one.
      real(dp), allocatable, intent(in) :: table(:, :)
      real(dp) :: indenter(n_indenter_variables)
      type(attraction_t) :: law
      integer :: index

      indenter = plain_indenter(values(:indenter_input%second_poisson_ratio))
      index = nint(values(n_same + attracted_input%law))
      associate (in => indenter_input, own => values(n_same + 1:), a => attracted_input)
         indenter(in%work_of_adhesion:in%lambda) = values(in%work_of_adhesion:in%lambda)
         indenter(in%theory) = choose_auto
         indenter(in%load:in%contact_radius) = own(a%load:a%contact_radius)
         indenter(in%base_approach:in%machine_stiffness) = own(a%base_approach:a%machine_stiffness)
         indenter(in%branch) = own(a%branch)
         indenter(in%profiles:in%r_max) = own(a%profiles:a%r_max)
         if (index == law_table .and. allocated(table)) then
            law = attraction_of_table(table(:, 1), table(:, 2))
         else if (index /= law_table .and. count(is_set(values(in%work_of_adhesion:in%adhesion_range))) == 2) then
            law = attraction_of_two(index, values(in%adhesion_stress), values(in%work_of_adhesion), values(in%adhesion_range))
         else
            return
         end if
         indenter(in%work_of_adhesion) = law%work
         indenter(in%adhesion_stress) = law%stress
         indenter(in%adhesion_range) = unset
      end associate
   end function values_of_indenter

end module adfric_round_attracted_rows
