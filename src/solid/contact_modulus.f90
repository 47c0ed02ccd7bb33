! SPDX-License-Identifier: GPL-3.0-or-later
!> The contact modulus E* of elastic bodies, given as such or by the moduli of the bodies:
!>
!>    1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2
!>
!> (K. L. Johnson, Contact Mechanics, 1985, section 4.2). A body without moduli is rigid. Every model with a contact modulus has
!> these rows in its table, one behind the other, and reads them here.
module adfric_solid_contact_modulus
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_describe_derived, only: derived_t, add_derived
   use adfric_describe_rows, only: poisson_ratio
   use adfric_describe_table, only: variable_t
   implicit none (type, external)
   private
   public :: set_modulus_rows, contact_modulus_of, has_contact_modulus, check_contact_modulus, derive_contact_modulus
   public :: plane_strain_modulus, poisson_compliance_of, dundurs_ratio_of, has_poisson_ratio
   public :: n_one_body, n_two_bodies, modulus_names

   !> Number of rows where one body is elastic, and where both may be.
   integer, parameter :: n_one_body = 3, n_two_bodies = 5
   !> Moduli of solids, from the softest gel to diamond [Pa].
   real(dp), parameter :: softest = 1.0_dp, hardest = 2.0e12_dp
   !> Indices among the rows.
   integer, parameter :: contact = 1, young = 2, poisson = 3, second_young = 4, second_poisson = 5

   !> Names of the rows.
   character(*), parameter :: modulus_names = &
      & 'contact_modulus young_modulus poisson_ratio second_young_modulus second_poisson_ratio'

contains

   !> The rows of the contact modulus and of the bodies.
   subroutine set_modulus_rows(first, rows)
      !> Row that gives the group, unit and range of the contact modulus and of Young's moduli.
      type(variable_t), intent(in) :: first
      !> Receives the rows; shape `(n_one_body)`, or `(n_two_bodies)` where both bodies may be elastic.
      type(variable_t), intent(out) :: rows(:)

      rows(:) = first
      rows%usual_lower = softest
      rows%usual_upper = hardest
      rows(contact)%name = 'contact_modulus'
      rows(contact)%meaning = 'E*, 1/E* = sum of (1 - nu^2)/E'
      if (size(rows) == n_one_body) rows(contact)%meaning = 'E* = E/(1 - nu^2)'
      rows(young)%name = 'young_modulus'
      rows(young)%meaning = 'E of an elastic body, instead of contact_modulus'
      rows(poisson) = poisson_ratio(group=first%group, name='poisson_ratio', meaning='Poisson''s ratio nu of this body')
      if (size(rows) == n_one_body) return
      rows(second_young)%name = 'second_young_modulus'
      rows(second_young)%meaning = 'E of the other body; rigid if not given'
      rows(second_poisson) = poisson_ratio(group=first%group, name='second_poisson_ratio', &
         & meaning='Poisson''s ratio nu of the other body')
   end subroutine set_modulus_rows

   !> E* [Pa] of values that have been checked.
   pure real(dp) function contact_modulus_of(values) result(modulus)
      !> Values of the rows; shape `(n_one_body)` or `(n_two_bodies)`.
      real(dp), intent(in) :: values(:)
      real(dp) :: other

      modulus = values(contact)
      if (is_set(modulus)) return
      modulus = plane_strain_modulus(values(young), values(poisson))
      if (size(values) == n_one_body) return
      if (.not. is_set(values(second_young))) return
      other = plane_strain_modulus(values(second_young), values(second_poisson))
      ! the same bits whichever body comes first
      modulus = min(modulus, other)/(1 + min(modulus, other)/max(modulus, other))
   end function contact_modulus_of

   !> Sum of nu/G over the bodies [1/Pa], G the shear modulus: what the tangential compliance of a half-space has beside the sum of
   !> (1 - nu)/G, which is 2/E*. A contact modulus with Poisson's ratio is that of one body on a rigid one, or of two alike.
   pure real(dp) function poisson_compliance_of(values) result(compliance)
      !> Values of the rows, with Poisson's ratio of each elastic body; shape `(n_two_bodies)`.
      real(dp), intent(in) :: values(:)

      if (is_set(values(contact))) then
         compliance = 2*values(poisson)/((1 - values(poisson))*values(contact))
         return
      end if
      compliance = 2*values(poisson)*(1 + values(poisson))/values(young)
      if (is_set(values(second_young))) compliance = compliance &
         & + 2*values(second_poisson)*(1 + values(second_poisson))/values(second_young)
   end function poisson_compliance_of

   !> Dundurs's beta of both bodies, by which pressure shears and shear presses. A contact modulus with Poisson's ratio is that of one
   !> body on a rigid one.
   pure real(dp) function dundurs_ratio_of(values) result(beta)
      !> Values of the rows, with Poisson's ratio of each elastic body; shape `(n_two_bodies)`.
      real(dp), intent(in) :: values(:)
      real(dp) :: compliance

      beta = (1 - 2*values(poisson))/(2*(1 - values(poisson)))
      if (is_set(values(contact)) .or. .not. is_set(values(second_young))) return
      compliance = (1 - 2*values(poisson))*(1 + values(poisson))/values(young) &
         & - (1 - 2*values(second_poisson))*(1 + values(second_poisson))/values(second_young)
      beta = contact_modulus_of(values)*compliance/2
   end function dundurs_ratio_of

   !> Is Poisson's ratio known, beside a contact modulus, too?
   pure logical function has_poisson_ratio(values)
      !> Values of the rows; shape `(n_one_body)` or `(n_two_bodies)`.
      real(dp), intent(in) :: values(:)

      has_poisson_ratio = is_set(values(poisson))
   end function has_poisson_ratio

   !> E/(1 - nu^2) [Pa].
   elemental real(dp) function plane_strain_modulus(young_modulus, poisson_ratio) result(modulus)
      !> E [Pa], > 0.
      real(dp), intent(in) :: young_modulus
      !> nu [-], -1 < nu <= 1/2.
      real(dp), intent(in) :: poisson_ratio

      modulus = young_modulus/((1 - poisson_ratio)*(1 + poisson_ratio))
   end function plane_strain_modulus

   !> Do the values say what E* is?
   pure logical function has_contact_modulus(values)
      !> Values of the rows; shape `(n_one_body)` or `(n_two_bodies)`.
      real(dp), intent(in) :: values(:)

      has_contact_modulus = is_set(values(contact)) .or. all(is_set(values([young, poisson])))
      if (is_set(values(contact)) .or. size(values) == n_one_body) return
      has_contact_modulus = has_contact_modulus .and. (is_set(values(second_young)) .eqv. is_set(values(second_poisson)))
   end function has_contact_modulus

   !> Add to `problems` what is missing or stands beside another.
   subroutine check_contact_modulus(rows, values, problems, has_own_poisson_ratio)
      !> The rows of `set_modulus_rows`; their names are part of the messages.
      type(variable_t), intent(in) :: rows(:)
      !> Values of the rows; shape `(n_one_body)` or `(n_two_bodies)`.
      real(dp), intent(in) :: values(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      !> Has Poisson's ratio of the first body a use of its own beside the contact modulus?
      logical, intent(in) :: has_own_poisson_ratio
      logical :: is_given(size(rows))
      integer :: k

      is_given = is_set(values)
      if (is_given(contact)) then
         if (has_own_poisson_ratio) is_given(poisson) = .false.
         do k = young, size(rows)
            if (.not. is_given(k)) cycle
            call add(contact, 'stands beside '//rows(k)%name//'; give '//rows(contact)%name//', or young_modulus and poisson_ratio')
            return
         end do
      else if (.not. is_given(young)) then
         call add(contact, 'is missing [Pa]; give it, or young_modulus and poisson_ratio')
      else
         if (.not. is_given(poisson)) call add(poisson, 'is missing [-]; young_modulus needs it')
         if (size(rows) == n_one_body) return
         if (is_given(second_young) .and. .not. is_given(second_poisson)) &
            & call add(second_poisson, 'is missing [-]; second_young_modulus needs it')
         if (is_given(second_poisson) .and. .not. is_given(second_young)) &
            & call add(second_young, 'is missing [Pa]; second_poisson_ratio needs it')
      end if

   contains

      !> Add a problem of one row to the list.
      subroutine add(index, text)
         !> Index of the variable among the rows, such as `young`.
         integer, intent(in) :: index
         character(*), intent(in) :: text

         call problems%add(rows(index)%group, rows(index)%name, text)
      end subroutine add

   end subroutine check_contact_modulus

   !> The contact modulus where it follows from the moduli of the bodies; nothing where it is given itself.
   function derive_contact_modulus(rows, values) result(list)
      !> The rows of `set_modulus_rows`; the first one describes the contact modulus.
      type(variable_t), intent(in) :: rows(:)
      !> Values of the rows; shape `(n_one_body)` or `(n_two_bodies)`.
      real(dp), intent(in) :: values(:)
      type(derived_t), allocatable :: list(:)

      allocate (list(0))
      if (is_set(values(contact)) .or. .not. has_contact_modulus(values)) return
      associate (row => rows(contact))
         call add_derived(list, row%name, row%unit, row%meaning, contact_modulus_of(values), modulus_names)
      end associate
   end function derive_contact_modulus

end module adfric_solid_contact_modulus
