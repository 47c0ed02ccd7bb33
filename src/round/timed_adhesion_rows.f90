! SPDX-License-Identifier: GPL-3.0-or-later
!> Rows of the model `adhesive_indenter_time` beside those of `indenter_time`: adhesion and cells as input, and its results.
module adfric_round_timed_adhesion_rows
   use adfric_base_kinds, only: dp
   use adfric_base_counting, only: counting
   use adfric_describe_rows, only: result_row, whole_number
   use adfric_describe_table, only: profile_t, result_t, variable_t
   use adfric_round_timed_rows, only: n_timed_profiles, n_timed_results, set_timed_profiles, set_timed_results, timed_output
   use adfric_round_variables, only: indenter_input
   implicit none (type, external)
   private
   public :: set_adhesion_rows, set_adhesion_results, set_adhesion_profiles

   !> Variables behind those of `indenter_time`; a component is the index of its row.
   type :: adhesion_input_t
      !> Indices of the rows.
      integer :: work_of_adhesion = 0, adhesion_stress = 0, adhesion_range = 0, lambda = 0, cells = 0
   end type adhesion_input_t
   type(adhesion_input_t), parameter, public :: adhesion_input = transfer(counting, adhesion_input_t())
   integer, parameter, public :: n_adhesion_rows = storage_size(adhesion_input)/storage_size(1)

   !> Results behind those of `indenter_time`; a component is the index of its row.
   type :: adhesion_output_t
      !> Indices of the rows.
      integer :: pull_off_load = 0, pull_off_approach = 0, pull_off_time = 0, jump_in_approach = 0, jump_in_load = 0, &
         & jumps = 0, adhesion_energy = 0, relaxed_pull_off_load = 0, glassy_pull_off_load = 0, frozen_pull_off_load = 0, &
         & cells_per_zone = 0
   end type adhesion_output_t
   type(adhesion_output_t), parameter, public :: adhesion_output = transfer(counting, adhesion_output_t())
   integer, parameter, public :: n_adhesion_results = storage_size(adhesion_output)/storage_size(1)
   !> The profile behind those of `indenter_time`.
   integer, parameter, public :: p_adhesion_radius = n_timed_profiles + 1, n_adhesion_profiles = p_adhesion_radius
   !> Most cells that may be asked for.
   integer, parameter, public :: most_cells = 20000

contains

   !> The rows.
   subroutine set_adhesion_rows(indenter, v)
      !> The table of the model `indenter`, which has the same adhesion; shape `(n_indenter_variables)`.
      type(variable_t), intent(in) :: indenter(:)
      !> Receives the rows; shape `(n_adhesion_rows)`.
      type(variable_t), intent(out) :: v(:)

      v(:adhesion_input%lambda) = indenter(indenter_input%work_of_adhesion:indenter_input%lambda)
      v(adhesion_input%lambda)%meaning = 'Maugis''s parameter of r^n with the relaxed modulus, instead of the '// &
         & 'stress; of a cone, a paraboloid or a power'
      v(adhesion_input%cells) = whole_number(group='numerics', name='cells', meaning='cells of the first grid up to the '// &
         & 'largest radius of adhesion; if not given what radii and zone need', default=0, lower=0, upper=most_cells)
   end subroutine set_adhesion_rows

   !> The results.
   subroutine set_adhesion_results(r)
      !> Receives the rows; shape `(n_timed_results + n_adhesion_results)`.
      type(result_t), intent(out) :: r(:)
      type(adhesion_output_t), parameter :: out = adhesion_output

      call set_timed_results(r(:n_timed_results))
      r(timed_output%loss_time)%long_name = 'time at which adhesion is lost for the last time'
      r(timed_output%dissipated_energy)%long_name = 'energy that relaxation and jumps have taken by the end'
      r(timed_output%energy_imbalance)%long_name = 'work less what springs, arms and adhesion store and what '// &
         & 'relaxation and jumps have taken, over the largest of all these: an independent check'
      associate (r => r(n_timed_results + 1:))
         r(out%pull_off_load) = result_row(name='pull_off_load', unit='N', long_name='least load while retracting; '// &
            & 'absent where retraction ends before it', is_main=.true.)
         r(out%pull_off_approach) = result_row(name='pull_off_approach', unit='m', long_name='approach at that load', &
            & is_main=.true.)
         r(out%pull_off_time) = result_row(name='pull_off_time', unit='s', long_name='time of that load')
         r(out%jump_in_approach) = result_row(name='jump_in_approach', unit='m', long_name='approach at which adhesion first '// &
            & 'jumps in')
         r(out%jump_in_load) = result_row(name='jump_in_load', unit='N', long_name='load after the first jump in')
         r(out%jumps) = result_row(name='jumps', unit='-', long_name='jumps of the radius of adhesion, in and off')
         r(out%adhesion_energy) = result_row(name='adhesion_energy', unit='J', long_name='energy of adhesion at the end, below 0')
         r(out%relaxed_pull_off_load) = result_row(name='relaxed_pull_off_load', unit='N', long_name='pull-off load with the '// &
            & 'relaxed modulus: the limit of slow retraction', is_main=.true.)
         r(out%glassy_pull_off_load) = result_row(name='glassy_pull_off_load', unit='N', long_name='pull-off load with the '// &
            & 'instantaneous modulus: the limit of an approach and a retraction that are both fast')
         r(out%frozen_pull_off_load) = result_row(name='frozen_pull_off_load', unit='N', long_name='limit of a fast retraction '// &
            & 'after a relaxed contact at the largest approach or load', is_main=.true.)
         r(out%cells_per_zone) = result_row(name='cells_per_zone', unit='-', long_name='cells of the narrowest zone that '// &
            & 'was met')
      end associate
   end subroutine set_adhesion_results

   !> The profiles.
   subroutine set_adhesion_profiles(p)
      !> Receives the rows; shape `(n_adhesion_profiles)`.
      type(profile_t), intent(out) :: p(:)

      call set_timed_profiles(p(:n_timed_profiles))
      p(p_adhesion_radius) = profile_t(name='adhesion_radius', unit='m', long_name='radius c up to which adhesion acts')
   end subroutine set_adhesion_profiles

end module adfric_round_timed_adhesion_rows
