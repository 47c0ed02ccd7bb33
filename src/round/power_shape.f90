! SPDX-License-Identifier: GPL-3.0-or-later
!> Profiles that are sums of powers, f = sum of C_i r^n_i: cones, paraboloids, r^n, and polynomials.
!>
!>     g = sum of K_i C_i x^n_i,  K = sqrt(pi) Gamma(n/2 + 1)/Gamma(n/2 + 1/2)
module adfric_round_power_shape
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_round_closed_annulus, only: add_power_annulus
   use adfric_round_shape, only: shape_t, spot_t
   implicit none (type, external)
   private
   public :: power_shape_t, new_power_shape, depth_factor, most_terms

   !> Most terms of a sum.
   integer, parameter :: most_terms = 8
   !> Powers of whole exponents below this are taken by multiplication.
   integer, parameter :: largest_whole = 17

   !> A sum of powers.
   type, extends(shape_t) :: power_shape_t
      !> Number of terms.
      integer :: n_terms = 1
      !> Exponents n_i > 0, and coefficients K_i C_i > 0 of g.
      real(dp) :: exponents(most_terms) = 2, factors(most_terms) = 1
      !> The exponents that are small whole numbers; else 0.
      integer :: whole(most_terms) = 0
   contains
      procedure :: evaluate
      procedure :: unknown_of
      procedure :: get_end
      procedure :: rise
      procedure :: inner_rise
      procedure :: energy
      procedure :: get_profile
      procedure :: radius_of_height
      procedure :: get_closed_annulus
      procedure :: is_paraboloid
      procedure :: radius_of_depth
   end type power_shape_t

contains

   !> K of an exponent.
   elemental real(dp) function depth_factor(exponent) result(factor)
      !> Exponent n of a power of r, > 0.
      real(dp), intent(in) :: exponent
      !> Up to this argument Gamma is a number.
      real(dp), parameter :: largest = 150.0_dp

      if (exponent/2 + 1 < largest) then
         factor = sqrt(pi)*gamma(exponent/2 + 1)/gamma(exponent/2 + 0.5_dp)
      else
         factor = sqrt(pi)*exp(log_gamma(exponent/2 + 1) - log_gamma(exponent/2 + 0.5_dp))
      end if
   end function depth_factor

   !> The shape of a sum of powers.
   pure subroutine new_power_shape(self, exponents, factors)
      type(power_shape_t), intent(out) :: self
      !> Exponents n_i > 0; shape `(n_terms)`, `n_terms` <= `most_terms`.
      real(dp), intent(in) :: exponents(:)
      !> Coefficients K_i C_i > 0 of g, in units of the case; shape `(n_terms)`.
      real(dp), intent(in) :: factors(:)

      self%n_terms = size(exponents)
      self%exponents(:self%n_terms) = exponents
      self%factors(:self%n_terms) = factors
      where (exponents < largest_whole .and. .not. abs(exponents - nint(exponents)) > 0) self%whole(:self%n_terms) = nint(exponents)
      self%onset = minval(exponents) - 1
      self%has_rising_slope = .not. any(exponents < 1)
      if (.not. any(abs(exponents - nint(exponents)) > 0)) self%reach = huge(1.0_dp)
   end subroutine new_power_shape

   !> Is it r^2 alone, whose pressure and gap have closed forms?
   pure logical function is_paraboloid(self)
      class(power_shape_t), intent(in) :: self

      is_paraboloid = self%n_terms == 1 .and. self%whole(1) == 2
   end function is_paraboloid

   !> The radius where g of a sum of one term has a value: the inverse of g.
   elemental real(dp) function radius_of_depth(self, depth) result(radius)
      class(power_shape_t), intent(in) :: self
      !> Depth, >= 0.
      real(dp), intent(in) :: depth

      select case (self%whole(1))
      case (1)
         radius = depth/self%factors(1)
      case (2)
         radius = sqrt(depth/self%factors(1))
      case default
         radius = 0
         if (depth > 0) radius = (depth/self%factors(1))**(1/self%exponents(1))
      end select
   end function radius_of_depth

   !> See `shape_t`: u = a.
   pure subroutine evaluate(self, u, is_beyond, spot)
      class(power_shape_t), intent(in) :: self
      real(dp), intent(in) :: u
      logical, intent(in) :: is_beyond
      type(spot_t), intent(out) :: spot
      real(dp) :: term
      integer :: k

      spot%radius = u
      spot%beyond = u
      if (.not. u > 0) return
      do k = 1, self%n_terms
         associate (n => self%exponents(k))
            term = self%factors(k)*power(u, n, self%whole(k))
            spot%depth = spot%depth + term
            spot%depth_slope = spot%depth_slope + n*term/u
            spot%depth_curve = spot%depth_curve + n*(n - 1)*term/u**2
            spot%load = spot%load + 2*n/(n + 1)*term*u
         end associate
      end do
      associate (unused => is_beyond)
      end associate
   end subroutine evaluate

   !> x^n; for small whole n by multiplication.
   elemental real(dp) function power(x, n, whole)
      !> The base, > 0.
      real(dp), intent(in) :: x
      !> The exponent, > 0.
      real(dp), intent(in) :: n
      !> The exponent where it is a small whole number, else 0.
      integer, intent(in) :: whole

      if (whole > 0) then
         power = x**whole
      else
         power = x**n
      end if
   end function power

   !> See `shape_t`.
   elemental real(dp) function unknown_of(self, radius)
      class(power_shape_t), intent(in) :: self
      real(dp), intent(in) :: radius

      unknown_of = radius
      associate (unused => self)
      end associate
   end function unknown_of

   !> See `shape_t`: where one of the terms n K C a^(n - 1/2) is the number.
   pure real(dp) function get_end(self, target)
      class(power_shape_t), intent(in) :: self
      real(dp), intent(in) :: target
      real(dp), parameter :: margin = 1.0_dp + 1.0e-6_dp, negligible = 1.0e-200_dp
      integer :: k

      get_end = huge(get_end)
      do k = 1, self%n_terms
         associate (n => self%exponents(k))
            ! a term that is next to nothing reaches the number beyond all radii
            if (.not. n*self%factors(k) > negligible*target) cycle
            get_end = min(get_end, margin*(target/(n*self%factors(k)))**(1/(n - 0.5_dp)))
         end associate
      end do
   end function get_end

   !> See `shape_t`.
   elemental real(dp) function rise(self, v)
      class(power_shape_t), intent(in) :: self
      real(dp), intent(in) :: v
      integer :: k

      rise = 0
      do k = 1, self%n_terms
         rise = rise + self%exponents(k)*self%factors(k)*power(v, self%exponents(k), self%whole(k))/v
      end do
   end function rise

   !> See `shape_t`: there is no corner.
   pure real(dp) function inner_rise(self)
      class(power_shape_t), intent(in) :: self

      inner_rise = 0
      associate (unused => self)
      end associate
   end function inner_rise

   !> See `shape_t`: two terms of g, i and j, give i j (i + j + 2)/((i + 1) (j + 1) (i + j + 1)) a times their values.
   pure real(dp) function energy(self, u, is_beyond)
      class(power_shape_t), intent(in) :: self
      real(dp), intent(in) :: u
      logical, intent(in) :: is_beyond
      real(dp) :: terms(most_terms)
      integer :: i, j

      energy = 0
      if (.not. u > 0) return
      do i = 1, self%n_terms
         terms(i) = self%factors(i)*power(u, self%exponents(i), self%whole(i))
         do j = 1, i
            associate (n => self%exponents(i), m => self%exponents(j))
               energy = energy + merge(1, 2, i == j)*terms(i)*terms(j)*n*m*(n + m + 2)/((n + 1)*(m + 1)*(n + m + 1))
            end associate
         end do
      end do
      energy = energy*u
      associate (unused => is_beyond)
      end associate
   end function energy

   !> See `shape_t`: the terms are those of g over K.
   pure subroutine get_profile(self, r, height, slope)
      class(power_shape_t), intent(in) :: self
      real(dp), intent(in) :: r
      real(dp), intent(out) :: height, slope
      real(dp) :: term
      integer :: k

      height = 0
      slope = 0
      if (.not. r > 0) return
      do k = 1, self%n_terms
         term = self%factors(k)/depth_factor(self%exponents(k))*power(r, self%exponents(k), self%whole(k))
         height = height + term
         slope = slope + self%exponents(k)*term/r
      end do
   end subroutine get_profile

   !> See `shape_t`: where one of the terms has the height.
   pure real(dp) function radius_of_height(self, height)
      class(power_shape_t), intent(in) :: self
      real(dp), intent(in) :: height
      integer :: k

      radius_of_height = huge(height)
      do k = 1, self%n_terms
         radius_of_height = min(radius_of_height, &
            & (height*depth_factor(self%exponents(k))/self%factors(k))**(1/self%exponents(k)))
      end do
   end function radius_of_height

   !> See `shape_t`: where all exponents are small whole numbers.
   pure subroutine get_closed_annulus(self, spot, is_beyond, s, opening, intensity, is_closed)
      class(power_shape_t), intent(in) :: self
      type(spot_t), intent(in) :: spot
      logical, intent(in) :: is_beyond
      real(dp), intent(in) :: s
      real(dp), intent(out) :: opening, intensity
      logical, intent(out) :: is_closed
      integer :: k

      opening = 0
      intensity = 0
      is_closed = all(self%whole(:self%n_terms) > 0)
      if (.not. is_closed) return
      do k = 1, self%n_terms
         call add_power_annulus(self%whole(k), self%factors(k), spot%radius, s, opening, intensity)
      end do
      associate (unused => is_beyond)
      end associate
   end subroutine get_closed_annulus

end module adfric_round_power_shape
