! SPDX-License-Identifier: GPL-3.0-or-later
!> A checksum of what stands in a results file for each block of points: results, states, counts and profiles. A block
!> whose checksum is another one is damaged.
module adfric_output_block_sums
   use adfric_base_kinds, only: dp, i8
   use adfric_hdf5_datasets, only: to_state
   use adfric_output_layout, only: layout_t
   use adfric_system_checksum, only: mix_reals, mix_integers
   implicit none (type, external)
   private
   public :: sum_of_block, profile_sums_t, sum_of_profiles

   !> Sums of the profiles of blocks that have not been written as a whole.
   type :: profile_sums_t
      private
      !> Numbers of the blocks in the run, and their sums so far.
      integer(i8), allocatable :: blocks(:), sums(:)
   contains
      procedure :: add
      procedure :: take
   end type profile_sums_t

contains

   !> Checksum of a block.
   integer(i8) function sum_of_block(layout, block, results, error_estimate, status, counts, profile_sum) result(sum)
      type(layout_t), intent(in) :: layout
      !> Number of the block in the run, from 1.
      integer(i8), intent(in) :: block
      !> Results in the units of the model, shape `(n_points, n_results)`; NaN where a point has no state.
      real(dp), intent(in) :: results(:, :)
      !> Estimated relative error of each point [-].
      real(dp), intent(in) :: error_estimate(:)
      !> Status of each point, one of `status_...`.
      integer, intent(in) :: status(:)
      !> What the model counted in the block.
      real(dp), intent(in) :: counts(:)
      !> Checksum of the profiles of the points, each of `sum_of_profiles`, put together by exclusive or; 0 if there are none.
      integer(i8), intent(in) :: profile_sum
      integer :: i, n

      n = size(status)
      sum = mix_integers(0_i8, 1, [block])
      do i = 1, size(layout%fields) - 2
         associate (numbers => results(:, layout%fields(i)%column))
            if (len(layout%fields(i)%flag_meanings) == 0) then
               sum = mix_reals(sum, n, numbers)
            else
               sum = mix_integers(sum, n, int(to_state(numbers), i8))
            end if
         end associate
      end do
      sum = mix_reals(sum, n, error_estimate)
      sum = mix_integers(sum, n, int(status, i8))
      sum = mix_reals(sum, size(counts), counts)
      sum = mix_integers(sum, 1, [profile_sum])
   end function sum_of_block

   !> Checksum of the profiles of a point.
   integer(i8) function sum_of_profiles(point, profiles) result(sum)
      !> Number of the point in the run, from 1.
      integer(i8), intent(in) :: point
      real(dp), intent(in), contiguous :: profiles(:, :, :)

      sum = mix_reals(mix_integers(0_i8, 1, [point]), size(profiles), profiles)
   end function sum_of_profiles

   !> Add the profiles of a point to the sum of its block.
   subroutine add(self, block, sum)
      !> The sums so far; that of the block is changed, or is new.
      class(profile_sums_t), intent(inout) :: self
      integer(i8), intent(in) :: block
      !> Checksum of the profiles of a point, see `sum_of_profiles`.
      integer(i8), intent(in) :: sum
      integer :: i

      if (.not. allocated(self%blocks)) allocate (self%blocks(0), self%sums(0))
      i = findloc(self%blocks, block, dim=1)
      if (i == 0) then
         self%blocks = [self%blocks, block]
         self%sums = [self%sums, sum]
      else
         self%sums(i) = ieor(self%sums(i), sum)
      end if
   end subroutine add

   !> Sum of the profiles of a block, which is forgotten; 0 if there are none.
   subroutine take(self, block, sum)
      !> The sums so far; that of the block is removed.
      class(profile_sums_t), intent(inout) :: self
      integer(i8), intent(in) :: block
      !> Checksum of the profiles of the block that have been added; 0 if there are none.
      integer(i8), intent(out) :: sum
      integer :: i

      sum = 0
      if (.not. allocated(self%blocks)) return
      i = findloc(self%blocks, block, dim=1)
      if (i == 0) return
      sum = self%sums(i)
      self%blocks = [self%blocks(:i - 1), self%blocks(i + 1:)]
      self%sums = [self%sums(:i - 1), self%sums(i + 1:)]
   end subroutine take

end module adfric_output_block_sums
