! SPDX-License-Identifier: GPL-3.0-or-later
!> A contact whose load is as good as 0 is lost, or made, at once.
!>
!> Where a load falls to 0 or rises from 0 the edge goes as a power of time, and the forces of springs are differences without digits.
!> Loads in order have approaches in order (`docs/theory/round_time.md`). So a load that is 0 for as long as less than a part of the
!> tolerance is prescribed bounds the approach from below. Both changes take no time: all arms answer together, with the
!> instantaneous modulus.
!>
!> A spring of force y is let go where the approach has fallen by y/E_glassy. A free spring of depth G and stretch theta is met
!> where the approach is G + theta, which rises with G. So a contact with an edge at G has that approach, and the load
!>
!>     P = 2 E_glassy int x d(G + theta)
!>
!> from the axis to the edge: no equation has to be solved but that of the edge itself, which is bracketed.
module adfric_round_timed_sudden
   use adfric_base_kinds, only: dp
   use adfric_numerics_time_panels, only: n_nodes, panel_nodes, panel_slopes, panel_sums
   use adfric_round_timed_path, only: mark_t, time_between
   use adfric_round_timed_springs, only: free_memory, get_spot, mark_of, timed_springs_t
   implicit none (type, external)
   private
   public :: let_go, force_at_axis, find_touch, touch_t, touch_at_once

   !> A contact that is made at once.
   type :: touch_t
      !> How far the approach is above that where the axis is met, and the load.
      real(dp) :: rise = 0, load = 0
      !> Depth of the edge, and its radius.
      real(dp) :: depth = 0, radius = 0
      !> The piece of free springs that it ends in, 0 beyond all, and the position in it.
      integer :: piece = 0
      !> See `piece`.
      real(dp) :: position = 0
   end type touch_t

   !> Free springs of a part of a piece, from the axis outwards.
   type :: free_part_t
      !> G, G + theta, and a; shape `(n_nodes)`.
      real(dp), dimension(n_nodes) :: depth = 0, meets = 0, radius = 0
      !> What the part adds to the load of a contact.
      real(dp) :: load = 0
      !> c_k by now; shape `(n_nodes, n_arms)`.
      real(dp), allocatable :: memory(:, :)
   end type free_part_t

contains

   !> Force of the spring on the axis, in contact, over the instantaneous modulus: what the approach falls by when all springs are let
   !> go.
   pure real(dp) function force_at_axis(self) result(fall)
      !> The springs in contact.
      type(timed_springs_t), intent(in) :: self
      real(dp) :: depth, memory(size(self%times)), arms(size(self%times))

      fall = 0
      if (self%touched%count == 0) return
      call self%touched%read_at(1, self%touched%ends(1, 1), depth, memory)
      arms = arms_in_contact(self, 1, self%touched%ends(1, 1), memory)
      fall = (self%relaxed*(self%approach - depth) + sum(self%moduli*arms))/self%glassy
   end function force_at_axis

   !> q_i of a spring in contact.
   pure function arms_in_contact(self, piece, position, memory) result(arms)
      type(timed_springs_t), intent(in) :: self
      !> Its piece, and the position there.
      integer, intent(in) :: piece
      real(dp), intent(in) :: position
      !> c_i where it passed the edge; shape `(n_arms)`.
      real(dp), intent(in) :: memory(:)
      real(dp) :: arms(size(memory))

      arms = self%drive + memory*exp(-self%touched%lag_of(piece, position, time_between(self%legs, self%touched%marks(piece), &
         & mark_of(self)))*self%touched%rates)
   end function arms_in_contact

   !> Let all springs go. The state of what has contact no more is left to the caller.
   pure subroutine let_go(self, carried)
      !> In: the springs in contact. Out: the same free, and the approach that has fallen.
      type(timed_springs_t), intent(inout) :: self
      !> Receives the energy that the springs take along, but for those of a face.
      real(dp), intent(out) :: carried
      real(dp), dimension(n_nodes) :: depth, stretch, radius, moment, energy
      real(dp) :: arms(n_nodes, size(self%times)), memory(size(self%times)), fall, axis
      integer :: piece, j

      carried = 0
      if (self%touched%count == 0) return
      fall = force_at_axis(self)
      call self%touched%read_at(1, self%touched%ends(1, 1), axis, memory)
      do piece = self%touched%count, 1, -1
         associate (ends => self%touched%ends(:, piece))
            do j = 1, n_nodes
               ! from the edge to the axis
               associate (position => ends(2) - (ends(2) - ends(1))*(panel_nodes(j) + 1)/2)
                  call self%touched%read_at(piece, position, depth(j), memory)
                  arms(j, :) = arms_in_contact(self, piece, position, memory)
               end associate
               associate (force => (self%relaxed*(self%approach - depth(j)) + sum(self%moduli*arms(j, :)))/self%glassy)
                  stretch(j) = self%approach - depth(j) - force
                  arms(j, :) = arms(j, :) - force
               end associate
               energy(j) = self%relaxed*stretch(j)**2 + sum(self%moduli*arms(j, :)**2)
            end do
         end associate
         call get_spot(self%contacts, depth, radius, moment)
         carried = carried - dot_product(panel_sums, energy*matmul(panel_slopes, radius))
         call self%free%push(mark_of(self), 0.0_dp, depth, free_memory(self, stretch, arms))
      end do
      self%at_edge = arms(n_nodes, :)
      self%approach = self%approach - fall
      self%drive = self%drive - fall
      self%depth = axis
      self%radius = radius(n_nodes)
   end subroutine let_go

   !> Free springs of a piece from its end, or those that were never touched.
   pure subroutine get_part(self, piece, position, depth, part)
      type(timed_springs_t), intent(in) :: self
      !> Index of the piece; 0 for what was never touched.
      integer, intent(in) :: piece
      !> Where the part ends, outwards: position in a piece, or the depth of a spring that was never touched.
      real(dp), intent(in) :: position
      !> Where what was never touched begins.
      real(dp), intent(in) :: depth
      !> Receives the part.
      type(free_part_t), intent(inout) :: part
      real(dp) :: moment(n_nodes), memory(size(self%times)), since
      integer :: j

      if (.not. allocated(part%memory)) allocate (part%memory(n_nodes, size(self%times)))
      if (piece == 0) then
         part%depth = depth + (position - depth)*(panel_nodes + 1)/2
         part%meets = part%depth
         part%memory = 0
      else
         associate (free => self%free)
            since = time_between(self%legs, free%marks(piece), mark_of(self))
            do j = 1, n_nodes
               associate (at => free%ends(2, piece) - (free%ends(2, piece) - position)*(panel_nodes(j) + 1)/2)
                  call free%read_at(piece, at, part%depth(j), memory)
                  part%memory(j, :) = memory*exp(-free%lag_of(piece, at, since)*free%rates)
               end associate
               part%meets(j) = part%depth(j) + sum(part%memory(j, :))
            end do
         end associate
      end if
      call get_spot(self%contacts, part%depth, part%radius, moment)
      ! a face has all digits so
      part%load = 2*self%glassy*(part%radius(1)*(part%meets(n_nodes) - part%meets(1)) &
         & + dot_product(panel_sums, (part%radius - part%radius(1))*matmul(panel_slopes, part%meets)))
   end subroutine get_part

   !> The contact that is made where the larger one of two sums of rise and load is 1. Both rise with the edge.
   pure subroutine find_touch(self, by_rise, by_load, touch)
      !> The springs without contact; some were touched before.
      type(timed_springs_t), intent(in) :: self
      !> Factors of rise and load in the two sums.
      real(dp), intent(in) :: by_rise(2), by_load(2)
      !> Receives the contact.
      type(touch_t), intent(out) :: touch
      integer, parameter :: most_halvings = 60, most_doublings = 300
      type(free_part_t) :: part
      real(dp) :: meets_axis, load, low, high, begin
      integer :: piece, k

      load = 0
      meets_axis = 0
      begin = 0
      do piece = self%free%count, 1, -1
         call get_part(self, piece, self%free%ends(1, piece), 0.0_dp, part)
         if (piece == self%free%count) meets_axis = part%meets(1)
         if (reached_by(part) >= 1) exit
         begin = part%depth(n_nodes)
         load = load + part%load
      end do
      piece = max(piece, 0)
      if (piece > 0) then
         low = self%free%ends(2, piece)
         high = self%free%ends(1, piece)
      else
         low = begin
         high = max(2*begin, self%depth_size*epsilon(1.0_dp))
         do k = 1, most_doublings
            call get_part(self, piece, high, begin, part)
            if (reached_by(part) >= 1) exit
            high = 2*high
         end do
      end if
      do k = 1, most_halvings
         touch%position = (low + high)/2
         call get_part(self, piece, touch%position, begin, part)
         if (reached_by(part) >= 1) then
            high = touch%position
         else
            low = touch%position
         end if
         if (abs(high - low) <= 4*epsilon(1.0_dp)*abs(high)) exit
      end do
      ! a load without digits goes in steps, and the one below what is asked for may be none at all
      if (reached_by(part) < 0.5_dp) then
         touch%position = high
         call get_part(self, piece, high, begin, part)
      end if
      touch%piece = piece
      touch%depth = part%depth(n_nodes)
      touch%radius = part%radius(n_nodes)
      touch%rise = part%meets(n_nodes) - meets_axis
      touch%load = load + part%load

   contains

      !> The larger sum of a contact that ends where a part does; 1 is asked for.
      pure real(dp) function reached_by(of) result(reached)
         type(free_part_t), intent(in) :: of

         reached = maxval(by_rise*(of%meets(n_nodes) - meets_axis) + by_load*(load + of%load))
      end function reached_by

   end subroutine find_touch

   !> Make a contact at once.
   pure subroutine touch_at_once(self, touch, squares, carried)
      !> In: the springs without contact. Out: in contact up to the edge; which mode they are in is left to the caller.
      type(timed_springs_t), intent(inout) :: self
      !> What was found of the same springs.
      type(touch_t), intent(in) :: touch
      !> Receives int q_i^2 dx over the contact; shape `(n_arms)`.
      real(dp), intent(out) :: squares(:)
      !> Receives the energy that the springs had.
      real(dp), intent(out) :: carried
      type(free_part_t) :: part
      type(mark_t) :: mark
      real(dp), dimension(n_nodes) :: radius_rate, energy
      real(dp) :: arms(n_nodes, size(self%times)), free(n_nodes, size(self%times)), meets, fall, moment, missing, begin
      integer :: piece, j

      mark = mark_of(self)
      call get_part(self, self%free%count, self%free%ends(2, self%free%count), 0.0_dp, part)
      meets = part%meets(1) + touch%rise
      fall = self%approach - meets
      ! of a load the approach was that of the axis
      if (.not. self%control%by_approach > 0) fall = -touch%rise
      self%drive = self%drive - fall
      self%approach = self%approach - fall
      squares = 0
      carried = 0
      self%sums = 0
      begin = 0
      do piece = self%free%count, touch%piece, -1
         if (piece == touch%piece) then
            call get_part(self, piece, touch%position, begin, part)
         else
            call get_part(self, piece, self%free%ends(1, piece), begin, part)
         end if
         begin = part%depth(n_nodes)
         radius_rate = matmul(panel_slopes, part%radius)
         do j = 1, n_nodes
            free(j, :) = matmul(self%states, part%memory(j, :))
            arms(j, :) = free(j, :) + (meets - part%meets(j))
            energy(j) = self%relaxed*sum(part%memory(j, :))**2 + sum(self%moduli*free(j, :)**2)
         end do
         if (piece == self%free%count) then
            ! the springs of a face
            self%sums = part%radius(1)*arms(1, :)
            squares = part%radius(1)*arms(1, :)**2
            carried = part%radius(1)*energy(1)
         end if
         do j = 1, size(self%times)
            self%sums(j) = self%sums(j) + dot_product(panel_sums, arms(:, j)*radius_rate)
            squares(j) = squares(j) + dot_product(panel_sums, arms(:, j)**2*radius_rate)
         end do
         carried = carried + dot_product(panel_sums, energy*radius_rate)
         do j = 1, size(self%times)
            arms(:, j) = arms(:, j) - self%drive(j)
         end do
         call self%touched%push(mark, 0.0_dp, part%depth, arms)
      end do
      self%at_edge = free(n_nodes, :)
      self%free%count = touch%piece
      if (touch%piece > 0) self%free%ends(2, touch%piece) = touch%position
      self%depth = touch%depth
      self%load = touch%load
      call get_spot(self%contacts, self%depth, self%radius, moment)
      ! the sums as the load has them
      missing = touch%load/2 - self%relaxed*(self%approach*self%radius - moment) - sum(self%moduli*self%sums)
      if (size(self%times) > 0) self%sums = self%sums + missing/sum(self%moduli)
   end subroutine touch_at_once

end module adfric_round_timed_sudden
