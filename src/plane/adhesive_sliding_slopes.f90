! SPDX-License-Identifier: GPL-3.0-or-later
!> The elastic slope v' = (E(s) u)' beside an adhesive sliding contact, and its far field: all that pressures do.
!>
!> v' + 2 i p is analytic above the surface. Its real part is known in contact, its imaginary part beside it. With
!> Q(x) = |S(x - x_l) S(x - x_t)| and the chord S of `adhesive_sliding_zones`,
!>
!>     v'(X) = f(X) - ... + (2 p0/pi) {ln|(tau + tau_l)/(tau - tau_l)| - ln|(tau + tau_t)/(tau - tau_t)|}
!>             + sum_i C_i (1/pi) integral over the contact of e_i(x) sqrt[Q(X)/Q(x)]/S(X - x) dx
!>
!> The first terms are the slope of a contact without end, cut off: for a wave with E(-V) = E' - i E''
!>
!>     E'' cos X - E' sin X + sqrt(Q) [E' cos((X + m)/2) + E'' sin((X + m)/2)]
!>
!> and for a cylinder -X + sqrt(Q) sgn(X - m). A pressure that is bounded at both edges has a v' of mean 0 (wave), or one that falls
!> as 1/X (cylinder): the first equation. The next terms far away are load and moment.
module adfric_plane_adhesive_sliding_slopes
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_plane_adhesive_sliding_nodes, only: nodes_t
   use adfric_plane_adhesive_sliding_zones, only: adhesive_slide_t, slide_zones_t, outer_nodes_t, chord, chord_beside
   implicit none (type, external)
   private
   public :: slopes_outside, get_far_field

   !> Positions of the contact whose kernels are made at once.
   integer, parameter :: block_size = 32

contains

   !> Slopes v' at positions beside the contact.
   pure subroutine slopes_outside(slide, zones, inner, kernel_weights, layers, outer, is_trailing, slopes)
      type(adhesive_slide_t), intent(in) :: slide
      type(slide_zones_t), intent(in) :: zones
      !> See `set_layers`.
      type(nodes_t), intent(in) :: inner
      real(dp), intent(in) :: kernel_weights(:), layers(:, 0:)
      !> The positions, and whether they are nearer to the trailing edge.
      type(outer_nodes_t), intent(in) :: outer
      logical, intent(in) :: is_trailing
      !> Slopes without the amplitudes (0), and of each amplitude; shape `(n, 0:n_arms)`.
      real(dp), intent(out) :: slopes(:, 0:)
      real(dp) :: roots(size(outer%weights))

      roots = sqrt(chord(slide%is_wave, outer%from_leading)*chord(slide%is_wave, outer%to_trailing))
      call get_known_slopes(slide, zones, outer, is_trailing, roots, slopes(:, 0))
      if (slide%solid%n_arms > 0) call add_layers(slide, inner, kernel_weights, layers, outer, is_trailing, roots, slopes)
   end subroutine slopes_outside

   !> Slopes of the contact without end, and of the zones.
   pure subroutine get_known_slopes(slide, zones, outer, is_trailing, roots, slopes)
      type(adhesive_slide_t), intent(in) :: slide
      type(slide_zones_t), intent(in) :: zones
      type(outer_nodes_t), intent(in) :: outer
      logical, intent(in) :: is_trailing
      !> sqrt(Q) at the positions.
      real(dp), intent(in) :: roots(:)
      real(dp), intent(out) :: slopes(:)
      real(dp), dimension(size(roots)) :: behind, tau, x
      real(dp) :: storage, loss, whole

      associate (wave => slide%is_wave, z => zones)
         behind = chord(wave, outer%to_trailing)
         tau = sqrt(chord(wave, outer%from_leading)/behind)
         x = z%middle + z%half_width + outer%from_leading
         if (wave) then
            call slide%solid%get_complex_ratio(storage, loss)
            slopes = (loss*cos(x) - storage*sin(x)) + roots*(storage*cos((x + z%middle)/2) + loss*sin((x + z%middle)/2))
         else
            if (is_trailing) x = z%middle - z%half_width - outer%to_trailing
            ! -x +- sqrt(Q) = -m -+ w^2/(sqrt(Q) + |x - m|)
            slopes = merge(1.0_dp, -1.0_dp, is_trailing)*z%half_width**2/(roots + abs(x - z%middle)) - z%middle
         end if
         ! tau^2 - tau_c^2 from the distance to c
         whole = chord_beside(slide, z, 0.0_dp)
         slopes = slopes + (2*slide%stress/pi)*log((tau + z%tau_leading)**2*behind*chord_beside(slide, z, z%leading) &
            & /(abs(chord(wave, outer%from_c_leading))*whole))
         slopes = slopes - (2*slide%stress/pi)*log((tau + z%tau_trailing)**2*behind*chord(wave, z%trailing) &
            & /(abs(chord(wave, outer%to_c_trailing))*whole))
      end associate
   end subroutine get_known_slopes

   !> Add what the arms bring along, by the kernel sqrt(Q(X)) weight(x)/S(X - x), with chords from the edge that is nearer to x.
   pure subroutine add_layers(slide, inner, kernel_weights, layers, outer, is_trailing, roots, slopes)
      type(adhesive_slide_t), intent(in) :: slide
      type(nodes_t), intent(in) :: inner
      real(dp), intent(in) :: kernel_weights(:), layers(:, 0:)
      type(outer_nodes_t), intent(in) :: outer
      logical, intent(in) :: is_trailing
      real(dp), intent(in) :: roots(:)
      !> In: the known slopes in column 0. Out: all; shape `(outer, 0:n_arms)`.
      real(dp), intent(inout) :: slopes(:, 0:)
      real(dp), dimension(size(roots), 2) :: sines, cosines
      real(dp) :: kernel(size(roots), block_size)
      integer :: first, last, n, half, j, column

      n = size(kernel_weights)
      half = merge((n + 1)/2, merge(n, 0, is_trailing), slide%is_wave)
      sines(:, 1) = outer%to_trailing
      sines(:, 2) = outer%from_leading
      cosines = 1
      if (slide%is_wave) then
         cosines = 2*cos(sines/2)
         sines = 2*sin(sines/2)
      end if
      slopes(:, 1:) = 0
      do first = 1, n, block_size
         last = min(first + block_size - 1, n)
         do j = first, last
            associate (d => merge(inner%left(j), inner%right(j), j <= half), side => merge(1, 2, j <= half))
               if (slide%is_wave) then
                  kernel(:, j - first + 1) = kernel_weights(j)*roots/(sines(:, side)*cos(d/2) + cosines(:, side)*sin(d/2))
               else
                  kernel(:, j - first + 1) = kernel_weights(j)*roots/(sines(:, side) + d)
               end if
            end associate
         end do
         ! what has decayed at the last position of the block is not summed up
         column = slide%solid%n_arms + 1 - count(layers(last, 1:) > 0)
         if (.not. slide%is_wave) slopes(:, 0) = slopes(:, 0) + matmul(kernel(:, :last - first + 1), layers(first:last, 0))
         if (slide%solid%n_arms == 1 .and. column == 1) then
            slopes(:, 1) = slopes(:, 1) + matmul(kernel(:, :last - first + 1), layers(first:last, 1))
         else
            slopes(:, column:) = slopes(:, column:) + matmul(kernel(:, :last - first + 1), layers(first:last, column:))
         end if
      end do
   end subroutine add_layers

   !> The far field: what must be 0, load and friction.
   pure subroutine get_far_field(slide, zones, inner, kernel_weights, layers, bounded, load, friction)
      type(adhesive_slide_t), intent(in) :: slide
      type(slide_zones_t), intent(in) :: zones
      !> See `set_layers`.
      type(nodes_t), intent(in) :: inner
      real(dp), intent(in) :: kernel_weights(:), layers(:, 0:)
      !> What must be 0, load and friction: without the amplitudes (0), and of each amplitude; shape `(0:n_arms)`.
      real(dp), intent(out) :: bounded(0:), load(0:), friction(0:)
      real(dp) :: xi(size(inner%weights))

      xi = merge(inner%left - zones%half_width, zones%half_width - inner%right, inner%left < inner%right)
      if (slide%is_wave) then
         call get_far_field_of_wave(slide, zones, xi, kernel_weights, layers, bounded, load, friction)
      else
         call get_far_field_of_cylinder(slide, zones, xi, kernel_weights, layers, bounded, load, friction)
      end if
   end subroutine get_far_field

   !> v' + 2 i p = 2 i q + 4 i p_1 e^{ix} + ... high above a wave; T = -Im p_1.
   pure subroutine get_far_field_of_wave(slide, zones, xi, kernel_weights, layers, bounded, load, friction)
      type(adhesive_slide_t), intent(in) :: slide
      type(slide_zones_t), intent(in) :: zones
      !> Positions in the contact from its middle.
      real(dp), intent(in) :: xi(:)
      real(dp), intent(in) :: kernel_weights(:), layers(:, 0:)
      real(dp), intent(out) :: bounded(0:), load(0:), friction(0:)
      complex(dp), parameter :: i = (0.0_dp, 1.0_dp)
      complex(dp) :: eta, tau, first, second, phases(size(xi)), second_phases(size(xi)), shift
      real(dp) :: storage, loss
      integer :: k

      associate (w => zones%half_width, tl => zones%tau_leading, tt => zones%tau_trailing, p0 => slide%stress)
         call slide%solid%get_complex_ratio(storage, loss)
         eta = cmplx(loss, storage, dp)*exp(i*zones%middle)
         shift = exp(-i*zones%middle)
         tau = exp(i*w/2)
         first = cmplx(real(eta)*cos(w/2)**2, aimag(eta)*sin(w/2)**2, dp) &
            & + (2*p0/pi)*(log(tau + tl) - log(tau - tl) - log(tau + tt) + log(tt - tau))
         second = shift*sin(w/2)**2*(eta - conjg(eta)*cos(w/2)**2) &
            & + (2*p0/pi)*i*shift*sin(w)*tau*(2*tt/(tau**2 - tt**2) - 2*tl/(tau**2 - tl**2))
         phases = kernel_weights*exp(-i*xi/2)
         second_phases = phases*(exp(-i*xi) - cos(w))
         do k = 0, slide%solid%n_arms
            if (k > 0) first = sum(phases*layers(:, k))
            if (k > 0) second = shift*sum(second_phases*layers(:, k))
            bounded(k) = real(first)
            load(k) = aimag(first)/2
            friction(k) = real(second)/4
         end do
      end associate
   end subroutine get_far_field_of_wave

   !> v' + 2 i p = -(2/pi) (F/x + M/x^2 + ...) far from a cylinder, and T = M.
   pure subroutine get_far_field_of_cylinder(slide, zones, xi, kernel_weights, layers, bounded, load, friction)
      type(adhesive_slide_t), intent(in) :: slide
      type(slide_zones_t), intent(in) :: zones
      !> Positions in the contact from its middle.
      real(dp), intent(in) :: xi(:)
      real(dp), intent(in) :: kernel_weights(:), layers(:, 0:)
      real(dp), intent(out) :: bounded(0:), load(0:), friction(0:)
      real(dp) :: a, b, first, second

      associate (z => zones, w => zones%half_width, tl => zones%tau_leading, tt => zones%tau_trailing, p0 => slide%stress)
         ! 1 - tau^2 at the outer ends of the zones
         a = 2*w/(2*w + z%leading)
         b = -2*w/z%trailing
         bounded(0) = -z%middle + (2*p0/pi)*(log((1 + tl)**2/a) - log((tt + 1)**2/abs(b)))
         first = (2*p0/pi)*(-w)*(-2*tl/a + 2*tt/b)
         second = (2*p0/pi)*(w**2/2)*(2*tl*(1 + tl**2)/a**2 - 2*tt*(1 + tt**2)/b**2)
         load(0) = pi*w**2/4 - (pi/2)*first
         friction(0) = z%middle*load(0) - (pi/2)*second
         if (slide%solid%n_arms == 0) return
         bounded(1:) = matmul(kernel_weights, layers(:, 1:))
         load(1:) = -(pi/2)*matmul(kernel_weights*xi, layers(:, 1:))
         friction(1:) = z%middle*load(1:) - (pi/2)*matmul(kernel_weights*(xi**2 - w**2/2), layers(:, 1:))
         first = -(pi/2)*sum(kernel_weights*xi*layers(:, 0))
         bounded(0) = bounded(0) + sum(kernel_weights*layers(:, 0))
         load(0) = load(0) + first
         friction(0) = friction(0) + z%middle*first - (pi/2)*sum(kernel_weights*(xi**2 - w**2/2)*layers(:, 0))
      end associate
   end subroutine get_far_field_of_cylinder

end module adfric_plane_adhesive_sliding_slopes
