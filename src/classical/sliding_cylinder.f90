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
module adfric_classical_sliding_cylinder
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_numerics_bessel_ratios, only: bessel_i1_i0, bessel_i2_i0, bessel_k1_k0
   use adfric_numerics_double_exponential, only: integrand_t, integrate
   use adfric_numerics_hyperbolic, only: sinh_minus_argument
   use adfric_numerics_secant_root, only: rising_equation_t, find_rising_root
   use adfric_classical_sliding_solid, only: sliding_solid_t
   use adfric_classical_sliding_shift, only: sliding_shift_t, find_shift
   implicit none (type, external)
   private
   public :: cylinder_contact_t, cylinder_of_width, cylinder_of_load, sliding_cylinder_pressure, sliding_cylinder_gap

   !> Exponent whose decay is nothing.
   real(dp), parameter :: long_way = 45
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

   !> What a relaxation length adds to the pressure at a place in the contact.
   type, extends(integrand_t) :: contact_integrand_t
      !> The place y from the middle.
      real(dp) :: place = 0
      !> What is left from the end of the range to the leading edge.
      real(dp) :: rest = 0
      !> Relaxation length a, and a/(4 rho).
      real(dp) :: length = 1, factor = 0
   contains
      procedure :: evaluate => contact_term
   end type contact_integrand_t

   !> What a retardation length adds to the gap at a place.
   type, extends(integrand_t) :: gap_integrand_t
      !> Way from the leading edge to the place, or from the place to the trailing edge.
      real(dp) :: way = 0
      !> Does the place lie ahead of the contact?
      logical :: is_ahead = .true.
      !> What is left from the end of the range to the trailing edge.
      real(dp) :: rest = 0
      !> Retardation length b, and 4 rho'/b^2.
      real(dp) :: length = 1, factor = 0
   contains
      procedure :: evaluate => gap_term
   end type gap_integrand_t

contains

   !> The contact of a given half-width.
   pure subroutine cylinder_of_width(solid, half_width, contact, is_converged)
      !> The solid, in any unit of length.
      type(sliding_solid_t), intent(in) :: solid
      !> Half-width [the same unit], > 0; no length over it lies outside 1e-100 to 1e100.
      real(dp), intent(in) :: half_width
      !> The contact.
      type(cylinder_contact_t), intent(out) :: contact
      !> Was the system solved?
      logical, intent(out) :: is_converged

      contact%half_width = half_width
      contact%solid = solid
      call contact%solid%change_unit(half_width)
      associate (a => contact%solid%relaxation, b => contact%solid%retardation, shift => contact%shift)
         contact%rho = a*bessel_i1_i0(1/a)/4
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
      !> The solid, in any unit of length.
      type(sliding_solid_t), intent(in) :: solid
      !> 4 R W/(pi E0) [the square of this unit], >= 0: the square of the half-width if the solid were relaxed. No load makes no
      !> contact.
      real(dp), intent(in) :: square
      !> The contact.
      type(cylinder_contact_t), intent(out) :: contact
      !> Was it found?
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
      !> The equation with the solid and the load.
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

   !> Pressure at x. With y = x - m, R^2 = (1 - y^2)/4 and the sums G_i of the shift
   !>
   !>     p = 2 R + 2 sum_i e_i G_i int_y^1 e^(-(z-y)/a_i) [1 + z a_i/(4 rho_i)] dz/R
   pure real(dp) function sliding_cylinder_pressure(contact, x) result(p)
      !> The contact.
      type(cylinder_contact_t), intent(in) :: contact
      !> Place along the surface, from the lowest point of the cylinder [w].
      real(dp), intent(in) :: x
      type(contact_integrand_t) :: integrand
      real(dp) :: y, part, range
      integer :: i
      logical :: is_converged

      y = x - contact%shift%shift
      p = 0
      if (abs(y) >= 1) return
      p = sqrt((1 - y)*(1 + y))
      integrand%place = y
      do i = 1, contact%solid%n_arms
         integrand%length = contact%solid%relaxation(i)
         integrand%factor = integrand%length/(4*contact%rho(i))
         range = min(1 - y, long_way*integrand%length)
         integrand%rest = (1 - y) - range
         call integrate(integrand, range, part, is_converged)
         p = p + 2*contact%solid%ratios(i)*contact%shift%edge_pressures(i)*part
         if (.not. is_converged) p = not_a_number()
      end do
      ! next to an edge round-off may change the sign
      if (p < 0) p = 0
   end function sliding_cylinder_pressure

   !> The integrand of the pressure, see `integrand_t`.
   pure real(dp) function contact_term(self, from_left, from_right) result(term)
      !> The arm and the place.
      class(contact_integrand_t), intent(in) :: self
      !> Distance from the place.
      real(dp), intent(in) :: from_left
      !> Distance from the end of the range.
      real(dp), intent(in) :: from_right
      real(dp) :: to_leading, to_trailing

      to_leading = from_right + self%rest
      to_trailing = (1 + self%place) + from_left
      term = exp(-from_left/self%length)*(1 + (self%place + from_left)*self%factor)*2/sqrt(to_leading*to_trailing)
   end function contact_term

   !> Gap at x. With |y| = cosh v
   !>
   !>     g = (sinh 2v - 2v)/4 + m sinh v sign(y) + sum_j eta_j int_y e^(-(z-y)/b_j) [|z|/sqrt(z^2 - 1) - 4 rho'_j v(z)/b_j^2] dz
   !>
   !> up to the trailing edge from behind, and without end ahead.
   pure real(dp) function sliding_cylinder_gap(contact, x) result(g)
      !> The contact.
      type(cylinder_contact_t), intent(in) :: contact
      !> Place along the surface, from the lowest point of the cylinder [w].
      real(dp), intent(in) :: x
      type(gap_integrand_t) :: integrand
      real(dp) :: y, v, part, range
      integer :: j
      logical :: is_converged

      y = x - contact%shift%shift
      g = 0
      if (abs(y) <= 1) return
      integrand%way = abs(y) - 1
      integrand%is_ahead = y > 0
      v = 2*asinh(sqrt(integrand%way/2))
      do j = 1, contact%solid%n_arms
         integrand%length = contact%solid%retardation(j)
         integrand%factor = 4*contact%gap_rho(j)/integrand%length**2
         range = long_way*integrand%length
         if (y < 0) range = min(range, integrand%way)
         integrand%rest = integrand%way - range
         call integrate(integrand, range, part, is_converged)
         g = g + contact%shift%shares(j)*part
         if (.not. is_converged) g = not_a_number()
      end do
      g = g + sinh_minus_argument(2*v)/4 + sign(contact%shift%shift*sinh(v), y)
      if (g < 0) g = 0
   end function sliding_cylinder_gap

   !> The integrand of the gap, see `integrand_t`.
   pure real(dp) function gap_term(self, from_left, from_right) result(term)
      !> The arm and the place.
      class(gap_integrand_t), intent(in) :: self
      !> Distance from the place.
      real(dp), intent(in) :: from_left
      !> Distance from the end of the range.
      real(dp), intent(in) :: from_right
      real(dp) :: to_edge

      if (self%is_ahead) then
         to_edge = self%way + from_left
      else
         to_edge = from_right + self%rest
      end if
      term = (1 + to_edge)/sqrt(to_edge*(2 + to_edge)) - self%factor*2*asinh(sqrt(to_edge/2))
      term = exp(-from_left/self%length)*term
   end function gap_term

end module adfric_classical_sliding_cylinder
