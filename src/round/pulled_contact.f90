! SPDX-License-Identifier: GPL-3.0-or-later
!> A contact that is pulled sideways: its force T and its displacement D from rest to the onset of sliding, along a position that
!> may be anything, and what follows. T and D are taken once, as piecewise polynomials, on panels that are halved until their last
!> coefficients are round-off; all that depends on a spring is then a matter of polynomials.
module adfric_round_pulled_contact
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use adfric_base_kinds, only: dp
   use adfric_numerics_chebyshev, only: chebyshev_positions, coefficients_of, degree, slope_of, value_of
   use adfric_numerics_gauss, only: gauss_nodes, gauss_weights
   implicit none (type, external)
   private
   public :: pulled_contact_t, pulled_curve_t, force_panel_t, pulled_spot_t, take_curve
   public :: force_at, displacement_at, extension_at, work_between, first_fall, first_reach

   !> Panels of each piece to begin with; most of them; how often one is halved.
   integer, parameter :: first_panels = 4, most_panels = 200, most_halvings = 8
   !> Last coefficients of a panel that is fine enough; of one that may be, if they fall no more; and of one that is too coarse at last,
   !> relative to the largest value. Next to the end of contact a state is known to the root of round-off.
   real(dp), parameter :: fine = 1.0e-13_dp, noise = 1.0e-9_dp, coarse = 1.0e-7_dp
   !> Coefficients fall no more if the last two are more than this share of the six before.
   real(dp), parameter :: level_share = 0.1_dp
   !> A slope of this size, relative to the sum of the coefficients, is round-off.
   real(dp), parameter :: level = 1.0e-11_dp
   !> Share of a panel next to its end where a slope that is 0 there has a sign.
   real(dp), parameter :: near_end = 1.0e-5_dp
   !> Positions of a panel where signs are looked at, and halvings that leave round-off.
   integer, parameter :: n_marks = 32, most_bisections = 60

   !> A contact, as its model knows it.
   type, abstract :: pulled_contact_t
      !> Pieces of its path from rest; within each, T and D are smooth.
      integer :: n_pieces = 1
      !> Does it slide then? Otherwise contact is lost.
      logical :: slides = .true.
      !> Force of sliding; 0 where contact is lost.
      real(dp) :: force_after = 0
   contains
      procedure(get_state_i), deferred :: get_state
   end type pulled_contact_t

   abstract interface
      !> A state on the path.
      pure subroutine get_state_i(self, piece, position, displacement, force)
         import :: pulled_contact_t, dp
         implicit none (type, external)
         class(pulled_contact_t), intent(in) :: self
         !> Number of the piece.
         integer, intent(in) :: piece
         !> Position in the piece, 0 to 1.
         real(dp), intent(in) :: position
         !> Receive D and T.
         real(dp), intent(out) :: displacement, force
      end subroutine get_state_i
   end interface

   !> A panel of the path.
   type :: force_panel_t
      !> Piece, and the range of positions in it.
      integer :: piece = 1
      !> Ends of the range.
      real(dp) :: low = 0, high = 1
      !> Coefficients of D and T.
      real(dp) :: displacement(0:degree) = 0, force(0:degree) = 0
   end type force_panel_t

   !> The path of a contact.
   type :: pulled_curve_t
      !> The panels.
      type(force_panel_t), allocatable :: panels(:)
      !> See `pulled_contact_t`.
      logical :: slides = .true.
      !> Force of sliding; 0 where contact is lost.
      real(dp) :: force_after = 0
      !> D and T at the end.
      real(dp) :: last_displacement = 0, last_force = 0
      !> Are all panels good enough?
      logical :: is_converged = .true.
   end type pulled_curve_t

   !> A position of a curve: the panel, and x from -1 to 1 in it.
   type :: pulled_spot_t
      !> Number of the panel; 0: none.
      integer :: panel = 0
      !> Position in it.
      real(dp) :: x = -1
   end type pulled_spot_t

contains

   !> Take the path of a contact.
   pure subroutine take_curve(contact, curve)
      class(pulled_contact_t), intent(in) :: contact
      type(pulled_curve_t), intent(out) :: curve
      type(force_panel_t) :: panels(most_panels)
      real(dp) :: largest(2)
      integer :: n, piece, k

      n = 0
      ! a path of no length
      largest = tiny(largest)
      do piece = 1, contact%n_pieces
         do k = 0, 2*first_panels
            call widen(contact, piece, real(k, dp)/(2*first_panels), largest)
         end do
      end do
      do piece = 1, contact%n_pieces
         do k = 1, first_panels
            call add_panels(contact, piece, real(k - 1, dp)/first_panels, real(k, dp)/first_panels, largest, panels, n, &
               & curve%is_converged)
         end do
      end do
      curve%panels = panels(:n)
      curve%slides = contact%slides
      curve%force_after = contact%force_after
      call contact%get_state(contact%n_pieces, 1.0_dp, curve%last_displacement, curve%last_force)
   end subroutine take_curve

   !> Widen the largest values by those of a position.
   pure subroutine widen(contact, piece, position, largest)
      class(pulled_contact_t), intent(in) :: contact
      integer, intent(in) :: piece
      real(dp), intent(in) :: position
      !> The largest D and T.
      real(dp), intent(inout) :: largest(2)
      real(dp) :: displacement, force

      call contact%get_state(piece, position, displacement, force)
      largest = max(largest, [displacement, force])
   end subroutine widen

   !> Panels of a range: from the left, each halved until it is fine enough.
   pure subroutine add_panels(contact, piece, from, to, largest, panels, n, is_converged)
      class(pulled_contact_t), intent(in) :: contact
      integer, intent(in) :: piece
      !> Ends of the range.
      real(dp), intent(in) :: from, to
      !> The largest D and T.
      real(dp), intent(in) :: largest(2)
      !> The panels, of which `n` are there.
      type(force_panel_t), intent(inout) :: panels(most_panels)
      !> Their number, which grows.
      integer, intent(inout) :: n
      !> Becomes false where a panel stays too coarse.
      logical, intent(inout) :: is_converged
      type(force_panel_t) :: panel
      real(dp) :: low, width, tail
      integer :: halvings

      low = from
      halvings = 0
      do while (low < to .and. n < most_panels)
         width = (to - from)/2.0_dp**halvings
         call take_panel(contact, piece, low, min(low + width, to), largest, panel, tail)
         if (tail > fine .and. halvings < most_halvings .and. n + 2 < most_panels) then
            halvings = halvings + 1
            cycle
         end if
         is_converged = is_converged .and. tail < coarse
         n = n + 1
         panels(n) = panel
         low = panel%high
         ! the next one may be wider, where it then ends at a whole number of its widths
         do while (halvings > 0)
            if (modulo(nint((low - from)/(to - from)*2.0_dp**halvings), 2) == 1) exit
            halvings = halvings - 1
         end do
      end do
      is_converged = is_converged .and. .not. low < to
   end subroutine add_panels

   !> A panel, and the size of its last coefficients.
   pure subroutine take_panel(contact, piece, low, high, largest, panel, tail)
      class(pulled_contact_t), intent(in) :: contact
      integer, intent(in) :: piece
      !> Ends of the range.
      real(dp), intent(in) :: low, high
      real(dp), intent(in) :: largest(2)
      type(force_panel_t), intent(out) :: panel
      !> Receives the last two coefficients of D and T over the largest values, if they are not round-off; huge where there is no state.
      real(dp), intent(out) :: tail
      real(dp) :: x(0:degree), displacement(0:degree), force(0:degree)
      integer :: j

      x = chebyshev_positions()
      do j = 0, degree
         call contact%get_state(piece, low + (high - low)*(1 + x(j))/2, displacement(j), force(j))
      end do
      panel%piece = piece
      panel%low = low
      panel%high = high
      panel%displacement = coefficients_of(displacement)
      panel%force = coefficients_of(force)
      tail = size_of(panel, degree - 1, degree, largest)
      if (.not. ieee_is_finite(tail)) tail = huge(tail)
      if (tail < noise .and. tail > level_share*size_of(panel, degree - 7, degree - 2, largest)) tail = fine
   end subroutine take_panel

   !> The largest of some coefficients of D and T, over the largest values.
   pure real(dp) function size_of(panel, first, last, largest)
      type(force_panel_t), intent(in) :: panel
      integer, intent(in) :: first, last
      real(dp), intent(in) :: largest(2)

      size_of = max(maxval(abs(panel%displacement(first:last)))/largest(1), maxval(abs(panel%force(first:last)))/largest(2))
   end function size_of

   !> T at a position.
   pure real(dp) function force_at(curve, spot) result(force)
      type(pulled_curve_t), intent(in) :: curve
      type(pulled_spot_t), intent(in) :: spot

      force = value_of(curve%panels(spot%panel)%force, spot%x)
   end function force_at

   !> D at a position.
   pure real(dp) function displacement_at(curve, spot) result(displacement)
      type(pulled_curve_t), intent(in) :: curve
      type(pulled_spot_t), intent(in) :: spot

      displacement = value_of(curve%panels(spot%panel)%displacement, spot%x)
   end function displacement_at

   !> p D + q T at a position.
   pure real(dp) function extension_at(curve, p, q, spot) result(extension)
      type(pulled_curve_t), intent(in) :: curve
      !> Weights.
      real(dp), intent(in) :: p, q
      type(pulled_spot_t), intent(in) :: spot

      associate (panel => curve%panels(spot%panel))
         extension = value_of(p*panel%displacement + q*panel%force, spot%x)
      end associate
   end function extension_at

   !> int (prescribed - p D - q T) dD between two positions.
   pure real(dp) function work_between(curve, prescribed, p, q, from, to) result(work)
      type(pulled_curve_t), intent(in) :: curve
      !> What D and T are taken from, and their weights.
      real(dp), intent(in) :: prescribed, p, q
      type(pulled_spot_t), intent(in) :: from, to
      real(dp) :: low, high, x
      integer :: k, node

      work = 0
      do k = from%panel, to%panel
         low = -1
         high = 1
         if (k == from%panel) low = from%x
         if (k == to%panel) high = to%x
         do node = 1, size(gauss_nodes)
            x = low + (high - low)*(1 + gauss_nodes(node))/2
            work = work + gauss_weights(node)*(high - low)/2*(prescribed - extension_at(curve, p, q, pulled_spot_t(k, x))) &
               & *slope_of(curve%panels(k)%displacement, x)
         end do
      end do
   end function work_between

   !> Where p D + q T begins to fall, at or after a position; the end of the path if it never does.
   pure subroutine first_fall(curve, p, q, from, spot, falls)
      type(pulled_curve_t), intent(in) :: curve
      real(dp), intent(in) :: p, q
      type(pulled_spot_t), intent(in) :: from
      type(pulled_spot_t), intent(out) :: spot
      logical, intent(out) :: falls
      real(dp) :: c(0:degree), low, x, before
      integer :: k, mark

      falls = .true.
      do k = from%panel, size(curve%panels)
         c = p*curve%panels(k)%displacement + q*curve%panels(k)%force
         low = -1
         if (k == from%panel) low = from%x
         before = low
         do mark = 0, n_marks + 1
            x = low + (1 - low)*min(real(mark, dp)/n_marks, 1.0_dp)
            ! at the end of a path the slope may be 0
            if (mark == n_marks) x = 1 - near_end*(1 - low)
            if (slope_of(c, x) < -level*sum(abs(c))) then
               spot = pulled_spot_t(k, before)
               if (x > before) spot%x = turn_between(c, before, x)
               return
            end if
            before = x
         end do
      end do
      spot = pulled_spot_t(size(curve%panels), 1.0_dp)
      falls = .false.
   end subroutine first_fall

   !> Where a sum whose slope falls through 0 turns.
   pure real(dp) function turn_between(c, low, high) result(turn)
      !> Coefficients.
      real(dp), intent(in) :: c(0:degree)
      !> Positions where it rises and falls.
      real(dp), intent(in) :: low, high
      real(dp) :: ends(2)
      integer :: k

      ends = [low, high]
      do k = 1, most_bisections
         turn = ends(1) + (ends(2) - ends(1))/2
         ends(merge(2, 1, slope_of(c, turn) < 0)) = turn
      end do
   end function turn_between

   !> Where p D + q T reaches a value from below, after a position where it is below.
   pure subroutine first_reach(curve, p, q, value, from, spot, is_reached)
      type(pulled_curve_t), intent(in) :: curve
      !> Weights, and the value.
      real(dp), intent(in) :: p, q, value
      type(pulled_spot_t), intent(in) :: from
      type(pulled_spot_t), intent(out) :: spot
      logical, intent(out) :: is_reached
      real(dp) :: c(0:degree), low, x, ends(2)
      integer :: k, mark, j

      do k = from%panel, size(curve%panels)
         c = p*curve%panels(k)%displacement + q*curve%panels(k)%force
         low = -1
         if (k == from%panel) low = from%x
         ends(1) = low
         do mark = 1, n_marks
            x = low + (1 - low)*mark/n_marks
            ends(2) = x
            is_reached = value_of(c, x) > value*(1 + 4*epsilon(value))
            if (.not. is_reached .and. slope_of(c, ends(1)) > 0 .and. slope_of(c, x) < 0) then
               ! it may be reached at a top between two positions
               ends(2) = turn_between(c, ends(1), x)
               is_reached = value_of(c, ends(2)) > value*(1 + 4*epsilon(value))
            end if
            if (is_reached) then
               do j = 1, most_bisections
                  x = ends(1) + (ends(2) - ends(1))/2
                  ends(merge(2, 1, value_of(c, x) > value)) = x
               end do
               spot = pulled_spot_t(k, x)
               return
            end if
            ends(1) = x
         end do
      end do
      is_reached = .false.
   end subroutine first_reach

end module adfric_round_pulled_contact
