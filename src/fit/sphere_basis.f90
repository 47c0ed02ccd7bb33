! SPDX-License-Identifier: GPL-3.0-or-later
!> What the variables of the model `sphere` are in reduced ones, and how the two change together.
!>
!> Every quantity of a sphere is a product of powers of R, E*, w and tau0 times a function of lambda and x. So it is enough to know how the
!> logarithms of R, E*, w, tau0 and lambda, and x, change with each free variable. With the stress unit (2 pi w E*^2/9R)^(1/3):
!>
!>     ln lambda = ln sigma0 - (1/3) ln w + (1/3) ln R - (2/3) ln E* + const;   sigma0 = w/h0
module adfric_fit_sphere_basis
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: is_set
   use adfric_fit_problem, only: free_t
   use adfric_solid_contact_modulus, only: contact_modulus_of
   use adfric_round_sphere_contact, only: theory_hertz, theory_maugis_dugdale
   use adfric_round_sphere_units, only: get_sphere_units
   use adfric_round_sphere_variables, only: in => sphere_input
   implicit none (type, external)
   private
   public :: basis_t, set_basis, theory_of, of_radius, of_modulus, of_work, of_strength, of_lambda, of_edge

   !> The columns of `by_free`: logarithms of R, E*, w, tau0, lambda, and x.
   integer, parameter :: of_radius = 1, of_modulus = 2, of_work = 3, of_strength = 4, of_lambda = 5, of_edge = 6, n_basis = 6
   !> Relative step of the difference for a modulus that is made of others, and a half of the digits of its closed form.
   real(dp), parameter :: relative_step = 6.0e-6_dp

   !> A sphere.
   type :: basis_t
      !> One of `theory_...`.
      integer :: theory = theory_maugis_dugdale
      !> tau0 (0: none), lambda and x.
      real(dp) :: strength = 0, lambda = 1, edge = 0
      !> Units of radii in the plane of contact, of the approach, of forces and of stresses.
      real(dp) :: length = 1, approach = 1, force = 1, stress = 1
      !> Derivatives of the six by the numbers that are fitted; shape `(n_free, 6)`.
      real(dp), allocatable :: by_free(:, :)
   end type basis_t

contains

   !> The theory that values of the sphere ask for; `auto` means Maugis-Dugdale, which it stands for, or Hertz where nothing adheres.
   pure integer function theory_of(values)
      real(dp), intent(in) :: values(:)

      theory_of = nint(values(in%theory)) - 2
      if (theory_of < 0) then
         theory_of = theory_hertz
         if (is_set(values(in%work_of_adhesion))) theory_of = theory_maugis_dugdale
      end if
   end function theory_of

   !> The reduced variables, and how they change.
   pure subroutine set_basis(self, values, frees, slopes)
      type(basis_t), intent(inout) :: self
      real(dp), intent(in) :: values(:)
      type(free_t), intent(in) :: frees(:)
      real(dp), intent(in) :: slopes(:)
      real(dp) :: modulus, work, change
      integer :: k

      if (.not. allocated(self%by_free)) allocate (self%by_free(size(frees), n_basis))
      self%by_free = 0
      self%theory = theory_of(values)
      modulus = contact_modulus_of(values(in%contact_modulus:in%second_poisson_ratio))
      ! without adhesion the units are those of w = E* R
      work = modulus*values(in%radius)
      if (self%theory /= theory_hertz) work = values(in%work_of_adhesion)
      call get_sphere_units(values(in%radius), modulus, work, self%length, self%approach, self%force, self%stress)
      self%strength = 0
      if (is_set(values(in%shear_strength))) self%strength = values(in%shear_strength)
      self%edge = values(in%edge_fraction)
      self%lambda = 1
      if (self%theory == theory_maugis_dugdale) self%lambda = lambda_of(values, work, self%stress)
      do k = 1, size(frees)
         if (frees(k)%variable == 0) cycle
         change = slopes(k)
         if (abs(values(frees(k)%variable)) > 0) change = slopes(k)/values(frees(k)%variable)
         associate (row => self%by_free(k, :))
            select case (frees(k)%variable)
            case (in%radius)
               row(of_radius) = change
            case (in%contact_modulus:in%second_poisson_ratio)
               row(of_modulus) = slopes(k)*modulus_slope(values, frees(k)%variable)
            case (in%work_of_adhesion)
               row(of_work) = change
            case (in%shear_strength)
               row(of_strength) = change
            case (in%lambda, in%adhesion_stress)
               row(of_lambda) = change
            case (in%adhesion_range)
               row(of_lambda) = -change
            case (in%edge_fraction)
               row(of_edge) = slopes(k)
            end select
         end associate
      end do
      call finish_chain(self, values)
   end subroutine set_basis

   !> Maugis's parameter.
   pure real(dp) function lambda_of(values, work, stress)
      real(dp), intent(in) :: values(:)
      !> Work of adhesion [J/m^2], and the unit of stresses [Pa].
      real(dp), intent(in) :: work, stress

      lambda_of = 1
      if (is_set(values(in%lambda))) lambda_of = values(in%lambda)
      if (is_set(values(in%adhesion_stress))) lambda_of = values(in%adhesion_stress)/stress
      if (is_set(values(in%adhesion_range))) lambda_of = work/values(in%adhesion_range)/stress
   end function lambda_of

   !> Let lambda change with R, E* and w where the stress or the range of adhesion is prescribed, and w with E* R without adhesion.
   pure subroutine finish_chain(self, values)
      type(basis_t), intent(inout) :: self
      real(dp), intent(in) :: values(:)
      real(dp) :: power

      associate (b => self%by_free)
         if (self%theory == theory_hertz) b(:, of_work) = b(:, of_modulus) + b(:, of_radius)
         if (self%theory /= theory_maugis_dugdale) then
            b(:, of_lambda) = 0
         else if (is_set(values(in%adhesion_stress)) .or. is_set(values(in%adhesion_range))) then
            power = merge(-1.0_dp, 2.0_dp, is_set(values(in%adhesion_stress)))/3
            b(:, of_lambda) = b(:, of_lambda) + power*b(:, of_work) + b(:, of_radius)/3 - 2*b(:, of_modulus)/3
         end if
      end associate
   end subroutine finish_chain

   !> Derivative of ln E* by one of the moduli or Poisson's ratios.
   pure real(dp) function modulus_slope(values, index)
      real(dp), intent(in) :: values(:)
      integer, intent(in) :: index
      real(dp) :: low(in%contact_modulus:in%second_poisson_ratio), high(in%contact_modulus:in%second_poisson_ratio), h

      if (index == in%contact_modulus) then
         modulus_slope = 1/values(index)
         return
      end if
      low = values(in%contact_modulus:in%second_poisson_ratio)
      high = low
      h = relative_step*max(abs(values(index)), tiny(h))
      if (.not. abs(values(index)) > 0) h = relative_step
      low(index) = low(index) - h
      high(index) = high(index) + h
      modulus_slope = log(contact_modulus_of(high)/contact_modulus_of(low))/(2*h)
   end function modulus_slope

end module adfric_fit_sphere_basis
