! SPDX-License-Identifier: GPL-3.0-or-later
!> Quantities that follow from the estimates of a sphere, with their errors by the linear rule.
!>
!>     ln sigma0 = ln lambda + (1/3) ln w - (1/3) ln R + (2/3) ln E* + const,   h0 = w/sigma0,   Pc = pi w R P(fold)
module adfric_fit_derived
   use adfric_base_kinds, only: dp
   use adfric_base_words, only: has_word
   use adfric_fit_objective, only: objective_t
   use adfric_fit_path, only: sphere_path_t, set_path
   use adfric_fit_sphere_basis, only: of_radius, of_modulus, of_work, of_lambda
   use adfric_fit_solution, only: solution_t, derived_value_t
   use adfric_round_sphere_contact, only: theory_hertz, theory_maugis_dugdale
   implicit none (type, external)
   private
   public :: find_derived

contains

   !> Find the derived quantities. The sum of squares has been evaluated at the estimate.
   subroutine find_derived(self, names, covariance, solution)
      type(objective_t), intent(in) :: self
      !> Names of those that are wanted; empty: all.
      character(*), intent(in) :: names
      !> Covariance of the numbers that are fitted.
      real(dp), intent(in) :: covariance(:, :)
      type(solution_t), intent(inout) :: solution
      type(sphere_path_t) :: path
      real(dp) :: stress

      if (allocated(solution%derived)) deallocate (solution%derived)
      allocate (solution%derived(0))
      if (size(self%spheres) == 0) return
      ! they differ between curves of values of their own
      if (allocated(self%spheres(1)%others)) return
      associate (basis => self%spheres(1)%basis, b => self%spheres(1)%basis%by_free)
         if (basis%theory == theory_hertz) return
         if (basis%theory == theory_maugis_dugdale) then
            stress = basis%lambda*basis%stress
            call add('adhesion_stress', 'Pa', stress, stress*(b(:, of_lambda) + (b(:, of_work) - b(:, of_radius) &
               & + 2*b(:, of_modulus))/3))
            stress = self%spheres(1)%basis%force/(acos(-1.0_dp)*radius_of())/stress
            call add('adhesion_range', 'm', stress, stress*(-b(:, of_lambda) + (2*b(:, of_work) + b(:, of_radius) &
               & - 2*b(:, of_modulus))/3))
            call add('lambda', '-', basis%lambda, basis%lambda*b(:, of_lambda))
         end if
         call set_path(path, basis%theory, .false., basis%lambda, 0.0_dp)
         call add('pull_off_load', 'N', basis%force*path%fold%p, basis%force*(path%fold%p*(b(:, of_work) + b(:, of_radius)) &
            & + path%fold%p_l*basis%lambda*b(:, of_lambda)))
      end associate

   contains

      !> The radius of the sphere, from its units.
      pure real(dp) function radius_of()
         radius_of = self%spheres(1)%basis%length**2/self%spheres(1)%basis%approach
      end function radius_of

      !> Add a quantity if it is wanted, and not free itself.
      subroutine add(name, unit, value, gradient)
         character(*), intent(in) :: name, unit
         real(dp), intent(in) :: value
         !> Its derivatives by the numbers that are fitted.
         real(dp), intent(in) :: gradient(:)
         type(derived_value_t) :: one
         integer :: k

         if (len_trim(names) > 0 .and. .not. has_word(names, name)) return
         do k = 1, self%n_free
            if (self%frees(k)%name == name .or. self%frees(k)%name == 'sphere%'//name) return
         end do
         one%name = name
         one%unit = unit
         one%value = value
         one%error = sqrt(max(dot_product(gradient, matmul(covariance, gradient)), 0.0_dp))
         solution%derived = [solution%derived, one]
      end subroutine add

   end subroutine find_derived

end module adfric_fit_derived
