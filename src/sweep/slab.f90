!> A slab: the blocks of points whose results go to the sink together.
module adfric_sweep_slab
   use adfric_base_kinds, only: dp, i8
   use adfric_base_model, only: attribute_t
   implicit none (type, external)
   private
   public :: slab_t, new_slab, slab_bytes, attributes_t

   !> What a model counted in a block.
   type :: attributes_t
      type(attribute_t), allocatable :: items(:)
   end type attributes_t

   !> Results of the points `first` to `first + n_points - 1`, kept as they are written.
   type :: slab_t
      !> Number of the first point of the run in the slab, from 1.
      integer(i8) :: first = 1
      integer :: n_points = 0
      !> Blocks: all; those that have been given to a thread; those that are solved. An empty slab has none.
      integer :: n_blocks = 0, n_taken = 0, n_solved = 0
      !> Points of each block, but for the last one of the run, which may have less.
      integer :: block_size = 1
      !> Shape `(n_points, n_results)`.
      real(dp), allocatable :: results(:, :)
      !> Shape `(n_points)`.
      real(dp), allocatable :: error_estimate(:)
      !> Shape `(n_points)`.
      integer, allocatable :: status(:)
      !> Shape `(n_blocks)`.
      type(attributes_t), allocatable :: attributes(:)
   contains
      procedure :: move_to
      procedure :: get_block
   end type slab_t

contains

   !> Make room for a slab; it is empty.
   subroutine new_slab(self, n_results, block_size, max_blocks, is_ready)
      type(slab_t), intent(out) :: self
      integer, intent(in) :: n_results
      !> Number of points of a block, and of blocks.
      integer, intent(in) :: block_size, max_blocks
      !> False if there is no memory.
      logical, intent(out) :: is_ready
      integer :: status

      self%block_size = block_size
      allocate (self%error_estimate(block_size*max_blocks), self%status(block_size*max_blocks), &
         self%attributes(max_blocks))
      ! Alone large.
      allocate (self%results(block_size*max_blocks, n_results), stat=status)
      is_ready = status == 0
   end subroutine new_slab

   !> Memory of a slab [bytes].
   pure real(dp) function slab_bytes(n_results, n_points)
      integer, intent(in) :: n_results
      integer, intent(in) :: n_points
      integer, parameter :: real_bytes = 8, integer_bytes = 4

      slab_bytes = real(n_points, dp)*(real_bytes*(n_results + 1) + integer_bytes)
   end function slab_bytes

   !> Let the slab stand for other points, none of them solved.
   pure subroutine move_to(self, first, n_left)
      class(slab_t), intent(inout) :: self
      !> Number of its first point, from 1.
      integer(i8), intent(in) :: first
      !> Number of points from there to the end of the run; 0 makes the slab empty.
      integer(i8), intent(in) :: n_left

      self%first = first
      self%n_points = int(min(size(self%status, kind=i8), n_left))
      self%n_blocks = (self%n_points + self%block_size - 1)/self%block_size
      self%n_taken = 0
      self%n_solved = 0
   end subroutine move_to

   !> Points of a block.
   pure subroutine get_block(self, block, offset, n)
      class(slab_t), intent(in) :: self
      !> From 1.
      integer, intent(in) :: block
      !> Number of points of the slab that stand before it.
      integer, intent(out) :: offset
      !> Number of its points.
      integer, intent(out) :: n

      offset = (block - 1)*self%block_size
      n = min(self%block_size, self%n_points - offset)
   end subroutine get_block

end module adfric_sweep_slab
