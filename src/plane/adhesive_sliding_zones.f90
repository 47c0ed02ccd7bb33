! SPDX-License-Identifier: GPL-3.0-or-later
!> Edges of the contact and of the two adhesion zones of a wave or a cylinder that slides steadily over a viscoelastic half-plane
!> and adheres to it (Dugdale), and the positions at which its equations are summed up.
!>
!> Reduced: relaxed modulus E0 = 1. A wave h = cos x has lengths in 1/k, heights and gaps in D, pressures in E0 k D. A cylinder h =
!> -x^2/2 has lengths in any unit l, heights in l^2/R, pressures in E0 l/R, forces in E0 l^2/R. The body moves to +x. Contact holds
!> at x_t < x < x_l with x_t, x_l = m -+ w, adhesion pulls by p0 in the zones c_t < x < x_t and x_l < x < c_l, where the gap is at
!> most d0, and the rest is free.
module adfric_plane_adhesive_sliding_zones
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_numerics_libm, only: expm1
   use adfric_plane_adhesive_sliding_nodes, only: nodes_t, get_nodes
   use adfric_plane_sliding_solid, only: sliding_solid_t
   implicit none (type, external)
   private
   public :: adhesive_slide_t, slide_zones_t, outer_nodes_t, set_compliances, chord, chord_beside, get_zones, set_outer_nodes, &
      & set_layers, piece_leading, piece_free, piece_trailing

   !> The parts of the gap: leading zone, free gap, trailing zone.
   integer, parameter :: piece_leading = 1, piece_free = 2, piece_trailing = 3
   !> How near positions come to the ends of a range; the inner ones have weights with an inverse root.
   real(dp), parameter :: inner_depth = 70, outer_depth = 38
   !> Range of the memory ahead of a cylinder, in the longest retardation length.
   real(dp), parameter :: memory_range = 45
   !> Where a layer counts as decayed, in its relaxation length.
   real(dp), parameter :: decayed = 45

   !> What slides on what.
   type :: adhesive_slide_t
      !> Is it a wave, or a cylinder?
      logical :: is_wave = .true.
      !> Stress p0 and range d0 of adhesion, > 0.
      real(dp) :: stress = 1, range = 1
      !> The solid.
      type(sliding_solid_t) :: solid
      !> Compliances c_j of its Kelvin elements [1/E0], > 0; shape `(n_arms)`.
      real(dp), allocatable :: compliances(:)
      !> 1, or more for finer sums.
      real(dp) :: refinement = 1
   end type adhesive_slide_t

   !> Edges, and what follows from them.
   type :: slide_zones_t
      !> Middle m and half-width w of the contact, lengths of both zones, and of the free gap between them.
      real(dp) :: middle = 0, half_width = 1, leading = 1, trailing = 1, free = 1
      !> tau = sqrt(S(x - x_l)/S(x - x_t)) at the outer ends of the zones, with the chord S.
      real(dp) :: tau_leading = 0, tau_trailing = 0
      !> Amplitudes C_i of what the arms bring along, in contact and beyond; shape `(n_arms)`.
      real(dp), allocatable :: amplitudes(:)
      !> Kelvin elements of the slope at the leading edge (0), at the right ends of leading zone, free gap and trailing zone (1 to
      !> 3), and at the outer end of the trailing zone; shapes `(n_arms, 0:3)` and `(n_arms)`.
      real(dp), allocatable :: piece_end(:, :), trailing_end(:)
      !> Mean pressure q, penetration since first touch and tangential stress T of a wave; load and force of a cylinder.
      real(dp) :: load = 0, penetration = 0, friction = 0
      !> Residuals: pressure bounded at both edges; gap at the outer ends of the leading and of the trailing zone over the range,
      !> less 1.
      real(dp) :: residual(3) = 0
   end type slide_zones_t

   !> Positions beside the contact.
   type :: outer_nodes_t
      !> Distances from the leading edge ahead, and from the trailing edge (of the next contact) behind; weights; shape `(n)`.
      real(dp), allocatable :: from_leading(:), to_trailing(:), weights(:)
      !> Distances from the outer ends of the zones, < 0 within the zone; shape `(n)`.
      real(dp), allocatable :: from_c_leading(:), to_c_trailing(:)
   end type outer_nodes_t

contains

   !> Compliances of the Kelvin elements of the solid.
   pure subroutine set_compliances(slide)
      !> In: with its solid. Out: with the compliances.
      type(adhesive_slide_t), intent(inout) :: slide
      integer :: j

      associate (s => slide%solid)
         if (allocated(slide%compliances)) deallocate (slide%compliances)
         allocate (slide%compliances(s%n_arms))
         do j = 1, s%n_arms
            slide%compliances(j) = 1/(s%retardation(j)*sum(s%ratios*s%relaxation/s%distances(:, j)**2))
         end do
      end associate
   end subroutine set_compliances

   !> The chord S of a distance: 2 sin(d/2) for a wave, d for a cylinder.
   elemental real(dp) function chord(is_wave, d)
      logical, intent(in) :: is_wave
      real(dp), intent(in) :: d

      chord = d
      if (is_wave) chord = 2*sin(d/2)
   end function chord

   !> Chord of the contact with a part of the gap beside it, from what is left of the period.
   pure real(dp) function chord_beside(slide, zones, part)
      type(adhesive_slide_t), intent(in) :: slide
      type(slide_zones_t), intent(in) :: zones
      real(dp), intent(in) :: part

      chord_beside = 2*zones%half_width + part
      if (slide%is_wave) chord_beside = 2*sin(((zones%leading - part) + zones%free + zones%trailing)/2)
   end function chord_beside

   !> Edges of four coordinates: m, ln tan(w/2), ln(leading/free), ln(trailing/free) of a wave; m, ln w, ln leading, ln trailing of
   !> a cylinder. Each state has four finite ones.
   pure subroutine get_zones(slide, z, zones)
      type(adhesive_slide_t), intent(in) :: slide
      !> The coordinates.
      real(dp), intent(in) :: z(4)
      type(slide_zones_t), intent(out) :: zones
      real(dp) :: gap, shares(2), rest, top

      zones%middle = z(1)
      if (slide%is_wave) then
         zones%half_width = 2*atan(exp(z(2)))
         gap = 4*atan(exp(-z(2)))
         top = max(0.0_dp, z(3), z(4))
         shares = exp(z(3:4) - top)
         rest = exp(-top)
         zones%leading = gap*shares(1)/(sum(shares) + rest)
         zones%trailing = gap*shares(2)/(sum(shares) + rest)
         zones%free = gap*rest/(sum(shares) + rest)
      else
         zones%half_width = exp(z(2))
         zones%leading = exp(z(3))
         zones%trailing = exp(z(4))
         zones%free = huge(1.0_dp)
      end if
      zones%tau_leading = sqrt(chord(slide%is_wave, zones%leading)/chord_beside(slide, zones, zones%leading))
      zones%tau_trailing = sqrt(chord_beside(slide, zones, zones%trailing)/chord(slide%is_wave, zones%trailing))
   end subroutine get_zones

   !> Positions of a piece of the gap; ahead of a cylinder they end where its memory does.
   pure subroutine set_outer_nodes(slide, zones, piece, outer)
      type(adhesive_slide_t), intent(in) :: slide
      type(slide_zones_t), intent(in) :: zones
      !> One of `piece_...`.
      integer, intent(in) :: piece
      type(outer_nodes_t), intent(out) :: outer
      type(nodes_t) :: nodes
      real(dp) :: shortest, far

      associate (z => zones, s => slide%solid)
         shortest = z%half_width
         if (s%n_arms > 0) shortest = min(shortest, s%relaxation(1))
         select case (piece)
         case (piece_leading)
            call get_nodes(z%leading, [shortest, min(z%half_width, z%free)], outer_depth, slide%refinement, nodes)
            outer%from_leading = nodes%left
            outer%from_c_leading = -nodes%right
            if (slide%is_wave) outer%to_trailing = nodes%right + (z%free + z%trailing)
            if (slide%is_wave) outer%to_c_trailing = nodes%right + z%free
         case (piece_free)
            if (slide%is_wave) then
               call get_nodes(z%free, [min(shortest, z%leading), min(z%half_width, z%trailing)], outer_depth, slide%refinement, &
                  & nodes)
               outer%to_trailing = z%trailing + nodes%right
               outer%to_c_trailing = nodes%right
            else
               far = memory_range*s%retardation(s%n_arms)
               call get_nodes(far, [min(shortest, z%leading), far], outer_depth, slide%refinement, nodes)
            end if
            outer%from_leading = z%leading + nodes%left
            outer%from_c_leading = nodes%left
         case default
            call get_nodes(z%trailing, [min(shortest, z%free), z%half_width], outer_depth, slide%refinement, nodes)
            outer%to_trailing = nodes%right
            outer%to_c_trailing = -nodes%left
            if (slide%is_wave) outer%from_leading = nodes%left + (z%free + z%leading)
            if (slide%is_wave) outer%from_c_leading = nodes%left + z%free
         end select
         outer%weights = nodes%weights
         if (slide%is_wave) return
         ! a cylinder has no next contact
         if (piece == piece_trailing) then
            outer%from_leading = outer%to_trailing + 2*z%half_width
            outer%from_c_leading = outer%from_leading + z%leading
         else
            outer%to_trailing = outer%from_leading + 2*z%half_width
            outer%to_c_trailing = outer%to_trailing + z%trailing
         end if
      end associate
   end subroutine set_outer_nodes

   !> Positions in the contact with the weights of the kernel, and there what the arms bring along, e_i = exp((x - x_l)/a_i). Column
   !> 0 is what is known of a cylinder, sum of E_i a_i (1 - e_i): with it the amplitudes of long relaxation lengths are small.
   pure subroutine set_layers(slide, zones, inner, kernel_weights, layers)
      type(adhesive_slide_t), intent(in) :: slide
      type(slide_zones_t), intent(in) :: zones
      !> The positions; weights 1/(pi sqrt Q), shape `(n)`; layers, shape `(n, 0:n_arms)`.
      type(nodes_t), intent(out) :: inner
      real(dp), allocatable, intent(out) :: kernel_weights(:), layers(:, :)
      integer :: i, n

      n = slide%solid%n_arms
      if (n == 0) then
         allocate (kernel_weights(0), layers(0, 0:0), inner%left(0), inner%right(0), inner%weights(0))
         return
      end if
      call get_nodes(2*zones%half_width, [zones%trailing, min(slide%solid%relaxation(1), zones%leading)], inner_depth, &
         & slide%refinement, inner)
      kernel_weights = inner%weights/(pi*sqrt(chord(slide%is_wave, inner%left)*chord(slide%is_wave, inner%right)))
      allocate (layers(size(inner%weights), 0:n))
      layers(:, 0) = 0
      do i = 1, n
         layers(:, i) = 0
         where (inner%right < decayed*slide%solid%relaxation(i)) layers(:, i) = exp(-inner%right/slide%solid%relaxation(i))
         if (.not. slide%is_wave) layers(:, 0) = layers(:, 0) &
            & - slide%solid%ratios(i)*slide%solid%relaxation(i)*growth(-inner%right/slide%solid%relaxation(i))
      end do
   end subroutine set_layers

   !> exp(x) - 1.
   elemental real(dp) function growth(x)
      real(dp), intent(in) :: x

      growth = expm1(x)
   end function growth

end module adfric_plane_adhesive_sliding_zones
