! SPDX-License-Identifier: GPL-3.0-or-later
!> Results and profiles of the model `indenter_time`.
module adfric_round_timed_rows
   use adfric_base_counting, only: counting
   use adfric_describe_rows, only: result_row
   use adfric_describe_table, only: profile_t, result_t
   implicit none (type, external)
   private
   public :: set_timed_results, set_timed_profiles

   !> Results in the order of their rows; a component is the index of its row.
   type :: timed_output_t
      !> Indices of the rows.
      integer :: largest_load = 0, largest_approach = 0, largest_contact_radius = 0, time_of_largest_contact = 0, &
         & loss_time = 0, path_work = 0, elastic_energy = 0, dissipated_energy = 0, energy_imbalance = 0, &
         & storage_modulus = 0, loss_modulus = 0, load = 0, approach = 0, contact_radius = 0
   end type timed_output_t
   type(timed_output_t), parameter, public :: timed_output = transfer(counting, timed_output_t())
   integer, parameter, public :: n_timed_results = storage_size(timed_output)/storage_size(1)
   !> Indices of the profiles.
   integer, parameter, public :: p_time = 1, p_approach = 2, p_load = 3, p_radius = 4, p_area = 5, &
      & p_stiffness = 6, n_timed_profiles = 6

contains

   !> The results.
   subroutine set_timed_results(r)
      !> Receives the rows; shape `(n_timed_results)`.
      type(result_t), intent(out) :: r(:)
      type(timed_output_t), parameter :: out = timed_output

      r(out%largest_load) = result_row(name='largest_load', unit='N', long_name='largest load at a step', is_main=.true.)
      r(out%largest_approach) = result_row(name='largest_approach', unit='m', long_name='largest approach at a step', &
         & is_main=.true.)
      r(out%largest_contact_radius) = result_row(name='largest_contact_radius', unit='m', &
         & long_name='largest radius of contact at a step', is_main=.true.)
      r(out%time_of_largest_contact) = result_row(name='time_of_largest_contact', unit='s', long_name='time of that step')
      r(out%loss_time) = result_row(name='loss_time', unit='s', long_name='time at which contact is lost for the last time', &
         & is_main=.true.)
      r(out%path_work) = result_row(name='path_work', unit='J', long_name='work of the load along the whole path', is_main=.true.)
      r(out%elastic_energy) = result_row(name='elastic_energy', unit='J', long_name='energy that the solid stores at the end, '// &
         & 'springs of relaxation included')
      r(out%dissipated_energy) = result_row(name='dissipated_energy', unit='J', long_name='energy that relaxation has taken by '// &
         & 'the end')
      r(out%energy_imbalance) = result_row(name='energy_imbalance', unit='-', long_name='work less what springs in contact '// &
         & 'store, have lost and took along, over the largest work: an independent check')
      r(out%storage_modulus) = result_row(name='storage_modulus', unit='Pa', long_name='in-phase change of load over that of '// &
         & 'approach in the last period, without drift, over 2 a of the contact before the first one', is_main=.true.)
      r(out%loss_modulus) = result_row(name='loss_modulus', unit='Pa', long_name='the same of the load a quarter of a period '// &
         & 'ahead', is_main=.true.)
      r(out%load) = result_row(name='load', unit='N', long_name='load at a time')
      r(out%approach) = result_row(name='approach', unit='m', long_name='approach of distant points at a time')
      r(out%contact_radius) = result_row(name='contact_radius', unit='m', long_name='radius a of contact at a time')
      r(out%load:out%contact_radius)%is_hidden = .true.
   end subroutine set_timed_results

   !> The profiles.
   subroutine set_timed_profiles(p)
      !> Receives the rows; shape `(n_timed_profiles)`.
      type(profile_t), intent(out) :: p(:)

      p(p_time) = profile_t(name='time', unit='s', long_name='time')
      p(p_approach) = profile_t(name='approach', unit='m', long_name='approach of distant points')
      p(p_load) = profile_t(name='load', unit='N', long_name='load')
      p(p_radius) = profile_t(name='contact_radius', unit='m', long_name='radius a of contact')
      p(p_area) = profile_t(name='contact_area', unit='m^2', long_name='area of contact')
      p(p_stiffness) = profile_t(name='contact_stiffness', unit='N/m', long_name='change of load per change of approach of a '// &
         & 'sudden step, 2 a E')
   end subroutine set_timed_profiles

end module adfric_round_timed_rows
