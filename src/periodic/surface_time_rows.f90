! SPDX-License-Identifier: GPL-3.0-or-later
!> Rows of the model `surface_time`: its history, its results and its profiles.
module adfric_periodic_surface_time_rows
   use adfric_base_kinds, only: dp
   use adfric_base_counting, only: counting
   use adfric_describe_rows, only: list_row, result_row, whole_number
   use adfric_describe_table, only: profile_t, result_t, variable_t
   implicit none (type, external)
   private
   public :: set_history_rows, set_ageing_results

   !> Rows of the history in their order; a component is the index of its row.
   type :: ageing_input_t
      !> Indices of the rows.
      integer :: times = 0, mean_pressures = 0, steps_per_leg = 0
   end type ageing_input_t
   type(ageing_input_t), parameter, public :: ageing_input = transfer(counting, ageing_input_t())
   integer, parameter, public :: n_ageing_rows = storage_size(ageing_input)/storage_size(1)

   !> Results in the order of their rows; a component is the index of its row.
   type :: ageing_output_t
      !> Indices of the rows.
      integer :: last_fraction = 0, last_smooth_fraction = 0, last_penetration = 0, growth = 0, contact_violation = 0
   end type ageing_output_t
   type(ageing_output_t), parameter, public :: ageing_output = transfer(counting, ageing_output_t())
   integer, parameter, public :: n_ageing_results = storage_size(ageing_output)/storage_size(1)
   !> Indices of the profiles.
   integer, parameter, public :: p_time = 1, p_pressure = 2, p_penetration = 3, p_fraction = 4, p_smooth = 5, p_gap = 6, &
      & p_elastic = 7, n_ageing_profiles = 7

contains

   !> Rows of the history.
   subroutine set_history_rows(v)
      !> Receives the rows; shape `(n_ageing_rows)`.
      type(variable_t), intent(out) :: v(:)

      associate (in => ageing_input)
         v(in%times) = list_row(group='history', name='times', unit='s', meaning='times at which the mean '// &
            & 'pressure is given; between them it is straight, and where two are equal it jumps', most_count=1000000, least_count=2)
         v(in%mean_pressures) = list_row(group='history', name='mean_pressures', unit='Pa', &
            & meaning='load over nominal area at these times', most_count=1000000, least_count=2, lower=0.0_dp)
         v(in%steps_per_leg) = whole_number(group='output', name='steps_per_leg', meaning='steps that are '// &
            & 'written of each straight leg', default=1, lower=1, upper=1000000)
      end associate
   end subroutine set_history_rows

   !> Rows of the results and the profiles.
   subroutine set_ageing_results(r, p)
      !> Receives the results; shape `(n_ageing_results)`.
      type(result_t), intent(out) :: r(:)
      !> Receives the profiles; shape `(n_ageing_profiles)`.
      type(profile_t), intent(out) :: p(:)

      associate (out => ageing_output)
         r(out%last_fraction) = result_row(name='largest_contact_fraction', unit='-', &
            & long_name='share of the area in contact at the last step, which is the largest', is_main=.true.)
         r(out%last_smooth_fraction) = result_row(name='largest_smooth_contact_fraction', unit='-', &
            & long_name='the same from where its edge cuts rows and columns of cells')
         r(out%last_penetration) = result_row(name='largest_penetration', unit='m', &
            & long_name='approach from first touch at the last step, at the mean of the deformed surface', is_main=.true.)
         r(out%growth) = result_row(name='contact_growth', unit='-', &
            & long_name='share of the area in contact at the last step over that at the first step with a load', is_main=.true.)
         r(out%contact_violation) = result_row(name='contact_violation', unit='-', &
            & long_name='largest violation of g >= 0, p >= 0, g p = 0 of all steps')
         p(p_time) = profile_t(name='time', unit='s', long_name='time')
         p(p_pressure) = profile_t(name='mean_pressure', unit='Pa', long_name='load over nominal area')
         p(p_penetration) = profile_t(name='penetration', unit='m', &
            & long_name='approach from first touch, at the mean of the deformed surface')
         p(p_fraction) = profile_t(name='contact_fraction', unit='-', long_name='share of the area in contact')
         p(p_smooth) = profile_t(name='smooth_contact_fraction', unit='-', &
            & long_name='share of the area in contact from where its edge cuts rows and columns of cells')
         p(p_gap) = profile_t(name='mean_gap', unit='m', long_name='volume between the surfaces over nominal area')
         p(p_elastic) = profile_t(name='elastic_mean_pressure', unit='Pa', &
            & long_name='mean pressure under which the relaxed solid has this contact')
      end associate
   end subroutine set_ageing_results

end module adfric_periodic_surface_time_rows
