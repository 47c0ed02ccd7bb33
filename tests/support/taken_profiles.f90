! SPDX-License-Identifier: GPL-3.0-or-later
!> Takes the profiles of a block: counts them, keeps them where there is space, and stops when it is told to.
module taken_profiles
   use adfric_base_kinds, only: dp
   use adfric_describe_profile_receiver, only: profile_receiver_t
   implicit none (type, external)
   private
   public :: taken_profiles_t

   type, extends(profile_receiver_t) :: taken_profiles_t
      integer :: n_taken = 0
      !> After so many it wants no more.
      integer :: most = huge(1)
      !> Profiles by the index of their point in its block, shape `(n_last_axis, n_first_axis, n_profiles, n_points)`; none are
      !> kept where it is not allocated.
      real(dp), allocatable :: kept(:, :, :, :)
   contains
      procedure :: take
   end type taken_profiles_t

contains

   !> See `profile_receiver_t`.
   subroutine take(self, index, profiles, goes_on)
      class(taken_profiles_t), intent(inout) :: self
      integer, intent(in) :: index
      real(dp), intent(in) :: profiles(:, :, :)
      logical, intent(out) :: goes_on

      self%n_taken = self%n_taken + 1
      if (allocated(self%kept)) self%kept(:, :, :, index) = profiles
      goes_on = self%n_taken < self%most
   end subroutine take

end module taken_profiles
