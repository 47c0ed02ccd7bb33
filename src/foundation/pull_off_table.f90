! SPDX-License-Identifier: GPL-3.0-or-later
!> The pull-off loads of all surfaces of a run: the first point of a surface has its pull-off load found, all others look it up.
!>
!> All threads use one table. What stands in it depends on the surface alone, so it does not matter who found it.
module adfric_foundation_pull_off_table
   use adfric_base_kinds, only: dp
   use adfric_numerics_found_once, only: found_once_t, search_t
   use adfric_foundation_pull_off, only: pull_off_t, find_pull_off
   use adfric_foundation_steady_state, only: branch_adhered
   use adfric_foundation_surface, only: surface_t, is_identical_surface
   implicit none (type, external)
   private
   public :: get_pull_off

contains

   !> The pull-off load of a surface, from the table if it stands there.
   subroutine get_pull_off(table, surface, pull_off)
      type(found_once_t), intent(inout) :: table
      !> The surface in reduced units; its branch does not matter.
      type(surface_t), intent(in) :: surface
      !> In: the pull-off load of a surface, or of none. Out: that of this surface.
      type(pull_off_t), intent(inout) :: pull_off
      type(surface_t) :: adhered
      type(search_t) :: search
      real(dp) :: found(3)

      if (pull_off%is_known) then
         if (is_identical_surface(surface, pull_off%surface)) return
      end if
      call table%look_up(key_of(surface), found, pull_off%is_known, search)
      if (pull_off%is_known) then
         pull_off%is_converged = found(1) > 0
         pull_off%load = found(2)
         pull_off%penetration = found(3)
      else
         adhered = surface
         adhered%branch = branch_adhered
         call find_pull_off(adhered, pull_off)
         call table%keep(search, [merge(1.0_dp, 0.0_dp, pull_off%is_converged), pull_off%load, pull_off%penetration])
      end if
      pull_off%surface = surface
   end subroutine get_pull_off

   !> Numbers of a surface that its pull-off load depends on: all but the branch.
   pure function key_of(surface) result(key)
      type(surface_t), intent(in) :: surface
      real(dp) :: key(9)

      key = [merge(1.0_dp, 0.0_dp, surface%shape%is_3d), real(surface%adhesion%edge, dp), real(surface%n_strips, dp), &
         & surface%foundation%u, surface%foundation%beta, surface%adhesion%stress, surface%adhesion%range, &
         & surface%shape%steepness, surface%tolerance]
   end function key_of

end module adfric_foundation_pull_off_table
