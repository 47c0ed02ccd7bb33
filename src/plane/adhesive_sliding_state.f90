! SPDX-License-Identifier: GPL-3.0-or-later
!> The equations of one state of an adhesive wave or cylinder that slides steadily over a viscoelastic half-plane, for any number N
!> of relaxation times.
!>
!> v = E(s) u, s = -V d/dx, is elastic with the pressure p. In contact u' = h', so v' is what a contact without end has, and
!> sum C_i exp((x - x_l)/a_i), what the arms bring along. The Kelvin elements of the slope, y_j - b_j y_j' = v', say
!> u' = v'/Einf + sum c_j y_j. They are known in contact; beside it they are carried against the motion, from the trailing edge over
!> the gap to the leading edge,
!>
!>     y_j(x) = exp(-(X - x)/b_j) y_j(X) + (1/b_j) integral_x^X exp(-(t - x)/b_j) v'(t) dt
!>
!> where they must be those of the contact again: N linear equations for the C_i, and no exponential grows. Ahead of a cylinder they
!> come from far away. Three equations remain for the edges: the pressure is bounded at both edges of the contact, and the gap is
!> the range at the outer ends of both zones. Load, penetration and friction follow. Friction is the loss of the solid alone, since
!> integral p g' dx = 0.
module adfric_plane_adhesive_sliding_state
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_numerics_lapack, only: dgesv
   use adfric_numerics_libm, only: expm1
   use adfric_plane_adhesive_sliding_nodes, only: nodes_t
   use adfric_plane_adhesive_sliding_slopes, only: slopes_outside, get_far_field
   use adfric_plane_adhesive_sliding_zones, only: adhesive_slide_t, slide_zones_t, outer_nodes_t, set_outer_nodes, set_layers, &
      & piece_leading, piece_free, piece_trailing
   implicit none (type, external)
   private
   public :: evaluate_zones

   !> What depends linearly on the amplitudes: columns 0: endless contact and zones; i: C_i.
   type :: amplitude_columns_t
      !> Far field (`get_far_field`), mean gap and what the pieces open, shapes `(0:n_arms)` and `(0:n_arms, 3)`.
      real(dp), allocatable :: bounded(:), load(:), friction(:), mean_gap(:), opening(:, :)
      !> Kelvin elements at the left end (0) and the right ends of the pieces, in contact at the leading edge, and at the outer end
      !> of the trailing zone; shapes `(n_arms, 0:n_arms, 0:3)` and `(n_arms, 0:n_arms)`.
      real(dp), allocatable :: elements(:, :, :), contact(:, :), trailing(:, :)
   end type amplitude_columns_t

contains

   !> All equations of given edges.
   pure subroutine evaluate_zones(slide, zones, is_solved)
      type(adhesive_slide_t), intent(in) :: slide
      !> In: edges (`get_zones`). Out: with amplitudes, results and residuals.
      type(slide_zones_t), intent(inout) :: zones
      !> Are all of them numbers?
      logical, intent(out) :: is_solved
      type(nodes_t) :: inner
      type(amplitude_columns_t) :: columns
      real(dp), allocatable :: kernel_weights(:), layers(:, :)
      real(dp) :: c(0:slide%solid%n_arms)
      integer :: piece

      is_solved = zones%half_width > 0 .and. zones%leading > 0 .and. zones%trailing > 0 .and. zones%free > 0 &
         & .and. zones%tau_leading > 0 .and. zones%tau_trailing < huge(1.0_dp)
      if (.not. is_solved) return
      call set_layers(slide, zones, inner, kernel_weights, layers)
      call new_columns(slide, zones, columns)
      call get_far_field(slide, zones, inner, kernel_weights, layers, columns%bounded, columns%load, columns%friction)
      ! Kelvin elements are carried from the trailing edge back to the leading one
      do piece = piece_trailing, piece_leading, -1
         if (piece == piece_free) columns%trailing = columns%elements(:, :, 2)
         if (piece == piece_free .and. .not. slide%is_wave) then
            columns%elements(:, :, 2) = 0
            columns%elements(:, :, 1) = 0
            if (slide%solid%n_arms == 0) cycle
         end if
         call add_piece(slide, zones, inner, kernel_weights, layers, piece, columns)
      end do
      c(0) = 1
      call find_amplitudes(columns, c(1:), is_solved)
      if (.not. is_solved) return
      zones%amplitudes = c(1:)
      zones%load = dot_product(columns%load, c)
      zones%friction = dot_product(columns%friction, c)
      if (slide%is_wave) zones%penetration = 1 - dot_product(columns%mean_gap, c)
      zones%residual(1) = dot_product(columns%bounded, c)
      zones%residual(2) = dot_product(columns%opening(:, piece_leading), c)/slide%range - 1
      zones%residual(3) = -dot_product(columns%opening(:, piece_trailing), c)/slide%range - 1
      if (allocated(zones%piece_end)) deallocate (zones%piece_end)
      allocate (zones%piece_end(slide%solid%n_arms, 0:3))
      do piece = 0, 3
         zones%piece_end(:, piece) = matmul(columns%elements(:, :, piece), c)
      end do
      zones%trailing_end = matmul(columns%trailing, c)
      is_solved = all(abs(zones%residual) < huge(1.0_dp)) .and. abs(zones%load) < huge(1.0_dp) &
         & .and. abs(zones%friction) < huge(1.0_dp) .and. abs(zones%penetration) < huge(1.0_dp)
   end subroutine evaluate_zones

   !> Columns with the Kelvin elements of the contact.
   pure subroutine new_columns(slide, zones, columns)
      type(adhesive_slide_t), intent(in) :: slide
      type(slide_zones_t), intent(in) :: zones
      type(amplitude_columns_t), intent(out) :: columns
      integer :: i, n

      n = slide%solid%n_arms
      allocate (columns%bounded(0:n), columns%load(0:n), columns%friction(0:n), columns%mean_gap(0:n), columns%opening(0:n, 3), &
         & columns%elements(n, 0:n, 0:3), columns%contact(n, 0:n))
      columns%mean_gap = 0
      columns%opening = 0
      columns%elements = 0
      columns%contact(:, 0) = elements_of_contact(slide, zones%middle + zones%half_width, 0.0_dp)
      columns%elements(:, 0, 3) = elements_of_contact(slide, zones%middle - zones%half_width, &
         & 2*zones%half_width)
      do i = 1, n
         columns%contact(:, i) = -slide%solid%relaxation(i)/slide%solid%distances(i, :)
         columns%elements(:, i, 3) = columns%contact(:, i)*exp(-2*zones%half_width/slide%solid%relaxation(i))
      end do
   end subroutine new_columns

   !> The amplitudes that make the Kelvin elements of the gap those of the contact at the leading edge.
   pure subroutine find_amplitudes(columns, amplitudes, is_solved)
      type(amplitude_columns_t), intent(in) :: columns
      real(dp), intent(out) :: amplitudes(:)
      logical, intent(out) :: is_solved
      real(dp) :: matrix(size(amplitudes), size(amplitudes)), right(size(amplitudes), 1), scales(size(amplitudes))
      integer :: pivots(size(amplitudes)), info, n, j

      n = size(amplitudes)
      is_solved = n == 0
      if (is_solved) return
      matrix = columns%contact(:, 1:) - columns%elements(:, 1:, 0)
      right(:, 1) = columns%elements(:, 0, 0) - columns%contact(:, 0)
      do j = 1, n
         scales(j) = maxval(abs(matrix(j, :)))
         matrix(j, :) = matrix(j, :)/scales(j)
         right(j, 1) = right(j, 1)/scales(j)
      end do
      call dgesv(n, 1, matrix, n, pivots, right, n, info)
      amplitudes = right(:, 1)
      is_solved = info == 0
   end subroutine find_amplitudes

   !> Kelvin elements in the contact for amplitudes of 0.
   pure function elements_of_contact(slide, x, right) result(y)
      type(adhesive_slide_t), intent(in) :: slide
      !> Position and its distance from the leading edge.
      real(dp), intent(in) :: x, right
      real(dp) :: y(slide%solid%n_arms)
      real(dp) :: storage, loss
      integer :: j

      associate (s => slide%solid)
         if (slide%is_wave) then
            call s%get_complex_ratio(storage, loss)
            ! Re[(loss + i storage) e^{ix} (1 + i b)/(1 + b^2)]
            y = ((loss*cos(x) - storage*sin(x)) - s%retardation*(storage*cos(x) + loss*sin(x)))/(1 + s%retardation**2)
         else
            do j = 1, s%n_arms
               y(j) = -x + sum(s%ratios*s%relaxation**2/s%distances(:, j)*growth(-right/s%relaxation))
            end do
         end if
      end associate
   end function elements_of_contact

   !> exp(x) - 1.
   elemental real(dp) function growth(x)
      real(dp), intent(in) :: x

      growth = expm1(x)
   end function growth

   !> Carry the Kelvin elements over a piece of the gap, from its right end to the left one, and add what it opens.
   pure subroutine add_piece(slide, zones, inner, kernel_weights, layers, piece, columns)
      type(adhesive_slide_t), intent(in) :: slide
      type(slide_zones_t), intent(in) :: zones
      type(nodes_t), intent(in) :: inner
      real(dp), intent(in) :: kernel_weights(:), layers(:, 0:)
      integer, intent(in) :: piece
      type(amplitude_columns_t), intent(inout) :: columns
      type(outer_nodes_t) :: outer
      real(dp), allocatable :: slopes(:, :), left(:)
      real(dp), dimension(0:slide%solid%n_arms) :: integrals, moments
      real(dp), dimension(slide%solid%n_arms, 0:slide%solid%n_arms) :: weighted, grown
      real(dp), allocatable :: decays(:, :)
      real(dp) :: length, offset, x, decay
      integer :: j, k

      call set_outer_nodes(slide, zones, piece, outer)
      allocate (slopes(size(outer%weights), 0:slide%solid%n_arms))
      call slopes_outside(slide, zones, inner, kernel_weights, layers, outer, piece == piece_trailing, slopes)
      call locate_piece(zones, piece, outer, left, length, offset, x)
      integrals = matmul(outer%weights, slopes)
      moments = matmul(outer%weights*left, slopes)
      associate (opening => columns%opening(:, piece), b => slide%solid%retardation, cs => slide%compliances)
         opening = integrals
         columns%opening(0, piece) = columns%opening(0, piece) - rise_of_height(slide, x, length)
         if (slide%is_wave) columns%mean_gap(0) = columns%mean_gap(0) + moment_of_height(x, length)/two_pi
         if (slide%is_wave) columns%mean_gap = columns%mean_gap - moments/two_pi
         allocate (decays(slide%solid%n_arms, size(left)))
         do k = 1, size(left)
            decays(:, k) = outer%weights(k)*exp(-left(k)/b)
         end do
         weighted = matmul(decays, slopes)
         grown = 0
         if (slide%is_wave) then
            do k = 1, size(left)
               decays(:, k) = outer%weights(k)*growth(-left(k)/b)
            end do
            grown = matmul(decays, slopes)
         end if
         do j = 1, slide%solid%n_arms
            decay = 0
            if (length < huge(1.0_dp)) decay = exp(-length/b(j))
            columns%elements(j, :, piece - 1) = decay*columns%elements(j, :, piece) + weighted(j, :)/b(j)
            if (.not. length < huge(1.0_dp)) cycle
            ! b times the change of an element, of which a long retardation length leaves no difference of digits
            opening = opening - cs(j)*(b(j)*expm1(-length/b(j))*columns%elements(j, :, piece) + weighted(j, :))
            if (slide%is_wave) columns%mean_gap = columns%mean_gap - cs(j)*b(j)*(b(j)*second_growth(length/b(j)) &
               & *columns%elements(j, :, piece) + grown(j, :))/two_pi
         end do
         if (slide%is_wave) columns%mean_gap = columns%mean_gap - offset*opening/two_pi
      end associate
   end subroutine add_piece

   !> exp(-x) - 1 + x for x >= 0.
   pure real(dp) function second_growth(x)
      real(dp), intent(in) :: x
      real(dp) :: term
      integer :: k

      second_growth = expm1(-x) + x
      if (x > 0.5_dp) return
      second_growth = 0
      term = -x
      do k = 2, 20
         term = -term*x/k
         second_growth = second_growth + term
      end do
   end function second_growth

   !> Where a piece of the gap is.
   pure subroutine locate_piece(zones, piece, outer, left, length, offset, x)
      type(slide_zones_t), intent(in) :: zones
      integer, intent(in) :: piece
      type(outer_nodes_t), intent(in) :: outer
      !> Distances of the positions from its left end, its length, where it begins, from the leading edge and in x.
      real(dp), allocatable, intent(out) :: left(:)
      real(dp), intent(out) :: length, offset, x

      select case (piece)
      case (piece_leading)
         left = outer%from_leading
         offset = 0
         length = zones%leading
         x = zones%middle + zones%half_width
      case (piece_free)
         left = outer%from_c_leading
         offset = zones%leading
         length = zones%free
         x = zones%middle + zones%half_width + zones%leading
      case default
         left = -outer%to_c_trailing
         offset = zones%leading + zones%free
         length = zones%trailing
         x = zones%middle - zones%half_width - zones%trailing
      end select
   end subroutine locate_piece

   !> h(x + d) - h(x); nothing over an endless piece.
   pure real(dp) function rise_of_height(slide, x, d)
      type(adhesive_slide_t), intent(in) :: slide
      real(dp), intent(in) :: x, d

      rise_of_height = 0
      if (slide%is_wave) then
         rise_of_height = -2*sin(x + d/2)*sin(d/2)
      else if (d < huge(1.0_dp)) then
         rise_of_height = -(x + d/2)*d
      end if
   end function rise_of_height

   !> The integral of s h'(x + s) from 0 to d for the wave.
   pure real(dp) function moment_of_height(x, d)
      real(dp), intent(in) :: x, d

      moment_of_height = d*cos(x + d) - 2*cos(x + d/2)*sin(d/2)
   end function moment_of_height

end module adfric_plane_adhesive_sliding_state
