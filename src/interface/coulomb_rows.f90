! SPDX-License-Identifier: GPL-3.0-or-later
!> Coulomb's friction of periodic surfaces in partial slip: under a constant load the tangential force over nominal area, T, has grown
!> from 0, up to mu times the mean pressure P.
!>
!> Two frictionless contacts are enough (J. Jaeger, Arch. Appl. Mech. 63, 1993, 402; M. Ciavarella, Int. J. Solids Struct. 35, 1998,
!> 2349): the shear traction is mu [p(P) - p(P*)], P* = P - T/mu, the displacement mu m times the difference of the penetrations, and
!> what touches under P* is what sticks. m is the ratio of the tangential to the normal compliance,
!>
!>     m = 1 of waves along x under a force along x,   m = 1 + K of waves along x under a force along y,
!>     m = 1 + K/2 on average of all directions,   K = (E*/2) sum of nu/G over the bodies
!>
!> The rows of such friction are here, and its results.
module adfric_interface_coulomb_rows
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_interface_normal_contact, only: friction_holds
   use adfric_solid_contact_modulus, only: contact_modulus_of, poisson_compliance_of
   use adfric_describe_rows, only: choice, number, positive, result_row
   use adfric_describe_table, only: result_t, variable_t
   implicit none (type, external)
   private
   public :: coulomb_t, set_coulomb_rows, check_coulomb, has_coulomb, resolve_coulomb, needs_poisson_ratio, slip_results
   public :: n_coulomb_rows, n_slip_results, along_x, along_y

   !> Indices among the rows, and their number.
   integer, parameter :: tangential_stress = 1, tangential_axis = 2, coefficient = 3
   integer, parameter :: n_coulomb_rows = coefficient
   !> Directions of the force, the indices of the words of `tangential_axis`.
   integer, parameter :: along_x = 1, along_y = 2
   !> Number of the results, and their indices: what sticks, displacement, stiffness, energy of a cycle.
   integer, parameter :: n_slip_results = 4

   !> Friction of a point.
   type :: coulomb_t
      !> Tangential force over nominal area T [Pa], of either sign.
      real(dp) :: stress = 0
      !> mu [-], > 0.
      real(dp) :: coefficient = 1
      !> `along_x` or `along_y`.
      integer :: axis = along_x
      !> K, what Poisson's ratio adds to the tangential compliance of waves across the force, in that under pressure [-].
      real(dp) :: poisson = 0
   contains
      procedure :: compliance_ratio
      procedure :: get_share
   end type coulomb_t

contains

   !> The rows, in the groups `operating` and `friction`.
   subroutine set_coulomb_rows(rows)
      !> Receives the rows; shape `(n_coulomb_rows)`.
      type(variable_t), intent(out) :: rows(:)

      rows(tangential_stress) = number(group='operating', name='tangential_stress', unit='Pa', &
         & meaning='tangential force over nominal area, which has grown from 0 under the load; up to mu P, of either sign')
      rows(tangential_axis) = choice(group='operating', name='tangential_axis', &
         & meaning='axis along which it acts; x if not given', choices='x y')
      rows(coefficient) = positive(group='friction', name='coefficient', unit='-', &
         & meaning='mu of Coulomb''s friction, for partial slip')
   end subroutine set_coulomb_rows

   !> The results of partial slip.
   function slip_results() result(r)
      type(result_t), allocatable :: r(:)

      allocate (r(n_slip_results))
      r(1) = result_row(name='stick_fraction', unit='-', long_name='share of the area of contact that sticks')
      r(2) = result_row(name='tangential_displacement', unit='m', &
         & long_name='of the mean planes by the tangential force')
      r(3) = result_row(name='tangential_stiffness', unit='Pa/m', &
         & long_name='slope of the tangential force over nominal area over its displacement, while it grows')
      r(4) = result_row(name='cycle_energy', unit='J/m^2', &
         & long_name='energy that friction takes in a cycle between T and -T, over nominal area')
   end function slip_results

   !> Is there such friction?
   pure logical function has_coulomb(values)
      !> Values of the rows; shape `(n_coulomb_rows)`.
      real(dp), intent(in) :: values(:)

      has_coulomb = is_set(values(coefficient))
   end function has_coulomb

   !> Does the tangential compliance depend on Poisson's ratio?
   pure logical function needs_poisson_ratio(values, is_line)
      !> Values of the rows; shape `(n_coulomb_rows)`.
      real(dp), intent(in) :: values(:)
      !> Does the surface vary along x alone?
      logical, intent(in) :: is_line

      needs_poisson_ratio = has_coulomb(values)
      if (needs_poisson_ratio .and. is_line) needs_poisson_ratio = axis_of(values) == along_y
   end function needs_poisson_ratio

   !> Direction of the force.
   pure integer function axis_of(values) result(axis)
      !> Values of the rows; shape `(n_coulomb_rows)`.
      real(dp), intent(in) :: values(:)

      axis = along_x
      if (is_set(values(tangential_axis))) axis = nint(values(tangential_axis))
   end function axis_of

   !> Add to `problems` what is missing, and what has no meaning.
   subroutine check_coulomb(rows, values, is_adhesive, has_shear, problems)
      !> The rows; their names are part of the messages.
      type(variable_t), intent(in) :: rows(:)
      !> Values of the rows; shape `(n_coulomb_rows)`.
      real(dp), intent(in) :: values(:)
      !> Does the surface adhere, and has it friction of a shear strength?
      logical, intent(in) :: is_adhesive, has_shear
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      integer :: k

      if (has_coulomb(values)) then
         if (is_adhesive) call add(coefficient, 'stands beside &adhesion; mu p has no meaning where p is below 0: give ' &
            & //'shear_strength')
         if (has_shear) call add(coefficient, 'stands beside shear_strength or pressure_factor; give one friction')
         if (.not. is_set(values(tangential_stress))) call add(tangential_stress, 'is missing [Pa]; &friction coefficient needs it')
      else
         do k = tangential_stress, tangential_axis
            if (is_set(values(k))) call add(k, 'has no meaning without &friction coefficient')
         end do
      end if

   contains

      !> Add a problem of one row to the list.
      subroutine add(index, text)
         !> Index of the variable among the rows.
         integer, intent(in) :: index
         !> What is wrong.
         character(*), intent(in) :: text

         call problems%add(rows(index)%group, rows(index)%name, text)
      end subroutine add

   end subroutine check_coulomb

   !> Friction of values that have been checked.
   pure subroutine resolve_coulomb(values, moduli, is_line, friction)
      !> Values of the rows; shape `(n_coulomb_rows)`.
      real(dp), intent(in) :: values(:)
      !> Values of the rows of the contact modulus; shape `(n_two_bodies)`.
      real(dp), intent(in) :: moduli(:)
      !> Does the surface vary along x alone?
      logical, intent(in) :: is_line
      !> Receives the friction.
      type(coulomb_t), intent(out) :: friction

      friction%stress = values(tangential_stress)
      friction%coefficient = values(coefficient)
      friction%axis = axis_of(values)
      if (needs_poisson_ratio(values, is_line)) friction%poisson = contact_modulus_of(moduli)*poisson_compliance_of(moduli)/2
   end subroutine resolve_coulomb

   !> m, the ratio of the tangential to the normal compliance.
   pure real(dp) function compliance_ratio(self, is_line) result(ratio)
      class(coulomb_t), intent(in) :: self
      !> Does the surface vary along x alone?
      logical, intent(in) :: is_line

      ratio = 1 + self%poisson/2
      if (is_line) ratio = 1 + merge(self%poisson, 0.0_dp, self%axis == along_y)
   end function compliance_ratio

   !> The force over that which friction can hold.
   pure subroutine get_share(self, pressure, tau, is_sustained)
      class(coulomb_t), intent(in) :: self
      !> Mean pressure P, in the unit of `stress`.
      real(dp), intent(in) :: pressure
      !> Receives |T|/(mu P), 0 to 1; 0 without load.
      real(dp), intent(out) :: tau
      !> Does friction hold the force?
      logical, intent(out) :: is_sustained
      real(dp) :: needed

      tau = 0
      needed = abs(self%stress)/self%coefficient
      is_sustained = friction_holds(needed, pressure)
      if (is_sustained .and. pressure > 0) tau = min(needed/pressure, 1.0_dp)
   end subroutine get_share

end module adfric_interface_coulomb_rows
