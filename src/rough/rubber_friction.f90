! SPDX-License-Identifier: GPL-3.0-or-later
!> Persson's theory of the hysteretic friction of a viscoelastic solid that slides over a rough surface (J. Chem. Phys. 115, 2001).
!> With the slope t of the waves up to q, t^2 = M_2(q), and means over the directions phi of the waves,
!>
!>     mu = int t dt A S(A) < cos phi Im E(q V cos phi) >/p,   A = erf(1/(2 sqrt(G))),   G = (1/4) int_0^t t dt < |E(q V cos phi)|^2 >/p^2
!>
!> The means are elementary for a sum of arms E_i with times tau_i: with x_i = q V tau_i, D(x) = 1 - 1/sqrt(1 + x^2),
!>
!>     < cos phi Im E > = sum E_i D(x_i)/x_i,
!>     < |E|^2 > = E_0^2 + sum B_i D(x_i),   B_i = 2 E_i (E_0 + sum_j E_j tau_j/(tau_i + tau_j))
module adfric_rough_rubber_friction
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use adfric_base_kinds, only: dp
   use adfric_numerics_gauss, only: gauss_integrals_10
   use adfric_rough_separation_functions, only: energy_share_t
   use adfric_rough_wave_nodes, only: n_of_panel, wave_nodes_t
   use adfric_solid_prony, only: prony_t
   implicit none (type, external)
   private
   public :: rubber_friction_t, get_rubber_friction

   !> Friction at a speed.
   type :: rubber_friction_t
      !> Part of the area in contact.
      real(dp) :: contact_fraction = 0
      !> Coefficients of friction of the shares W of the energy that were asked for; shape `(n_shares)`.
      real(dp), allocatable :: coefficients(:)
      !> Coefficient of friction if contact were full.
      real(dp) :: full_contact = 0
      !> Are they numbers? If not, nothing is known.
      logical :: is_finite = .true.
   end type rubber_friction_t

contains

   !> Friction at a speed under a pressure.
   pure subroutine get_rubber_friction(nodes, prony, pressure, speed, shares, friction)
      type(wave_nodes_t), intent(in) :: nodes
      !> The solid, contact moduli [Pa] and times [s].
      type(prony_t), intent(in) :: prony
      !> Mean pressure [Pa], and speed [m/s], >= 0.
      real(dp), intent(in) :: pressure, speed
      type(energy_share_t), intent(in) :: shares(:)
      type(rubber_friction_t), intent(out) :: friction
      real(dp) :: loss(n_of_panel), square(n_of_panel), of_full(n_of_panel), g(n_of_panel), fraction(n_of_panel), before
      real(dp), allocatable :: products(:), moduli(:)
      integer :: i, k, n

      ! moduli over the pressure, so that nothing depends on units
      moduli = prony%moduli/pressure
      allocate (products(size(moduli)))
      associate (e_0 => prony%relaxed/pressure)
         do i = 1, size(moduli)
            products(i) = 2*moduli(i)*(e_0 + sum(moduli*prony%times/(prony%times + prony%times(i))))
         end do
         allocate (friction%coefficients(size(shares)), source=0.0_dp)
         before = nodes%ends(0)**2*e_0**2/8
         do i = 1, size(nodes%weights, 2)
            do k = 1, n_of_panel
               call get_means(nodes%q(k, i)*speed*prony%times, moduli, products, loss(k), square(k))
               square(k) = square(k) + e_0**2
            end do
            ! G at the nodes and at the end of the panel
            g = before + nodes%widths(i)/2*matmul(gauss_integrals_10, nodes%t(:, i)**2*square)/4
            before = before + sum(nodes%weights(:, i)*nodes%t(:, i)**2*square)/4
            friction%is_finite = minval(g) > 0
            if (.not. friction%is_finite) return
            fraction = erf(1/(2*nodes%slope*sqrt(g)))
            of_full = nodes%slope**2*nodes%weights(:, i)*nodes%t(:, i)**2*loss
            friction%full_contact = friction%full_contact + sum(of_full)
            do n = 1, size(shares)
               friction%coefficients(n) = friction%coefficients(n) + sum(of_full*shares(n)%share(fraction))
            end do
         end do
      end associate
      friction%contact_fraction = erf(1/(2*nodes%slope*sqrt(before)))
      friction%is_finite = ieee_is_finite(friction%contact_fraction) .and. ieee_is_finite(friction%full_contact) &
         & .and. all(ieee_is_finite(friction%coefficients))
   end subroutine get_rubber_friction

   !> Means over the directions of a wave: of cos phi Im E, and of |E|^2 less the relaxed part.
   pure subroutine get_means(x, moduli, products, loss, square)
      !> Wave number times path per relaxation time of each arm; and moduli, and coefficients B, over the pressure and its square.
      real(dp), intent(in) :: x(:), moduli(:), products(:)
      real(dp), intent(out) :: loss, square
      real(dp) :: root
      integer :: i

      loss = 0
      square = 0
      do i = 1, size(x)
         ! D(x) = x^2/(root (1 + root)) has no difference
         root = hypot(1.0_dp, x(i))
         loss = loss + moduli(i)*(x(i)/root)/(1 + root)
         square = square + products(i)*(x(i)/root)*(x(i)/(1 + root))
      end do
   end subroutine get_means

end module adfric_rough_rubber_friction
