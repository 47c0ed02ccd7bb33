! SPDX-License-Identifier: GPL-3.0-or-later
!> A rigid cylinder, or parabola h = -x^2/(2 R), that slides steadily to +x over a viscoelastic half-plane without friction (S. C.
!> Hunter, J. Appl. Mech. 28, 611, 1961, has one relaxation time), in closed form for any relaxation spectrum.
!>
!> It is a wave whose length is without bound (`sliding_wave`). Reduced: lengths along the surface in the half-width w of the
!> contact, which stands at m - 1 < x < m + 1; pressures in E0 w/(2 R), heights in w^2/R. With L_i = 1/a_i, M_j = 1/b_j
!>
!>     rho_i = I1(L_i)/(4 L_i I0(L_i)),    nu_i = I2(L_i)/I0(L_i),    rho'_j = K1(M_j)/(4 M_j K0(M_j))
!>     load ratio   W/(pi E0 w^2/(4 R)) = 1 + 8 sum_j eta_j rho'_j/b_j
!>     friction     T/W = (4 w/R) sum_i e_i a_i (nu_i/4 + 2 rho_i sigma_i + 2 m G_i)/(load ratio)
!>
!> The load rises with w: for a given load the contact is unique, and it determines w.
module adfric_plane_sliding_cylinder
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_numerics_bessel_ratios, only: bessel_i1_deficit, bessel_i1_i0, bessel_i2_i0, bessel_k1_k0
   use adfric_numerics_secant_root, only: rising_equation_t, find_rising_root
   use adfric_plane_sliding_solid, only: sliding_solid_t
   use adfric_plane_sliding_shift, only: sliding_shift_t, find_shift
   implicit none (type, external)
   private
   public :: cylinder_contact_t, cylinder_of_width, cylinder_of_load

   !> What a logarithm of two equal loads may be.
   real(dp), parameter :: round_off = 4*epsilon(1.0_dp)

   !> A contact.
   type :: cylinder_contact_t
      !> Half-width w of the contact, in the unit of length of the solid that was given.
      real(dp) :: half_width = 0
      !> The solid, with lengths in w.
      type(sliding_solid_t) :: solid
      !> Load W per length over pi E0 w^2/(4 R), >= 1.
      real(dp) :: load_ratio = 1
      !> Friction coefficient T/W over w/R, >= 0.
      real(dp) :: friction_ratio = 0
      !> Shift m [w] and sums over the arms.
      type(sliding_shift_t) :: shift
      !> Means rho_i of the contact [w^2]; shape `(n)`.
      real(dp), allocatable :: rho(:)
      !> 1 - 4 rho_i/a_i, with its digits where it is small; shape `(n)`.
      real(dp), allocatable :: deficits(:)
      !> Means rho'_j of the gap [w^2]; shape `(n)`.
      real(dp), allocatable :: gap_rho(:)
   end type cylinder_contact_t

   !> Logarithm of the load over the one that is wanted, which rises with x = ln w.
   type, extends(rising_equation_t) :: load_equation_t
      !> The solid.
      type(sliding_solid_t) :: solid
      !> Logarithm of the wanted 4 R W/(pi E0), the square of the half-width on the relaxed solid.
      real(dp) :: wanted = 0
   contains
      procedure :: evaluate
   end type load_equation_t

contains

   !> The contact of a given half-width.
   pure subroutine cylinder_of_width(solid, half_width, contact, is_converged)
      type(sliding_solid_t), intent(in) :: solid
      !> Half-width [the same unit], > 0; no length over it lies outside 1e-100 to 1e100.
      real(dp), intent(in) :: half_width
      type(cylinder_contact_t), intent(out) :: contact
      logical, intent(out) :: is_converged

      contact%half_width = half_width
      contact%solid = solid
      call contact%solid%change_unit(half_width)
      associate (a => contact%solid%relaxation, b => contact%solid%retardation, shift => contact%shift)
         contact%rho = a*bessel_i1_i0(1/a)/4
         contact%deficits = bessel_i1_deficit(1/a)
         contact%gap_rho = b*bessel_k1_k0(1/b)/4
         call find_shift(contact%solid, 0.0_dp, contact%rho, contact%gap_rho, shift, is_converged)
         if (.not. is_converged) return
         contact%load_ratio = 1 + 8*shift%edge_load
         contact%friction_ratio = 4*sum(contact%solid%ratios*a*(bessel_i2_i0(1/a)/4 + 2*contact%rho*shift%slopes &
            & + 2*shift%shift*shift%edge_pressures))/contact%load_ratio
      end associate
   end subroutine cylinder_of_width

   !> The contact under a load.
   pure subroutine cylinder_of_load(solid, square, contact, is_converged)
      type(sliding_solid_t), intent(in) :: solid
      !> 4 R W/(pi E0) [the square of this unit], >= 0: the square of the half-width if the solid were relaxed. No load makes no
      !> contact.
      real(dp), intent(in) :: square
      type(cylinder_contact_t), intent(out) :: contact
      logical, intent(out) :: is_converged
      type(load_equation_t) :: equation
      real(dp) :: x, low, high

      contact%solid = solid
      is_converged = square >= 0 .and. .not. square > 0
      if (.not. square > 0) return
      equation%solid = solid
      equation%wanted = log(square)
      ! the load ratio lies between the relaxed and the instantaneous solid
      high = equation%wanted/2 + 1
      low = high - 2 - log(solid%instantaneous_ratio())/2
      x = low + (high - low)/2
      call find_rising_root(equation, low, high, 2.0_dp, round_off, x, is_converged)
      if (is_converged) call cylinder_of_width(solid, exp(x), contact, is_converged)
   end subroutine cylinder_of_load

   !> See `rising_equation_t`.
   pure subroutine evaluate(self, x, value)
      class(load_equation_t), intent(in) :: self
      !> ln w.
      real(dp), intent(in) :: x
      !> Logarithm of the load over the one that is wanted; NaN if there is no solution.
      real(dp), intent(out) :: value
      type(cylinder_contact_t) :: contact
      logical :: is_converged

      call cylinder_of_width(self%solid, exp(x), contact, is_converged)
      value = not_a_number()
      if (is_converged) value = log(contact%load_ratio) + (2*x - self%wanted)
   end subroutine evaluate

end module adfric_plane_sliding_cylinder
