! SPDX-License-Identifier: GPL-3.0-or-later
!> The layer between a rigid surface and its base, as an input of an elastic model gives it: rows of the group `layer`, and the
!> kernel that follows. Without a thickness the solid is a half-space. With moduli of the base the layer is a coating, bonded to an elastic
!> half-space; else its base is rigid.
module adfric_periodic_layer_rows
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_describe_rows, only: above_zero, choice, poisson_ratio
   use adfric_describe_scene_rules, only: hidden
   use adfric_describe_table, only: variable_t
   use adfric_periodic_layer_kernel, only: layer_kernel_t
   use adfric_solid_contact_modulus, only: contact_modulus_of, n_one_body, n_two_bodies
   use adfric_solid_layer_compliance, only: new_coating
   implicit none (type, external)
   private
   public :: set_layer_rows, check_layer_rows, get_layer, numbers_of_layer, has_layer, needs_ratio_of_layer, n_layer_rows
   public :: n_layer_numbers

   !> Number of the rows, and of the numbers from which a kernel is made.
   integer, parameter :: n_layer_rows = 4, n_layer_numbers = 5
   !> Indices among the rows, and that of the bonded base in the choice.
   integer, parameter :: thickness = 1, base = 2, base_young = 3, base_poisson = 4
   integer, parameter :: bonded = 2
   !> Index of Poisson's ratio among the rows of the modulus.
   integer, parameter :: ratio_of_layer = n_one_body
   !> Least thickness, in periods: below it pressure hardly spreads, and numbers leave their range. Largest ratio of moduli.
   real(dp), parameter :: thinnest = 1.0e-6_dp, most_unequal = 1.0e12_dp
   !> Young's moduli, from the softest gel to diamond [Pa].
   real(dp), parameter :: softest = 1.0_dp, hardest = 2.0e12_dp

contains

   !> The rows of the layer.
   subroutine set_layer_rows(rows)
      !> Receives the rows; shape `(n_layer_rows)`.
      type(variable_t), intent(out) :: rows(:)

      rows(thickness) = above_zero(group='layer', name='thickness', unit='m', &
         & meaning='thickness of a layer on a base; without it the solid is a half-space')
      rows(base) = choice(group='layer', name='base', &
         & meaning='whether the layer slips on a rigid base (frictionless) or not (bonded)', choices='frictionless bonded')
      rows(base_young) = above_zero(group='layer', name='base_young_modulus', unit='Pa', &
         & meaning='E of the half-space below a coating')
      rows(base_young)%usual_lower = softest
      rows(base_young)%usual_upper = hardest
      rows(base_poisson) = poisson_ratio(group='layer', name='base_poisson_ratio', &
         & meaning='Poisson''s ratio nu of the half-space below a coating')
   end subroutine set_layer_rows

   !> Is the solid a layer?
   pure logical function has_layer(values)
      !> Values of the rows; shape `(n_layer_rows)`.
      real(dp), intent(in) :: values(:)

      has_layer = is_set(values(thickness))
   end function has_layer

   !> Does the layer need Poisson's ratio, beside a contact modulus, too?
   pure logical function needs_ratio_of_layer(values) result(needs)
      !> Values of the rows; shape `(n_layer_rows)`.
      real(dp), intent(in) :: values(:)

      needs = is_set(values(base_young))
      if (is_set(values(base))) needs = needs .or. nint(values(base)) == bonded
   end function needs_ratio_of_layer

   !> Add to `problems` what is wrong with the layer.
   subroutine check_layer_rows(rows, values, modulus_rows, moduli, length, problems)
      !> Rows of the layer and those of the modulus; their names stand in the messages.
      type(variable_t), intent(in) :: rows(:), modulus_rows(:)
      !> Values of the rows of the layer; shape `(n_layer_rows)`.
      real(dp), intent(in) :: values(:)
      !> Values of the rows of the modulus; shape `(n_two_bodies)`.
      real(dp), intent(in) :: moduli(:)
      !> Period along x [m].
      real(dp), intent(in) :: length
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      integer :: k

      if (.not. is_set(values(thickness))) then
         do k = base, n_layer_rows
            if (is_set(values(k))) call add(rows(k), 'has no meaning without thickness')
         end do
         return
      end if
      if (values(thickness) < thinnest*length) call add(rows(thickness), 'is less than 1e-6 of the period along x')
      if (is_set(values(base_young)) .neqv. is_set(values(base_poisson))) then
         k = merge(base_poisson, base_young, is_set(values(base_young)))
         call add(rows(k), 'is missing; the half-space below a coating has both moduli')
      else if (is_set(values(base)) .and. is_set(values(base_young))) then
         call add(rows(base_young), 'stands beside '//rows(base)%name//', that of a rigid base; give one of them')
      else if (.not. (is_set(values(base)) .or. is_set(values(base_young)))) then
         ! in a scene on a layer the modulus below a coating has no name
         if (rows(base_young)%name == hidden) then
            call add(rows(base), 'is missing, allowed: frictionless, bonded; a coating has extent = ''coating''')
         else
            call add(rows(base), 'is missing, allowed: frictionless, bonded; or give '//rows(base_young)%name//' of a coating')
         end if
      end if
      ! the rows of the second body are the last ones
      k = findloc(is_set(moduli(n_one_body + 1:n_two_bodies)), .true., 1)
      if (k > 0) call add(modulus_rows(n_one_body + k), 'has no meaning beside a layer; the other body is rigid')
      if (needs_ratio_of_layer(values) .and. .not. is_set(moduli(ratio_of_layer))) then
         call add(modulus_rows(ratio_of_layer), 'is missing [-]; a '// &
            & trim(merge('coating     ', 'bonded layer', is_set(values(base_young))))//' needs it')
      else if (is_set(values(base_young)) .and. is_set(values(base_poisson)) .and. problems%count() == 0) then
         associate (ratio => shear_ratio_of(values, moduli))
            if (.not. (ratio >= 1/most_unequal .and. ratio <= most_unequal)) call add(rows(base_young), &
               & 'leads to a ratio of the shear moduli of layer and base that is not between 1e-12 and 1e12')
         end associate
      end if

   contains

      !> Add a problem of one row to the list.
      subroutine add(row, text)
         !> Row of the variable.
         type(variable_t), intent(in) :: row
         !> What is wrong with the variable; its name is put before this.
         character(*), intent(in) :: text

         call problems%add(row%group, row%name, text)
      end subroutine add

   end subroutine check_layer_rows

   !> Shear modulus of a coating over that of its half-space [-]: G = E* (1 - nu)/2.
   pure real(dp) function shear_ratio_of(values, moduli) result(ratio)
      !> Values of the rows of the layer, with those of a coating; shape `(n_layer_rows)`.
      real(dp), intent(in) :: values(:)
      !> Values of the rows of the modulus; shape `(n_two_bodies)`.
      real(dp), intent(in) :: moduli(:)

      ratio = contact_modulus_of(moduli)/values(base_young)*(1 - moduli(ratio_of_layer))*(1 + values(base_poisson))
   end function shear_ratio_of

   !> The kernel of a layer, whose values have been checked.
   pure subroutine get_layer(values, moduli, length, kernel)
      !> Values of the rows of the layer; shape `(n_layer_rows)`.
      real(dp), intent(in) :: values(:)
      !> Values of the rows of the modulus; shape `(n_two_bodies)`.
      real(dp), intent(in) :: moduli(:)
      !> Period along x [m], the unit of the kernel's lengths.
      real(dp), intent(in) :: length
      !> Receives the kernel, with pressures in the contact modulus of the layer.
      type(layer_kernel_t), intent(out) :: kernel

      kernel%thickness = values(thickness)/length
      if (is_set(moduli(ratio_of_layer))) kernel%poisson_ratio = moduli(ratio_of_layer)
      if (is_set(values(base_young))) then
         allocate (kernel%coating)
         call new_coating(kernel%coating, shear_ratio_of(values, moduli), moduli(ratio_of_layer), values(base_poisson))
      else
         kernel%is_bonded = nint(values(base)) == bonded
      end if
   end subroutine get_layer

   !> Numbers from which the kernel of a layer follows; kernels of equal numbers are equal.
   pure function numbers_of_layer(values, moduli, length) result(numbers)
      !> Values of the rows of the layer, which have been checked; shape `(n_layer_rows)`.
      real(dp), intent(in) :: values(:)
      !> Values of the rows of the modulus; shape `(n_two_bodies)`.
      real(dp), intent(in) :: moduli(:)
      !> Period along x [m].
      real(dp), intent(in) :: length
      real(dp) :: numbers(n_layer_numbers)

      numbers = 0
      numbers(1) = values(thickness)/length
      if (is_set(values(base))) numbers(2) = values(base)
      if (needs_ratio_of_layer(values)) numbers(3) = moduli(ratio_of_layer)
      if (.not. is_set(values(base_young))) return
      numbers(4) = shear_ratio_of(values, moduli)
      numbers(5) = values(base_poisson)
   end function numbers_of_layer

end module adfric_periodic_layer_rows
