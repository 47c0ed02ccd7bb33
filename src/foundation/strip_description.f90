! SPDX-License-Identifier: GPL-3.0-or-later
!> What is said of a case of `wavy_sliding` whose strips have closed forms: quantities that follow from its values, and doubts.
module adfric_foundation_strip_description
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: is_set
   use adfric_describe_derived, only: derived_t, add_derived
   use adfric_foundation_adhesion, only: edge_front
   use adfric_foundation_case, only: wavy_case_t, resolve_case
   use adfric_foundation_variables, only: in => foundation_input
   implicit none (type, external)
   private
   public :: derive_strips, doubt_strips

contains

   !> Add what follows from the values of a point, for `adfric check` and the results file.
   subroutine derive_strips(derived, values)
      !> The quantities, to which is added.
      type(derived_t), allocatable, intent(inout) :: derived(:)
      !> Values of one point; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      character(*), parameter :: of_stiffness = 'stiffness young_modulus poisson_ratio thickness'
      character(*), parameter :: of_phase = 'period velocity relaxation_time', of_viscosity = of_phase//' retardation_ratio'
      character(*), parameter :: of_range = 'stress surface_energy range'
      type(wavy_case_t) :: point

      call resolve_case(values, point)
      associate (given => point%given, f => point%surface%foundation)
         call add_derived(derived, 'relaxation_phase', '-', 'relaxation phase k V Ts', f%u, of_phase)
         call add_derived(derived, 'retardation_phase', '-', 'retardation phase k V Te', f%v, of_viscosity)
         call add_derived(derived, 'loss_ratio', '-', 'loss modulus over stiffness', f%loss, of_viscosity)
         call add_derived(derived, 'stiffness', 'Pa/m', 'long-time stiffness', point%pressure_unit/point%height, &
            & of_stiffness)
         call add_derived(derived, 'pressure_unit', 'Pa', 'pressure unit, height times stiffness', point%pressure_unit, &
            & of_stiffness//' height')
         call add_derived(derived, 'reduced_stress', '-', 'adhesion stress over the pressure unit', given%stress, &
            & of_stiffness//' height stress')
         if (given%stress > 0) call add_derived(derived, 'range', 'm', 'range of adhesion', &
            & given%range*point%height, of_range)
         call add_derived(derived, 'reduced_range', '-', 'range of adhesion over height', given%range, of_range//' height')
      end associate
   end subroutine derive_strips

   !> Sliding so slow that a layer has no front (docs/theory/columns_adhesion.md); empty without a doubt.
   function doubt_strips(values) result(text)
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text
      character(40) :: lengths
      type(wavy_case_t) :: point
      real(dp) :: lag

      text = ''
      call resolve_case(values, point)
      if (.not. is_set(values(in%thickness)) .or. point%given%edge /= edge_front .or. point%given%stress <= 0) return
      lag = values(in%velocity)*values(in%relaxation_time)
      if (lag >= values(in%thickness)) return
      write (lengths, '(es9.2, a, es9.2, a)') lag, ' m <', values(in%thickness), ' m'
      text = 'edge = ''front'' needs velocity times relaxation_time above thickness, but'//trim(lengths) &
         & //': the layer has less friction'//new_line('a')
   end function doubt_strips

end module adfric_foundation_strip_description
