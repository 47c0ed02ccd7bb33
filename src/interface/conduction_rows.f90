! SPDX-License-Identifier: GPL-3.0-or-later
!> Electrical and thermal conductance of a contact, from the bodies' resistivities and conductivities: rows of the group `solid`,
!> and the results.
!>
!> A current that enters a half-space of the resistivity rho at a point makes the potential rho I/(2 pi r) on its surface. A force
!> makes the displacement P/(pi E* r) of both surfaces together. So the voltage between the bodies and the approach obey one
!> equation on the spots that touch, and (J. R. Barber, Proc. R. Soc. Lond. A 459, 2003, 53)
!>
!>     1/R = 2/((rho1 + rho2) E*) dF/d delta
!>
!> The derivative is that with the spots as they are: of a rigid flat punch. Without adhesion it is the contact stiffness. Thermal
!> conductivities take the part of 1/rho.
module adfric_interface_conduction_rows
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_describe_rows, only: positive, result_row
   use adfric_describe_table, only: result_t, variable_t
   implicit none (type, external)
   private
   public :: set_conduction_rows, has_conduction, check_conduction, refuse_conduction, conduction_results, conductances
   public :: n_conduction_rows, n_conduction_results

   !> Indices among the rows, and their number.
   integer, parameter :: resistivity = 1, second_resistivity = 2, conductivity = 3, second_conductivity = 4
   integer, parameter :: n_conduction_rows = second_conductivity
   !> Number of results: electrical and thermal conductance.
   integer, parameter :: n_conduction_results = 2

contains

   !> The rows.
   subroutine set_conduction_rows(rows)
      !> Receives the rows; shape `(n_conduction_rows)`.
      type(variable_t), intent(out) :: rows(:)
      character(*), parameter :: group = 'solid'

      rows(resistivity) = positive(group=group, name='resistivity', unit='ohm m', &
         & meaning='electrical resistivity of the solid, for the conductance of the contact')
      rows(second_resistivity) = positive(group=group, name='second_resistivity', unit='ohm m', &
         & meaning='electrical resistivity of the body that is pressed on it')
      rows(conductivity) = positive(group=group, name='thermal_conductivity', unit='W/m/K', &
         & meaning='thermal conductivity of the solid, for the conductance of the contact')
      rows(second_conductivity) = positive(group=group, name='second_thermal_conductivity', unit='W/m/K', &
         & meaning='thermal conductivity of the body that is pressed on it')
   end subroutine set_conduction_rows

   !> Is a conductance wanted?
   pure logical function has_conduction(values)
      !> Values of the rows; shape `(n_conduction_rows)`.
      real(dp), intent(in) :: values(:)

      has_conduction = any(is_set(values))
   end function has_conduction

   !> Add to `problems` a body whose resistivity or conductivity is missing.
   subroutine check_conduction(rows, values, problems)
      !> The rows of `set_conduction_rows`; their names are part of the messages.
      type(variable_t), intent(in) :: rows(:)
      !> Values of the rows; shape `(n_conduction_rows)`.
      real(dp), intent(in) :: values(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      integer :: k

      do k = resistivity, conductivity, 2
         if (is_set(values(k)) .and. .not. is_set(values(k + 1))) call miss(k + 1, k)
         if (is_set(values(k + 1)) .and. .not. is_set(values(k))) call miss(k, k + 1)
      end do

   contains

      !> Add a problem of one row.
      subroutine miss(missing, given)
         !> Index of the row that is missing, and of that which needs it.
         integer, intent(in) :: missing, given

         call problems%add(rows(missing)%group, rows(missing)%name, 'is missing ['//rows(missing)%unit//']; '//rows(given)%name// &
            & ' needs it')
      end subroutine miss

   end subroutine check_conduction

   !> Add to `problems` what is given of conduction, where it has no meaning.
   subroutine refuse_conduction(rows, values, reason, problems)
      !> The rows of `set_conduction_rows`; their names are part of the messages.
      type(variable_t), intent(in) :: rows(:)
      !> Values of the rows; shape `(n_conduction_rows)`.
      real(dp), intent(in) :: values(:)
      !> Why it has no meaning, behind the name of the variable.
      character(*), intent(in) :: reason
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      integer :: k

      do k = 1, n_conduction_rows
         if (.not. is_set(values(k))) cycle
         call problems%add(rows(k)%group, rows(k)%name, reason)
         return
      end do
   end subroutine refuse_conduction

   !> The results: of a body that ends, or over nominal area.
   function conduction_results(is_over_area) result(r)
      !> Are they over nominal area?
      logical, intent(in) :: is_over_area
      type(result_t), allocatable :: r(:)

      allocate (r(n_conduction_results))
      if (is_over_area) then
         r(1) = result_row(name='electrical_conductance', unit='S/m^2', &
            & long_name='current through the spots that touch, over nominal area and voltage')
         r(2) = result_row(name='thermal_conductance', unit='W/m^2/K', &
            & long_name='heat through the spots that touch, over nominal area and difference of temperature')
      else
         r(1) = result_row(name='electrical_conductance', unit='S', &
            & long_name='current through the spots that touch, over voltage')
         r(2) = result_row(name='thermal_conductance', unit='W/K', &
            & long_name='heat through the spots that touch, over difference of temperature')
      end if
   end function conduction_results

   !> Electrical and thermal conductance.
   pure subroutine conductances(values, punch_stiffness, found)
      !> Values of the rows, which have been checked; shape `(n_conduction_rows)`.
      real(dp), intent(in) :: values(:)
      !> Stiffness over E* of a punch of the shape of the spots [m], or over nominal area [1/m]; 2 a of a circle.
      real(dp), intent(in) :: punch_stiffness
      !> Receives the conductances that are wanted; shape `(n_conduction_results)`.
      real(dp), intent(inout) :: found(:)

      if (is_set(values(resistivity))) found(1) = 2*punch_stiffness/(values(resistivity) + values(second_resistivity))
      if (.not. is_set(values(conductivity))) return
      associate (one => values(conductivity), other => values(second_conductivity))
         found(2) = 2*punch_stiffness*(min(one, other)/(1 + min(one, other)/max(one, other)))
      end associate
   end subroutine conductances

end module adfric_interface_conduction_rows
