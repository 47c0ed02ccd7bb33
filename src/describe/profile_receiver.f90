! SPDX-License-Identifier: GPL-3.0-or-later
!> Where a model hands over the profiles of a block, one point after the other, so that no more than those of one are kept.
module adfric_describe_profile_receiver
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: profile_receiver_t

   !> Something that takes profiles.
   type, abstract :: profile_receiver_t
   contains
      procedure(take_i), deferred :: take
   end type profile_receiver_t

   abstract interface

      !> Take the profiles of a solved point.
      subroutine take_i(self, index, profiles, goes_on)
         import :: profile_receiver_t, dp
         implicit none (type, external)
         !> The receiver, which may keep or write what it takes.
         class(profile_receiver_t), intent(inout) :: self
         !> Index of the point in its block, from 1.
         integer, intent(in) :: index
         !> Profiles of the point; shape `(n_last_axis, n_first_axis, n_profiles)`.
         real(dp), intent(in) :: profiles(:, :, :)
         !> False if nothing more of this block is wanted, not even its results.
         logical, intent(out) :: goes_on
      end subroutine take_i

   end interface

end module adfric_describe_profile_receiver
