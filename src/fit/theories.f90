! SPDX-License-Identifier: GPL-3.0-or-later
!> A fit as another theory of the sphere would have it.
module adfric_fit_theories
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: unset, is_set
   use adfric_fit_problem, only: fit_t
   use adfric_fit_sphere_basis, only: theory_of
   use adfric_round_sphere_contact, only: theory_hertz, theory_maugis_dugdale
   use adfric_round_sphere_variables, only: in => sphere_input, out => sphere_output
   implicit none (type, external)
   private
   public :: make_theory, theory_name

contains

   !> Name of a theory.
   subroutine theory_name(fit, position, name)
      type(fit_t), intent(in) :: fit
      !> Index in the choices of the model's variable `theory`.
      integer, intent(in) :: position
      !> Receives the name.
      character(:), allocatable, intent(out) :: name
      integer :: k, first

      associate (choices => fit%model%variables(in%theory)%choices)
         first = 1
         do k = 2, position
            first = first + index(choices(first:), ' ')
         end do
         name = choices(first:first + index(choices(first:)//' ', ' ') - 2)
      end associate
   end subroutine theory_name

   !> The same data fitted by another theory: without the variables that it does not have.
   subroutine make_theory(fit, position, other, kept, is_possible)
      type(fit_t), intent(in) :: fit
      integer, intent(in) :: position
      type(fit_t), intent(out) :: other
      !> Receives the numbers of the free variables that it has.
      integer, allocatable, intent(out) :: kept(:)
      !> Can the theory fit these data? Hertz has no negative loads, Maugis-Dugdale needs a lambda.
      logical, intent(out) :: is_possible
      logical :: has(size(fit%frees))
      integer :: k, theory

      is_possible = .false.
      if (fit%model%name /= 'sphere') return
      other = fit
      other%base(in%theory) = position
      theory = theory_of(other%base)
      has = .true.
      do k = 1, size(has)
         select case (fit%frees(k)%variable)
         case (in%lambda, in%adhesion_stress, in%adhesion_range)
            has(k) = theory == theory_maugis_dugdale
         case (in%work_of_adhesion)
            has(k) = theory /= theory_hertz
         end select
      end do
      kept = pack([(k, k=1, size(has))], has)
      other%frees = fit%frees(kept)
      deallocate (other%theories)
      allocate (other%theories(0))
      if (theory /= theory_maugis_dugdale) other%base([in%lambda, in%adhesion_stress, in%adhesion_range]) = unset
      is_possible = size(kept) > 0
      if (theory == theory_hertz) is_possible = is_possible .and. .not. has_negative_loads(fit)
      if (theory == theory_maugis_dugdale) is_possible = any(is_set(fit%base([in%lambda, in%adhesion_stress, in%adhesion_range]))) &
         & .or. any(fit%frees%variable == in%lambda .or. fit%frees%variable == in%adhesion_stress &
         & .or. fit%frees%variable == in%adhesion_range)
   end subroutine make_theory

   !> Is a load in contact negative, or is there a pull-off?
   pure logical function has_negative_loads(fit)
      type(fit_t), intent(in) :: fit
      real(dp), allocatable :: loads(:)
      logical, allocatable :: counts(:)
      integer :: k

      has_negative_loads = .false.
      if (allocated(fit%events)) has_negative_loads = size(fit%events) > 0
      do k = 1, size(fit%data_sets)
         associate (data => fit%data_sets(k))
            if (data%abscissa == in%load) then
               loads = data%x
            else if (data%ordinate == out%load) then
               loads = data%y
            else
               cycle
            end if
            counts = ieee_is_finite(loads)
            if (allocated(data%is_contact)) counts = counts .and. data%is_contact
            loads = pack(loads, counts)
            has_negative_loads = has_negative_loads .or. any(loads < 0)
         end associate
      end do
   end function has_negative_loads

end module adfric_fit_theories
