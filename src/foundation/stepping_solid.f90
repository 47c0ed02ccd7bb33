! SPDX-License-Identifier: GPL-3.0-or-later
!> The viscoelastic foundation of a time stepping: a column with any number of relaxation times, in reduced units.
!>
!> Stiffnesses are in units of the relaxed one \( k_0 \), times in units of that in which a period passes. A column is a spring 1 and arms
!> \( k_i, \tau_i \) beside it; the length of dashpot i is \( e_i \), and \( r_i = w - e_i \) is what stretches the spring of the arm:
!> $$ p = w + \sum k_i r_i, \qquad \tau_i e_i' = r_i. $$
!> The same column is a spring \( k_g = 1 + \sum k_i \) and Kelvin elements \( y_j \) in series, which relax alone while p is constant:
!> $$ w = p + \sum y_j, \qquad y_j' = -y_j/\lambda_j. $$
!> Contact gives w, and there the arms are alone; adhesion and free zones give p, and there the elements are.
module adfric_foundation_stepping_solid
   use adfric_base_kinds, only: dp
   use adfric_solid_prony, only: prony_t, new_prony
   use adfric_solid_retardation, only: retardation_t, new_retardation
   implicit none (type, external)
   private
   public :: solid_t, new_solid, multiply, product_of

   !> Arms that relax in a smaller share of a period are as one: what they do to friction is less than this share of the rest.
   real(dp), parameter :: slowest = 1.0e-30_dp

   !> A column of the foundation at one velocity.
   type :: solid_t
      !> Number of arms, and of Kelvin elements.
      integer :: n = 0
      !> Instantaneous stiffness [k0].
      real(dp) :: glassy = 1
      !> Stiffnesses [k0] and relaxation times [period] of the arms; shape `(n)`.
      real(dp), allocatable :: stiffness(:), time(:)
      !> Compliances [1/k0] and retardation times [period] of the Kelvin elements; shape `(n)`.
      real(dp), allocatable :: compliance(:), retardation(:)
      !> The elements y_j from the r_i, and from the e_i, at p = 0 in the second case; shape `(n, n)`.
      real(dp), allocatable :: elements_of_stretches(:, :), elements_of_lengths(:, :)
      !> The r_i from the elements y_j, and the e_i at p = 0; shape `(n, n)`.
      real(dp), allocatable :: stretches_of_elements(:, :), lengths_of_elements(:, :)
   end type solid_t

contains

   !> The column at one velocity.
   pure subroutine new_solid(self, prony, pace)
      type(solid_t), intent(out) :: self
      type(prony_t), intent(in) :: prony
      !> Periods that pass in the unit of time of `prony`, V/l; >= 0.
      real(dp), intent(in) :: pace
      type(prony_t) :: reduced
      type(retardation_t) :: kelvin
      integer :: i, j

      ! arms too fast for the digits of a position are one arm, which is next to no resistance at all
      call new_prony(reduced, 1.0_dp, prony%moduli/prony%relaxed, max(prony%times*pace, slowest))
      call new_retardation(kelvin, reduced)
      self%n = size(reduced%times)
      associate (n => self%n)
         allocate (self%stiffness(n), self%time(n), self%compliance(n), self%retardation(n))
         allocate (self%elements_of_stretches(n, n), self%elements_of_lengths(n, n))
         allocate (self%stretches_of_elements(n, n), self%lengths_of_elements(n, n))
      end associate
      self%stiffness = reduced%moduli
      self%glassy = 1 + sum(reduced%moduli)
      self%compliance = kelvin%compliances
      associate (k => self%stiffness, tau => reduced%times, lambda => kelvin%times, apart => kelvin%distances)
         do j = 1, self%n
            do i = 1, self%n
               self%elements_of_stretches(j, i) = -kelvin%compliances(j)*lambda(j)*k(i)/apart(i, j)
               self%elements_of_lengths(j, i) = kelvin%compliances(j)*k(i)*tau(i)/apart(i, j)
               self%stretches_of_elements(i, j) = -tau(i)/apart(i, j)
               self%lengths_of_elements(i, j) = lambda(j)/apart(i, j)
            end do
         end do
         self%time = tau
         self%retardation = lambda
      end associate
   end subroutine new_solid

   !> Multiply a square matrix by vectors.
   pure subroutine multiply(n, n_vectors, matrix, vectors, is_added, products)
      !> Number of components, and of vectors.
      integer, intent(in) :: n, n_vectors
      real(dp), intent(in) :: matrix(n, n), vectors(n, n_vectors)
      !> Are the products added to what stands in `products`?
      logical, intent(in) :: is_added
      real(dp), intent(inout) :: products(n, n_vectors)
      integer :: i, k

      ! four columns at once: the loops over so few components are short
      do i = 1, n_vectors
         if (.not. is_added) products(:, i) = 0
         do k = 1, n - 3, 4
            products(:, i) = products(:, i) + (vectors(k, i)*matrix(:, k) + vectors(k + 1, i)*matrix(:, k + 1) &
               & + vectors(k + 2, i)*matrix(:, k + 2) + vectors(k + 3, i)*matrix(:, k + 3))
         end do
         do k = n - mod(n, 4) + 1, n
            products(:, i) = products(:, i) + vectors(k, i)*matrix(:, k)
         end do
      end do
   end subroutine multiply

   !> A matrix times a vector.
   pure function product_of(matrix, vector) result(product)
      !> The matrix; shape `(n, n)`.
      real(dp), intent(in) :: matrix(:, :)
      !> The vector; shape `(n)`.
      real(dp), intent(in) :: vector(:)
      real(dp) :: product(size(vector))
      integer :: k

      product = 0
      do k = 1, size(vector)
         product = product + vector(k)*matrix(:, k)
      end do
   end function product_of

end module adfric_foundation_stepping_solid
