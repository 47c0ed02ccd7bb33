! SPDX-License-Identifier: GPL-3.0-or-later
!> A rigid punch pressed on an elastic half-plane without friction, plane strain (Y; Johnson, Contact Mechanics, 1985, 2.8, 5.2).
!>
!> The profile z(x) >= 0 is even and rises from its tip. Inside the contact |x| < a the slopes of punch and surface agree,
!>
!>     int p(s)/(x - s) ds = (pi E*/2) z'(x)
!>
!> The solution that is bounded at the edges, p = sqrt(1 - t^2) G(t) with t = x/a, carries the load P(a). It is found by
!> collocation of Gauss and Chebyshev (Erdogan and Gupta 1972), which converges faster than any power of the number of points
!> for smooth profiles; its linear system is a cosine transform, which is its own inverse. Where the face ends before that,
!> |x| <= w, the contact is the whole face, and the rest of the load is carried as by a flat punch:
!> p = p_w + (P - P(w))/(pi sqrt(w^2 - x^2)).
module adfric_plane_rigid_punch
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_numerics_scalar_root, only: equation_t, find_root
   implicit none (type, external)
   private
   public :: punch_profile_t, punch_contact_t, solve_punch, solve_punch_of_width, bounded_load

   !> An even profile.
   type, abstract :: punch_profile_t
   contains
      procedure(evaluate_profile_i), deferred :: height
      procedure(evaluate_profile_i), deferred :: slope
   end type punch_profile_t

   abstract interface
      !> Height z [m] or slope z' [-] at x >= 0.
      elemental real(dp) function evaluate_profile_i(self, x)
         import :: punch_profile_t, dp
         implicit none (type, external)
         !> Profile that is evaluated.
         class(punch_profile_t), intent(in) :: self
         !> Coordinate from the middle of the punch [m], >= 0.
         real(dp), intent(in) :: x
      end function evaluate_profile_i
   end interface

   !> A solved contact.
   type :: punch_contact_t
      !> Half-width a of contact [m], load P [N/m], load of the flat part [N/m].
      real(dp) :: half_width = 0, load = 0, excess = 0
      !> E* [Pa].
      real(dp) :: modulus = 1
      !> The bounded part is the sum of b_k sin(k th), x = a cos th [Pa]; those of even k are 0. Shape `(n_terms)`.
      real(dp), allocatable :: b(:)
      !> Relative difference of the load from its closed form.
      real(dp) :: load_error = 0
      !> Has the half-width been found to round-off?
      logical :: is_converged = .false.
   contains
      procedure :: pressure
      procedure :: rise
   end type punch_contact_t

   !> P(a) = load for x = a.
   type, extends(equation_t) :: punch_load_equation_t
      !> Shape of the punch.
      class(punch_profile_t), allocatable :: profile
      !> E* [Pa], and the load that is given [N/m].
      real(dp) :: modulus = 1, load = 0
      !> See `load_nodes`.
      real(dp), allocatable :: nodes(:)
   contains
      procedure :: evaluate
   end type punch_load_equation_t

contains

   !> Solve for the contact under a load > 0.
   pure subroutine solve_punch(profile, face, modulus, load, n, self)
      class(punch_profile_t), intent(in) :: profile
      !> Half-width w of the face [m], > 0.
      real(dp), intent(in) :: face
      !> Contact modulus E* [Pa].
      real(dp), intent(in) :: modulus
      !> Load P per length [N/m], > 0.
      real(dp), intent(in) :: load
      !> Number of points of collocation, even.
      integer, intent(in) :: n
      !> The contact; `is_converged` tells whether it was found.
      type(punch_contact_t), intent(out) :: self
      type(punch_load_equation_t) :: equation
      real(dp) :: bounded, nodes(n)

      self%load = load
      self%modulus = modulus
      self%half_width = face
      self%is_converged = .true.
      nodes = load_nodes(n)
      bounded = load_at(profile, modulus, face, nodes)
      if (bounded > load) then
         allocate (equation%profile, source=profile)
         equation%modulus = modulus
         equation%load = load
         equation%nodes = nodes
         self%half_width = face*min(0.9_dp, sqrt(load/bounded))
         call find_root(equation, 0.0_dp, face, .true., self%half_width, self%is_converged)
         bounded = load
      end if
      self%excess = load - bounded
      if (self%is_converged) call collocate(profile, n, bounded, self)
   end subroutine solve_punch

   !> The contact of a given half-width, with the load that is bounded at its edges.
   pure subroutine solve_punch_of_width(profile, half_width, modulus, n, self)
      class(punch_profile_t), intent(in) :: profile
      !> Half-width a of contact [m], > 0.
      real(dp), intent(in) :: half_width
      !> Contact modulus E* [Pa].
      real(dp), intent(in) :: modulus
      !> Number of points of collocation, even.
      integer, intent(in) :: n
      !> The contact; `is_converged` tells whether it was found.
      type(punch_contact_t), intent(out) :: self

      self%half_width = half_width
      self%modulus = modulus
      self%load = bounded_load(profile, modulus, half_width, n)
      call collocate(profile, n, self%load, self)
   end subroutine solve_punch_of_width

   !> Load of the bounded solution on |x| < a: P = (E*/2) int x z'(x)/sqrt(a^2 - x^2) dx.
   pure real(dp) function bounded_load(profile, modulus, a, n)
      class(punch_profile_t), intent(in) :: profile
      !> Contact modulus E* [Pa].
      real(dp), intent(in) :: modulus
      !> Half-width a of contact [m], > 0.
      real(dp), intent(in) :: a
      !> Number of nodes, that of the points of collocation.
      integer, intent(in) :: n

      bounded_load = load_at(profile, modulus, a, load_nodes(n))
   end function bounded_load

   !> Where the integrand of the load is evaluated [a]: x > 0 only, with twice as many points as for the pressure.
   pure function load_nodes(n) result(nodes)
      !> Number of nodes, that of the points of collocation.
      integer, intent(in) :: n
      real(dp) :: nodes(n)
      integer :: i

      nodes = cos((2*[(i, i=1, n)] - 1)*pi/(4*n))
   end function load_nodes

   !> Load of the bounded solution from nodes that are given.
   pure real(dp) function load_at(profile, modulus, a, nodes)
      class(punch_profile_t), intent(in) :: profile
      !> Contact modulus E* [Pa].
      real(dp), intent(in) :: modulus
      !> Half-width a of contact [m], > 0.
      real(dp), intent(in) :: a
      !> Nodes from `load_nodes`, in half-widths [-].
      real(dp), intent(in) :: nodes(:)

      load_at = modulus/2*sum(a*nodes*profile%slope(a*nodes))*pi/size(nodes)
   end function load_at

   !> See `equation_t`.
   pure subroutine evaluate(self, x, value, slope)
      class(punch_load_equation_t), intent(in) :: self
      !> Half-width of contact [m], > 0.
      real(dp), intent(in) :: x
      !> Load of the bounded solution less the load that is given [N/m]; 0 at the root.
      real(dp), intent(out) :: value
      !> Derivative of the value with respect to x [N/m^2].
      real(dp), intent(out) :: slope
      real(dp), parameter :: h = 1.0e-5_dp

      value = load_at(self%profile, self%modulus, x, self%nodes) - self%load
      slope = (load_at(self%profile, self%modulus, x*(1 + h), self%nodes) &
         & - load_at(self%profile, self%modulus, x*(1 - h), self%nodes))/(2*h*x)
   end subroutine evaluate

   !> Collocation at x_j = a cos th_j, th_j = (2j - 1) pi/(2n + 2), j = 1 ... n + 1. A pressure sum of b_k sin(k th) has the slopes
   !>
   !>     sum over k of b_k cos(k th_j) = (E*/2) z'(x_j),  b_k = (2/(n + 1)) sum over j of (E*/2) z'(x_j) cos(k th_j)
   !>
   !> z' is odd: the even b_k and what the middle position adds are 0, and half of the positions will do.
   pure subroutine collocate(profile, n, bounded, self)
      class(punch_profile_t), intent(in) :: profile
      !> Number of points of collocation, even.
      integer, intent(in) :: n
      !> Load of the bounded part [N/m].
      real(dp), intent(in) :: bounded
      !> In: half-width, modulus and load. Out: also coefficients, error of the load and `is_converged`.
      type(punch_contact_t), intent(inout) :: self
      !> A series ends where its terms are round-off of the largest.
      real(dp), parameter :: round_off = 8*epsilon(1.0_dp)
      real(dp) :: cosines(0:4*n + 3), slopes(n/2)
      integer :: j, k

      do j = 0, 4*n + 3
         cosines(j) = cos(j*pi/(2*n + 2))
      end do
      slopes = self%modulus/2*profile%slope(self%half_width*cosines(1:n - 1:2))
      allocate (self%b(n), source=0.0_dp)
      do k = 1, n, 2
         do j = 1, n/2
            ! k th_j within one turn
            self%b(k) = self%b(k) + slopes(j)*cosines(modulo(k*(2*j - 1), 4*n + 4))
         end do
         self%b(k) = 4*self%b(k)/(n + 1)
      end do
      self%load_error = abs(self%b(1)*self%half_width*pi/2 - bounded)/self%load
      self%is_converged = maxval(abs(self%b)) < huge(1.0_dp)
      do k = n, 1, -1
         if (abs(self%b(k)) > round_off*maxval(abs(self%b))) exit
      end do
      self%b = self%b(:k)
   end subroutine collocate

   !> Pressure at x; 0 outside, NaN at the edge of a face that is in contact all over.
   elemental real(dp) function pressure(self, x)
      class(punch_contact_t), intent(in) :: self
      !> Coordinate along the surface, from the middle of the punch [m].
      real(dp), intent(in) :: x
      real(dp) :: t, root, th
      integer :: k

      pressure = 0
      t = abs(x)/self%half_width
      if (t > 1) return
      root = sqrt((1 - t)*(1 + t))
      if (self%excess > 0) then
         pressure = not_a_number()
         if (.not. root > 0) return
         pressure = self%excess/(pi*self%half_width*root)
      end if
      th = atan2(root, t)
      do k = 1, size(self%b), 2
         pressure = pressure + self%b(k)*sin(k*th)
      end do
   end function pressure

   !> How far the surface lies above its level at the edge of contact, x = a, at any x [m]: the integral of
   !> (2/E*) sum b_k times T_(k+1)(t) inside, (t - sqrt(t^2 - 1))^(k+1) outside, and of the flat part.
   elemental real(dp) function rise(self, x)
      class(punch_contact_t), intent(in) :: self
      !> Coordinate along the surface, from the middle of the punch [m].
      real(dp), intent(in) :: x
      real(dp) :: t, v
      integer :: k

      t = abs(x)/self%half_width
      rise = 0
      if (t <= 1) then
         v = atan2(sqrt((1 - t)*(1 + t)), t)
         do k = 1, size(self%b), 2
            rise = rise + self%b(k)/2*((cos((k + 1)*v) - 1)/(k + 1) - less_one(cos((k - 1)*v), k - 1))
         end do
         rise = 2*self%half_width/self%modulus*rise
      else
         v = asinh(sqrt((t - 1)*(t + 1)))
         do k = 1, size(self%b), 2
            if (k == 1) then
               rise = rise + self%b(k)/2*(v - (1 - exp(-2*v))/2)
            else
               rise = rise + self%b(k)/2*((1 - exp(-(k - 1)*v))/(k - 1) - (1 - exp(-(k + 1)*v))/(k + 1))
            end if
         end do
         rise = 2/self%modulus*(self%half_width*rise + self%excess/pi*v)
      end if
   end function rise

   !> (c - 1)/k; 0 for k = 0.
   elemental real(dp) function less_one(c, k)
      !> The number c of the formula.
      real(dp), intent(in) :: c
      !> The divisor k of the formula, >= 0.
      integer, intent(in) :: k

      less_one = 0
      if (k > 0) less_one = (c - 1)/k
   end function less_one

end module adfric_plane_rigid_punch
