!> What a model counts while it solves: sums over blocks that describe a whole run.
module adfric_run_counts
   use adfric_base_kinds, only: dp
   use adfric_model_model, only: model_t
   use adfric_model_table, only: attribute_t
   implicit none (type, external)
   private
   public :: find_counts, pick_counts

contains

   !> Names of what the model counts: it is asked to solve no point at all.
   subroutine find_counts(model, counts)
      !> The model, which is asked to solve no point.
      class(model_t), intent(in) :: model
      !> What the model counts; all values are 0.
      type(attribute_t), allocatable, intent(out) :: counts(:)
      real(dp) :: values(size(model%variables), 0), results(size(model%results), 0), error_estimate(0)
      integer :: status(0)

      call model%solve_block(values, results, error_estimate, status, counts)
   end subroutine find_counts

   !> The counts of a block in the order of their names.
   pure function pick_counts(counts, found) result(values)
      !> Names of the counts in their order; their values are not used.
      type(attribute_t), intent(in) :: counts(:)
      !> What the model counted in the block; a name that is missing counts as 0.
      type(attribute_t), intent(in) :: found(:)
      real(dp) :: values(size(counts))
      integer :: i, k

      values = 0
      do i = 1, size(counts)
         do k = 1, size(found)
            if (found(k)%name == counts(i)%name) values(i) = found(k)%value
         end do
      end do
   end function pick_counts

end module adfric_run_counts
